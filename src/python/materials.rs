//! Numbers for the rows of a scene, as Python hands them over.
//!
//! An array has a number for each row, a dictionary names those that it changes.

use super::refusal::Refusal;
use crate::question::{Light, MaterialChanges, PatchName, PatchValue, SceneChain};
use crate::scene::{Channel, Channels};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// Values for rows, each with the number or the name of what it is for.
#[derive(FromPyObject)]
pub(super) struct GivenValues {
    /// The argument's name, for refusals.
    argument: String,
    /// Whether there is a value for each row, in order.
    is_array: bool,
    values: Vec<(String, [f64; 3])>,
}

/// A chain and its light.
#[derive(FromPyObject)]
pub(super) struct GivenLight {
    chain: String,
    channel: Option<String>,
    reflectance: GivenValues,
    emittance: GivenValues,
    importance: GivenValues,
}

/// The number of values is not that of the rows.
#[derive(Debug, thiserror::Error)]
#[error("{argument} has {values} values for {rows} faces: give one for each, or a dictionary")]
struct NotOneEach {
    argument: String,
    values: usize,
    rows: usize,
}

impl GivenValues {
    /// The values in all channels, in a scene of so many rows.
    pub(super) fn colours(&self, rows: usize) -> Result<Vec<PatchValue<Channels<f64>>>, Refusal> {
        let values = self.values.len();
        if self.is_array && values != rows {
            let argument = self.argument.clone();
            return Err(NotOneEach {
                argument,
                values,
                rows,
            }
            .into());
        }
        let values = self.values.iter().map(|(patch, [r, g, b])| PatchValue {
            patch: PatchName::from(patch.as_str()),
            value: Channels {
                r: *r,
                g: *g,
                b: *b,
            },
        });
        Ok(values.collect())
    }

    /// The values, which have no channels.
    pub(super) fn numbers(&self, rows: usize) -> Result<Vec<PatchValue>, Refusal> {
        let colours = self.colours(rows)?.into_iter();
        let numbers = colours.map(|PatchValue { patch, value }| PatchValue {
            patch,
            value: value.r,
        });
        Ok(numbers.collect())
    }
}

impl GivenLight {
    /// The materials in a scene of so many rows.
    pub(super) fn materials(&self, rows: usize) -> Result<MaterialChanges, Refusal> {
        Ok(MaterialChanges {
            reflectance: self.reflectance.colours(rows)?,
            emittance: self.emittance.colours(rows)?,
        })
    }

    /// The direct importances.
    pub(super) fn importance(&self, rows: usize) -> Result<Vec<PatchValue>, Refusal> {
        self.importance.numbers(rows)
    }

    /// The channel that is meant.
    pub(super) fn channel(&self) -> PyResult<Option<Channel>> {
        let Some(name) = &self.channel else {
            return Ok(None);
        };
        let mut all = Channel::ALL.into_iter();
        let found = all.find(|channel| channel.name() == name);
        let refused = || format!("channel is {name:?}: it must be \"r\", \"g\" or \"b\"");
        found
            .map(Some)
            .ok_or_else(|| PyValueError::new_err(refused()))
    }

    /// The chain that is meant.
    pub(super) fn chain(&self) -> PyResult<SceneChain> {
        match self.chain.as_str() {
            "visibility" => Ok(SceneChain::Visibility),
            "radiosity" => Ok(SceneChain::Radiosity),
            "importance" => Ok(SceneChain::Importance),
            other => Err(PyValueError::new_err(format!(
                "chain is {other:?}: it must be \"visibility\", \"radiosity\" or \"importance\""
            ))),
        }
    }

    /// The chain and its light, in a scene of so many rows.
    pub(super) fn light(
        &self,
        (chain, channel): (SceneChain, Option<Channel>),
        rows: usize,
    ) -> Result<Light, Refusal> {
        Ok(Light {
            chain,
            channel,
            materials: self.materials(rows)?,
            importance: self.importance(rows)?,
        })
    }
}
