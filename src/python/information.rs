//! Information of a scene, and the cuts that gain the most.

use super::arrays::column;
use super::call::{Call, answered};
use super::form_factors::GivenAccuracy;
use super::materials::GivenLight;
use super::scene::GivenScene;
use crate::geometry::SplitAxis;
use crate::information::OpenScene;
use crate::question::{Measure, MeasureAnswer, PatchName, Split, Unreached};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// `MutualInformation` and `ContinuousInformation` of the package.
#[pyfunction]
pub(super) fn measure<'py>(
    py: Python<'py>,
    scene: GivenScene<'py>,
    accuracy: GivenAccuracy,
    light: GivenLight,
    is_open: bool,
    is_continuous: bool,
    call: Call,
) -> PyResult<Bound<'py, PyDict>> {
    let recipe = scene.recipe()?;
    let (tolerance, congruence) = accuracy.asked()?;
    let meant = (light.chain()?, light.channel()?);
    let (answer, names, notes) = answered(py, &call, move |progress| {
        let opened = recipe.open()?;
        let question = Measure {
            scene: opened.source(),
            tolerance,
            congruence,
            light: light.light(meant, opened.rows())?,
            open_scene: if is_open {
                OpenScene::AddOutsideState
            } else {
                OpenScene::Refuse
            },
            continuous: is_continuous,
            pairs: false,
            store: None,
        };
        let answer = question.ask(progress)?;
        let names = opened.names();
        let notes = opened.remarks(answer.notes.clone());
        Ok((answer, names, notes))
    })?;
    let dict = measured(py, &answer)?;
    dict.set_item("names", names)?;
    dict.set_item("notes", notes)?;
    Ok(dict)
}

/// The numbers and columns of a scene's information.
fn measured<'py>(py: Python<'py>, answer: &MeasureAnswer) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("total_area", answer.total_area)?;
    dict.set_item("closed", answer.closed)?;
    dict.set_item("positional_entropy", answer.positional_entropy)?;
    dict.set_item("entropy_rate", answer.entropy_rate)?;
    dict.set_item("mutual_information", answer.mutual_information)?;
    dict.set_item("error", answer.mutual_information_error)?;
    dict.set_item("grade", answer.error_grade.name())?;
    dict.set_item("resolution", answer.resolution)?;
    dict.set_item("resolution_error", answer.resolution_error)?;
    let rows = answer.contributions.iter();
    let terms = rows.clone().map(|row| row.mutual_information);
    dict.set_item("contributions", column(py, terms))?;
    dict.set_item("weights", column(py, rows.clone().map(|row| row.weight)))?;
    dict.set_item("row_sums", column(py, rows.map(|row| row.row_sum)))?;
    dict.set_item("outside_contribution", answer.outside_contribution)?;
    dict.set_item("continuous", answer.continuous_mutual_information)?;
    dict.set_item("continuous_error", answer.continuous_error)?;
    let grade = answer.continuous_error_grade.map(|grade| grade.name());
    dict.set_item("continuous_grade", grade)?;
    dict.set_item("lower_bound", answer.continuous_lower_bound)?;
    dict.set_item("lines", answer.continuous_lines)?;
    let unreached = answer.unreached.as_ref().map(Unreached::to_string);
    dict.set_item("unreached", unreached)?;
    Ok(dict)
}

/// `BestSplit` of the package.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "they are those of the question")]
pub(super) fn best_split<'py>(
    py: Python<'py>,
    scene: GivenScene<'py>,
    patch: String,
    against: Vec<String>,
    axis: Option<String>,
    parts: u32,
    precision: Option<u32>,
    light: GivenLight,
    call: Call,
) -> PyResult<Bound<'py, PyDict>> {
    let recipe = scene.recipe()?;
    let meant = (light.chain()?, light.channel()?);
    let axis = axis.map(|name| axis_named(&name)).transpose()?;
    let (answer, notes) = answered(py, &call, move |progress| {
        let opened = recipe.open()?;
        let against = against.iter().map(|name| PatchName::from(name.as_str()));
        let question = Split {
            scene: opened.source(),
            patch: PatchName::from(patch.as_str()),
            against: against.collect(),
            axis,
            parts,
            precision,
            light: light.light(meant, opened.rows())?,
        };
        let answer = question.ask(progress)?;
        let notes = opened.remarks(answer.notes.clone());
        Ok((answer, notes))
    })?;
    let dict = PyDict::new(py);
    dict.set_item("face", answer.patch)?;
    dict.set_item("axis", answer.axis)?;
    dict.set_item("position", answer.position)?;
    dict.set_item("positions", column(py, answer.positions.iter().copied()))?;
    dict.set_item("position_error", answer.position_error)?;
    dict.set_item("gain", answer.gain)?;
    dict.set_item("gain_relative_error", answer.gain_error)?;
    dict.set_item("gain_at_middle", answer.gain_at_middle)?;
    dict.set_item("maximum_gain", answer.maximum_gain)?;
    dict.set_item("residual", answer.residual)?;
    let enclosures = answer.enclosures.as_ref();
    let enclosures = enclosures.map(|found| pythonize::pythonize(py, found));
    dict.set_item("enclosures", enclosures.transpose()?)?;
    dict.set_item("notes", notes)?;
    Ok(dict)
}

fn axis_named(name: &str) -> PyResult<SplitAxis> {
    let mut all = SplitAxis::ALL.into_iter();
    let found = all.find(|axis| axis.name() == name);
    found.ok_or_else(|| {
        PyValueError::new_err(format!("axis is {name:?}: it must be \"u\" or \"v\""))
    })
}
