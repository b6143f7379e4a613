//! The paper's claims.

use super::call::{Call, answered};
use crate::question::Reproduce;
use pyo3::prelude::*;

/// A list of `Claim` of the package.
#[pyfunction]
pub(super) fn reproduce<'py>(
    py: Python<'py>,
    claims: Vec<String>,
    printed_only: bool,
    precision: Option<u32>,
    call: Call,
) -> PyResult<Bound<'py, PyAny>> {
    let question = Reproduce {
        claims,
        printed_only,
        precision: precision.unwrap_or(Reproduce::default().precision),
    };
    let answer = answered(py, &call, move |progress| Ok(question.ask(progress)?))?;
    Ok(pythonize::pythonize(py, &answer.claims)?)
}
