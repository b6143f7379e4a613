//! Time and memory against the number of patches, of threads and of ranks, and what they would be
//! on a cluster.
//!
//! * `measured`: passes, stores, products and messages, by this process or by the ranks of a job.
//! * `model`: the model that predicts more patches on more nodes, each of its terms marked as
//!   measured or assumed.

mod measured;
mod model;
mod timer;

use super::StudyError;
use crate::exchange::Ranks;

/// What a number rests on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Basis {
    /// It was timed or counted in this run.
    Measured,
    /// It is taken for granted.
    Assumed,
    /// It was computed from measured and assumed ones by the model.
    Predicted,
}

/// One number of the study.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct ScaleRow {
    /// The work, in words.
    pub case: String,
    /// What the number rests on.
    pub basis: Basis,
    /// The number of patches, if it is of a scene.
    pub patches: Option<usize>,
    /// Nodes of the cluster.
    pub nodes: usize,
    /// Processes that share the work out.
    pub ranks: usize,
    /// Threads of each process.
    pub threads: usize,
    /// The time, or the quantity of a term.
    pub value: f64,
    /// The unit of the value.
    pub unit: &'static str,
    /// The memory of each process, in bytes; of what was measured, the most that one ever had.
    pub memory: Option<f64>,
}

/// The rows of the study: those measured, the terms of the model, and its predictions.
///
/// **Arguments** `ranks`: share out what is measured; each calls this, and has the same rows. The
/// folder of temporary files (`TMPDIR`) must be one that all of them see. `quick`: up to some
/// thousand patches, in seconds.
///
/// # Errors
/// [`StudyError`] if a scene is refused, or there is no place for a store.
pub fn scale(ranks: &dyn Ranks, quick: bool) -> Result<Vec<ScaleRow>, StudyError> {
    let (mut rows, terms) = measured::measured(ranks, quick)?;
    rows.extend(terms.rows());
    rows.extend(terms.predictions());
    Ok(rows)
}
