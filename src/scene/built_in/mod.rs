//! Scenes by name: those of the paper, the insides of regular solids and boxes, lit rooms, and a
//! well-known one.
//!
//! ```text
//!   two-squares     fig. 2   unit squares at 90° with a common edge
//!   three-squares   fig. 3   three unit squares in a corner
//!   cube:N          figs. 4, 5   the inside of the unit cube, N × N patches on a face
//!   tetrahedron, octahedron, dodecahedron, icosahedron   the insides of the regular solids
//!   box:X,Y,Z       the inside of a box with these edges
//!   cornell-box     not of the paper: the empty room of Cornell University, from
//!                   data/scenes/cornell-box.obj; with its two blocks, cornell-box-blocks
//!   lit-cube, lit-cube-edge, lit-hall, lit-wings, shaded-cube, shaded-cube-low, shaded-cube-sharp,
//!   lit-table
//!                   not of the paper: rooms with a light, the last four with plates
//! ```
//!
//! Open this file for the names and the paper's squares, `boxes` for boxes with or without a grid
//! on their faces, `solids` for the regular solids, `lit_rooms` for rooms with a light.
//!
//! **Not covered**: furnished rooms.

pub(crate) mod boxes;
mod lit_rooms;
pub(crate) mod solids;

use super::{NamedPatch, Scene, SceneError, files};
use crate::geometry::{Patch, Rectangle, SplitAxis};
use crate::numeric::real;
use crate::scene::visibility::surfaces::Prepared;
use glam::DVec3;
use lit_rooms::lit_room;
use solids::regular_solid;
use std::sync::Arc;

/// Largest N of `cube:N`: 24,576 patches, whose pairs take seconds to measure as they come.
const LARGEST_CUBE: usize = 256;

impl Scene {
    /// A built-in scene: `two-squares`, `three-squares`, `cube:N`, `box:X,Y,Z`, `tetrahedron`,
    /// `octahedron`, `dodecahedron`, `icosahedron`, `cornell-box`,
    /// `cornell-box-blocks`, or a lit room: `lit-cube`, `lit-cube-edge`, `lit-hall`, `lit-wings`,
    /// `shaded-cube`, `shaded-cube-low`, `shaded-cube-sharp` or `lit-table`.
    ///
    /// In the first two, patch 0 is the one that the paper cuts; its axis u runs away from the
    /// edge it shares with patch 1.
    ///
    /// # Errors
    /// [`SceneError::UnknownName`]; [`SceneError::Patch`] for a box without extent.
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::Scene;
    /// assert_eq!(Scene::built_in("cube:3")?.patches().len(), 54);
    /// # Ok::<(), infoscene::scene::SceneError>(())
    /// ```
    pub fn built_in(name: &str) -> Result<Self, SceneError> {
        match name {
            "two-squares" => Self::floor_and_wall(1.0),
            "three-squares" => corner(),
            "cornell-box" => files::cornell_box(false),
            "cornell-box-blocks" => files::cornell_box(true),
            _ => {
                if let Some(scene) = regular_solid(name).or_else(|| lit_room(name)) {
                    return scene;
                }
                let edges = name.strip_prefix("box:").map(|edges| edges.split(','));
                let edges =
                    edges.map(|edges| edges.map(str::parse).collect::<Result<Vec<f64>, _>>());
                if let Some(Ok([x, y, z])) = edges.as_ref().map(|e| e.as_ref().map(Vec::as_slice)) {
                    return Self::inside_of_box(*x, *y, *z);
                }
                let size = name.strip_prefix("cube:").and_then(|n| n.parse().ok());
                match size.filter(|n| (1..=LARGEST_CUBE).contains(n)) {
                    Some(n) => {
                        let line = |k: usize| real(k) / real(n);
                        Self::gridded_box([1.0; 3], &(1..n).map(line).collect::<Vec<_>>())
                    }
                    None => Err(SceneError::UnknownName {
                        name: name.to_owned(),
                        largest: LARGEST_CUBE,
                    }),
                }
            }
        }
    }

    /// A floor `depth × 1` and a unit square wall at 90°, with a common edge of length 1; patch 0
    /// is the floor, its axis u runs away from the edge.
    ///
    /// # Errors
    /// [`SceneError::Patch`] unless `depth` is finite and > 0.
    pub fn floor_and_wall(depth: f64) -> Result<Self, SceneError> {
        Self::try_new(vec![
            rectangle_patch(0, "floor", DVec3::ZERO, depth * DVec3::X, DVec3::Y)?,
            rectangle_patch(1, "wall", DVec3::ZERO, DVec3::Y, DVec3::Z)?,
        ])
    }

    /// Two aligned unit squares that face each other at a distance.
    ///
    /// # Errors
    /// [`SceneError::Patch`] unless `distance` is finite.
    pub fn facing_squares(distance: f64) -> Result<Self, SceneError> {
        Self::try_new(vec![
            rectangle_patch(0, "floor", DVec3::ZERO, DVec3::X, DVec3::Y)?,
            rectangle_patch(1, "ceiling", distance * DVec3::Z, DVec3::Y, DVec3::X)?,
        ])
    }

    /// The scene in which patch `index` is cut across an axis; the part at `v0` takes its place,
    /// the other one follows at the end. Both are of its material and lie where it lay; each is a
    /// row of its own unless the patch was summed with others.
    ///
    /// # Errors
    /// [`SceneError::NoSuchPatch`], [`SceneError::Patch`] if the patch is not a rectangle or the
    /// position is not inside it; [`SceneError::CutThroughPart`] if others lie in it.
    pub fn with_patch_split(
        &self,
        index: usize,
        axis: SplitAxis,
        position: f64,
    ) -> Result<Self, SceneError> {
        if let Some(part) = self.parts_of(index).next() {
            return Err(SceneError::CutThroughPart { base: index, part });
        }
        let rectangle = self.rectangle(index)?;
        let name = self.patches[index].name.clone();
        let patch = &self.patches[index];
        let material = patch.material.clone();
        let own = std::iter::once(&name);
        let wholes: Arc<[String]> = patch.wholes.iter().chain(own).cloned().collect();
        let parts = rectangle
            .split(axis, position)
            .and_then(|[near, far]| Ok([Patch::try_from(&near)?, Patch::try_from(&far)?]))
            .map_err(|source| SceneError::Patch {
                index,
                name: name.clone(),
                source,
            })?;
        let [near, far] = parts;
        let mut scene = Self {
            prepared: Prepared::default(),
            ..self.clone()
        };
        let part = |name, shape| {
            let part = NamedPatch::new(name, shape).with_material(material.clone());
            part.with_wholes(Arc::clone(&wholes))
        };
        scene.patches[index] = part(format!("{name} (near)"), near);
        scene.patches.push(part(format!("{name} (far)"), far));
        scene.bases.push(self.bases[index]);
        let own_row = self.patches_of_group(self.groups[index]).count() == 1;
        scene.groups.push(if own_row {
            self.group_count()
        } else {
            self.groups[index]
        });
        Ok(scene)
    }
}

/// Unit squares in the planes z = 0, x = 0 and y = 0, fronts towards the positive octant.
fn corner() -> Result<Scene, SceneError> {
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    Scene::try_new(vec![
        rectangle_patch(0, "floor", DVec3::ZERO, x, y)?,
        rectangle_patch(1, "wall", DVec3::ZERO, y, z)?,
        rectangle_patch(2, "side wall", DVec3::ZERO, z, x)?,
    ])
}

/// A rectangle under a name, refused by its index.
pub(crate) fn rectangle_patch(
    index: usize,
    name: &str,
    origin: DVec3,
    u: DVec3,
    v: DVec3,
) -> Result<NamedPatch, SceneError> {
    let shape = Rectangle::try_new(origin, u, v).and_then(|rectangle| Patch::try_from(&rectangle));
    match shape {
        Ok(shape) => Ok(NamedPatch::new(name.to_owned(), shape)),
        Err(source) => Err(SceneError::Patch {
            index,
            name: name.to_owned(),
            source,
        }),
    }
}
