//! Questions that a user may ask, each a plain struct with its answer.
//!
//! A question has public fields and a method `ask`, which takes a listener for progress and returns
//! the answer. An answer is a record: what it serializes to is what the command prints as JSON, and
//! what other programs read. Tables and figures of answers are made in `report`, arguments are
//! parsed in the command; neither computes anything.
//!
//! **Not here**: formats, arguments, files that answers are written to.

mod check;
mod convert;
mod curve;
mod cut;
mod decimals;
mod discontinuities;
mod error;
mod form_factor_matrix;
mod form_factors;
#[cfg(all(feature = "proptest", feature = "report"))]
mod fuzz;
mod grid;
mod light;
mod lights;
mod material_changes;
mod measure;
mod patch_name;
mod patch_values;
mod point_file;
mod points;
mod radiosity;
mod refine;
mod refined;
mod remedy;
#[cfg(feature = "report")]
mod report;
#[cfg(feature = "report")]
mod reported;
mod reproduce;
mod sample;
mod sampled_information;
mod scene;
mod split;
mod store;
#[cfg(feature = "report")]
mod study;
#[cfg(feature = "report")]
mod study_rows;
mod unfolded;
mod unreached;

pub use check::{BlockedRecord, Check, CheckAnswer, FreeEdgeRecord, PatchMark};
pub use convert::{Convert, ConvertAnswer, SceneFormat};
pub use curve::{Curve, CurveAnswer, CurvePoint};
pub use cut::{Cut, CutAnswer, CutEnclosures, Cuts, CutsAnswer, IrradianceExponent};
pub use discontinuities::{
    BestCutRecord, Discontinuities, DiscontinuitiesAnswer, DiscontinuityRecord, GainCurve,
    ReceiverMap,
};
pub use error::QuestionError;
pub use form_factor_matrix::{FormFactorMatrix, MatrixEntries, MatrixLine};
pub use form_factors::{FormFactorRecord, FormFactors, FormFactorsAnswer, PatchRecord};
#[cfg(all(feature = "proptest", feature = "report"))]
pub use fuzz::{Fuzz, FuzzAnswer};
pub use grid::{Grid, GridAnswer, GridEnclosures, GridLines, GridSample};
pub use light::{Light, SceneChain};
pub use lights::{ChannelLight, ChannelSolution, Power};
pub use material_changes::MaterialChanges;
pub use measure::{
    Contribution, FacePairRecord, Measure, MeasureAnswer, PairLossRecord, RowSumRecord,
};
pub use patch_name::{PatchName, PatchNameError};
pub use patch_values::{PatchValue, PatchValueError};
pub use point_file::{PointFileError, SurfacePoint};
pub use points::{PointRecord, PointSource, Points, PointsAnswer, SeenPatch, SeenRecord};
pub use radiosity::{PatchLight, Radiosity, RadiosityAnswer};
pub use refine::{NetWish, Refine};
pub use refined::{LitElement, RefineAnswer, RefineStep, RefinedPatch};
pub use remedy::Remedy;
#[cfg(feature = "report")]
pub use report::Report;
#[cfg(feature = "report")]
pub use reported::{Machine, PartTime, ReportAnswer, ReportedClaim, ReportedScene, ReportedStudy};
pub use reproduce::{JudgedClaim, Reproduce, ReproduceAnswer};
pub use sample::{Sample, SampleAnswer};
pub use sampled_information::SampledInformation;
pub use scene::{SceneOrigin, SceneSource, TURNED_AWAY};
pub use split::{Split, SplitAnswer, SplitEnclosures};
pub use store::{CheckStore, StoreAnswer, StoreFormFactors};
#[cfg(feature = "report")]
pub use study::{Study, StudyAnswer, StudySubject};
#[cfg(feature = "report")]
pub use study_rows::{DirectionRecord, LimitRecord, ProfileRecord};
pub use unfolded::{MeshNet, NetCell, NetWall};
pub use unreached::Unreached;
