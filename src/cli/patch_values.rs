//! Numbers for some patches of a scene: `floor=0.5,3=1`.

use infoscene::scene::{Material, MaterialError, Scene, SceneError};
use std::str::FromStr;

/// `PATCH=VALUE`, or `PATCH` alone for 1; PATCH is an index, a name, or `all`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PatchValue {
    patch: String,
    value: f64,
}

/// A patch or its value was refused.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(super) enum PatchValueError {
    #[error("{0:?} is not a number: write PATCH=VALUE")]
    NotANumber(String),
    #[error("there is no patch {0:?}: name one, give its index from 0 to {1}, or say all")]
    NoSuchPatch(String, usize),
    #[error("patch {0} ({1}): {2}")]
    Material(usize, String, MaterialError),
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
                let number = number.map_err(|_| PatchValueError::NotANumber(value.to_owned()))?;
                (patch, number)
            }
        };
        Ok(Self {
            patch: patch.trim().to_owned(),
            value,
        })
    }
}

impl PatchValue {
    /// The rows meant: all of a name, as a file may use it more than once.
    fn rows(&self, names: &[&str]) -> Result<Vec<usize>, PatchValueError> {
        let all = 0..names.len();
        let named = |index: &usize| names[*index] == self.patch;
        let meant: Vec<usize> = if self.patch == "all" {
            all.collect()
        } else {
            match self.patch.parse::<usize>() {
                Ok(index) => all.filter(|other| *other == index).collect(),
                Err(_) => all.filter(named).collect(),
            }
        };
        if meant.is_empty() {
            let last = names.len() - 1;
            return Err(PatchValueError::NoSuchPatch(self.patch.clone(), last));
        }
        Ok(meant)
    }
}

/// A value for every row of the scene: 0 where none is given, the last one where several are.
pub(super) fn values(given: &[PatchValue], scene: &Scene) -> Result<Vec<f64>, PatchValueError> {
    let names = scene.group_names();
    let mut values = vec![0.0; names.len()];
    for one in given {
        for row in one.rows(&names)? {
            values[row] = one.value;
        }
    }
    Ok(values)
}

/// Materials given beside the scene's own.
#[derive(Debug, clap::Args)]
pub(super) struct Materials {
    /// Reflectances in place of the scene's: PATCH=VALUE,…; PATCH is an index, a name, or all.
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    reflectance: Vec<PatchValue>,
    /// Emittances in place of the scene's: PATCH=VALUE,…, or PATCH alone for 1.
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    emittance: Vec<PatchValue>,
}

impl Materials {
    /// Is none given?
    pub(super) const fn is_empty(&self) -> bool {
        self.reflectance.is_empty() && self.emittance.is_empty()
    }

    /// The materials of the scene's rows, with these in place of its own.
    pub(super) fn of(&self, scene: &Scene) -> Result<Vec<Material>, PatchValueError> {
        let names = scene.group_names();
        let own = (0..names.len()).map(|row| scene.group_material(row));
        let mut numbers = Vec::with_capacity(names.len());
        for material in own {
            let material = material?;
            numbers.push([material.reflectance(), material.emittance()]);
        }
        for (place, given) in [&self.reflectance, &self.emittance].into_iter().enumerate() {
            for one in given {
                for row in one.rows(&names)? {
                    numbers[row][place] = one.value;
                }
            }
        }
        let materials = numbers.into_iter().zip(names).enumerate();
        materials
            .map(|(row, ([reflectance, emittance], name))| {
                Material::try_new(reflectance, emittance)
                    .map_err(|error| PatchValueError::Material(row, name.to_owned(), error))
            })
            .collect()
    }
}
