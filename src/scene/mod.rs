//! Scenes: named patches with their materials, and the surfaces that obstruct.
//!
//! The paper's own scenes are built in ([`Scene::built_in`]), others are read from [`files`] or
//! made from patches. A scene also says what only obstructs, which patches lie in another one, and
//! which are summed into one row ([`Scene::base_of`], [`Scene::group_of`]), and to which length its
//! coordinates are known ([`Scene::resolution`]).
//!
//! What may stand between two patches is found ([`Blockers`]), and [`Occlusion`] says what becomes
//! of it.
//!
//! **Not covered**: what patches exchange.

mod built_in;
mod channel;
mod convex_room;
mod cracks;
mod edges;
mod error;
pub mod files;
mod fronts;
mod joined;
mod material;
mod overlap;
mod parts;
mod planes;
mod regions;
mod resolution;
mod row_materials;
mod subdivision;
mod visibility;

pub use channel::{Channel, Channels};
pub use edges::{FreeEdge, Joints};
pub use error::SceneError;
pub use material::{Material, MaterialError, MaterialFault, PatchMaterial};
pub(crate) use material::{checked_emittance, checked_reflectance};
pub use parts::EmptyRow;
pub use resolution::ResolvedSurfaces;
pub use visibility::blockers::{Blocker, Blockers};
pub use visibility::grid_lines::GridLines;
pub use visibility::lines::{Chord, Passage, SceneLines};
pub use visibility::obstacle::Obstacle;
pub use visibility::occlusion::Occlusion;
pub(crate) use visibility::occlusion::are_few;
pub(crate) use visibility::screening::{Screened, Screening};

use crate::geometry::{GeometryError, Patch, Rectangle};
use std::sync::Arc;
use visibility::surfaces::Prepared;

/// A patch, its name and its material.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedPatch {
    name: String,
    /// The names of what it is a piece of: objects, groups, a face that was divided.
    wholes: Arc<[String]>,
    shape: Patch,
    material: PatchMaterial,
}

impl NamedPatch {
    /// A black patch under a name.
    #[must_use]
    pub fn new(name: String, shape: Patch) -> Self {
        Self {
            name,
            wholes: Arc::default(),
            shape,
            material: PatchMaterial::BLACK,
        }
    }

    /// Gives the patch this material, a [`Material`] being that of all channels.
    #[must_use]
    pub fn with_material(self, material: impl Into<PatchMaterial>) -> Self {
        Self {
            material: material.into(),
            ..self
        }
    }

    /// Makes the patch a piece of what has these names: of an object, of a face.
    #[must_use]
    pub fn with_wholes(self, wholes: Arc<[String]>) -> Self {
        Self { wholes, ..self }
    }

    /// The name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The names of what the patch is a piece of: objects and groups of its file, the face or the
    /// patch that it was cut from.
    #[must_use]
    pub fn wholes(&self) -> &[String] {
        &self.wholes
    }

    /// The patch with its front where its back is. The first corner stays the first.
    #[must_use]
    pub fn reversed(self) -> Self {
        let shape = self.shape.reversed();
        Self { shape, ..self }
    }

    /// The polygon.
    #[must_use]
    pub const fn shape(&self) -> &Patch {
        &self.shape
    }

    /// The material, as far as it is known.
    #[must_use]
    pub const fn material(&self) -> &PatchMaterial {
        &self.material
    }
}

/// A list of patches, their grouping, and surfaces that only obstruct.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    patches: Vec<NamedPatch>,
    obstructions: Vec<NamedPatch>,
    /// The base of each patch that lies in another one.
    bases: Vec<Option<usize>>,
    /// The row of each patch, numbered in the order of their first patches.
    groups: Vec<usize>,
    /// The length by which each coordinate may be off.
    resolution: f64,
    /// The rows without a patch, in order.
    empty_rows: Vec<EmptyRow>,
    /// Planes and trees of the surfaces, found when first asked for and dropped when surfaces
    /// change.
    prepared: Prepared,
}

impl Scene {
    /// The scene of these patches: nothing else obstructs, no patch lies in another, each is a row
    /// of its own.
    ///
    /// # Errors
    /// [`SceneError::Empty`] without a patch.
    pub fn try_new(patches: Vec<NamedPatch>) -> Result<Self, SceneError> {
        if patches.is_empty() {
            return Err(SceneError::Empty);
        }
        let (bases, groups) = (vec![None; patches.len()], (0..patches.len()).collect());
        Ok(Self {
            patches,
            obstructions: Vec::new(),
            bases,
            groups,
            resolution: 0.0,
            empty_rows: Vec::new(),
            prepared: Prepared::default(),
        })
    }

    /// The scene with the front of every patch where its back is: what mends a file whose faces run
    /// clockwise.
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::Scene;
    /// let outside = Scene::built_in("cube:1")?.reversed();
    /// assert_eq!(outside.patches()[0].shape().normal(), -glam::DVec3::Z);
    /// # Ok::<(), infoscene::scene::SceneError>(())
    /// ```
    #[must_use]
    pub fn reversed(self) -> Self {
        let patches = self.patches.into_iter().map(NamedPatch::reversed);
        Self {
            patches: patches.collect(),
            prepared: Prepared::default(),
            ..self
        }
    }

    /// The patches, in order.
    #[must_use]
    pub fn patches(&self) -> &[NamedPatch] {
        &self.patches
    }

    /// The patches, then the obstructions: all that is there.
    pub(crate) fn surfaces(&self) -> impl Iterator<Item = &NamedPatch> {
        self.patches.iter().chain(&self.obstructions)
    }

    /// A patch, or an obstruction: these are numbered after the patches.
    pub(crate) fn surface(&self, index: usize) -> &NamedPatch {
        match index.checked_sub(self.patches.len()) {
            None => &self.patches[index],
            Some(obstruction) => &self.obstructions[obstruction],
        }
    }

    /// The sum of the patches' areas `A_T`; what lies in another patch counts once.
    #[must_use]
    pub fn total_area(&self) -> f64 {
        let whole = self.patches.iter().zip(&self.bases);
        whole
            .filter(|(_, base)| base.is_none())
            .map(|(patch, _)| patch.shape.area())
            .sum()
    }

    /// The patch with this index, as a rectangle.
    ///
    /// # Errors
    /// [`SceneError::NoSuchPatch`]; [`SceneError::Patch`] if it is not a rectangle, as it is not
    /// either when others lie in it.
    pub fn rectangle(&self, index: usize) -> Result<Rectangle, SceneError> {
        self.check(index)?;
        let patch = &self.patches[index];
        let shape = match self.parts_of(index).next() {
            None => Rectangle::try_from(&patch.shape),
            Some(part) => Err(GeometryError::NotARectangle {
                reason: format!("patch {part} lies in it, and it counts without"),
            }),
        };
        shape.map_err(|source| self.refused(index, source))
    }

    /// The patch with this index, of which nothing is left out: no other patch lies in it.
    ///
    /// # Errors
    /// [`SceneError::NoSuchPatch`]; [`SceneError::NotAPatchOfItsOwn`].
    pub fn whole_patch(&self, index: usize) -> Result<&NamedPatch, SceneError> {
        self.check(index)?;
        match self.parts_of(index).next() {
            None => Ok(&self.patches[index]),
            Some(_) => Err(SceneError::NotAPatchOfItsOwn {
                index,
                what: "has others lying in it",
            }),
        }
    }

    /// The refusal of a surface's shape, with its name.
    pub(crate) fn refused(&self, index: usize, source: GeometryError) -> SceneError {
        SceneError::Patch {
            index,
            name: self.surface(index).name.clone(),
            source,
        }
    }

    fn check(&self, index: usize) -> Result<(), SceneError> {
        if index < self.patches.len() {
            Ok(())
        } else {
            Err(SceneError::NoSuchPatch {
                index,
                last: self.patches.len() - 1,
            })
        }
    }
}
