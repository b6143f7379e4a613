//! Numbers as NumPy arrays.

use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;

/// A column of numbers.
pub(super) fn column(
    py: Python<'_>,
    numbers: impl Iterator<Item = f64>,
) -> Bound<'_, PyArray1<f64>> {
    PyArray1::from_vec(py, numbers.collect())
}

/// A column, if all of its numbers are known.
pub(super) fn known_column(
    py: Python<'_>,
    numbers: impl Iterator<Item = Option<f64>>,
) -> Option<Bound<'_, PyArray1<f64>>> {
    let numbers: Option<Vec<f64>> = numbers.collect();
    numbers.map(|numbers| PyArray1::from_vec(py, numbers))
}

/// A matrix of numbers that stand row after row.
pub(super) fn matrix(
    py: Python<'_>,
    numbers: Vec<f64>,
    shape: [usize; 2],
) -> PyResult<Bound<'_, PyArray2<f64>>> {
    PyArray1::from_vec(py, numbers).reshape(shape)
}
