//! Questions that a user may ask, each a plain struct with its answer.
//!
//! A question has public fields and a method `ask`, which takes a listener for progress and returns
//! the answer. An answer is a record: what it serializes to is what the command prints as JSON, and
//! what other programs read. Tables and figures of answers are made in `report`, arguments are
//! parsed in the command; neither computes anything.
//!
//! Rooms: `form_factors`, `information` of a chain, `cuts` of patches, and the `paper`'s claims and
//! studies. Here are the scenes and the light that questions are about, radiosity, and files.
//!
//! **Not here**: formats, arguments, files that answers are written to.

mod check;
mod convert;
mod cuts;
mod decimals;
mod error;
mod form_factors;
mod information;
mod light;
mod lights;
mod material_changes;
mod paper;
mod patch_name;
mod patch_values;
mod point_file;
mod radiosity;
mod refine;
mod refined;
mod remedy;
mod scene;
mod unfolded;
mod unreached;

pub use check::{BlockedRecord, Check, CheckAnswer, FreeEdgeRecord, PatchMark};
pub use convert::{Convert, ConvertAnswer, SceneFormat};
pub use cuts::{
    BestCutRecord, Cut, CutAnswer, CutEnclosures, Cuts, CutsAnswer, Discontinuities,
    DiscontinuitiesAnswer, DiscontinuityRecord, GainCurve, Grid, GridAnswer, GridEnclosures,
    GridLines, GridSample, IrradianceExponent, ReceiverMap, Split, SplitAnswer, SplitEnclosures,
};
pub use error::QuestionError;
pub use form_factors::{
    CheckStore, FormFactorMatrix, FormFactorRecord, FormFactors, FormFactorsAnswer, MatrixEntries,
    MatrixLine, PatchRecord, PointRecord, PointSource, Points, PointsAnswer, SeenPatch, SeenRecord,
    StoreAnswer, StoreFormFactors,
};
pub use information::{
    Contribution, FacePairRecord, Measure, MeasureAnswer, PairLossRecord, RowSumRecord, Sample,
    SampleAnswer, SampledInformation,
};
pub use light::{Light, SceneChain};
pub use lights::{ChannelLight, ChannelSolution, Power};
pub use material_changes::MaterialChanges;
pub use paper::{Curve, CurveAnswer, CurvePoint, JudgedClaim, Reproduce, ReproduceAnswer};
#[cfg(feature = "report")]
pub use paper::{
    DirectionRecord, LimitRecord, Machine, PartTime, ProfileRecord, Report, ReportAnswer,
    ReportedClaim, ReportedScene, ReportedStudy, Study, StudyAnswer, StudySubject,
};
#[cfg(all(feature = "proptest", feature = "report"))]
pub use paper::{Fuzz, FuzzAnswer};
pub use patch_name::{PatchName, PatchNameError};
pub use patch_values::{PatchValue, PatchValueError};
pub use point_file::{PointFileError, SurfacePoint};
pub use radiosity::{PatchLight, Radiosity, RadiosityAnswer};
pub use refine::{NetWish, Refine};
pub use refined::{LitElement, RefineAnswer, RefineStep, RefinedPatch};
pub use remedy::Remedy;
pub use scene::{SceneOrigin, SceneSource, TURNED_AWAY};
pub use unfolded::{MeshNet, NetCell, NetWall};
pub use unreached::Unreached;
