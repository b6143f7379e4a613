//! `infoscene sample SCENE --lines N`.

use super::Answer;
use super::output::{Output, say};
use super::progress::Bar;
use super::scene::ScenePairsArguments;
use infoscene::information::LineKind;
use infoscene::question;
use infoscene::report::sample_report;

#[derive(Debug, clap::Args)]
pub(super) struct Sample {
    #[command(flatten)]
    scene: ScenePairsArguments,
    /// Number of lines.
    #[arg(long, value_name = "N", default_value_t = 1_000_000,
        value_parser = clap::value_parser!(u32).range(2..))]
    lines: u32,
    /// How the lines are drawn.
    #[arg(long, value_enum, default_value_t = LineKindName::Local)]
    kind: LineKindName,
    /// The same seed draws the same lines.
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// The continuous mutual information, too, from the same lines.
    #[arg(long)]
    continuous: bool,
    /// The exact value and the expected bias, too: of a scene of up to 6144 patches.
    #[arg(long)]
    exact: bool,
    #[command(flatten)]
    output: Output,
}

#[derive(Debug, Clone, Copy, clap::ValueEnum)]
pub(super) enum LineKindName {
    /// From points of the patches, to what is met first.
    Local,
    /// Through the whole scene, with all that is met.
    Global,
}

impl From<LineKindName> for LineKind {
    fn from(name: LineKindName) -> Self {
        match name {
            LineKindName::Local => Self::Local,
            LineKindName::Global => Self::Global,
        }
    }
}

impl Sample {
    pub(super) fn answer(&self) -> Answer {
        self.output.check()?;
        let drawing = Drawing {
            lines: self.lines,
            kind: self.kind,
            seed: self.seed,
        };
        drawing.answer(&self.scene, self.exact, self.continuous, &self.output)
    }
}

/// The lines that are drawn, by `sample` or by `measure --sample`.
pub(super) struct Drawing {
    pub(super) lines: u32,
    pub(super) kind: LineKindName,
    pub(super) seed: u64,
}

impl Drawing {
    pub(super) fn answer(
        &self,
        scene: &ScenePairsArguments,
        exact: bool,
        continuous: bool,
        output: &Output,
    ) -> Answer {
        let question = question::Sample {
            scene: scene.source(),
            lines: self.lines,
            kind: self.kind.into(),
            seed: self.seed,
            continuous,
            exact,
            tolerance: scene.tolerance(),
            congruence: scene.congruence(),
        };
        let answer = question.ask(&Bar::default())?;
        say(&answer.notes);
        output.write(&sample_report(&answer)?)
    }
}
