//! The chain of a scene that is meant, and the light that it takes.

use super::QuestionError;
use super::material_changes::{MaterialChanges, first_coloured, in_channel};
use super::patch_values::{PatchValue, values};
use crate::scene::{Channel, Channels, Scene};
use crate::transport::{RadiositySolution, SceneExchange, TransportError};

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
    /// The channel of colour, which a chain of coloured light needs: each has a chain of its own,
    /// and their mean has none.
    pub channel: Option<Channel>,
    /// Materials in place of the scene's own; none for the visibility chain.
    pub materials: MaterialChanges,
    /// Direct importances, for the importance chain.
    pub importance: Vec<PatchValue>,
}

impl Light {
    /// Whether the chain is that of visibility, which takes no light.
    ///
    /// # Errors
    /// [`QuestionError::NoLightMeant`] if light is described nevertheless.
    pub(super) fn is_visibility(&self) -> Result<bool, QuestionError> {
        let is_visibility = self.chain == SceneChain::Visibility;
        let is_described =
            !self.materials.is_empty() || !self.importance.is_empty() || self.channel.is_some();
        if is_visibility && is_described {
            return Err(QuestionError::NoLightMeant);
        }
        Ok(is_visibility)
    }

    /// The radiosities, or the reflected importances.
    pub(super) fn brightness(
        &self,
        scene: &Scene,
        exchange: &SceneExchange<'_>,
    ) -> Result<RadiositySolution, QuestionError> {
        let reflectances = self.materials.reflectances(scene)?;
        if self.chain == SceneChain::Importance {
            let channel = channel_meant(self.channel, scene, [&reflectances, &[]])?;
            let direct = values(&self.importance, scene)?;
            let found = exchange
                .system(in_channel(&reflectances, channel))
                .and_then(|room| room.importance(&direct))
                .map_err(|source| self.refused(source))?;
            return Ok(found.reflected);
        }
        let emittances = self.materials.emittances(scene)?;
        let channel = channel_meant(self.channel, scene, [&reflectances, &emittances])?;
        exchange
            .system(in_channel(&reflectances, channel))
            .and_then(|room| room.radiosity(&in_channel(&emittances, channel)))
            .map_err(|source| self.refused(source))
    }

    /// The refusal of the light in the channel that is meant.
    fn refused(&self, source: TransportError) -> QuestionError {
        match self.channel {
            Some(channel) => QuestionError::InChannel { channel, source },
            None => source.into(),
        }
    }
}

/// The channel that is meant; any one if all are the same.
pub(super) fn channel_meant(
    named: Option<Channel>,
    scene: &Scene,
    colours: [&[Channels<f64>]; 2],
) -> Result<Channel, QuestionError> {
    let coloured = colours.into_iter().find_map(first_coloured);
    match (named, coloured) {
        (None, Some(row)) => Err(QuestionError::ChannelNotNamed {
            row,
            name: scene.group_names()[row].to_owned(),
        }),
        (named, _) => Ok(named.unwrap_or(Channel::Red)),
    }
}
