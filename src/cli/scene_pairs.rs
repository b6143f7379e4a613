//! What all questions about the pairs of a scene share.

use super::Outcome;
use super::output::progress_bar;
use super::scene::SceneArgument;
use infoscene::form_factor::DEFAULT_TOLERANCE;
use infoscene::scene::{Account, Blockers, Congruence, Scene, SceneError, ScenePairs, Unreached};
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
        if self.scene.is_unoccluded() {
            return Err(
                "lines at random end at what they first meet: leave out --unoccluded".into(),
            );
        }
        Ok(self.scene.read()?)
    }

    /// The scene, if nothing stands between the rows asked for.
    pub(super) fn scene(
        &self,
        from: Option<usize>,
        to: Option<usize>,
    ) -> Result<Scene, SceneError> {
        if self.scene.is_unoccluded() {
            return self.scene.read();
        }
        let (one, other) = match (from, to) {
            (None, None) => return self.scene.unblocked(),
            (Some(one), other) => (one, other),
            (None, Some(one)) => (one, None),
        };
        let scene = self.scene.read()?;
        let last = scene.group_count() - 1;
        for index in [from, to].into_iter().flatten() {
            if index > last {
                return Err(SceneError::NoSuchPatch { index, last });
            }
        }
        let blockers = Blockers::of(&scene);
        for first in scene.patches_of_group(one) {
            let found = match other {
                None => blockers.of_row(first),
                Some(other) => scene
                    .patches_of_group(other)
                    .find_map(|second| blockers.of_pair(first, second)),
            };
            if let Some(found) = found {
                return Err(found.into());
            }
        }
        drop(blockers);
        Ok(scene)
    }

    /// The pairs of a scene; the first pass over all of them shows its progress.
    pub(super) fn pairs(&self, scene: &Scene) -> Result<ScenePairs, Box<dyn Error>> {
        let congruence = if self.every_pair {
            Congruence::Ignored
        } else {
            Congruence::Shared
        };
        let pairs = ScenePairs::try_new(scene, self.tolerance, congruence)?;
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
