//! The radiosities of a scene, and the importances.

use super::QuestionError;
use super::patch_values::{MaterialChanges, PatchValue, values};
use super::scene::SceneSource;
use super::unreached::Unreached;
use crate::exchange::{Closure, Congruence, ExchangeAreas, PlanSummary, Progress, Tolerance};
use crate::numeric::compensated_sum;
use crate::scene::Material;
use crate::transport::{RadiositySolution, RadiositySystem};

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

/// The light of a scene, as a record whose keys are relied on by scripts.
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
    /// The length by which each coordinate may be off.
    pub resolution: f64,
    /// The balance of power.
    pub power: Power,
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
    /// A bound on what the resolution of the coordinates can change of the radiosity, beside the
    /// errors; none where no bound is known.
    pub resolution_error: Option<f64>,
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

impl Power {
    fn of(
        materials: &[Material],
        areas: &[f64],
        closure: &Closure,
        radiosity: &RadiositySolution,
    ) -> Self {
        let sum = |term: &dyn Fn(usize) -> f64| {
            compensated_sum(areas.iter().enumerate().map(|(i, area)| area * term(i)))
        };
        Self {
            emitted: sum(&|i| materials[i].emittance()),
            absorbed: sum(&|i| (1.0 - materials[i].reflectance()) * radiosity.received[i]),
            escaped: sum(&|i| closure.escaping(i) * radiosity.values[i]),
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
        let materials = self.materials.of(&scene)?;
        let direct = values(&self.importance, &scene)?;
        let asked = (self.tolerance, self.congruence);
        let pairs = self.scene.pairs(&scene, asked, progress)?;
        let exchange = pairs.exchange_areas()?;
        let room = RadiositySystem::of(&exchange, &materials)?;
        let emittances: Vec<f64> = materials.iter().map(Material::emittance).collect();
        let radiosity = room.radiosity(&emittances)?;
        let importance = if self.importance.is_empty() {
            None
        } else {
            Some(room.importance(&direct)?)
        };
        let names = scene.group_names();
        let errors = radiosity.form_factor_errors.as_ref();
        let moved = match exchange.resolution_errors() {
            None => Some(vec![0.0; names.len()]),
            Some(bounds) => room.resolution_errors(bounds, &radiosity.values, &emittances),
        };
        let patches = names.iter().enumerate().map(|(index, name)| PatchLight {
            index,
            name: (*name).to_owned(),
            radiosity: radiosity.values[index],
            irradiance: radiosity.received[index],
            importance: importance.as_ref().map(|found| found.values[index]),
            form_factor_error: errors.map(|errors| errors[index]),
            resolution_error: moved.as_ref().map(|errors| errors[index]),
        });
        let closure = Closure::of_held(&exchange);
        Ok(RadiosityAnswer {
            patches: patches.collect(),
            residual: radiosity.residual,
            iterations: radiosity.iterations,
            relative_error: radiosity.relative_error,
            closed: closure.is_closed(),
            resolution: scene.resolution(),
            power: Power::of(&materials, exchange.areas(), &closure, &radiosity),
            plan: exchange.summary().plan.clone(),
            unreached: self.unreached(&names, &exchange, &radiosity),
            notes: loaded.notes,
        })
    }

    fn unreached(
        &self,
        names: &[&str],
        exchange: &ExchangeAreas,
        radiosity: &RadiositySolution,
    ) -> Option<Unreached> {
        let RadiositySolution { relative_error, .. } = *radiosity;
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
