//! Radiosities, on the mesh as it is and on one that is refined.

use super::arrays::{column, known_column, matrix};
use super::call::{Call, answered};
use super::form_factors::GivenAccuracy;
use super::materials::GivenLight;
use super::scene::GivenScene;
use crate::hierarchy::{Factors, Goal, OracleName};
use crate::question::{PatchLight, Radiosity, RadiosityAnswer, Refine, RefineAnswer, Unreached};
use crate::scene::Channel;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// `Radiosity` of the package.
#[pyfunction]
pub(super) fn radiosity<'py>(
    py: Python<'py>,
    scene: GivenScene<'py>,
    accuracy: GivenAccuracy,
    light: GivenLight,
    call: Call,
) -> PyResult<Bound<'py, PyDict>> {
    let recipe = scene.recipe()?;
    let (tolerance, congruence) = accuracy.asked()?;
    let (answer, areas, notes) = answered(py, &call, move |progress| {
        let opened = recipe.open()?;
        let question = Radiosity {
            scene: opened.source(),
            tolerance,
            congruence,
            materials: light.materials(opened.rows())?,
            importance: light.importance(opened.rows())?,
            ..Radiosity::default()
        };
        let answer = question.ask(progress)?;
        let areas = opened.scene.row_areas();
        let notes = opened.remarks(answer.notes.clone());
        Ok((answer, areas, notes))
    })?;
    let dict = lit(py, &answer)?;
    dict.set_item("areas", column(py, areas.into_iter()))?;
    dict.set_item("notes", notes)?;
    Ok(dict)
}

/// The columns of a scene's light, and its balance.
fn lit<'py>(py: Python<'py>, answer: &RadiosityAnswer) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    let rows = answer.patches.iter();
    dict.set_item("values", column(py, rows.clone().map(|row| row.radiosity)))?;
    let irradiance = column(py, rows.clone().map(|row| row.irradiance));
    dict.set_item("irradiance", irradiance)?;
    let importance = known_column(py, rows.clone().map(|row| row.importance));
    dict.set_item("importance", importance)?;
    let bounds = known_column(py, rows.clone().map(|row| row.form_factor_error));
    dict.set_item("form_factor_bounds", bounds)?;
    let bounds = known_column(py, rows.clone().map(|row| row.resolution_error));
    dict.set_item("resolution_bounds", bounds)?;
    let of_row = |row: &PatchLight| {
        let channels = row.channels.as_ref()?;
        Some(Channel::ALL.map(|channel| channels.of(channel).radiosity))
    };
    let colours: Option<Vec<[f64; 3]>> = rows.clone().map(of_row).collect();
    let shape = [answer.patches.len(), 3];
    let colours = colours.filter(|colours| !colours.is_empty());
    let colours = colours.map(|colours| matrix(py, colours.concat(), shape));
    dict.set_item("colours", colours.transpose()?)?;
    let names: Vec<&str> = rows.map(|row| row.name.as_str()).collect();
    dict.set_item("names", names)?;
    dict.set_item("residual", answer.residual)?;
    dict.set_item("iterations", answer.iterations)?;
    dict.set_item("relative_error", answer.relative_error)?;
    dict.set_item("closed", answer.closed)?;
    dict.set_item("resolution", answer.resolution)?;
    dict.set_item("emitted", answer.power.emitted)?;
    dict.set_item("absorbed", answer.power.absorbed)?;
    dict.set_item("escaped", answer.power.escaped)?;
    let unreached = answer.unreached.as_ref().map(Unreached::to_string);
    dict.set_item("unreached", unreached)?;
    Ok(dict)
}

/// The choices of a refinement.
#[derive(FromPyObject)]
pub(super) struct GivenRefinement {
    elements: Option<usize>,
    links: Option<usize>,
    error: Option<f64>,
    oracle: String,
    linear: bool,
    exact: bool,
    bound: bool,
    gather: bool,
}

impl GivenRefinement {
    /// The one goal that is given.
    fn goal(&self) -> PyResult<Goal> {
        match (self.elements, self.links, self.error) {
            (Some(elements), None, None) => Ok(Goal::Elements(elements)),
            (None, Some(links), None) => Ok(Goal::Links(links)),
            (None, None, Some(error)) => Ok(Goal::Error(error)),
            _ => Err(PyValueError::new_err(
                "give one of elements, links and error: it says where refinement ends",
            )),
        }
    }
}

/// `Refined` of the package.
#[pyfunction]
pub(super) fn refine<'py>(
    py: Python<'py>,
    scene: GivenScene<'py>,
    refinement: GivenRefinement,
    light: GivenLight,
    call: Call,
) -> PyResult<Bound<'py, PyDict>> {
    let recipe = scene.recipe()?;
    let (goal, channel) = (refinement.goal()?, light.channel()?);
    let oracle: OracleName = refinement
        .oracle
        .parse()
        .map_err(|error| PyValueError::new_err(format!("oracle: {error}")))?;
    let (answer, notes) = answered(py, &call, move |progress| {
        let opened = recipe.open()?;
        let question = Refine {
            scene: opened.source(),
            oracle,
            goal,
            linear: refinement.linear,
            materials: light.materials(opened.rows())?,
            channel,
            importance: light.importance(opened.rows())?,
            factors: if refinement.exact {
                Factors::Exact
            } else {
                Factors::OfPoints
            },
            bound: refinement.bound,
            gather: refinement.gather,
            mesh: true,
            ..Refine::default()
        };
        let answer = question.ask(progress)?;
        let notes = opened.remarks(answer.notes.clone());
        Ok((answer, notes))
    })?;
    let dict = refined(py, &answer)?;
    dict.set_item("notes", notes)?;
    Ok(dict)
}

/// The columns of the light on a refined mesh, and its steps.
fn refined<'py>(py: Python<'py>, answer: &RefineAnswer) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    let rows = answer.patches.iter();
    let faces: Vec<usize> = rows.clone().map(|row| row.index).collect();
    dict.set_item("faces", faces)?;
    dict.set_item("values", column(py, rows.clone().map(|row| row.radiosity)))?;
    let irradiance = column(py, rows.clone().map(|row| row.irradiance));
    dict.set_item("irradiance", irradiance)?;
    let gathered = known_column(py, rows.clone().map(|row| row.gathered));
    dict.set_item("gathered", gathered)?;
    let elements: Vec<usize> = rows.clone().map(|row| row.elements).collect();
    dict.set_item("elements", elements)?;
    dict.set_item("areas", column(py, rows.clone().map(|row| row.area)))?;
    let names: Vec<&str> = rows.map(|row| row.name.as_str()).collect();
    dict.set_item("names", names)?;
    let mesh = answer.mesh.iter().flatten();
    let corners = mesh.clone().flat_map(|element| &element.corners);
    let vertices = corners.clone().flatten().copied().collect();
    dict.set_item("vertices", matrix(py, vertices, [corners.count(), 3])?)?;
    let counts: Vec<usize> = mesh.clone().map(|element| element.corners.len()).collect();
    dict.set_item("counts", counts)?;
    let faces: Vec<usize> = mesh.clone().map(|element| element.row).collect();
    dict.set_item("element_faces", faces)?;
    let values = column(py, mesh.map(|element| element.radiosity));
    dict.set_item("element_values", values)?;
    dict.set_item("steps", pythonize::pythonize(py, &answer.steps)?)?;
    dict.set_item("oracle", answer.oracle)?;
    dict.set_item("linear", answer.linear)?;
    Ok(dict)
}
