//! The light of a scene, each channel by itself, and their means.
//!
//! ```text
//!   r, g, b:  B = E + R F B        B̄ = (B_r + B_g + B_b)/3
//! ```
//!
//! The mean of the reflectances does not give the mean of the radiosities. A grey scene is solved
//! once and has no channels.

use super::QuestionError;
use super::material_changes::{first_coloured, in_channel};
use crate::numeric::compensated_sum;
use crate::scene::{Channel, Channels};
use crate::transport::{Importance, RadiositySolution, SceneExchange, TransportError};

/// The light of one row in one channel: the keys are relied on by scripts.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct ChannelLight {
    /// The radiosity.
    pub radiosity: f64,
    /// The irradiance.
    pub irradiance: f64,
    /// The importance, if it was asked for.
    pub importance: Option<f64>,
    /// A bound on the error that the form factors' errors bring to the radiosity.
    pub form_factor_error: Option<f64>,
    /// A bound on what the resolution of the coordinates can change of the radiosity.
    pub resolution_error: Option<f64>,
}

/// The solution of one channel: the keys are relied on by scripts.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct ChannelSolution {
    /// The largest `|B_i − E_i − R_i H_i|/B_i`.
    pub residual: f64,
    /// Products with the matrix.
    pub iterations: usize,
    /// A bound on the relative error of each radiosity, for the form factors as computed.
    pub relative_error: f64,
    /// The balance of power.
    pub power: Power,
}

/// The balance of power: emitted light is absorbed or escapes.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Power {
    /// The power that is emitted.
    pub emitted: f64,
    /// The power that is absorbed.
    pub absorbed: f64,
    /// The power that escapes.
    pub escaped: f64,
}

/// A room that is to be lit.
pub(super) struct Room<'r> {
    pub(super) exchange: &'r SceneExchange<'r>,
    pub(super) reflectances: &'r [Channels<f64>],
    pub(super) emittances: &'r [Channels<f64>],
    /// Direct importances, if importances are asked for.
    pub(super) direct: Option<&'r [f64]>,
}

impl Room<'_> {
    /// The light in all channels, one of which has some at least.
    pub(super) fn lights(&self) -> Result<Lights, QuestionError> {
        let coloured = [self.reflectances, self.emittances].map(first_coloured);
        if coloured.iter().all(Option::is_none) {
            let lit = self.lit(Channel::Red, false)?;
            return Ok(Lights::Grey(Box::new(lit)));
        }
        let or_dark = self.emittances.iter().any(|colour| colour.largest() > 0.0);
        let lit = |channel| {
            let lit = self.lit(channel, or_dark);
            lit.map_err(|source| QuestionError::InChannel { channel, source })
        };
        Ok(Lights::Coloured(Box::new(Channels::try_from_fn(lit)?)))
    }

    /// The light of one channel; without a source it is dark, if that is allowed.
    fn lit(&self, channel: Channel, or_dark: bool) -> Result<Lit, TransportError> {
        let [reflectances, emittances] =
            [self.reflectances, self.emittances].map(|all| in_channel(all, channel));
        let room = self.exchange.system(reflectances.clone())?;
        let radiosity = if or_dark && emittances.iter().all(|emittance| *emittance <= 0.0) {
            RadiositySolution::dark(emittances.len())
        } else {
            room.radiosity(&emittances)?
        };
        let importance = self.direct.map(|direct| room.importance(direct));
        let moved = self
            .exchange
            .resolution_errors(&room, &radiosity.values, &emittances)?;
        Ok(Lit {
            power: self.power(&reflectances, &emittances, &radiosity),
            radiosity,
            importance: importance.transpose()?,
            moved,
        })
    }

    fn power(&self, reflectances: &[f64], emittances: &[f64], found: &RadiositySolution) -> Power {
        let areas = self.exchange.areas().iter().enumerate();
        let sum = |term: &dyn Fn(usize) -> f64| {
            compensated_sum(areas.clone().map(|(i, area)| area * term(i)))
        };
        Power {
            emitted: sum(&|i| emittances[i]),
            absorbed: sum(&|i| (1.0 - reflectances[i]) * found.received[i]),
            escaped: sum(&|i| self.exchange.closure().escaping(i) * found.values[i]),
        }
    }
}

/// A room in one channel.
pub(super) struct Lit {
    radiosity: RadiositySolution,
    importance: Option<Importance>,
    /// Bounds on what the resolution can change.
    moved: Option<Vec<f64>>,
    power: Power,
}

impl Lit {
    fn patch(&self, row: usize) -> ChannelLight {
        let errors = self.radiosity.form_factor_errors.as_ref();
        let importance = self.importance.as_ref();
        ChannelLight {
            radiosity: self.radiosity.values[row],
            irradiance: self.radiosity.received[row],
            importance: importance.map(|found| found.values[row]),
            form_factor_error: errors.map(|errors| errors[row]),
            resolution_error: self.moved.as_ref().map(|errors| errors[row]),
        }
    }

    const fn solution(&self) -> ChannelSolution {
        ChannelSolution {
            residual: self.radiosity.residual,
            iterations: self.radiosity.iterations,
            relative_error: self.radiosity.relative_error,
            power: self.power,
        }
    }
}

/// The light of a scene in all channels.
pub(super) enum Lights {
    /// One light for all of them.
    Grey(Box<Lit>),
    /// A light for each.
    Coloured(Box<Channels<Lit>>),
}

impl Lights {
    /// The light of a row, and that of its channels.
    pub(super) fn patch(&self, row: usize) -> (ChannelLight, Option<Channels<ChannelLight>>) {
        let channels = match self {
            Self::Grey(lit) => return (lit.patch(row), None),
            Self::Coloured(lights) => lights.map(|lit| lit.patch(row)),
        };
        let mean = |of: fn(&ChannelLight) -> f64| channels.map(of).mean();
        let known = |of: fn(&ChannelLight) -> Option<f64>| {
            Channels::try_from_fn(|channel| of(channels.of(channel)).ok_or(()))
                .ok()
                .map(|all| all.mean())
        };
        let light = ChannelLight {
            radiosity: mean(|light| light.radiosity),
            irradiance: mean(|light| light.irradiance),
            importance: known(|light| light.importance),
            form_factor_error: known(|light| light.form_factor_error),
            resolution_error: known(|light| light.resolution_error),
        };
        (light, Some(channels))
    }

    /// The solution, and those of its channels.
    pub(super) fn solution(&self) -> (ChannelSolution, Option<Channels<ChannelSolution>>) {
        let channels = match self {
            Self::Grey(lit) => return (lit.solution(), None),
            Self::Coloured(lights) => lights.map(Lit::solution),
        };
        let mean = |of: fn(&Power) -> f64| channels.map(|channel| of(&channel.power)).mean();
        let solution = ChannelSolution {
            residual: channels.map(|channel| channel.residual).largest(),
            iterations: channels.iter().map(|channel| channel.iterations).sum(),
            relative_error: channels.map(|channel| channel.relative_error).largest(),
            power: Power {
                emitted: mean(|power| power.emitted),
                absorbed: mean(|power| power.absorbed),
                escaped: mean(|power| power.escaped),
            },
        };
        (solution, Some(channels))
    }
}
