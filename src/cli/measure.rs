//! `infoscene measure SCENE`.

use super::light::LightArguments;
use super::output::{Output, finished, say};
use super::progress::Bar;
use super::ranks::first_alone;
use super::sample::{Drawing, LineKindName};
use super::scene::ScenePairsArguments;
use super::{Answer, Outcome};
use infoscene::exchange::Ranks;
use infoscene::information::OpenScene;
use infoscene::question;
use infoscene::report::measure_report;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub(super) struct Measure {
    #[command(flatten)]
    scene: ScenePairsArguments,
    #[command(flatten)]
    light: LightArguments,
    /// Take an open scene, too: what escapes goes to one more state, outside.
    #[arg(long)]
    open: bool,
    /// The continuous mutual information, too: of a closed scene that is convex inside, or from
    /// random lines; from a million where something stands in the way.
    #[arg(long)]
    continuous: bool,
    /// What each pair of patches loses against the continuous one: the most that subdividing both
    /// can gain.
    #[arg(long, requires = "continuous", conflicts_with = "sample")]
    pairs: bool,
    /// Estimates from so many random lines, as `sample --exact` makes them; light and tolerance do
    /// not enter.
    #[arg(long, visible_alias = "lines", value_name = "LINES", conflicts_with = "open",
        value_parser = clap::value_parser!(u32).range(2..))]
    sample: Option<u32>,
    /// How the lines are drawn.
    #[arg(long, value_enum, requires = "sample", default_value_t = LineKindName::Local)]
    kind: LineKindName,
    /// The same seed draws the same lines.
    #[arg(long, value_name = "S", requires = "sample", default_value_t = 1)]
    seed: u64,
    /// Read the form factors from the folder that `form-factor --store` wrote, and hold none.
    #[arg(long, value_name = "DIR", conflicts_with = "sample")]
    store: Option<PathBuf>,
    #[command(flatten)]
    output: Output,
}

impl Measure {
    pub(super) fn answer(&self, ranks: &dyn Ranks) -> Answer {
        if let Some(lines) = self.sample {
            return first_alone(ranks, || self.sampled(lines));
        }
        self.output.check()?;
        let question = question::Measure {
            scene: self.scene.source(),
            tolerance: self.scene.tolerance(),
            congruence: self.scene.congruence(),
            light: self.light.light(),
            open_scene: if self.open {
                OpenScene::AddOutsideState
            } else {
                OpenScene::Refuse
            },
            continuous: self.continuous,
            pairs: self.pairs,
            store: self.store.clone(),
        };
        let answer = question.ask_among(ranks, &Bar::default())?;
        if ranks.number() > 0 {
            return Ok(Outcome::Done);
        }
        say(&answer.notes);
        self.output.write(&measure_report(&answer)?)?;
        Ok(finished(answer.unreached.as_ref()))
    }

    /// The flag `--sample` asks another question.
    fn sampled(&self, lines: u32) -> Answer {
        self.output.check()?;
        if !self.light.is_absent() {
            let message = "lines at random know the chain of visibility only: leave out --sample, \
                           or --chain";
            return Err(message.into());
        }
        let drawing = Drawing {
            lines,
            kind: self.kind,
            seed: self.seed,
        };
        let (exact, continuous) = (true, self.continuous);
        drawing.answer(&self.scene, exact, continuous, &self.output)
    }
}
