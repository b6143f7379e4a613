//! What all questions about the pairs of a scene share.

use super::Outcome;
use super::output::progress_bar;
use super::scene::SceneArgument;
use crate::form_factor::DEFAULT_TOLERANCE;
use crate::scene::{
    Blockers, Congruence, PassSummary, Progress, Scene, SceneError, ScenePairs, Unreached,
};
use indicatif::{ProgressBar, style::TemplateError};
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

    /// A bar that shows the progress of the first pass over all pairs of a scene.
    pub(super) fn bar(&self, scene: &Scene) -> Result<PairsBar, TemplateError> {
        let rows = scene.group_count();
        let all = (rows * (rows - 1) / 2) as u64;
        let bar = progress_bar(all, "pairs")?;
        Ok(PairsBar { bar, all })
    }

    /// The pairs of a scene, whose passes advance a bar.
    pub(super) fn pairs<'b>(
        &self,
        scene: &Scene,
        bar: &'b PairsBar,
    ) -> Result<ScenePairs<'b>, SceneError> {
        let congruence = if self.every_pair {
            Congruence::Ignored
        } else {
            Congruence::Shared
        };
        Ok(ScenePairs::try_new(scene, self.tolerance, congruence)?.with_progress(bar))
    }
}

/// A progress bar that goes when all pairs have been visited once.
pub(super) struct PairsBar {
    bar: ProgressBar,
    all: u64,
}

impl Progress for PairsBar {
    fn advance(&self, finished: usize) {
        if self.bar.is_hidden() {
            return;
        }
        self.bar.inc(finished as u64);
        if self.bar.position() >= self.all {
            self.bar.finish_and_clear();
        }
    }
}

/// The exit status of an answer; what misses the tolerance is named on standard error.
pub(super) fn outcome(scene: &Scene, account: Option<&PassSummary>, tolerance: f64) -> Outcome {
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
