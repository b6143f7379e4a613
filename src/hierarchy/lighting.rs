//! The materials of the patches, as far as light asks for them.

use super::HierarchyError;
use crate::scene::{Channel, Scene, SceneError};
use crate::transport::TransportError;

/// The reflectance and the emittance of each patch.
#[derive(Debug, Clone, PartialEq)]
pub struct Lighting {
    reflectances: Vec<f64>,
    emittances: Vec<f64>,
}

impl Lighting {
    /// The lighting by patches with these reflectances, in `[0, 1)`, and emittances, at least 0.
    ///
    /// # Errors
    /// [`HierarchyError::Transport`] with a reflectance out of range or a source that is negative,
    /// with lists of different lengths or without any light; [`HierarchyError::Mirror`].
    pub fn try_new(reflectances: Vec<f64>, emittances: Vec<f64>) -> Result<Self, HierarchyError> {
        if reflectances.len() != emittances.len() {
            return Err(HierarchyError::Transport(TransportError::WrongCount {
                what: "emittances",
                found: emittances.len(),
                expected: reflectances.len(),
            }));
        }
        for (patch, value) in reflectances.iter().copied().enumerate() {
            if !(0.0..=1.0).contains(&value) {
                let source = TransportError::ReflectanceOutOfRange { patch, value };
                return Err(HierarchyError::Transport(source));
            }
            if value >= 1.0 {
                return Err(HierarchyError::Mirror { patch });
            }
        }
        let what = "emittance";
        for (patch, value) in emittances.iter().copied().enumerate() {
            if !(value.is_finite() && value >= 0.0) {
                let source = TransportError::SourceOutOfRange { what, patch, value };
                return Err(HierarchyError::Transport(source));
            }
        }
        if emittances.iter().all(|emittance| *emittance <= 0.0) {
            return Err(HierarchyError::Transport(TransportError::NoSource { what }));
        }
        Ok(Self {
            reflectances,
            emittances,
        })
    }

    /// The lighting of a scene by its own materials, in one channel of colour.
    ///
    /// # Errors
    /// [`HierarchyError::Scene`] with the first patch whose material is not known; as
    /// [`try_new`](Self::try_new).
    pub fn of(scene: &Scene, channel: Channel) -> Result<Self, HierarchyError> {
        let rows = || (0..scene.patches().len()).map(|patch| scene.group_of(patch));
        let reflectances = rows().map(|row| Ok(*scene.group_reflectance(row)?.of(channel)));
        let emittances = rows().map(|row| Ok(*scene.group_emittance(row)?.of(channel)));
        Self::try_new(
            reflectances.collect::<Result<_, SceneError>>()?,
            emittances.collect::<Result<_, SceneError>>()?,
        )
    }

    /// The reflectances of the patches.
    #[must_use]
    pub fn reflectances(&self) -> &[f64] {
        &self.reflectances
    }

    /// The emittances of the patches.
    #[must_use]
    pub fn emittances(&self) -> &[f64] {
        &self.emittances
    }

    /// The reflectance of a patch.
    #[must_use]
    pub fn reflectance(&self, patch: usize) -> f64 {
        self.reflectances[patch]
    }

    /// The emittance of a patch.
    #[must_use]
    pub fn emittance(&self, patch: usize) -> f64 {
        self.emittances[patch]
    }

    /// Whether a patch is a light. Errors are measured over all that is not.
    #[must_use]
    pub fn is_light(&self, patch: usize) -> bool {
        self.emittances[patch] > 0.0
    }

    /// The number of patches.
    #[must_use]
    pub fn patches(&self) -> usize {
        self.reflectances.len()
    }
}
