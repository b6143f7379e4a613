//! The plates that may stand between two elements: fewer and fewer for parts of them.
//!
//! ```text
//!   aside    all of plate k, or of both elements, is on one side of: the plane of either element,
//!            of the plate, or of an edge of the plate along the axis
//!   across   the elements are on either side of the plate's plane, and the tube around the axis
//!            meets it within the plate
//!   between  anything else
//! ```
//!
//! The axis leads from centre to centre. A point at the share t of a segment between the elements
//! lies within `r(t) = (1−t) r_0 + t r_1` of it, and on the plate's plane for some t alone:
//!
//! ```text
//!   (1−t) min h_0 + t min h_1 ≤ 0 ≤ (1−t) max h_0 + t max h_1        h: heights of the corners
//! ```
//!
//! so that a tube of the largest r(t) among these holds all that meets the plane. What is aside
//! takes nothing, what is across takes all, and of what is between it is open.
//!
//! **Not covered**: several plates that hide together.

use crate::form_factor::{Plate, PointView, Polygon, Seen};
use crate::geometry::Patch;
use crate::hierarchy::tree::Element;
use crate::numeric::parallel_map;
use crate::scene::{Blockers, Scene, Screened, Screening};
use glam::DVec3;
use smallvec::SmallVec;
use std::collections::HashMap;

/// Sines of angles below which a line runs along a plate.
const EDGE_ON: f64 = 1e-9;

/// What is known of the space between two elements, and holds for parts of them.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Visibility {
    /// Nothing stands between them.
    Clear,
    /// Nothing but these plates may, by their numbers.
    Past(SmallVec<[u32; 4]>),
    /// They see nothing of each other.
    Hidden,
}

/// The place of a plate relative to all segments between two elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::hierarchy) enum Place {
    /// None meets it.
    Aside,
    /// All meet it.
    Across,
    /// Some may meet it.
    Between,
}

impl Visibility {
    /// The visibility past candidates whose places are known.
    pub(in crate::hierarchy) fn past(candidates: &[u32], place: impl Fn(u32) -> Place) -> Self {
        let mut left: SmallVec<[u32; 4]> = SmallVec::new();
        for number in candidates {
            match place(*number) {
                Place::Aside => {}
                Place::Across => return Self::Hidden,
                Place::Between => left.push(*number),
            }
        }
        if left.is_empty() {
            Self::Clear
        } else {
            Self::Past(left)
        }
    }
}

/// The convex pieces of a scene's screens, and those that stand between its patches.
#[derive(Debug, Clone)]
pub(in crate::hierarchy) struct Plates {
    plates: Vec<Plate>,
    polygons: Vec<Polygon>,
    /// What stands between pairs of patches, row by row of the lower triangle.
    pairs: Vec<Visibility>,
}

impl Plates {
    /// The plates of a scene, screens back to back as one; none if nothing is in the way.
    pub(super) fn of(scene: &Scene) -> Option<Self> {
        if !Blockers::of(scene).can_block() {
            return None;
        }
        let screening = Screening::of(scene);
        let mut pieces = Pieces::default();
        let of_screen: Vec<Vec<u32>> = pieces.add_all(scene);
        let visibility = |first: usize, second: usize| match screening.between(first, second) {
            Screened::Nothing => Visibility::Clear,
            Screened::Wholly => Visibility::Hidden,
            Screened::By(screens) => {
                let plates = screens.iter().flat_map(|screen| &of_screen[*screen]);
                let mut plates: SmallVec<[u32; 4]> = plates.copied().collect();
                plates.sort_unstable();
                plates.dedup();
                Visibility::Past(plates)
            }
        };
        let rows = parallel_map(scene.patches().len(), &|first| {
            let row: Vec<_> = (0..first).map(|second| visibility(first, second)).collect();
            row
        });
        Some(Self {
            plates: pieces.plates,
            polygons: pieces.polygons,
            pairs: rows.into_iter().flatten().collect(),
        })
    }

    /// The plate with this number.
    pub(in crate::hierarchy) fn plate(&self, number: u32) -> &Plate {
        &self.plates[number as usize]
    }

    /// The plates with these numbers.
    pub(super) fn selected(&self, numbers: &[u32]) -> SmallVec<[&Plate; 8]> {
        let numbers = numbers.iter();
        numbers
            .map(|number| &self.plates[*number as usize])
            .collect()
    }

    /// The polygons of the plates with these numbers.
    pub(in crate::hierarchy) fn polygons(&self, numbers: &[u32]) -> SmallVec<[&Polygon; 8]> {
        let numbers = numbers.iter();
        numbers
            .map(|number| &self.polygons[*number as usize])
            .collect()
    }

    /// The form factor from a point to what plates leave of a shape.
    pub(in crate::hierarchy) fn form_factor(
        &self,
        view: PointView,
        shape: &Patch,
        between: &[u32],
    ) -> f64 {
        let corners = shape.corners();
        if (view.point - corners[0]).dot(shape.normal()) <= 0.0 {
            return 0.0;
        }
        match view.visible(corners, &self.selected(between)) {
            Seen::Part(value) => value,
            Seen::Whole => view.form_factor(corners),
        }
    }

    /// What stands between two patches.
    pub(in crate::hierarchy) fn of_patches(&self, first: usize, second: usize) -> &Visibility {
        let [low, high] = [first.min(second), first.max(second)];
        if low == high {
            return &Visibility::Hidden;
        }
        &self.pairs[high * (high - 1) / 2 + low]
    }

    /// What stands between two elements, of what stands between those that they are parts of.
    pub(super) fn narrowed(
        &self,
        inherited: &Visibility,
        ends: [&Element; 2],
        touching: f64,
    ) -> Visibility {
        match inherited {
            Visibility::Past(candidates) => Visibility::past(candidates, |number| {
                place(self.plate(number), ends, touching)
            }),
            known => known.clone(),
        }
    }
}

/// The convex pieces of screens, each once.
#[derive(Debug, Default)]
struct Pieces {
    plates: Vec<Plate>,
    polygons: Vec<Polygon>,
    numbers: HashMap<Vec<[u64; 3]>, u32>,
}

impl Pieces {
    /// Adds the screens of a scene, and returns the numbers of the pieces of each.
    fn add_all(&mut self, scene: &Scene) -> Vec<Vec<u32>> {
        let (screens, unit) = (scene.screens(), scene.planes().unit());
        let screens = (0..screens.count()).map(|index| screens.screen(index));
        screens
            .map(|screen| {
                let pieces = screen.outline.pieces().iter();
                let corners =
                    pieces.map(|piece| piece.iter().map(|corner| *corner * unit).collect());
                // a piece without an area hides nothing
                let shapes = corners.filter_map(|corners| Patch::try_new(corners).ok());
                shapes.map(|shape| self.add(&shape)).collect()
            })
            .collect()
    }

    fn add(&mut self, shape: &Patch) -> u32 {
        let bits = |corner: &DVec3| corner.to_array().map(|x| (x + 0.0).to_bits());
        let mut key: Vec<[u64; 3]> = shape.corners().iter().map(bits).collect();
        key.sort_unstable();
        let next = self.plates.len();
        *self.numbers.entry(key).or_insert_with(|| {
            self.plates
                .push(Plate::new(shape.corners(), shape.normal()));
            self.polygons.push(Polygon::new(shape));
            u32::try_from(next).unwrap_or_else(|_| unreachable!("plates fill no memory so large"))
        })
    }
}

/// The place of a plate relative to two elements.
fn place(plate: &Plate, ends: [&Element; 2], touching: f64) -> Place {
    for end in ends {
        let (origin, normal) = (end.centre(), end.shape().normal());
        let rises = |corner: &DVec3| (*corner - origin).dot(normal) > touching;
        if !plate.corners().iter().any(rises) {
            return Place::Aside;
        }
    }
    let heights = ends.map(|end| {
        let heights = end
            .shape()
            .corners()
            .iter()
            .map(|corner| plate.height(*corner));
        heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], height| {
            [low.min(height), high.max(height)]
        })
    });
    let [[low, high], [least, most]] = heights;
    if high.max(most) <= touching || low.min(least) >= -touching {
        return Place::Aside;
    }
    let is_between_planes = low.max(least) >= touching && high.min(most) <= -touching;
    let [from, to] = ends.map(Element::centre);
    let radii = ends.map(Element::radius);
    let at_plane = shares_at_plane(heights).map(|t| radii[0] + t * (radii[1] - radii[0]));
    let radius = at_plane[0].max(at_plane[1]);
    match in_tube(plate, from, to - from, radius) {
        Place::Across if !is_between_planes => Place::Between,
        place => place,
    }
}

/// The least and the largest share of a segment at which it can meet a plane, for the least and the
/// largest heights of both ends over it, of which some are above and some below.
fn shares_at_plane([[low, high], [least, most]]: [[f64; 2]; 2]) -> [f64; 2] {
    // where the height that leads from one end to the other is 0, if it changes sign
    let zero = |from: f64, to: f64| from / (from - to);
    let first = if low > 0.0 {
        zero(low, least)
    } else if high < 0.0 {
        zero(high, most)
    } else {
        0.0
    };
    let last = if least > 0.0 {
        zero(low, least)
    } else if most < 0.0 {
        zero(high, most)
    } else {
        1.0
    };
    [first, last]
}

/// The place of a plate relative to a tube around a line.
fn in_tube(plate: &Plate, origin: DVec3, axis: DVec3, radius: f64) -> Place {
    let corners = plate.corners();
    let slope = plate.normal().dot(axis);
    // a line along the plate meets it edge on
    let is_steep = slope * slope > EDGE_ON * EDGE_ON * axis.length_squared();
    if !is_steep {
        return Place::Between;
    }
    let mut found = Place::Across;
    for (from, to) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        let outward = (*to - *from).cross(axis) * slope.signum();
        let apart = (origin - *from).dot(outward);
        let wide = radius * radius * outward.length_squared();
        if apart * apart < wide {
            found = Place::Between;
        } else if apart > 0.0 {
            return Place::Aside;
        }
    }
    found
}
