//! The radiosities of a scene, and the importances.

use super::QuestionError;
use super::material_changes::{MaterialChanges, first_coloured, in_channel};
use super::patch_values::{PatchValue, values};
use super::scene::SceneSource;
use super::unreached::Unreached;
use crate::exchange::{Closure, Congruence, ExchangeAreas, PlanSummary, Progress, Tolerance};
use crate::numeric::compensated_sum;
use crate::scene::{Channel, Channels};
use crate::transport::{Importance, RadiositySolution, RadiositySystem, TransportError};

/// The question for the radiosities of a scene.
///
/// # Examples
/// ```
/// use infoscene::exchange::Unheard;
/// use infoscene::question::{MaterialChanges, Radiosity};
/// let furnace = Radiosity {
///     scene: "cube:2".into(),
///     materials: MaterialChanges {
///         reflectance: vec!["all=0.75".parse()?],
///         emittance: vec!["all=1".parse()?],
///     },
///     ..Radiosity::default()
/// };
/// // a closed room of one material: B = E/(1 − R) everywhere
/// for patch in furnace.ask(&Unheard)?.patches {
///     assert!((patch.radiosity - 4.0).abs() < 1e-10);
/// }
/// # Ok::<(), infoscene::question::QuestionError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Radiosity {
    /// The scene.
    pub scene: SceneSource,
    /// The error that is accepted of every form factor; its relative one of the radiosities, too.
    pub tolerance: Tolerance,
    /// The treatment of congruent pairs.
    pub congruence: Congruence,
    /// Materials in place of the scene's own.
    pub materials: MaterialChanges,
    /// Direct importances: if some are given, importances are computed, too.
    pub importance: Vec<PatchValue>,
}

impl Default for Radiosity {
    /// The scene's own materials, to the default tolerance.
    fn default() -> Self {
        Self {
            scene: SceneSource::default(),
            tolerance: Tolerance::default(),
            congruence: Congruence::Shared,
            materials: MaterialChanges::default(),
            importance: Vec::new(),
        }
    }
}

/// The light of a scene, as a record whose keys are relied on by scripts. In a coloured scene each
/// channel is solved by itself: lights and powers are their means, the residual and the error are
/// their largest, iterations their sum.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[non_exhaustive]
pub struct RadiosityAnswer {
    /// The rows.
    pub patches: Vec<PatchLight>,
    /// The largest `|B_i − E_i − R_i H_i|/B_i`.
    pub residual: f64,
    /// Products with the matrix.
    pub iterations: usize,
    /// A bound on the relative error of each radiosity, for the form factors as computed.
    pub relative_error: f64,
    /// Do all rows of form factors sum to one?
    pub closed: bool,
    /// The balance of power.
    pub power: Power,
    /// The solutions by channel, if the scene is coloured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub channels: Option<Channels<ChannelSolution>>,
    /// The pairs that were left out, shared and computed.
    pub plan: PlanSummary,
    /// The tolerance that is missed, if one is.
    #[serde(skip)]
    pub unreached: Option<Unreached>,
    /// Remarks of the scene's reader.
    #[serde(skip)]
    pub notes: Vec<String>,
}

/// The light of one row: the keys are relied on by scripts.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct PatchLight {
    /// The row, from 0.
    pub index: usize,
    /// The name of the row.
    pub name: String,
    /// The radiosity, in the unit of the emittances.
    pub radiosity: f64,
    /// The irradiance, in the same unit.
    pub irradiance: f64,
    /// The importance, if it was asked for.
    pub importance: Option<f64>,
    /// A bound on the error that the form factors' errors bring to the radiosity; none where no
    /// bound is known.
    pub form_factor_error: Option<f64>,
    /// The light by channel, if the scene is coloured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub channels: Option<Channels<ChannelLight>>,
}

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

/// A room in one channel.
struct Lit {
    radiosity: RadiositySolution,
    importance: Option<Importance>,
    power: Power,
}

impl Lit {
    fn power(
        [reflectances, emittances]: [&[f64]; 2],
        areas: &[f64],
        closure: &Closure,
        radiosity: &RadiositySolution,
    ) -> Power {
        let sum = |term: &dyn Fn(usize) -> f64| {
            compensated_sum(areas.iter().enumerate().map(|(i, area)| area * term(i)))
        };
        Power {
            emitted: sum(&|i| emittances[i]),
            absorbed: sum(&|i| (1.0 - reflectances[i]) * radiosity.received[i]),
            escaped: sum(&|i| closure.escaping(i) * radiosity.values[i]),
        }
    }

    fn patch(&self, row: usize) -> ChannelLight {
        let errors = self.radiosity.form_factor_errors.as_ref();
        let importance = self.importance.as_ref();
        ChannelLight {
            radiosity: self.radiosity.values[row],
            irradiance: self.radiosity.received[row],
            importance: importance.map(|found| found.values[row]),
            form_factor_error: errors.map(|errors| errors[row]),
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

impl Radiosity {
    /// Solves for the radiosities.
    ///
    /// # Errors
    /// [`QuestionError::PatchValue`]; the errors of the scene, of its pairs and of its light.
    pub fn ask(&self, progress: &dyn Progress) -> Result<RadiosityAnswer, QuestionError> {
        let loaded = self.scene.open()?;
        let scene = loaded.scene;
        let reflectances = self.materials.reflectances(&scene)?;
        let emittances = self.materials.emittances(&scene)?;
        let direct = values(&self.importance, &scene)?;
        let asked = (self.tolerance, self.congruence);
        let pairs = self.scene.pairs(&scene, asked, progress)?;
        let exchange = pairs.exchange_areas()?;
        let closure = Closure::of_held(&exchange);
        let lit = |channel, or_dark| {
            let colours = [&reflectances, &emittances].map(|all| in_channel(all, channel));
            let colours = colours.each_ref().map(Vec::as_slice);
            self.lit(&exchange, &closure, colours, (&direct, or_dark))
        };
        let coloured = [&reflectances, &emittances].map(|all| first_coloured(all));
        let lights = if coloured.iter().any(Option::is_some) {
            // one channel at least must have light
            let shines = |channel| in_channel(&emittances, channel).iter().any(|e| *e > 0.0);
            let or_dark = Channel::ALL.into_iter().any(shines);
            let lit = |channel| {
                lit(channel, or_dark).map_err(|source| QuestionError::InChannel { channel, source })
            };
            Lights::Coloured(Box::new(Channels::try_from_fn(lit)?))
        } else {
            Lights::Grey(lit(Channel::Red, false)?)
        };
        let names = scene.group_names();
        let mut answer = lights.answer(&names, closure.is_closed(), &exchange);
        answer.unreached = self.unreached(&names, &exchange, answer.relative_error);
        answer.notes = loaded.notes;
        Ok(answer)
    }

    /// The light of one channel: dark without a source, if that is allowed.
    fn lit(
        &self,
        exchange: &ExchangeAreas,
        closure: &Closure,
        [reflectances, emittances]: [&[f64]; 2],
        (direct, or_dark): (&[f64], bool),
    ) -> Result<Lit, TransportError> {
        let room = RadiositySystem::with_reflectances(exchange, reflectances.to_vec())?;
        let radiosity = if or_dark && emittances.iter().all(|emittance| *emittance <= 0.0) {
            RadiositySolution::dark(emittances.len())
        } else {
            room.radiosity(emittances)?
        };
        let importance = if self.importance.is_empty() {
            None
        } else {
            Some(room.importance(direct)?)
        };
        let colours = [reflectances, emittances];
        Ok(Lit {
            power: Lit::power(colours, exchange.areas(), closure, &radiosity),
            radiosity,
            importance,
        })
    }

    fn unreached(
        &self,
        names: &[&str],
        exchange: &ExchangeAreas,
        relative_error: f64,
    ) -> Option<Unreached> {
        let tolerance = self.tolerance;
        if relative_error > tolerance.relative {
            return Some(Unreached::Radiosity {
                tolerance: tolerance.relative,
                relative_error,
            });
        }
        Unreached::pairs(names, exchange.summary(), tolerance)
    }
}

/// The light of a scene in all channels.
enum Lights {
    /// The same in all of them.
    Grey(Lit),
    /// One for each.
    Coloured(Box<Channels<Lit>>),
}

impl Lights {
    /// The light of a row, and that of its channels.
    fn patch(&self, row: usize) -> (ChannelLight, Option<Channels<ChannelLight>>) {
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
        };
        (light, Some(channels))
    }

    /// The solution, and those of its channels.
    fn solution(&self) -> (ChannelSolution, Option<Channels<ChannelSolution>>) {
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

    fn answer(&self, names: &[&str], closed: bool, exchange: &ExchangeAreas) -> RadiosityAnswer {
        let patches = names.iter().enumerate().map(|(index, name)| {
            let (light, channels) = self.patch(index);
            PatchLight {
                index,
                name: (*name).to_owned(),
                radiosity: light.radiosity,
                irradiance: light.irradiance,
                importance: light.importance,
                form_factor_error: light.form_factor_error,
                channels,
            }
        });
        let (solution, channels) = self.solution();
        RadiosityAnswer {
            patches: patches.collect(),
            residual: solution.residual,
            iterations: solution.iterations,
            relative_error: solution.relative_error,
            closed,
            power: solution.power,
            channels,
            plan: exchange.summary().plan.clone(),
            unreached: None,
            notes: Vec::new(),
        }
    }
}
