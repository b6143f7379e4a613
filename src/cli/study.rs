//! `infoscene study stability|precision`.

use super::Answer;
use super::output::Output;
use crate::report::study_report;
use crate::study::precision::work_precision;
use crate::study::stability::gain_stability;

#[derive(Debug, clap::Args)]
pub(super) struct Study {
    /// What is studied.
    #[arg(value_enum)]
    subject: Subject,
    /// Fewer repetitions for the timings.
    #[arg(long)]
    quick: bool,
    #[command(flatten)]
    output: Output,
}

#[derive(Debug, Clone, Copy, clap::ValueEnum)]
enum Subject {
    /// What naive forms lose in stiff and extreme cases.
    Stability,
    /// Width of enclosures against run time.
    Precision,
}

impl Study {
    pub(super) fn answer(&self) -> Answer {
        let repetitions = if self.quick { 1 } else { 10_000 };
        match self.subject {
            Subject::Stability => {
                let rows = gain_stability(repetitions)?;
                self.output.write(&study_report("stability", &rows)?)
            }
            Subject::Precision => {
                let rows = work_precision(self.quick)?;
                self.output.write(&study_report("precision", &rows)?)
            }
        }
    }
}
