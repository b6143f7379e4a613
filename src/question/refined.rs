//! The light on a refined mesh: the records of a refinement's answer.

use super::unfolded::MeshNet;
use crate::hierarchy::{ErrorBound, HierarchyError, Refinement};
use crate::numeric::{real, try_parallel_map};
use crate::scene::Scene;

/// The light on a refined mesh, as a record whose keys are relied on by scripts.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[non_exhaustive]
pub struct RefineAnswer {
    /// The mesh of the patches, then that of each round.
    pub steps: Vec<RefineStep>,
    /// The name of the oracle.
    pub oracle: &'static str,
    /// The name of the scene.
    pub scene: String,
    /// Is the solution linear on each element, not constant?
    pub linear: bool,
    /// The light of the rows that have a patch, in the end.
    pub patches: Vec<RefinedPatch>,
    /// The elements of the last mesh, if they were asked for.
    #[serde(skip)]
    pub mesh: Option<Vec<LitElement>>,
    /// The net of the scene, if it was asked for.
    #[serde(skip)]
    pub net: Option<MeshNet>,
    /// Remarks of the scene's reader.
    #[serde(skip)]
    pub notes: Vec<String>,
}

/// A step of the refinement: the keys are relied on by scripts. Errors are those of the radiosity
/// in L2, relative, over all that is not light, against the continuous solution.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct RefineStep {
    /// Elements of the mesh.
    pub elements: usize,
    /// Links between them.
    pub links: usize,
    /// Form factors that were computed so far.
    pub evaluations: u64,
    /// Time that was taken so far, without that for this record.
    pub seconds: f64,
    /// A bound on the error of the last step; none for the others, for more than 2,000 elements,
    /// past what stands in the way unless it is asked for, or where none is known.
    pub error_bound: Option<f64>,
    /// An estimate of the error; none for a linear solution.
    pub error_estimate: Option<f64>,
    /// The mutual information of the radiosity chain of the links, in bits
    /// ([`link_information`](crate::hierarchy::link_information)).
    pub mutual_information: Option<f64>,
}

/// The light of one row: the keys are relied on by scripts.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct RefinedPatch {
    /// The row, from 0.
    pub index: usize,
    /// The name of the row.
    pub name: String,
    /// The area.
    pub area: f64,
    /// Elements that it was cut into.
    pub elements: usize,
    /// The mean radiosity, in the unit of the emittances.
    pub radiosity: f64,
    /// A bound on what the mean radiosity is off, in the same unit, where the error is bounded.
    pub radiosity_error: Option<f64>,
    /// The mean irradiance, in the same unit.
    pub irradiance: f64,
    /// The mean radiosity after one more gather, if it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gathered: Option<f64>,
}

/// An element of a refined mesh, and its light.
#[derive(Debug, Clone, PartialEq)]
pub struct LitElement {
    /// The row that it is a piece of.
    pub row: usize,
    /// The corners in order, counter-clockwise seen from the front.
    pub corners: Vec<[f64; 3]>,
    /// The mean radiosity, in the unit of the emittances.
    pub radiosity: f64,
}

/// The elements of a refined mesh.
pub(super) fn lit_elements(scene: &Scene, refinement: &Refinement<'_>) -> Vec<LitElement> {
    let (tree, radiosity) = (refinement.tree(), &refinement.solution().radiosity);
    let elements = tree.leaves().map(|leaf| {
        let element = &tree.elements()[leaf];
        let corners = element.shape().corners().iter();
        LitElement {
            row: scene.group_of(element.patch()),
            corners: corners.map(|corner| corner.to_array()).collect(),
            radiosity: radiosity[leaf],
        }
    });
    elements.collect()
}

impl RefineStep {
    /// The step in one line, as round so many.
    pub(super) fn told(&self, round: usize) -> String {
        let (elements, links, seconds) = (self.elements, self.links, self.seconds);
        let error = self.error_estimate;
        let error = error.map_or_else(String::new, |error| format!(", error about {error:.1e}"));
        format!("round {round}: {elements} elements, {links} links{error}, {seconds:.2} s")
    }
}

/// The light of the rows that have a patch: means over the leaves; gathered once more, if that is
/// asked for.
pub(super) fn lit_rows(
    scene: &Scene,
    refinement: &Refinement<'_>,
    is_gathered: bool,
    bound: Option<&ErrorBound>,
) -> Result<Vec<RefinedPatch>, HierarchyError> {
    let (tree, solution) = (refinement.tree(), refinement.solution());
    let names = scene.group_names().into_iter().enumerate();
    let mut rows: Vec<RefinedPatch> = names.map(|(index, name)| empty(index, name)).collect();
    let leaves: Vec<usize> = tree.leaves().collect();
    let gathered = is_gathered
        .then(|| try_parallel_map(leaves.len(), &|k| gathered_mean(refinement, leaves[k])));
    let gathered = gathered.transpose()?;
    for (k, leaf) in leaves.iter().copied().enumerate() {
        let element = &tree.elements()[leaf];
        let row = &mut rows[scene.group_of(element.patch())];
        let area = element.shape().area();
        row.area += area;
        row.elements += 1;
        row.radiosity += area * solution.radiosity[leaf];
        row.irradiance += area * solution.received.irradiance[leaf];
        if let Some(gathered) = &gathered {
            *row.gathered.get_or_insert(0.0) += area * gathered[k];
        }
    }
    if let Some(bound) = bound {
        for row in rows.iter_mut().filter(|row| row.elements > 0) {
            row.radiosity_error = Some(error_of_row(scene, refinement, row, bound)?);
        }
    }
    rows.retain(|row| row.elements > 0);
    for row in &mut rows {
        row.radiosity /= row.area;
        row.irradiance /= row.area;
        row.gathered = row.gathered.map(|sum| sum / row.area);
    }
    Ok(rows)
}

/// A bound on the error of the mean radiosity of a row, of which `radiosity` is the integral.
fn error_of_row(
    scene: &Scene,
    refinement: &Refinement<'_>,
    row: &RefinedPatch,
    bound: &ErrorBound,
) -> Result<f64, HierarchyError> {
    let tree = refinement.tree();
    let in_row = |leaf: usize| scene.group_of(tree.elements()[leaf].patch()) == row.index;
    let share = |leaf: usize| if in_row(leaf) { 1.0 / row.area } else { 0.0 };
    let mean = bound.goal(&tree.leaves().map(share).collect::<Vec<f64>>())?;
    Ok((mean.value - row.radiosity / row.area).abs() + mean.error)
}

/// The mean of the light that points of a leaf gather.
fn gathered_mean(refinement: &Refinement<'_>, leaf: usize) -> Result<f64, HierarchyError> {
    let element = &refinement.tree().elements()[leaf];
    let points = element.gauss_points();
    let gathered = points.map(|point| refinement.gathered(leaf, point));
    let sum = gathered.sum::<Result<f64, _>>()?;
    Ok(sum / real(element.shape().corners().len()))
}

/// A row of which nothing is known yet.
fn empty(index: usize, name: &str) -> RefinedPatch {
    RefinedPatch {
        index,
        name: name.to_owned(),
        area: 0.0,
        elements: 0,
        radiosity: 0.0,
        radiosity_error: None,
        irradiance: 0.0,
        gathered: None,
    }
}
