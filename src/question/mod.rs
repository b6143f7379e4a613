//! Questions that a user may ask, each a plain struct with its answer.
//!
//! A question has public fields and a method `ask`, which takes a listener for progress and returns
//! the answer. An answer is a record: what it serializes to is what the command prints as JSON, and
//! what other programs read. Tables and figures of answers are made in `report`, arguments are
//! parsed in the command; neither computes anything.
//!
//! **Not here**: formats, arguments, files that answers are written to.

mod curve;
mod cut;
mod decimals;
mod error;
#[cfg(all(feature = "proptest", feature = "report"))]
mod fuzz;
mod grid;
mod reproduce;
mod sampled_information;
#[cfg(feature = "report")]
mod study;
#[cfg(feature = "report")]
mod study_rows;

pub use curve::{Curve, CurveAnswer, CurvePoint};
pub use cut::{Cut, CutAnswer, CutEnclosures, Cuts, CutsAnswer, IrradianceExponent};
pub use error::QuestionError;
#[cfg(all(feature = "proptest", feature = "report"))]
pub use fuzz::{Fuzz, FuzzAnswer};
pub use grid::{Grid, GridAnswer, GridEnclosures, GridLines, GridSample};
pub use reproduce::{JudgedClaim, Reproduce, ReproduceAnswer};
pub use sampled_information::SampledInformation;
#[cfg(feature = "report")]
pub use study::{Study, StudyAnswer, StudySubject};
#[cfg(feature = "report")]
pub use study_rows::{DirectionRecord, LimitRecord, ProfileRecord};
