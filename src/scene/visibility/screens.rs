//! The screens of a scene: what its surfaces hide, in as few polygons as will do.
//!
//! ```text
//!   group    neighbours that lie in one plane, face the same way and share whole edges
//!   screen   a group, if it is convex; else surfaces of it, put together as long as they are
//! ```
//!
//! A wall of 8 × 8 facets is one screen, one with a window four. Where the facets meet nothing
//! passes, so that screens hide what the surfaces hide. Parts of a base are in the group of the
//! base, and hide no more than it does. A group with an opening comes as several, none of which has
//! any (`regions`).
//!
//! What is true of a group as a whole is true of its surfaces: of groups that see nothing of each
//! other all pairs of surfaces are hidden.
//!
//! **Not covered**: neighbours that meet in a part of an edge, or face opposite ways.

use super::bodies::Bodies;
use super::boxes::{BoxHull, Boxes, boxed};
use crate::geometry::{Outline, Patch, is_convex};
use crate::scene::regions::{Mesh, Region, without_straight_corners};
use crate::scene::{NamedPatch, Scene};
use glam::DVec3;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU8, Ordering};

/// The screens of a scene, the groups that they are pieces of, and the bodies that they bound.
#[derive(Debug)]
pub(crate) struct Screens {
    screens: Vec<Screen>,
    /// The group of each surface; obstructions are numbered after the patches.
    group_of: Vec<usize>,
    groups: Vec<Outline>,
    bodies: Bodies,
    /// The screens that can stand between two patches.
    tree: Boxes,
    /// Verdicts on pairs of groups, if these are fewer than the surfaces: on each with those before
    /// it and itself, from when the first of these pairs is asked for.
    verdicts: Vec<OnceLock<Box<[AtomicU8]>>>,
}

/// No verdict on a pair of groups yet.
const UNKNOWN: u8 = 0;

/// The verdict that two groups see nothing of each other.
const HIDDEN: u8 = 1;

/// The verdict that two groups may see something of each other.
const OPEN: u8 = 2;

/// Corners of the largest screen that is put together.
const MOST_CORNERS: usize = 8;

/// Most surfaces of a group that are put together one by one: the work grows with their square.
const MOST_PUT_TOGETHER: usize = 256;

/// Most pairs of groups of which verdicts are kept, a byte each.
const MOST_VERDICTS: usize = 1 << 26;

/// A polygon that hides what is behind it, from both sides.
#[derive(Debug)]
pub(crate) struct Screen {
    pub shape: Patch,
    pub outline: Outline,
    /// The plane that it lies in, by its number.
    pub plane: usize,
}

impl Screens {
    /// The screens of all surfaces of a scene.
    pub(crate) fn of(scene: &Scene) -> Self {
        let surfaces: Vec<&NamedPatch> = scene.surfaces().collect();
        let root = |surface: usize| match surface < scene.patches().len() {
            true => scene.root_of(surface),
            false => surface,
        };
        let is_whole = |surface: usize| root(surface) == surface;
        let corners = surfaces.iter().enumerate().map(|(index, surface)| {
            let is_whole = is_whole(index);
            if is_whole {
                surface.shape().given_corners()
            } else {
                &[]
            }
        });
        let mesh = Mesh::of(corners);
        let planes = scene.planes();
        let mut found = Self {
            screens: Vec::new(),
            group_of: vec![0; surfaces.len()],
            groups: Vec::new(),
            bodies: Bodies::default(),
            tree: Boxes::new(),
            verdicts: Vec::new(),
        };
        let mut is_taken: Vec<bool> = (0..surfaces.len()).map(|index| !is_whole(index)).collect();
        for seed in 0..surfaces.len() {
            if is_taken[seed] {
                continue;
            }
            let placed = planes.plane_of(seed);
            let may_join = |other| planes.plane_of(other) == placed;
            let region = Region::grown(&mesh, seed, &mut is_taken, may_join);
            let joined = match region.members.len() {
                1 => None,
                _ => region.corners(&mesh),
            };
            let joined = joined.and_then(|c| Patch::within(c, scene.resolution()).ok());
            let members = region.members.iter();
            let members = members.map(|index| (*index, surfaces[*index].shape()));
            found.add(scene, &members.collect::<Vec<_>>(), joined.as_ref());
        }
        for surface in 0..surfaces.len() {
            found.group_of[surface] = found.group_of[root(surface)];
        }
        let outlines = found.screens.iter().map(|screen| &screen.outline);
        found.bodies = Bodies::of(&outlines.collect::<Vec<_>>(), planes.noise());
        let splits = scene.splits();
        let screens = found.screens.iter().enumerate();
        let screens = screens.filter(|(_, screen)| splits[screen.plane]);
        found.tree = boxed(screens.map(|(index, screen)| (index, *screen.outline.bounds())));
        let groups = found.groups.len();
        if groups < surfaces.len() && groups * groups <= 2 * MOST_VERDICTS {
            found.verdicts = (0..groups).map(|_| OnceLock::new()).collect();
        }
        found
    }

    /// Adds a group of surfaces, and the screens that it takes.
    ///
    /// **Arguments** `joined`: their union, if it is a polygon.
    fn add(&mut self, scene: &Scene, members: &[(usize, &Patch)], joined: Option<&Patch>) {
        let planes = scene.planes();
        let plane = planes.facing(members[0].0);
        let outline = |shape: &Patch| Outline::new(shape, planes.unit(), plane);
        match joined {
            Some(joined) => {
                for (member, _) in members {
                    self.group_of[*member] = self.groups.len();
                }
                self.groups.push(outline(joined));
            }
            None => {
                for (member, shape) in members {
                    self.group_of[*member] = self.groups.len();
                    self.groups.push(outline(shape));
                }
            }
        }
        let normal = members[0].1.normal();
        let whole = joined.filter(|joined| is_piece(joined.corners(), normal));
        let pieces = whole.map(|whole| vec![whole.clone()]).or_else(|| {
            let corners = members
                .iter()
                .map(|(_, shape)| shape.given_corners().to_vec());
            let pieces = put_together(corners.collect(), normal);
            let piece = |corners| Patch::within(corners, scene.resolution()).ok();
            pieces.into_iter().map(piece).collect()
        });
        let alone = || members.iter().map(|(_, shape)| (*shape).clone()).collect();
        let shapes = pieces.unwrap_or_else(alone);
        let screens = shapes.into_iter().map(|shape| Screen {
            outline: outline(&shape),
            plane: planes.plane_of(members[0].0).plane,
            shape,
        });
        self.screens.extend(screens);
    }

    /// Number of screens.
    pub(crate) const fn count(&self) -> usize {
        self.screens.len()
    }

    /// A screen.
    pub(crate) fn screen(&self, index: usize) -> &Screen {
        &self.screens[index]
    }

    /// Whether two groups see nothing of each other, which is found out once; none where nothing
    /// is kept.
    pub(super) fn verdict(
        &self,
        groups: [usize; 2],
        are_hidden: impl Fn() -> bool,
    ) -> Option<bool> {
        let (low, high) = (groups[0].min(groups[1]), groups[0].max(groups[1]));
        let row = self.verdicts.get(high)?;
        let row = row.get_or_init(|| (0..=high).map(|_| AtomicU8::new(UNKNOWN)).collect());
        let verdict = &row[low];
        Some(match verdict.load(Ordering::Relaxed) {
            UNKNOWN => {
                let found = are_hidden();
                verdict.store(if found { HIDDEN } else { OPEN }, Ordering::Relaxed);
                found
            }
            known => known == HIDDEN,
        })
    }

    /// The group of a surface.
    pub(super) fn group_of(&self, surface: usize) -> usize {
        self.group_of[surface]
    }

    /// The outline of a group.
    pub(super) fn group(&self, group: usize) -> &Outline {
        &self.groups[group]
    }

    /// The bodies that the screens bound.
    pub(super) const fn bodies(&self) -> &Bodies {
        &self.bodies
    }

    /// The screens whose boxes meet the hull of two boxes. Screens in planes that have all patches
    /// on one side are not among them.
    pub(super) fn between(&self, ends: [&[DVec3; 2]; 2]) -> impl Iterator<Item = usize> {
        let hull = BoxHull::of(ends);
        let found = self.tree.locate_with_selection_function(hull);
        found.map(|boxed| boxed.data)
    }
}

/// Whether an outline is convex, and has few corners.
fn is_piece(corners: &[DVec3], normal: DVec3) -> bool {
    corners.len() <= MOST_CORNERS && is_convex(corners, normal, 0.0)
}

/// Outlines in one plane of which two at a time are put together along a common edge, as long as
/// they make up convex ones.
fn put_together(mut outlines: Vec<Vec<DVec3>>, normal: DVec3) -> Vec<Vec<DVec3>> {
    if outlines.len() > MOST_PUT_TOGETHER {
        return outlines;
    }
    let mut at = 0;
    while at < outlines.len() {
        let own = &outlines[at];
        let found = outlines.iter().enumerate().find_map(|(index, other)| {
            let union = (index != at).then(|| union(own, other)).flatten()?;
            is_piece(&union, normal).then_some((index, union))
        });
        match found {
            Some((index, union)) => {
                outlines[at] = union;
                outlines.remove(index);
                // what did not fit before may fit now
                at = 0;
            }
            None => at += 1,
        }
    }
    outlines
}

/// Two outlines as one along an edge that runs in opposite ways in both.
fn union(one: &[DVec3], other: &[DVec3]) -> Option<Vec<DVec3>> {
    let (n, m) = (one.len(), other.len());
    let edges = (0..n).flat_map(|i| (0..m).map(move |j| (i, j)));
    let is_common =
        |(i, j): &(usize, usize)| one[*i] == other[(j + 1) % m] && one[(i + 1) % n] == other[*j];
    let (i, j) = edges.into_iter().find(is_common)?;
    let own = (0..n).map(|k| one[(i + 1 + k) % n]);
    let its = (2..m).map(|k| other[(j + k) % m]);
    Some(without_straight_corners(
        &own.chain(its).collect::<Vec<_>>(),
    ))
}
