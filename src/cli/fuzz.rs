//! `infoscene fuzz`.

use super::output::{Output, progress_bar};
use super::{Answer, Outcome};
use infoscene::question;
use infoscene::report::{fuzz_report, json_text};
use infoscene::study::gain::fuzz::Sabotage;

#[derive(Debug, clap::Args)]
pub(super) struct Fuzz {
    /// Random refinements to try.
    #[arg(long, value_name = "N", default_value_t = 100_000,
        value_parser = clap::value_parser!(u32).range(1..))]
    cases: u32,
    /// The same seed makes the same cases, whatever the number of threads.
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// Most states before the division.
    #[arg(long, value_name = "MAX", default_value_t = 12,
        value_parser = clap::value_parser!(u64).range(2..=64))]
    states: u64,
    /// Break a hypothesis on purpose, to see a counterexample found.
    #[arg(long, value_enum, hide = true)]
    sabotage: Option<Broken>,
    #[command(flatten)]
    output: Output,
}

#[derive(Debug, Clone, Copy, clap::ValueEnum)]
enum Broken {
    Reciprocity,
    Covering,
    Gain,
}

impl Fuzz {
    pub(super) fn answer(&self) -> Answer {
        let question = question::Fuzz {
            cases: self.cases,
            seed: self.seed,
            states: usize::try_from(self.states)?,
            sabotage: self.sabotage.map(|broken| match broken {
                Broken::Reciprocity => Sabotage::Reciprocity,
                Broken::Covering => Sabotage::Covering,
                Broken::Gain => Sabotage::Gain,
            }),
        };
        self.output.check()?;
        let bar = progress_bar(self.cases.into(), "cases")?;
        let answer = question.ask(&|cases: usize| bar.inc(cases as u64))?;
        bar.finish_and_clear();
        let report = fuzz_report(&answer)?;
        if answer.counterexamples.is_empty() {
            return self.output.write(&report);
        }
        let text = json_text(&answer.counterexamples)?;
        let path = self.output.beside("counterexample.json", text.as_bytes())?;
        self.output.write(&report)?;
        eprintln!(
            "infoscene: a counterexample was found, see {}",
            path.display()
        );
        Ok(Outcome::Differs)
    }
}
