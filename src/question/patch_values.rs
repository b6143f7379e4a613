//! Numbers for some patches of a scene: `floor=0.5,3=1`.

use super::patch_name::{PatchName, PatchNameError};
use crate::scene::{Material, MaterialError, Scene, SceneError};
use std::str::FromStr;

/// A number for some patches: `PATCH=VALUE`, or `PATCH` alone for 1.
///
/// # Examples
/// ```
/// use infoscene::question::PatchValue;
/// let lamp: PatchValue = "lamp=2.5".parse()?;
/// assert_eq!((lamp.patch, lamp.value), ("lamp".into(), 2.5));
/// # Ok::<(), infoscene::question::PatchValueError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct PatchValue {
    /// The patches.
    pub patch: PatchName,
    /// The number.
    pub value: f64,
}

/// A patch or its value was refused.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PatchValueError {
    /// The text after the equals sign is not a number.
    #[error("{text:?} is not a number: write PATCH=VALUE")]
    NotANumber {
        /// The text.
        text: String,
    },
    /// No row has this index or this name.
    #[error(transparent)]
    Name(#[from] PatchNameError),
    /// A reflectance or an emittance is out of range.
    #[error("patch {row} ({name}): {source}")]
    Material {
        /// The row, from 0.
        row: usize,
        /// The name of the patch.
        name: String,
        /// The reason.
        source: MaterialError,
    },
    /// The scene has no material for a row.
    #[error(transparent)]
    Scene(#[from] SceneError),
}

impl FromStr for PatchValue {
    type Err = PatchValueError;

    fn from_str(text: &str) -> Result<Self, PatchValueError> {
        let (patch, value) = match text.rsplit_once('=') {
            None => (text, 1.0),
            Some((patch, value)) => {
                let number = value.trim().parse();
                let number = number.map_err(|_| PatchValueError::NotANumber {
                    text: value.to_owned(),
                })?;
                (patch, number)
            }
        };
        Ok(Self {
            patch: patch.into(),
            value,
        })
    }
}

/// A value for every row of the scene: 0 where none is given, the last one where several are.
pub(super) fn values(given: &[PatchValue], scene: &Scene) -> Result<Vec<f64>, PatchValueError> {
    let mut values = vec![0.0; scene.group_count()];
    for one in given {
        for row in one.patch.rows(scene)? {
            values[row] = one.value;
        }
    }
    Ok(values)
}

/// Reflectances and emittances in place of the scene's own.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MaterialChanges {
    /// Reflectances; of several for one patch the last counts.
    pub reflectance: Vec<PatchValue>,
    /// Emittances, likewise.
    pub emittance: Vec<PatchValue>,
}

impl MaterialChanges {
    /// Whether none is given.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.reflectance.is_empty() && self.emittance.is_empty()
    }

    /// The materials of the scene's rows, with these in place of its own.
    ///
    /// # Errors
    /// [`PatchValueError::Name`], [`PatchValueError::Material`]; [`PatchValueError::Scene`]
    /// if patches that are summed differ in their materials.
    pub fn of(&self, scene: &Scene) -> Result<Vec<Material>, PatchValueError> {
        let names = scene.group_names();
        let own = (0..names.len()).map(|row| scene.group_material(row));
        let mut numbers = Vec::with_capacity(names.len());
        for material in own {
            let material = material?;
            numbers.push([material.reflectance(), material.emittance()]);
        }
        for (place, given) in [&self.reflectance, &self.emittance].into_iter().enumerate() {
            for one in given {
                for row in one.patch.rows(scene)? {
                    numbers[row][place] = one.value;
                }
            }
        }
        let materials = numbers.into_iter().zip(names).enumerate();
        materials
            .map(|(row, ([reflectance, emittance], name))| {
                Material::try_new(reflectance, emittance).map_err(|source| {
                    let name = name.to_owned();
                    PatchValueError::Material { row, name, source }
                })
            })
            .collect()
    }
}
