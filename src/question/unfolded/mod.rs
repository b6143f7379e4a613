//! A refined scene unfolded into a page: its walls in their shape and size, as their fronts are
//! seen.
//!
//! `walls` puts patches in one plane together, `net` unfolds them, `packing` sets nets beside each
//! other, `shading` cuts leaves into cells over which a function is drawn.
//!
//! **Not covered**: obstructions, which carry no light.

mod edges;
mod net;
mod packing;
mod shading;
mod walls;

use crate::geometry::bounds;
use crate::hierarchy::{HierarchyError, Refinement};
use crate::numeric::try_parallel_map;
use crate::scene::Scene;
use glam::{DVec2, DVec3};
use net::{Place, places};
use shading::Fineness;
use walls::{Wall, walls};

/// The length over that of the scene by which coordinates may be off on a page.
const NOISE: f64 = 1e-6;
/// Cells beside each other across the scene, and shades from none to the largest value, beyond
/// which nothing finer is drawn.
const CELLS: f64 = 200.0;
const SHADES: f64 = 100.0;

/// A refined scene unfolded into a page, y upwards.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MeshNet {
    /// The walls.
    pub walls: Vec<NetWall>,
    /// The shaded cells, which cover the walls.
    pub cells: Vec<NetCell>,
    /// The outlines of the leaves.
    pub leaves: Vec<Vec<[f64; 2]>>,
    /// The outline of the leaf whose links are shown.
    pub receiver: Option<Vec<[f64; 2]>>,
    /// The outlines of the elements from which it receives light.
    pub sources: Vec<Vec<[f64; 2]>>,
}

/// A wall on the page.
#[derive(Debug, Clone, PartialEq)]
pub struct NetWall {
    /// The name of its largest patch.
    pub name: String,
    /// The edges of its border.
    pub border: Vec<[[f64; 2]; 2]>,
}

/// A shaded cell on the page.
#[derive(Debug, Clone, PartialEq)]
pub struct NetCell {
    /// The corners.
    pub corners: Vec<[f64; 2]>,
    /// The value; none for a light.
    pub value: Option<f64>,
}

/// The radiosity that a net shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shade {
    /// The mean of each leaf.
    Constant,
    /// The linear function of each leaf.
    Linear,
    /// The light that each point gathers.
    Gathered,
}

/// A function of a leaf and a point of it.
type Shading<'f> = dyn Fn(usize, DVec3) -> Result<f64, HierarchyError> + Sync + 'f;

/// A scene that is being unfolded.
struct Unfolding<'s> {
    walls: Vec<Wall>,
    places: Vec<Place>,
    /// The wall of each patch.
    wall_of: Vec<usize>,
    refinement: &'s Refinement<'s>,
    size: f64,
}

impl MeshNet {
    /// The net with the radiosity, and with the links of the leaf in the middle of a patch, if one
    /// is named.
    ///
    /// # Errors
    /// [`HierarchyError`] if the light cannot be gathered.
    pub(super) fn of(
        scene: &Scene,
        refinement: &Refinement<'_>,
        shade: Shade,
        links_of: Option<usize>,
    ) -> Result<Self, HierarchyError> {
        let unfolding = Unfolding::new(scene, refinement);
        let (tree, solution) = (refinement.tree(), refinement.solution());
        let linear = |leaf: usize, point: DVec3| {
            let slope = solution.gradient(tree, refinement.lighting(), leaf);
            solution.radiosity[leaf] + slope.dot(point - tree.elements()[leaf].centre())
        };
        let cells = match shade {
            Shade::Constant => unfolding.shaded(&|leaf, _| Ok(solution.radiosity[leaf])),
            Shade::Linear => unfolding.shaded(&|leaf, point| Ok(linear(leaf, point))),
            Shade::Gathered => unfolding.shaded(&|leaf, point| refinement.gathered(leaf, point)),
        }?;
        let receiver = links_of.map(|patch| unfolding.leaf_in_the_middle(patch));
        let sources = receiver.map(|leaf| unfolding.sources(leaf));
        let outline = |element: usize| unfolding.outline(element);
        Ok(Self {
            walls: unfolding.named_walls(scene),
            cells,
            leaves: tree.leaves().map(outline).collect(),
            receiver: receiver.map(outline),
            sources: sources.into_iter().flatten().map(outline).collect(),
        })
    }
}

impl<'s> Unfolding<'s> {
    fn new(scene: &Scene, refinement: &'s Refinement<'s>) -> Self {
        let patches = scene.patches().iter();
        let corners = patches.flat_map(|patch| patch.shape().corners());
        let [low, high] = bounds(corners.copied());
        let size = (high - low).length();
        let noise = (NOISE * size).max(2.0 * scene.resolution());
        let walls = walls(scene, noise);
        let mut wall_of = vec![0; scene.patches().len()];
        for (index, wall) in walls.iter().enumerate() {
            for patch in &wall.patches {
                wall_of[*patch] = index;
            }
        }
        Self {
            places: places(&walls, noise),
            walls,
            wall_of,
            refinement,
            size,
        }
    }

    fn named_walls(&self, scene: &Scene) -> Vec<NetWall> {
        let area = |patch: &usize| scene.patches()[*patch].shape().area();
        let walls = self.walls.iter().zip(&self.places).map(|(wall, place)| {
            let patches = wall.patches.iter().copied();
            // of equal ones the first
            let largest = patches
                .rev()
                .max_by(|one, other| area(one).total_cmp(&area(other)));
            let name = largest.map_or("", |patch| scene.patches()[patch].name());
            let edge = |edge: &[DVec3; 2]| edge.map(|end| place.of(wall, end).to_array());
            NetWall {
                name: name.to_owned(),
                border: wall.border.iter().map(edge).collect(),
            }
        });
        walls.collect()
    }

    /// Cells shaded by a function of a leaf and a point of it, as fine as the function varies.
    fn shaded(&self, value: &Shading<'_>) -> Result<Vec<NetCell>, HierarchyError> {
        let (tree, solution) = (self.refinement.tree(), self.refinement.solution());
        let is_light = |leaf: usize| {
            let patch = tree.elements()[leaf].patch();
            self.refinement.lighting().is_light(patch)
        };
        let lit = tree.leaves().filter(|leaf| !is_light(*leaf));
        let largest = lit.map(|leaf| solution.radiosity[leaf]).fold(0.0, f64::max);
        let fineness = Fineness {
            length: self.size / CELLS,
            difference: largest / SHADES,
        };
        let leaves: Vec<usize> = tree.leaves().collect();
        let shaded = try_parallel_map(leaves.len(), &|k| {
            let element = &tree.elements()[leaves[k]];
            let shade: &shading::Value<'_> = if is_light(leaves[k]) {
                &|_| Ok(None)
            } else {
                &|point| value(leaves[k], point).map(Some)
            };
            let cells = shading::cells(element, shade, fineness)?;
            let cells = cells.into_iter().map(|(corners, value)| NetCell {
                value,
                corners: self.on_page(element.patch(), &corners),
            });
            Ok::<_, HierarchyError>(cells.collect::<Vec<_>>())
        })?;
        Ok(shaded.into_iter().flatten().collect())
    }

    fn outline(&self, element: usize) -> Vec<[f64; 2]> {
        let element = &self.refinement.tree().elements()[element];
        self.on_page(element.patch(), element.shape().corners())
    }

    fn on_page(&self, patch: usize, corners: &[DVec3]) -> Vec<[f64; 2]> {
        let wall = self.wall_of[patch];
        let place = |corner: &DVec3| self.places[wall].of(&self.walls[wall], *corner);
        corners.iter().map(place).map(DVec2::into).collect()
    }

    /// The leaf of a patch whose centre is nearest to the patch's.
    fn leaf_in_the_middle(&self, patch: usize) -> usize {
        let elements = self.refinement.tree().elements();
        let middle = elements[patch].centre();
        let mut leaf = patch;
        while let Some(nearest) = elements[leaf].children().min_by(|one, other| {
            let distance = |child: &usize| elements[*child].centre().distance_squared(middle);
            distance(one).total_cmp(&distance(other))
        }) {
            leaf = nearest;
        }
        leaf
    }

    /// The elements from which a leaf receives light, by its own links and those around it.
    fn sources(&self, leaf: usize) -> Vec<usize> {
        let (tree, links) = (self.refinement.tree(), self.refinement.links());
        let parent = |element: &usize| tree.elements()[*element].parent();
        let around = std::iter::successors(Some(leaf), parent);
        let links = around.flat_map(|element| links.of(element));
        let lit = links.filter(|link| link.value > 0.0);
        lit.map(|link| link.source as usize).collect()
    }
}
