//! Time and memory against the number of patches and of threads, and what they would be on a
//! cluster.
//!
//! * [`measured`]: passes, stores and products on this machine.
//! * [`model`]: the model that predicts more patches on more nodes, each of its terms marked as
//!   measured or assumed.

pub mod measured;
pub mod model;

use super::StudyError;

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
    /// Threads of each node.
    pub threads: usize,
    /// The time, or the quantity of a term.
    pub value: f64,
    /// The unit of the value.
    pub unit: &'static str,
    /// The memory of each node, in bytes; of what was measured, the most that the process ever had.
    pub memory: Option<f64>,
}

/// The rows of the study: those measured, the terms of the model, and its predictions.
///
/// **Arguments** `quick`: up to some thousand patches, in seconds.
///
/// # Errors
/// [`StudyError`] if a scene is refused, or there is no place for a store.
pub fn scale(quick: bool) -> Result<Vec<ScaleRow>, StudyError> {
    let (mut rows, terms) = measured::measured(quick)?;
    rows.extend(terms.rows());
    rows.extend(terms.predictions());
    Ok(rows)
}
