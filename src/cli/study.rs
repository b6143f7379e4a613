//! `infoscene study SUBJECT`.

use super::output::{Output, check_place, write_file};
use super::{Answer, Outcome};
use infoscene::exchange::{Ranks, Unheard};
use infoscene::question::{self, StudySubject};
use infoscene::report::{study_figure, study_report};
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub(super) struct Study {
    /// What is studied.
    #[arg(value_enum)]
    subject: Subject,
    /// Fewer cases and repetitions for the timings.
    #[arg(long)]
    quick: bool,
    /// Draw the study of refinements, of accuracy, of tolerances or of oracles, too, into an SVG
    /// file.
    #[arg(long, value_name = "PATH")]
    figure: Option<PathBuf>,
    #[command(flatten)]
    output: Output,
}

#[derive(Debug, Clone, Copy, clap::ValueEnum)]
enum Subject {
    /// Error against run time of every route to a form factor, past others, too.
    Accuracy,
    /// Error against run time of whole scenes, from loose tolerances to tight ones.
    Tolerances,
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
    /// Error of hierarchical radiosity against elements, links and run time, for every oracle.
    Oracles,
    /// How measures of information rank random meshes, against their error.
    Information,
    /// Time and memory against the number of patches and threads, and under mpirun of ranks, and a
    /// model of what a cluster would take.
    Scale,
}

impl From<Subject> for StudySubject {
    fn from(subject: Subject) -> Self {
        match subject {
            Subject::Accuracy => Self::Accuracy,
            Subject::Tolerances => Self::Tolerances,
            Subject::Stability => Self::Stability,
            Subject::Precision => Self::Precision,
            Subject::Limits => Self::Limits,
            Subject::Profiles => Self::Profiles,
            Subject::Directions => Self::Directions,
            Subject::Walks => Self::Walks,
            Subject::Refinement => Self::Refinement,
            Subject::Sampling => Self::Sampling,
            Subject::Figure5 => Self::Figure5,
            Subject::Oracles => Self::Oracles,
            Subject::Information => Self::Information,
            Subject::Scale => Self::Scale,
        }
    }
}

impl Study {
    /// Is it a study that ranks share out?
    pub(super) const fn is_shared(&self) -> bool {
        matches!(self.subject, Subject::Scale)
    }

    pub(super) fn answer(&self, ranks: &dyn Ranks) -> Answer {
        let has_figure = matches!(
            self.subject,
            Subject::Refinement | Subject::Accuracy | Subject::Tolerances | Subject::Oracles
        );
        if self.figure.is_some() && !has_figure {
            let which = "only the studies of refinements, of accuracy, of tolerances and of \
                         oracles have a figure";
            return Err(which.into());
        }
        self.output.check()?;
        if let Some(path) = &self.figure {
            check_place(path)?;
        }
        let question = question::Study {
            subject: self.subject.into(),
            quick: self.quick,
        };
        let answer = question.ask_among(ranks, &Unheard)?;
        if ranks.number() > 0 {
            return Ok(Outcome::Done);
        }
        if let Some((path, figure)) = self.figure.as_ref().zip(study_figure(&answer)) {
            write_file(path, figure.to_svg()?.as_bytes())?;
        }
        self.output.write(&study_report(&answer)?)
    }
}
