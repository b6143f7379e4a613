//! Which chain of a scene is meant, and the light that it takes.

use super::patch_values::{Materials, PatchValue, values};
use infoscene::exchange::ExchangeAreas;
use infoscene::scene::{Material, Scene};
use infoscene::transport::{RadiositySolution, RadiositySystem};
use std::error::Error;

#[derive(Debug, clap::Args)]
pub(super) struct Light {
    /// The chain that is meant.
    #[arg(long, value_enum, default_value_t = Chain::Visibility)]
    chain: Chain,
    #[command(flatten)]
    materials: Materials,
    /// Direct importances, for the importance chain: PATCH=VALUE,…, or PATCH alone for 1; PATCH is an index, a name, or all.
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    importance: Vec<PatchValue>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Chain {
    /// Weights are areas, transitions form factors.
    Visibility,
    /// Weighted with the radiosities: weights are generalised areas (§3.4).
    Radiosity,
    /// Weighted with the reflected importances (§3.5).
    Importance,
}

/// Light was described for a chain without any.
#[derive(Debug, thiserror::Error)]
#[error("the visibility chain has no light: add --chain radiosity or --chain importance")]
struct NoLightMeant;

impl Light {
    /// Is it the visibility chain, which takes no light?
    ///
    /// # Errors
    /// If light is described nevertheless.
    pub(super) fn is_visibility(&self) -> Result<bool, Box<dyn Error>> {
        let is_visibility = self.chain == Chain::Visibility;
        if is_visibility && !(self.materials.is_empty() && self.importance.is_empty()) {
            return Err(NoLightMeant.into());
        }
        Ok(is_visibility)
    }

    /// The radiosities, or the reflected importances.
    pub(super) fn brightness(
        &self,
        scene: &Scene,
        exchange: &ExchangeAreas,
    ) -> Result<RadiositySolution, Box<dyn Error>> {
        let materials = self.materials.of(scene)?;
        let room = RadiositySystem::of(exchange, &materials)?;
        if self.chain == Chain::Importance {
            let direct = values(&self.importance, scene)?;
            return Ok(room.importance(&direct)?.reflected);
        }
        let emittances: Vec<f64> = materials.iter().map(Material::emittance).collect();
        Ok(room.radiosity(&emittances)?)
    }
}
