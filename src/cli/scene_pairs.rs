//! What all questions about the pairs of a scene share.

use super::Outcome;
use super::output::progress_bar;
use super::scene::SceneArgument;
use indicatif::ProgressBar;
use indicatif::style::TemplateError;
use infoscene::exchange::{
    Congruence, ExchangeError, PassSummary, Progress, ScenePairs, Unreached,
};
use infoscene::form_factor::DEFAULT_TOLERANCE;
use infoscene::scene::files::OpenError;
use infoscene::scene::{Occlusion, Scene};
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
    pub(super) fn scene(&self) -> Result<Scene, OpenError> {
        self.scene.read()
    }

    /// Was it asked to leave out occlusion?
    pub(super) fn is_unoccluded(&self) -> bool {
        self.scene.occlusion() == Occlusion::Ignore
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
    ) -> Result<ScenePairs<'b>, ExchangeError> {
        self.pairs_under(scene, self.scene.occlusion(), bar)
    }

    /// The pairs of a scene of which only those between these rows are asked for: elsewhere
    /// something may stand.
    pub(super) fn pairs_between<'b>(
        &self,
        scene: &Scene,
        from: Option<usize>,
        to: Option<usize>,
        bar: &'b PairsBar,
    ) -> Result<ScenePairs<'b>, ExchangeError> {
        if !self.is_unoccluded() {
            scene.check_rows_unblocked(from, to)?;
        }
        self.pairs_under(scene, Occlusion::Ignore, bar)
    }

    fn pairs_under<'b>(
        &self,
        scene: &Scene,
        occlusion: Occlusion,
        bar: &'b PairsBar,
    ) -> Result<ScenePairs<'b>, ExchangeError> {
        let congruence = if self.every_pair {
            Congruence::Ignored
        } else {
            Congruence::Shared
        };
        let pairs = ScenePairs::try_new(scene, self.tolerance, congruence, occlusion)?;
        Ok(pairs.with_progress(bar))
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
