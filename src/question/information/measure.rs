//! The information of a scene: entropies, mutual information, and what is lost of the continuous
//! one.

use super::measured::{MeasureAnswer, PairLossRecord};
use crate::chain::ChainError;
use crate::exchange::{Alone, Congruence, ExchangeError, Progress, Ranks, Tolerance};
use crate::information::{
    OpenScene, SceneInformation, brightness_information, chord_information, continuous_information,
    pair_losses, scene_information,
};
use crate::question::QuestionError;
use crate::question::form_factors::store::StoreToRead;
use crate::question::light::Light;
use crate::question::scene::{SceneSource, ignored_note};
use crate::question::unreached::Unreached;
use crate::scene::{Occlusion, Scene, SceneError};
use crate::transport::SceneExchange;
use std::path::PathBuf;

/// The question for the information of a scene.
///
/// # Examples
/// ```
/// use infoscene::exchange::Unheard;
/// use infoscene::question::Measure;
/// let cube = Measure { scene: "cube:1".into(), ..Measure::default() };
/// // one patch per face, from a 50-digit evaluation
/// let measured = cube.ask(&Unheard)?;
/// assert!((measured.mutual_information - 0.263_034_544_099_12).abs() < 1e-14);
/// # Ok::<(), infoscene::question::QuestionError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Measure {
    /// The scene.
    pub scene: SceneSource,
    /// The error that is accepted of every form factor.
    pub tolerance: Tolerance,
    /// The treatment of congruent pairs.
    pub congruence: Congruence,
    /// The chain that is meant, and its light.
    pub light: Light,
    /// The treatment of power that meets no patch; light needs no state for it.
    pub open_scene: OpenScene,
    /// Whether the continuous mutual information is asked for, too: the room must be closed, and
    /// convex inside unless something stands in the way; then it is sampled.
    pub continuous: bool,
    /// Whether the losses of the pairs of patches are asked for, too.
    pub pairs: bool,
    /// The store that the form factors are read from; none to compute them.
    pub store: Option<PathBuf>,
}

impl Default for Measure {
    /// The visibility chain of a closed scene, to the default tolerance.
    fn default() -> Self {
        Self {
            scene: SceneSource::default(),
            tolerance: Tolerance::default(),
            congruence: Congruence::Shared,
            light: Light::default(),
            open_scene: OpenScene::Refuse,
            continuous: false,
            pairs: false,
            store: None,
        }
    }
}

/// The number of random lines that the continuous mutual information is sampled with, where
/// something stands in the way, and their seed; [`Sample`](crate::question::Sample) takes others.
const CHORDS: u32 = 1_000_000;
const SEED: u64 = 1;

impl Measure {
    /// Measures the scene.
    ///
    /// # Errors
    /// [`QuestionError::OpenScene`] if the scene is open and no state was asked for what escapes;
    /// [`QuestionError::Chain`] if the continuous mutual information is asked for and lines escape;
    /// [`QuestionError::NoLightMeant`]; the errors of the scene, of its pairs and of its light.
    pub fn ask(&self, progress: &dyn Progress) -> Result<MeasureAnswer, QuestionError> {
        self.ask_among(&Alone, progress)
    }

    /// Measures the scene as one of the ranks that share its pairs out: each asks the same, and has
    /// the same answer.
    ///
    /// # Errors
    /// As [`ask`](Self::ask); [`ExchangeError::Rank`] of another rank's.
    pub fn ask_among(
        &self,
        ranks: &dyn Ranks,
        progress: &dyn Progress,
    ) -> Result<MeasureAnswer, QuestionError> {
        let loaded = self.scene.open()?;
        let scene = loaded.scene;
        let is_sampled = self.is_sampled(&scene)?;
        let measured = self.measured(&scene, ranks, progress)?;
        let names = scene.group_names();
        let unreached = Unreached::pairs(&names, &measured.summary, self.tolerance);
        let mut answer = MeasureAnswer::new(&names, measured);
        answer.channel = self.light.channel;
        answer.unreached = unreached;
        answer.resolution = scene.resolution();
        answer.notes = loaded.notes;
        answer.notes.extend(ignored_note(answer.plan.ignored));
        if is_sampled {
            let is_visibility = self.light.is_visibility()?;
            let chords = chord_information(&scene, CHORDS, SEED)?;
            answer.add_sampled(chords, is_visibility);
        } else if self.continuous || self.pairs {
            self.compare(&scene, &mut answer, progress)?;
        }
        Ok(answer)
    }

    /// The information of the chain that is meant.
    fn measured(
        &self,
        scene: &Scene,
        ranks: &dyn Ranks,
        progress: &dyn Progress,
    ) -> Result<SceneInformation, QuestionError> {
        let asked = (self.tolerance, self.congruence);
        let is_visibility = self.light.is_visibility()?;
        if let Some(folder) = &self.store {
            let store = StoreToRead::of(&self.scene, asked, folder);
            let pairs = store.pairs(scene, ranks)?;
            let matrix = store.open(scene, &pairs)?;
            if is_visibility {
                return scene_information(&matrix, self.open_scene).map_err(refused);
            }
            let exchange = SceneExchange::stored(&matrix, None)?;
            let brightness = self.light.brightness(scene, &exchange)?;
            return Ok(brightness_information(&matrix, &brightness)?);
        }
        let pairs = self.scene.pairs(scene, asked, progress)?.among(ranks);
        if is_visibility {
            return scene_information(&pairs, self.open_scene).map_err(refused);
        }
        let exchange = SceneExchange::held(&pairs)?;
        let brightness = self.light.brightness(scene, &exchange)?;
        Ok(brightness_information(exchange.lower_pairs(), &brightness)?)
    }

    /// Whether the continuous mutual information is to be sampled, as something stands in the way:
    /// told before the pass. Refused if the losses of pairs are asked for, or if a resolution of
    /// the coordinates would clear the way.
    fn is_sampled(&self, scene: &Scene) -> Result<bool, SceneError> {
        if !(self.continuous || self.pairs) || self.scene.occlusion != Occlusion::Exact {
            return Ok(false);
        }
        match Occlusion::Refuse.check(scene) {
            Err(SceneError::MayBeBlocked {
                resolution: None, ..
            }) if !self.pairs => Ok(true),
            checked => checked.map(|()| false),
        }
    }

    /// Adds the continuous mutual information, and what pairs lose against it.
    fn compare(
        &self,
        scene: &Scene,
        answer: &mut MeasureAnswer,
        progress: &dyn Progress,
    ) -> Result<(), QuestionError> {
        // without obstructions nothing is in the way in a room that is convex inside
        let bare = (self.scene.occlusion == Occlusion::Ignore).then(|| scene.clone());
        let bare = bare.map(|scene| scene.with_obstructions(Vec::new()));
        let room = bare.as_ref().unwrap_or(scene);
        if self.continuous {
            answer.add_continuous(scene, &continuous_information(room)?);
        }
        if self.pairs {
            let patches = scene.patches().len() as u64;
            progress.begin(patches * (patches - 1) / 2, "pairs");
            let losses = pair_losses(room, progress)?;
            let record = |pair| PairLossRecord::new(pair, scene);
            answer.pair_losses = Some(losses.iter().map(record).collect());
        }
        Ok(())
    }
}

/// An open scene could have been taken.
fn refused(error: ChainError) -> QuestionError {
    match error {
        ChainError::Exchange(error @ ExchangeError::OpenScene { .. }) => {
            QuestionError::OpenScene(error)
        }
        other => other.into(),
    }
}
