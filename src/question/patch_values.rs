//! Numbers for some patches of a scene: `floor=0.5,3=1`.

use super::patch_name::{PatchName, PatchNameError};
use crate::scene::{Channels, MaterialError, Scene, SceneError};
use std::str::FromStr;

/// A number for some patches, or one for each channel: `PATCH=VALUE`, or `PATCH` alone for 1, or
/// `PATCH=R:G:B`.
///
/// # Examples
/// ```
/// use infoscene::question::PatchValue;
/// use infoscene::scene::Channels;
/// let lamp: PatchValue = "lamp=2.5".parse()?;
/// assert_eq!((lamp.patch, lamp.value), ("lamp".into(), 2.5));
/// let red: PatchValue<Channels<f64>> = "wall=0.9:0.1:0.1".parse()?;
/// assert_eq!(red.value, Channels { r: 0.9, g: 0.1, b: 0.1 });
/// # Ok::<(), infoscene::question::PatchValueError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct PatchValue<T = f64> {
    /// The patches.
    pub patch: PatchName,
    /// The number, or the numbers.
    pub value: T,
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
    /// The text after the equals sign is not a number, nor three of them.
    #[error(
        "{text:?} is not a number, nor three as in 0.5:0.4:0.3: write PATCH=VALUE or PATCH=R:G:B"
    )]
    NotAColour {
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
        Self::parsed(text, 1.0, |text| {
            text.parse().map_err(|_| PatchValueError::NotANumber {
                text: text.to_owned(),
            })
        })
    }
}

impl FromStr for PatchValue<Channels<f64>> {
    type Err = PatchValueError;

    fn from_str(text: &str) -> Result<Self, PatchValueError> {
        Self::parsed(text, Channels::grey(1.0), |text| {
            let numbers = text.split(':').map(|number| number.trim().parse());
            let numbers: Result<Vec<f64>, _> = numbers.collect();
            match numbers.as_deref() {
                Ok([all]) => Ok(Channels::grey(*all)),
                Ok([r, g, b]) => Ok(Channels {
                    r: *r,
                    g: *g,
                    b: *b,
                }),
                _ => Err(PatchValueError::NotAColour {
                    text: text.to_owned(),
                }),
            }
        })
    }
}

impl<T> PatchValue<T> {
    /// `PATCH=VALUE`, or `PATCH` alone for one.
    fn parsed(
        text: &str,
        one: T,
        value: impl Fn(&str) -> Result<T, PatchValueError>,
    ) -> Result<Self, PatchValueError> {
        let (patch, value) = match text.rsplit_once('=') {
            None => (text, one),
            Some((patch, text)) => (patch, value(text.trim())?),
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
