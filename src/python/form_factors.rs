//! Form factors of a scene's rows, and of points.

use super::arrays::{column, known_column, matrix};
use super::call::{Call, answered};
use super::refusal::Refusal;
use super::scene::{GivenScene, Recipe};
use crate::exchange::{Congruence, Progress, Tolerance};
use crate::form_factor::DEFAULT_TOLERANCE;
use crate::question::{
    FormFactorRecord, FormFactors, FormFactorsAnswer, MatrixEntries, PatchName, PatchRecord,
    PointSource, Points, PointsAnswer, QuestionError, SurfacePoint, Unreached,
};
use numpy::PyReadonlyArray2;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::collections::HashMap;

/// The accuracy that is asked for.
#[derive(FromPyObject, Clone, Copy)]
pub(super) struct GivenAccuracy {
    tolerance: Option<f64>,
    absolute: Option<f64>,
    congruence: bool,
}

impl GivenAccuracy {
    /// The error that is accepted, and the treatment of congruent pairs.
    pub(super) fn asked(self) -> PyResult<(Tolerance, Congruence)> {
        if self
            .tolerance
            .is_some_and(|relative| !(relative > 0.0 && relative < 1.0))
        {
            return Err(PyValueError::new_err(
                "tolerance: it must be a number between 0 and 1",
            ));
        }
        if self
            .absolute
            .is_some_and(|error| !(0.0..1.0).contains(&error))
        {
            return Err(PyValueError::new_err(
                "absolute: it must be a number from 0 to 1",
            ));
        }
        let tolerance = Tolerance {
            relative: self.tolerance.unwrap_or(DEFAULT_TOLERANCE),
            absolute: self.absolute,
        };
        let congruence = if self.congruence {
            Congruence::Shared
        } else {
            Congruence::Ignored
        };
        Ok((tolerance, congruence))
    }
}

/// A matrix of form factors, or a part of it.
struct Factors {
    rows: Vec<usize>,
    columns: Vec<usize>,
    values: Vec<f64>,
    bounds: Vec<f64>,
    /// Bounds on the change by the resolution, if there is one.
    resolution_bounds: Option<Vec<f64>>,
    patches: Vec<PatchRecord>,
    resolution: f64,
    unreached: Option<String>,
    notes: Vec<String>,
}

/// `FormFactors` of the package.
#[pyfunction]
pub(super) fn form_factors<'py>(
    py: Python<'py>,
    scene: GivenScene<'py>,
    accuracy: GivenAccuracy,
    sender: Option<String>,
    receiver: Option<String>,
    call: Call,
) -> PyResult<Bound<'py, PyDict>> {
    let recipe = scene.recipe()?;
    let asked = accuracy.asked()?;
    let ends = [sender, receiver].map(|end| end.map(|name| PatchName::from(name.as_str())));
    let found = answered(py, &call, move |progress| {
        found(recipe, asked, ends, progress)
    })?;
    let shape = [found.rows.len(), found.columns.len()];
    let dict = PyDict::new(py);
    dict.set_item("values", matrix(py, found.values, shape)?)?;
    dict.set_item("bounds", matrix(py, found.bounds, shape)?)?;
    let bounds = found.resolution_bounds;
    let bounds = bounds.map(|bounds| matrix(py, bounds, shape)).transpose()?;
    dict.set_item("resolution_bounds", bounds)?;
    dict.set_item("rows", found.rows)?;
    dict.set_item("columns", found.columns)?;
    let patches = found.patches.iter();
    dict.set_item("areas", column(py, patches.clone().map(|patch| patch.area)))?;
    let sums = known_column(py, patches.clone().map(|patch| patch.row_sum));
    dict.set_item("row_sums", sums)?;
    let bounds = known_column(py, patches.clone().map(|patch| patch.row_sum_error));
    dict.set_item("row_sum_bounds", bounds)?;
    let names: Vec<&str> = patches.map(|patch| patch.name.as_str()).collect();
    dict.set_item("names", names)?;
    dict.set_item("resolution", found.resolution)?;
    dict.set_item("unreached", found.unreached)?;
    dict.set_item("notes", found.notes)?;
    Ok(dict)
}

/// Asks for the form factors, all or those of some rows.
fn found(
    recipe: Recipe,
    (tolerance, congruence): (Tolerance, Congruence),
    ends: [Option<PatchName>; 2],
    progress: &dyn Progress,
) -> Result<Factors, Refusal> {
    let opened = recipe.open()?;
    let is_whole = ends.iter().all(Option::is_none);
    let rows = ends.each_ref().map(|end| match end {
        Some(end) => end.rows(&opened.scene),
        None => Ok((0..opened.rows()).collect()),
    });
    let [rows, columns] = rows;
    let (rows, columns) = (rows?, columns?);
    // a matrix that is too large to be held beside its exchange areas is computed line by line,
    // which the question does beside one pair
    let is_large = is_whole && opened.rows() > FormFactors::MOST_HELD;
    let [from, to] = if is_large {
        [Some(PatchName::from(0)), Some(PatchName::from(0))]
    } else {
        ends
    };
    let question = FormFactors {
        scene: opened.source(),
        tolerance,
        congruence,
        from,
        to,
        matrix: is_whole,
    };
    let answer = question.ask(progress)?;
    let mut found = Factors {
        values: Vec::with_capacity(rows.len() * columns.len()),
        bounds: Vec::with_capacity(rows.len() * columns.len()),
        resolution_bounds: None,
        rows,
        columns,
        patches: answer.patches.clone(),
        resolution: answer.resolution,
        unreached: answer.unreached.as_ref().map(Unreached::to_string),
        notes: opened.remarks(answer.notes.clone()),
    };
    found.fill(&answer, is_large)?;
    Ok(found)
}

impl Factors {
    /// Fills in the entries of an answer.
    fn fill(
        &mut self,
        answer: &FormFactorsAnswer<'_>,
        is_large: bool,
    ) -> Result<(), QuestionError> {
        if let Some(matrix) = answer.matrix() {
            let missed = matrix.for_each_line(|line| {
                self.values.extend(line.row(MatrixEntries::FormFactors));
                self.bounds.extend(line.row(MatrixEntries::Bounds));
                Ok::<(), QuestionError>(())
            })?;
            self.unreached = missed.as_ref().map(Unreached::to_string);
            if self.resolution > 0.0 && !is_large {
                self.resolution_bounds = Some(self.entries(answer, |one| one.resolution_error));
            }
            return Ok(());
        }
        self.values = self.entries(answer, |one| one.value);
        self.bounds = self.entries(answer, |one| one.error);
        if self.resolution > 0.0 {
            self.resolution_bounds = Some(self.entries(answer, |one| one.resolution_error));
        }
        Ok(())
    }

    /// One number of each record, by rows and columns; 0 where a row does not see itself.
    fn entries(
        &self,
        answer: &FormFactorsAnswer<'_>,
        of: impl Fn(&FormFactorRecord) -> f64,
    ) -> Vec<f64> {
        let places = |all: &[usize]| -> HashMap<usize, usize> {
            let places = all.iter().enumerate();
            places.map(|(place, row)| (*row, place)).collect()
        };
        let (rows, columns) = (places(&self.rows), places(&self.columns));
        let mut entries = vec![0.0; rows.len() * columns.len()];
        for record in answer.records() {
            if let (Some(row), Some(place)) = (rows.get(&record.from), columns.get(&record.to)) {
                entries[row * columns.len() + place] = of(&record);
            }
        }
        entries
    }
}

/// `PointFormFactors` of the package.
#[pyfunction]
pub(super) fn point_form_factors<'py>(
    py: Python<'py>,
    scene: GivenScene<'py>,
    points: PyReadonlyArray2<'py, f64>,
    normals: PyReadonlyArray2<'py, f64>,
    call: Call,
) -> PyResult<Bound<'py, PyDict>> {
    let recipe = scene.recipe()?;
    let (at, _) = points.as_slice()?.as_chunks::<3>();
    let (normals, _) = normals.as_slice()?.as_chunks::<3>();
    let points = at.iter().zip(normals);
    let points = points.map(|(at, normal)| SurfacePoint {
        at: *at,
        normal: *normal,
    });
    let points: Vec<SurfacePoint> = points.collect();
    let (answer, notes) = answered(py, &call, move |progress| {
        let opened = recipe.open()?;
        let question = Points {
            scene: opened.source(),
            points: PointSource::Given(points),
        };
        let answer = question.ask(progress)?;
        let notes = opened.remarks(answer.notes.clone());
        Ok((answer, notes))
    })?;
    let dict = seen(py, &answer)?;
    dict.set_item("notes", notes)?;
    Ok(dict)
}

/// The columns and matrices of what points see.
fn seen<'py>(py: Python<'py>, answer: &PointsAnswer) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    let points = answer.points.iter();
    let shape = [answer.points.len(), answer.patches.len()];
    let factors = points.clone().flat_map(|point| &point.form_factors);
    let values = factors.clone().map(|one| one.value).collect();
    dict.set_item("values", matrix(py, values, shape)?)?;
    let bounds = factors.map(|one| one.error).collect();
    dict.set_item("bounds", matrix(py, bounds, shape)?)?;
    let unseen = known_column(py, points.clone().map(|point| point.unseen));
    dict.set_item("unseen", unseen)?;
    let bounds = known_column(py, points.clone().map(|point| point.unseen_error));
    dict.set_item("unseen_bounds", bounds)?;
    let backs = known_column(py, points.clone().map(|point| point.backs));
    dict.set_item("backs", backs)?;
    let bounds = known_column(py, points.map(|point| point.backs_error));
    dict.set_item("backs_bounds", bounds)?;
    let patches = answer.patches.iter();
    dict.set_item("areas", column(py, patches.clone().map(|patch| patch.area)))?;
    let names: Vec<&str> = patches.map(|patch| patch.name.as_str()).collect();
    dict.set_item("names", names)?;
    Ok(dict)
}
