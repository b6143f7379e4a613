//! Errors of studies.

use crate::chain::ChainError;
use crate::claims::ClaimError;
use crate::discretize::DiscretizeError;
use crate::exchange::{ExchangeError, RankFailed, StoreError};
use crate::form_factor::FormFactorError;
use crate::geometry::GeometryError;
use crate::hierarchy::HierarchyError;
use crate::scene::SceneError;
use crate::transport::TransportError;

/// A case of a study was refused.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StudyError {
    /// A gain's chain.
    #[error(transparent)]
    Chain(#[from] ChainError),
    /// A grid of a figure.
    #[error(transparent)]
    Claim(#[from] ClaimError),
    /// A grid.
    #[error(transparent)]
    Discretize(#[from] DiscretizeError),
    /// A pair's polygons.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
    /// A room's patches.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The exchange of a scene's rows was refused.
    #[error(transparent)]
    Exchange(#[from] ExchangeError),
    /// There is no place for a matrix.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// A room's light.
    #[error(transparent)]
    Transport(#[from] TransportError),
    /// A room's refinement.
    #[error(transparent)]
    Hierarchy(#[from] HierarchyError),
    /// A pair's exact value.
    #[error("{case}: {source}")]
    FormFactor {
        /// The pair.
        case: String,
        /// The reason.
        source: FormFactorError,
    },
    /// Threads for timings.
    #[error("no thread can be started: {0}")]
    Threads(String),
    /// The file of independent values cannot be read.
    #[error("form_factors.csv: {0}")]
    Table(#[from] csv::Error),
    /// Corners in it cannot be read.
    #[error("form_factors.csv: {0}")]
    Corners(#[from] serde_json::Error),
    /// The file of values past others cannot be read.
    #[error("occlusion.json: {0}")]
    OccludedPairs(serde_json::Error),
    /// A number of a file of independent values cannot be read.
    #[error("reference value {id}: {text:?} is not a number")]
    Number {
        /// The row or case.
        id: String,
        /// The text as given.
        text: String,
    },
}

impl From<RankFailed> for StudyError {
    fn from(failed: RankFailed) -> Self {
        Self::Exchange(failed.into())
    }
}
