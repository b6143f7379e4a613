//! The laws of a matrix from anywhere.

use super::arrays::column;
use super::refusal::Refusal;
use crate::exchange::MatrixLaws;
use numpy::{PyReadonlyArray1, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// `MatrixLaws` of the package.
#[pyfunction]
pub(super) fn matrix_laws<'py>(
    py: Python<'py>,
    values: PyReadonlyArray2<'py, f64>,
    areas: PyReadonlyArray1<'py, f64>,
    bounds: PyReadonlyArray2<'py, f64>,
) -> PyResult<Bound<'py, PyDict>> {
    let (entries, areas) = (values.as_slice()?, areas.as_slice()?);
    let bounds = bounds.as_slice()?;
    let laws = py.detach(|| MatrixLaws::of(entries, areas, bounds).map_err(Refusal::from));
    let laws = laws.map_err(|refusal| PyValueError::new_err(refusal.0))?;
    let dict = PyDict::new(py);
    dict.set_item("broken", pythonize::pythonize(py, &laws.broken)?)?;
    dict.set_item("closed", laws.closed)?;
    dict.set_item("transposed", laws.transposed)?;
    dict.set_item("row_sums", column(py, laws.row_sums.into_iter()))?;
    dict.set_item("worst_row", laws.worst_row)?;
    let largest = laws.largest_reciprocity_error;
    dict.set_item("largest_reciprocity_error", largest)?;
    Ok(dict)
}
