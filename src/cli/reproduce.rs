//! `infoscene reproduce [ID…]`.

use super::output::{Output, precision, progress_bar};
use super::{Answer, Outcome};
use infoscene::claims::DEFAULT_PRECISION;
use infoscene::question;
use infoscene::report::reproduction_report;

#[derive(Debug, clap::Args)]
pub(super) struct Reproduce {
    /// Claims to compute; all if none is named.
    #[arg(value_name = "ID")]
    ids: Vec<String>,
    /// Only the claims that print a number.
    #[arg(long)]
    printed: bool,
    /// Bits of the enclosures' ends.
    #[arg(long, value_name = "BITS", default_value_t = DEFAULT_PRECISION,
        value_parser = precision())]
    precision: u32,
    #[command(flatten)]
    output: Output,
}

impl Reproduce {
    pub(super) fn answer(&self) -> Answer {
        let question = question::Reproduce {
            claims: self.ids.clone(),
            printed_only: self.printed,
            precision: self.precision,
        };
        let claims = question.selection()?;
        self.output.check()?;
        let bar = progress_bar(claims.len() as u64, "claims")?;
        let answer = question.ask(&|finished: usize| bar.inc(finished as u64))?;
        bar.finish_and_clear();
        self.output.write(&reproduction_report(&answer)?)?;
        Ok(if answer.is_as_recorded() {
            Outcome::Done
        } else {
            Outcome::Differs
        })
    }
}
