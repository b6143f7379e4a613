//! Tables and figures of the studies.
//!
//! `measurements` has studies with one number per row, `routes` those that set several methods side
//! by side, `gradient_cuts` the reach of the cuts of §4.2, `refinement` the approach to the
//! continuous value, `sampling` the estimates from random lines and fig. 5, `tolerances` whole
//! scenes, `oracles` the refinement of meshes, `information` the ranks of random ones, `scale` what
//! a cluster would take.

mod gradient_cuts;
mod information;
mod measurements;
mod oracles;
mod refinement;
mod routes;
mod sampling;
mod scale;
mod tolerances;

use crate::question::StudyAnswer;
use crate::report::{Figure, Report, ReportError};

/// The answer to [`Study`](crate::question::Study): its table, and its rows under `rows` in JSON.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn study_report(answer: &StudyAnswer) -> Result<Report, ReportError> {
    match answer {
        StudyAnswer::Accuracy(rows) => routes::accuracy_report(rows),
        StudyAnswer::Tolerances(rows) => tolerances::tolerances_report(rows),
        StudyAnswer::Stability(rows) => routes::stability_report(rows),
        StudyAnswer::Precision(rows) => {
            measurements::measurements_report("precision", "relative width", rows)
        }
        StudyAnswer::Limits(rows) => gradient_cuts::limits_report(rows),
        StudyAnswer::Profiles(rows) => gradient_cuts::profiles_report(rows),
        StudyAnswer::Directions(rows) => gradient_cuts::directions_report(rows),
        StudyAnswer::Walks(rows) => {
            measurements::measurements_report("walks", "deviation of a walk, relative", rows)
        }
        StudyAnswer::Refinement(rows) => refinement::refinements_report(rows),
        StudyAnswer::Sampling(rows) => sampling::sampling_report(rows),
        StudyAnswer::Figure5(rows) => sampling::figure_5_report(rows),
        StudyAnswer::Oracles(rows) => oracles::oracles_report(rows),
        StudyAnswer::Information(rows) => information::information_report(rows),
        StudyAnswer::Scale(rows) => scale::scale_report(rows),
    }
}

/// The figure of a study; none but those of refinements, of accuracy, of tolerances and of oracles
/// has one.
#[must_use]
pub fn study_figure(answer: &StudyAnswer) -> Option<Figure> {
    match answer {
        StudyAnswer::Refinement(rows) => Some(refinement::refinements_figure(rows)),
        StudyAnswer::Accuracy(rows) => Some(routes::accuracy_figure(rows)),
        StudyAnswer::Tolerances(rows) => Some(tolerances::tolerances_figure(rows)),
        StudyAnswer::Oracles(rows) => Some(oracles::oracles_figure(rows)),
        _ => None,
    }
}
