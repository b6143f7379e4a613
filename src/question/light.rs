//! The chain of a scene that is meant, and the light that it takes.

use super::QuestionError;
use super::patch_values::{MaterialChanges, PatchValue, values};
use crate::exchange::ExchangeAreas;
use crate::scene::{Material, Scene};
use crate::transport::{RadiositySolution, RadiositySystem};

/// A chain of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
pub enum SceneChain {
    /// The visibility chain: weights are areas, transitions form factors.
    #[default]
    Visibility,
    /// The chain weighted with the radiosities: weights are generalised areas (§3.4).
    Radiosity,
    /// The chain weighted with the reflected importances (§3.5).
    Importance,
}

/// The chain that is meant, and the light that it takes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Light {
    /// The chain.
    pub chain: SceneChain,
    /// Materials in place of the scene's own; none for the visibility chain.
    pub materials: MaterialChanges,
    /// Direct importances, for the importance chain.
    pub importance: Vec<PatchValue>,
}

impl Light {
    /// Whether it is the visibility chain, which takes no light.
    ///
    /// # Errors
    /// [`QuestionError::NoLightMeant`] if light is described nevertheless.
    pub(super) fn is_visibility(&self) -> Result<bool, QuestionError> {
        let is_visibility = self.chain == SceneChain::Visibility;
        if is_visibility && !(self.materials.is_empty() && self.importance.is_empty()) {
            return Err(QuestionError::NoLightMeant);
        }
        Ok(is_visibility)
    }

    /// The radiosities, or the reflected importances.
    pub(super) fn brightness(
        &self,
        scene: &Scene,
        exchange: &ExchangeAreas,
    ) -> Result<RadiositySolution, QuestionError> {
        let materials = self.materials.of(scene)?;
        let room = RadiositySystem::of(exchange, &materials)?;
        if self.chain == SceneChain::Importance {
            let direct = values(&self.importance, scene)?;
            return Ok(room.importance(&direct)?.reflected);
        }
        let emittances: Vec<f64> = materials.iter().map(Material::emittance).collect();
        Ok(room.radiosity(&emittances)?)
    }
}
