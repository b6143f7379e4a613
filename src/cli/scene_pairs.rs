//! What all questions about the pairs of a scene share.

use super::Outcome;
use super::output::progress_bar;
use super::scene::SceneArgument;
use infoscene::form_factor::DEFAULT_TOLERANCE;
use infoscene::scene::{Account, Congruence, Occlusion, Scene, SceneError, ScenePairs, Unreached};
use std::error::Error;

#[derive(Debug, clap::Args)]
pub(super) struct ScenePairsOptions {
    #[command(flatten)]
    scene: SceneArgument,
    /// The relative error asked for of every form factor.
    #[arg(long, value_name = "REL", default_value_t = DEFAULT_TOLERANCE, value_parser = relative)]
    tolerance: f64,
    /// Compute congruent pairs, too.
    #[arg(long, hide = true)]
    every_pair: bool,
}

fn relative(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(number) if number > 0.0 && number < 1.0 => Ok(number),
        _ => Err("it must be a number between 0 and 1".to_owned()),
    }
}

impl ScenePairsOptions {
    /// The scene, whatever stands in it, for lines that end at what they first meet.
    pub(super) fn occluded_scene(&self) -> Result<Scene, Box<dyn Error>> {
        if self.is_unoccluded() {
            return Err(
                "lines at random end at what they first meet: leave out --unoccluded".into(),
            );
        }
        Ok(self.scene.read()?)
    }

    /// The scene, whatever lies or stands in it.
    pub(super) fn scene(&self) -> Result<Scene, SceneError> {
        self.scene.read()
    }

    /// Was it asked to leave out occlusion?
    pub(super) fn is_unoccluded(&self) -> bool {
        self.scene.occlusion() == Occlusion::Ignore
    }

    /// The pairs of a scene; the first pass over all of them shows its progress.
    pub(super) fn pairs(&self, scene: &Scene) -> Result<ScenePairs, Box<dyn Error>> {
        shown(self.quiet_pairs(scene)?)
    }

    /// The pairs of a scene, without progress.
    pub(super) fn quiet_pairs(&self, scene: &Scene) -> Result<ScenePairs, SceneError> {
        self.pairs_under(scene, self.scene.occlusion())
    }

    /// The pairs of a scene of which only those between these rows are asked for: elsewhere
    /// something may stand.
    pub(super) fn pairs_between(
        &self,
        scene: &Scene,
        from: Option<usize>,
        to: Option<usize>,
    ) -> Result<ScenePairs, Box<dyn Error>> {
        if !self.is_unoccluded() {
            scene.check_rows_unblocked(from, to)?;
        }
        shown(self.pairs_under(scene, Occlusion::Ignore)?)
    }

    fn pairs_under(&self, scene: &Scene, occlusion: Occlusion) -> Result<ScenePairs, SceneError> {
        let congruence = if self.every_pair {
            Congruence::Ignored
        } else {
            Congruence::Shared
        };
        ScenePairs::try_new(scene, self.tolerance, congruence, occlusion)
    }
}

/// The pairs, the first pass over all of which shows its progress.
pub(super) fn shown(pairs: ScenePairs) -> Result<ScenePairs, Box<dyn Error>> {
    let all = pairs.pairs() as u64;
    let bar = progress_bar(all, "pairs")?;
    if bar.is_hidden() {
        return Ok(pairs);
    }
    Ok(pairs.with_progress(move |more| {
        bar.inc(more as u64);
        if bar.position() >= all {
            bar.finish_and_clear();
        }
    }))
}

/// The exit status of an answer; what misses the tolerance is named on standard error.
pub(super) fn outcome(scene: &Scene, account: Option<&Account>, tolerance: f64) -> Outcome {
    let Some((account, worst)) = account.and_then(|account| Some((account, account.worst?))) else {
        return Outcome::Done;
    };
    let Unreached { first, second, .. } = worst;
    let names = scene.group_names();
    eprintln!(
        "infoscene: {} pairs miss the tolerance {tolerance:e}; the worst is {first} ({}) and {second} ({}), whose relative \
         error may be {:.0e}",
        account.unreached,
        names[first],
        names[second],
        worst.relative(),
    );
    Outcome::Differs
}
