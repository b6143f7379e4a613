//! `infoscene curve ID`.

use super::Answer;
use super::output::{Output, check_place, write_file};
use infoscene::exchange::Unheard;
use infoscene::question;
use infoscene::report::{curve_figure, curve_report};
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub(super) struct Curve {
    /// The claim whose figure is printed, as in `infoscene reproduce`.
    #[arg(value_name = "ID")]
    id: String,
    /// Draw the curve, too, into an SVG file.
    #[arg(long, value_name = "PATH")]
    figure: Option<PathBuf>,
    #[command(flatten)]
    output: Output,
}

impl Curve {
    pub(super) fn answer(&self) -> Answer {
        self.output.check()?;
        if let Some(path) = &self.figure {
            check_place(path)?;
        }
        let question = question::Curve {
            claim: self.id.clone(),
        };
        let answer = question.ask(&Unheard)?;
        if let Some(path) = &self.figure {
            write_file(path, curve_figure(&answer).to_svg()?.as_bytes())?;
        }
        self.output.write(&curve_report(&answer)?)
    }
}
