//! `infoscene study SUBJECT`.

use super::Answer;
use super::output::{Output, check_place, write_file};
use infoscene::report::{
    accuracy_report, directions_report, figure_5_report, limits_report, profiles_report,
    refinements_figure, refinements_report, sampling_report, stability_report, study_report,
};
use infoscene::study::cuts::directions::directions;
use infoscene::study::cuts::limits::gradient_limits;
use infoscene::study::cuts::profiles::profiles;
use infoscene::study::enclosures::work_precision;
use infoscene::study::form_factors::accuracy::accuracy;
use infoscene::study::form_factors::extreme_pairs::{StabilityRow, route_stability};
use infoscene::study::gain::stability::gain_stability;
use infoscene::study::light::stability::transport_stability;
use infoscene::study::light::walks::walk_variance;
use infoscene::study::lines::figure_5::figure_5;
use infoscene::study::lines::sampling::sampling;
use infoscene::study::refinement::refinements;

use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub(super) struct Study {
    /// What is studied.
    #[arg(value_enum)]
    subject: Subject,
    /// Fewer cases and repetitions for the timings.
    #[arg(long)]
    quick: bool,
    /// Draw the study of refinements, too, into an SVG file.
    #[arg(long, value_name = "PATH")]
    figure: Option<PathBuf>,
    #[command(flatten)]
    output: Output,
}

#[derive(Debug, Clone, Copy, clap::ValueEnum)]
enum Subject {
    /// Error against run time of every route to a form factor.
    Accuracy,
    /// What naive forms of the gain, and routes to a form factor, lose in stiff and extreme cases.
    Stability,
    /// Width of enclosures against run time.
    Precision,
    /// Where the cuts of §4.2 go as the exponent grows.
    Limits,
    /// Both cuts of §4.2 for radiosities that are no powers.
    Profiles,
    /// What straight cuts gain in any direction, where radiosity grows as a power.
    Directions,
    /// The variance of random walks, by what steers them.
    Walks,
    /// How discrete mutual information approaches the continuous one.
    Refinement,
    /// Error against run time of mutual information from random lines.
    Sampling,
    /// Fig. 5 read as estimates from random lines.
    #[value(name = "figure-5")]
    Figure5,
}

impl Study {
    pub(super) fn answer(&self) -> Answer {
        if self.figure.is_some() && !matches!(self.subject, Subject::Refinement) {
            return Err("only the study of refinements has a figure".into());
        }
        match self.subject {
            Subject::Accuracy => {
                let rows = accuracy(self.quick)?;
                self.output.write(&accuracy_report(&rows)?)
            }
            Subject::Stability => {
                let [gains, routes] = if self.quick { [1, 1] } else { [10_000, 10] };
                let gains = gain_stability(gains)?;
                let mut rows: Vec<_> = gains.into_iter().map(StabilityRow::from).collect();
                rows.extend(transport_stability(routes)?);
                rows.extend(route_stability(routes, self.quick)?);
                self.output.write(&stability_report(&rows)?)
            }
            Subject::Walks => {
                let rows = walk_variance(if self.quick { 200 } else { 10_000 })?;
                self.output.write(&study_report(
                    "walks",
                    "deviation of a walk, relative",
                    &rows,
                )?)
            }
            Subject::Precision => {
                let rows = work_precision(self.quick)?;
                self.output
                    .write(&study_report("precision", "relative width", &rows)?)
            }
            Subject::Limits => self.output.write(&limits_report(&gradient_limits()?)?),
            Subject::Refinement => {
                self.output.check()?;
                if let Some(path) = &self.figure {
                    check_place(path)?;
                }
                let rows = refinements(self.quick)?;
                if let Some(path) = &self.figure {
                    write_file(path, refinements_figure(&rows).to_svg()?.as_bytes())?;
                }
                self.output.write(&refinements_report(&rows)?)
            }
            Subject::Sampling => {
                self.output.check()?;
                self.output.write(&sampling_report(&sampling(self.quick)?)?)
            }
            Subject::Figure5 => {
                self.output.check()?;
                self.output.write(&figure_5_report(&figure_5(self.quick)?)?)
            }
            Subject::Directions => self.output.write(&directions_report(&directions()?)?),
            Subject::Profiles => self.output.write(&profiles_report(&profiles()?)?),
        }
    }
}
