//! Studies: error against run time of different forms of a formula, and how far results carry.

use super::study_rows::{DirectionRecord, LimitRecord, ProfileRecord};
use crate::exchange::{Alone, Progress, Ranks};
use crate::question::QuestionError;
use crate::study::Row;
use crate::study::cuts::directions::directions;
use crate::study::cuts::limits::gradient_limits;
use crate::study::cuts::profiles::profiles;
use crate::study::enclosures::work_precision;
use crate::study::form_factors::accuracy::{AccuracyRow, accuracy};
use crate::study::form_factors::extreme_pairs::{StabilityRow, route_stability};
use crate::study::form_factors::occluded::stability::occluded_stability;
use crate::study::form_factors::tolerances::{ToleranceRow, tolerances};
use crate::study::gain::stability::gain_stability;
use crate::study::hierarchy::information::{InformationRow, information};
use crate::study::hierarchy::oracles::{OracleRow, oracles};
use crate::study::light::stability::transport_stability;
use crate::study::light::walks::walk_variance;
use crate::study::lines::figure_5::{Figure5Row, figure_5};
use crate::study::lines::sampling::{SamplingRow, sampling};
use crate::study::refinement::{RefinementRow, refinements};
use crate::study::scale::{ScaleRow, scale};

/// The question for the rows of a study.
///
/// # Examples
/// ```
/// use infoscene::exchange::Unheard;
/// use infoscene::question::{Study, StudyAnswer, StudySubject};
/// let limits = Study { subject: StudySubject::Limits, quick: true }.ask(&Unheard)?;
/// let StudyAnswer::Limits(rows) = limits else { unreachable!() };
/// let last = rows.iter().find(|row| row.case == "n = 1e12");
/// // the root of x = 2 (1 − e^−x)
/// assert!(last.is_some_and(|row| (row.value - 1.593_624_260_04).abs() < 1e-10));
/// # Ok::<(), infoscene::question::QuestionError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Study {
    /// The subject.
    pub subject: StudySubject,
    /// Are fewer cases and repetitions for the timings enough?
    pub quick: bool,
}

/// The subject of a study.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StudySubject {
    /// Error against run time of every route to a form factor.
    Accuracy,
    /// Error against run time of whole scenes, from loose tolerances to tight ones.
    Tolerances,
    /// The digits that naive forms of the gain, and routes to a form factor, lose in stiff and
    /// extreme cases.
    Stability,
    /// Width of enclosures against run time.
    Precision,
    /// The cuts of §4.2 as the exponent grows.
    Limits,
    /// Both cuts of §4.2 for radiosities that are no powers.
    Profiles,
    /// The gains of straight cuts in any direction, where radiosity grows as a power.
    Directions,
    /// The variance of random walks, by what steers them.
    Walks,
    /// Discrete mutual information on its way to the continuous one.
    Refinement,
    /// Error against run time of mutual information from random lines.
    Sampling,
    /// Fig. 5 read as estimates from random lines.
    Figure5,
    /// Error of hierarchical radiosity against elements, links, form factors and run time, for
    /// every oracle.
    Oracles,
    /// The rank correlation of measures of information with the error over random meshes.
    Information,
    /// Time and memory against the number of patches, of threads and of ranks, and a model of a
    /// cluster.
    Scale,
}

/// The rows of a study, under its name.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[serde(tag = "study", content = "rows", rename_all = "kebab-case")]
pub enum StudyAnswer {
    /// A row for each case, method and setting.
    Accuracy(Vec<AccuracyRow>),
    /// A row for each scene, method and tolerance.
    Tolerances(Vec<ToleranceRow>),
    /// A row for each case and method.
    Stability(Vec<StabilityRow>),
    /// A row for each quantity and number of bits.
    Precision(Vec<Row>),
    /// A row for each cut and exponent.
    Limits(Vec<LimitRecord>),
    /// Two rows for each profile and irradiance: the mutual-information cut and the mean-square
    /// cut.
    Profiles(Vec<ProfileRecord>),
    /// A row for each pair of exponents and angle.
    Directions(Vec<DirectionRecord>),
    /// A row for each room and kind of walk.
    Walks(Vec<Row>),
    /// A row for each refinement of each scene.
    Refinement(Vec<RefinementRow>),
    /// A row for each scene, estimate and number of lines.
    Sampling(Vec<SamplingRow>),
    /// A row for each grid of the figure.
    #[serde(rename = "figure-5")]
    Figure5(Vec<Figure5Row>),
    /// A row for each room, oracle and mesh.
    Oracles(Vec<OracleRow>),
    /// A row for each room and measure.
    Information(Vec<InformationRow>),
    /// A row for each time that was measured, each term of the model, and each prediction.
    Scale(Vec<ScaleRow>),
}

impl Study {
    /// Computes the answer.
    ///
    /// # Errors
    /// [`QuestionError::Study`] or [`QuestionError::Discretize`] if a case is refused; none is
    /// known to be.
    pub fn ask(&self, progress: &dyn Progress) -> Result<StudyAnswer, QuestionError> {
        self.ask_among(&Alone, progress)
    }

    /// Computes the answer as one of the ranks of a job, which share out what the study
    /// [`Scale`](StudySubject::Scale) measures: each asks the same, and has the same answer.
    ///
    /// # Errors
    /// As [`ask`](Self::ask); [`ExchangeError::Rank`](crate::exchange::ExchangeError::Rank) of
    /// another rank's.
    pub fn ask_among(
        &self,
        ranks: &dyn Ranks,
        _: &dyn Progress,
    ) -> Result<StudyAnswer, QuestionError> {
        Ok(match self.subject {
            StudySubject::Accuracy => StudyAnswer::Accuracy(accuracy(self.quick)?),
            StudySubject::Tolerances => StudyAnswer::Tolerances(tolerances(self.quick)?),
            StudySubject::Stability => StudyAnswer::Stability(self.stability()?),
            StudySubject::Precision => StudyAnswer::Precision(work_precision(self.quick)?),
            StudySubject::Limits => {
                let rows = gradient_limits()?;
                StudyAnswer::Limits(rows.into_iter().map(LimitRecord::from).collect())
            }
            StudySubject::Profiles => {
                let rows = profiles()?;
                StudyAnswer::Profiles(rows.iter().flat_map(ProfileRecord::both).collect())
            }
            StudySubject::Directions => {
                let rows = directions()?;
                StudyAnswer::Directions(rows.iter().map(DirectionRecord::from).collect())
            }
            StudySubject::Walks => {
                let walks = if self.quick { 200 } else { 10_000 };
                StudyAnswer::Walks(walk_variance(walks)?)
            }
            StudySubject::Refinement => StudyAnswer::Refinement(refinements(self.quick)?),
            StudySubject::Sampling => StudyAnswer::Sampling(sampling(self.quick)?),
            StudySubject::Figure5 => StudyAnswer::Figure5(figure_5(self.quick)?),
            StudySubject::Oracles => StudyAnswer::Oracles(oracles(self.quick)?),
            StudySubject::Information => StudyAnswer::Information(information(self.quick)?),
            StudySubject::Scale => StudyAnswer::Scale(scale(ranks, self.quick)?),
        })
    }

    /// The digits that gains, solvers and routes keep.
    fn stability(&self) -> Result<Vec<StabilityRow>, QuestionError> {
        let [gains, routes] = if self.quick { [1, 1] } else { [10_000, 10] };
        let gains = gain_stability(gains)?;
        let mut rows: Vec<_> = gains.into_iter().map(StabilityRow::from).collect();
        rows.extend(transport_stability(routes)?);
        rows.extend(route_stability(routes, self.quick)?);
        rows.extend(occluded_stability(routes.min(3), self.quick)?);
        Ok(rows)
    }
}
