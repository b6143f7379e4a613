//! The refusals of a report.

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
