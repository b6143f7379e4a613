//! Questions about the paper: its claims and their curves, studies of them, the report.

mod curve;
#[cfg(all(feature = "proptest", feature = "report"))]
mod fuzz;
#[cfg(feature = "report")]
mod report;
#[cfg(feature = "report")]
mod reported;
mod reproduce;
#[cfg(feature = "report")]
mod study;
#[cfg(feature = "report")]
mod study_rows;

pub use curve::{Curve, CurveAnswer, CurvePoint};
#[cfg(all(feature = "proptest", feature = "report"))]
pub use fuzz::{Fuzz, FuzzAnswer};
#[cfg(feature = "report")]
pub use report::Report;
#[cfg(feature = "report")]
pub use reported::{Machine, PartTime, ReportAnswer, ReportedClaim, ReportedScene, ReportedStudy};
pub use reproduce::{JudgedClaim, Reproduce, ReproduceAnswer};
#[cfg(feature = "report")]
pub use study::{Study, StudyAnswer, StudySubject};
#[cfg(feature = "report")]
pub use study_rows::{DirectionRecord, LimitRecord, ProfileRecord};
