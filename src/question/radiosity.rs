//! The radiosities of a scene, and the importances.

use super::QuestionError;
use super::form_factors::store::StoreToRead;
use super::lights::{ChannelLight, ChannelSolution, Power, Room};
use super::material_changes::MaterialChanges;
use super::patch_values::{PatchValue, values};
use super::scene::{SceneSource, ignored_note};
use super::unreached::Unreached;
use crate::exchange::{
    Alone, Congruence, PassSummary, PlanSummary, ProductFiles, Progress, Ranks, ScenePairs,
    StoreError, Tolerance, agreed,
};
use crate::scene::{Channels, Scene};
use crate::transport::SceneExchange;
use std::path::PathBuf;
use std::sync::Arc;

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
    /// The store that the form factors are read from, once for each product; none to compute and
    /// hold them.
    pub store: Option<PathBuf>,
    /// Whether to go on with a solution over the store that was stopped.
    pub resume: bool,
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
            store: None,
            resume: false,
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
    /// The length by which each coordinate may be off.
    pub resolution: f64,
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
    /// A bound on what the resolution of the coordinates can change of the radiosity, beside the
    /// errors; none where no bound is known.
    pub resolution_error: Option<f64>,
    /// The light by channel, if the scene is coloured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub channels: Option<Channels<ChannelLight>>,
}

impl Radiosity {
    /// Solves for the radiosities.
    ///
    /// # Errors
    /// [`QuestionError::PatchValue`]; the errors of the scene, of its pairs and of its light.
    pub fn ask(&self, progress: &dyn Progress) -> Result<RadiosityAnswer, QuestionError> {
        self.ask_among(&Alone, progress)
    }

    /// Solves for the radiosities, as one of the ranks that share the form factors out: each asks
    /// the same, and has the same answer.
    ///
    /// # Errors
    /// As [`ask`](Self::ask); [`ExchangeError::Rank`](crate::exchange::ExchangeError::Rank) of
    /// another rank's.
    pub fn ask_among(
        &self,
        ranks: &dyn Ranks,
        progress: &dyn Progress,
    ) -> Result<RadiosityAnswer, QuestionError> {
        let loaded = self.scene.open()?;
        let scene = loaded.scene;
        let mut answer = match &self.store {
            None => {
                let asked = (self.tolerance, self.congruence);
                let pairs = self.scene.pairs(&scene, asked, progress)?.among(ranks);
                self.lit(&scene, &SceneExchange::held(&pairs)?)?
            }
            Some(folder) => {
                let store = StoreToRead::of(&self.scene, (self.tolerance, self.congruence), folder);
                let pairs = store.pairs(&scene, ranks)?;
                self.over_store(&store, &scene, &pairs)?
            }
        };
        let ignored = ignored_note(answer.plan.ignored);
        answer.notes = loaded.notes.into_iter().chain(ignored).collect();
        Ok(answer)
    }

    /// The answer over a store, whose products are kept in it until the answer is there.
    fn over_store(
        &self,
        store: &StoreToRead<'_>,
        scene: &Scene,
        pairs: &ScenePairs<'_>,
    ) -> Result<RadiosityAnswer, QuestionError> {
        let matrix = store.open(scene, pairs)?;
        let products = Arc::new(ProductFiles::open(store.folder, self.resume)?);
        let exchange = SceneExchange::stored(&matrix, Some(&products))?;
        let answer = self.lit(scene, &exchange)?;
        let is_first = pairs.ranks().number() == 0;
        let cleared = if is_first { products.clear() } else { Ok(()) };
        agreed::<_, StoreError>(pairs.ranks(), cleared)?;
        Ok(answer)
    }

    /// The light of a scene.
    fn lit(
        &self,
        scene: &Scene,
        exchange: &SceneExchange<'_>,
    ) -> Result<RadiosityAnswer, QuestionError> {
        let reflectances = self.materials.reflectances(scene)?;
        let emittances = self.materials.emittances(scene)?;
        let direct = values(&self.importance, scene)?;
        let room = Room {
            exchange,
            reflectances: &reflectances,
            emittances: &emittances,
            direct: (!self.importance.is_empty()).then_some(direct.as_slice()),
        };
        let lights = room.lights()?;
        let names = scene.group_names();
        let patches = names.iter().enumerate().map(|(index, name)| {
            let (light, channels) = lights.patch(index);
            PatchLight {
                index,
                name: (*name).to_owned(),
                radiosity: light.radiosity,
                irradiance: light.irradiance,
                importance: light.importance,
                form_factor_error: light.form_factor_error,
                resolution_error: light.resolution_error,
                channels,
            }
        });
        let (solution, channels) = lights.solution();
        Ok(RadiosityAnswer {
            patches: patches.collect(),
            residual: solution.residual,
            iterations: solution.iterations,
            relative_error: solution.relative_error,
            closed: exchange.closure().is_closed(),
            resolution: scene.resolution(),
            power: solution.power,
            channels,
            plan: exchange.summary().plan.clone(),
            unreached: self.unreached(&names, exchange.summary(), solution.relative_error),
            notes: Vec::new(),
        })
    }

    fn unreached(
        &self,
        names: &[&str],
        summary: &PassSummary,
        relative_error: f64,
    ) -> Option<Unreached> {
        let tolerance = self.tolerance;
        if relative_error > tolerance.relative {
            return Some(Unreached::Radiosity {
                tolerance: tolerance.relative,
                relative_error,
            });
        }
        Unreached::pairs(names, summary, tolerance)
    }
}
