//! Materials in place of a scene's own, and the reflectances and emittances that come of both.

use super::patch_values::{PatchValue, PatchValueError};
use crate::scene::{Channel, Channels, MaterialError, Scene, SceneError};
use crate::scene::{checked_emittance, checked_reflectance};

/// Reflectances and emittances in place of the scene's own.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MaterialChanges {
    /// Reflectances; of several for one patch the last counts.
    pub reflectance: Vec<PatchValue<Channels<f64>>>,
    /// Emittances, likewise.
    pub emittance: Vec<PatchValue<Channels<f64>>>,
}

impl MaterialChanges {
    /// Whether none is given.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.reflectance.is_empty() && self.emittance.is_empty()
    }

    /// The reflectances of the scene's rows, with these in place of its own, which may be unknown
    /// there.
    ///
    /// # Errors
    /// [`PatchValueError::Name`], [`PatchValueError::Material`]; [`PatchValueError::Scene`]
    /// if a reflectance that is needed is not known, or patches that are summed differ in theirs.
    pub fn reflectances(&self, scene: &Scene) -> Result<Vec<Channels<f64>>, PatchValueError> {
        let own = |row| scene.group_reflectance(row);
        changed(&self.reflectance, scene, own, checked_reflectance)
    }

    /// The emittances of the scene's rows, with these in place of its own.
    ///
    /// # Errors
    /// As [`reflectances`](Self::reflectances).
    pub fn emittances(&self, scene: &Scene) -> Result<Vec<Channels<f64>>, PatchValueError> {
        let own = |row| scene.group_emittance(row);
        changed(&self.emittance, scene, own, checked_emittance)
    }
}

/// The values given, and for other rows their own.
fn changed(
    given: &[PatchValue<Channels<f64>>],
    scene: &Scene,
    own: impl Fn(usize) -> Result<Channels<f64>, SceneError>,
    checked: impl Fn(f64) -> Result<f64, MaterialError>,
) -> Result<Vec<Channels<f64>>, PatchValueError> {
    let names = scene.group_names();
    let mut values = vec![None; names.len()];
    for one in given {
        for row in one.patch.rows(scene)? {
            values[row] = Some(one.value);
        }
    }
    let rows = values.into_iter().zip(names).enumerate();
    rows.map(|(row, (value, name))| {
        let Some(value) = value else {
            return Ok(own(row)?);
        };
        let channel = |channel| checked(*value.of(channel));
        Channels::try_from_fn(channel).map_err(|source| {
            let name = name.to_owned();
            PatchValueError::Material { row, name, source }
        })
    })
    .collect()
}

/// The values of one channel.
pub(super) fn in_channel(colours: &[Channels<f64>], channel: Channel) -> Vec<f64> {
    colours.iter().map(|colour| *colour.of(channel)).collect()
}

/// The first row that is coloured.
pub(super) fn first_coloured(colours: &[Channels<f64>]) -> Option<usize> {
    colours.iter().position(|colour| !colour.is_grey())
}
