//! Scenes: named patches, and what they exchange.
//!
//! The paper's own scenes are built in ([`Scene::built_in`]); others are made from patches.
//!
//! **Not covered**: occlusion (every exchange area is the unoccluded one), reflectance, files.

mod arrangement;
mod blockers;
mod built_in;
mod error;
mod exchange_areas;
mod overlap;

pub use blockers::{Blocker, Blockers, Obstacle};
pub use error::SceneError;
pub use exchange_areas::ExchangeAreas;

use crate::geometry::{Patch, Rectangle};

/// A patch and its name.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedPatch {
    name: String,
    shape: Patch,
}

impl NamedPatch {
    /// A patch under a name.
    #[must_use]
    pub const fn new(name: String, shape: Patch) -> Self {
        Self { name, shape }
    }

    /// The name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The polygon.
    #[must_use]
    pub const fn shape(&self) -> &Patch {
        &self.shape
    }
}

/// A list of patches.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    patches: Vec<NamedPatch>,
}

impl Scene {
    /// The scene of these patches.
    ///
    /// # Errors
    /// [`SceneError::Empty`] without a patch.
    pub fn try_new(patches: Vec<NamedPatch>) -> Result<Self, SceneError> {
        if patches.is_empty() {
            Err(SceneError::Empty)
        } else {
            Ok(Self { patches })
        }
    }

    /// The patches, in order.
    #[must_use]
    pub fn patches(&self) -> &[NamedPatch] {
        &self.patches
    }

    /// The sum of the patches' areas `A_T`.
    #[must_use]
    pub fn total_area(&self) -> f64 {
        self.patches.iter().map(|patch| patch.shape.area()).sum()
    }

    /// The patch with this index, as a rectangle.
    ///
    /// # Errors
    /// [`SceneError::NoSuchPatch`]; [`SceneError::Patch`] if it is not a rectangle.
    pub fn rectangle(&self, index: usize) -> Result<Rectangle, SceneError> {
        let patch = self.patches.get(index).ok_or(SceneError::NoSuchPatch {
            index,
            last: self.patches.len() - 1,
        })?;
        Rectangle::try_from(&patch.shape).map_err(|source| SceneError::Patch {
            index,
            name: patch.name.clone(),
            source,
        })
    }
}
