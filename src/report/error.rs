//! The refusals of a report.

use crate::scene::SceneError;
use std::path::PathBuf;

/// Records could not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReportError {
    /// A record is not a flat list of values.
    #[error("a record cannot be written as comma-separated values: {0}")]
    Csv(#[from] csv::Error),
    /// A value cannot be written as JSON.
    #[error("a record cannot be written as JSON: {0}")]
    Json(#[from] serde_json::Error),
    /// The text cannot be written where it goes.
    #[error("the answer cannot be written: {0}")]
    Write(#[from] std::io::Error),
    /// The name of a file does not say in which format a matrix is written.
    #[error(
        "{}: a matrix is written as .npy, .mtx, .array.mtx, .txt or .vf, so let its name end in \
         one of them", file.display()
    )]
    UnknownMatrixFormat {
        /// The file as named.
        file: PathBuf,
    },
    /// The format is of form factors only.
    #[error(
        "{}: View3D's output has no place for bounds: write .npy, .mtx, .array.mtx or .txt",
        file.display()
    )]
    NoPlaceForBounds {
        /// The file as named.
        file: PathBuf,
    },
    /// The number of entries is needed before they are computed.
    #[error(
        "coordinates in a .mtx file begin with their number, which is not known as {rows} rows are \
         too many to hold: write .array.mtx, .npy or .txt"
    )]
    CountNotKnown {
        /// Rows of the matrix.
        rows: usize,
    },
    /// Materials that a format needs are not there.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A figure cannot be drawn.
    #[error("the figure cannot be drawn: {reason}")]
    Figure {
        /// Why.
        reason: String,
    },
    /// A number is NaN or infinite.
    #[error("{key} is not finite")]
    NotFinite {
        /// Full key of the record's entry, such as `rows[3].relative_error`.
        key: String,
    },
}
