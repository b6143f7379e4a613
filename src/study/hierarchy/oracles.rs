//! The oracles on equal terms: error against elements, links, form factors and seconds.
//!
//! Each room is refined to the same numbers of elements by each oracle, in quarters; by the
//! gradient also in two at the best place across an element, by least squares and by information.
//! Errors are relative L2 over all that is not light, against a reference on a mesh many times
//! finer.
//!
//! ```text
//!   error ≥ projection error ≥ that of the best mesh        greedy by the true error: `true`
//! ```
//!
//! The first ratio is what links lose, the second what the oracle loses.

use super::rooms::{Judge, Room};
use crate::hierarchy::{CutCriterion, Division, Goal, OracleName};
use crate::study::StudyError;
use std::time::Instant;

/// The rooms, from the prototypes of boxes to those with shadows.
const ROOMS: [&str; 8] = [
    "lit-cube",
    "lit-cube-edge",
    "lit-hall",
    "lit-wings",
    "shaded-cube",
    "lit-table",
    "cornell-box",
    "cornell-box-blocks",
];
/// The rooms of a quick study.
const QUICK_ROOMS: usize = 1;
/// The meshes.
const ELEMENTS: [usize; 3] = [100, 300, 1000];
const QUICK_ELEMENTS: usize = 2;
/// The elements of a reference.
const REFERENCE: usize = 24_000;
const QUICK_REFERENCE: usize = 6_000;

/// One refinement of one room.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct OracleRow {
    /// The room.
    pub case: String,
    /// The oracle, and how elements are cut if not in quarters.
    pub method: String,
    /// The elements of the mesh.
    pub elements: usize,
    /// The links of the mesh.
    pub links: usize,
    /// The form factors of links that were computed.
    pub evaluations: u64,
    /// The form factors of points, and integrals of pairs, that the oracle asked for beyond them.
    pub oracle_points: u64,
    /// The integrals over pairs.
    pub oracle_pairs: u64,
    /// The error of the constants, relative.
    pub relative_error: f64,
    /// The error of the linear functions, relative.
    pub linear_error: f64,
    /// The error of the best constants on the mesh, relative.
    pub projection_error: f64,
    /// The error estimate of the reference, relative.
    pub reference_error: f64,
    /// The time of the whole refinement, in seconds.
    pub seconds: f64,
}

/// The rows of the study.
///
/// # Errors
/// None that is known: the rooms are built in and lit.
pub fn oracles(quick: bool) -> Result<Vec<OracleRow>, StudyError> {
    let (rooms, meshes, reference) = if quick {
        (QUICK_ROOMS, QUICK_ELEMENTS, QUICK_REFERENCE)
    } else {
        (ROOMS.len(), ELEMENTS.len(), REFERENCE)
    };
    let mut rows = Vec::new();
    for name in &ROOMS[..rooms] {
        let room = Room::try_new(name)?;
        let judge = room.judge(reference)?;
        for elements in &ELEMENTS[..meshes] {
            for name in OracleName::ALL {
                rows.push(row(&room, &judge, (name, Division::Quarters), *elements)?);
            }
            for criterion in [CutCriterion::MeanSquare, CutCriterion::Information] {
                let division = Division::Bisection(criterion);
                rows.push(row(
                    &room,
                    &judge,
                    (OracleName::Gradient, division),
                    *elements,
                )?);
            }
        }
    }
    Ok(rows)
}

fn row(
    room: &Room,
    judge: &Judge,
    (oracle, division): (OracleName, Division),
    elements: usize,
) -> Result<OracleRow, StudyError> {
    let reference = &judge.reference;
    let judged = oracle.oracle(Some(reference))?;
    let start = Instant::now();
    let mut mesh = room.refinement()?.with_division(division);
    mesh.refine(&*judged, Goal::Elements(elements), &mut |_| ())?;
    let seconds = start.elapsed().as_secs_f64();
    let (tree, lighting, solution) = (mesh.tree(), mesh.lighting(), mesh.solution());
    let cost = mesh.oracle_cost();
    Ok(OracleRow {
        case: room.name.to_owned(),
        method: match division {
            Division::Quarters => oracle.to_string(),
            Division::Bisection(CutCriterion::MeanSquare) => "best cut, mean square".to_owned(),
            Division::Bisection(CutCriterion::Information) => "best cut, information".to_owned(),
        },
        elements: tree.leaf_count(),
        links: mesh.links().count(),
        evaluations: mesh.evaluations(),
        oracle_points: cost.points,
        oracle_pairs: cost.pairs,
        relative_error: reference.error_of(tree, solution),
        linear_error: reference.linear_error_of(tree, lighting, solution),
        projection_error: reference.projection_error_of(tree),
        reference_error: judge.error,
        seconds,
    })
}
