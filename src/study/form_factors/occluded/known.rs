//! The pairs of `occlusion.json`, with values by two independent integrals.

use super::OccludedPair;
use crate::geometry::{GeometryError, Patch};
use crate::reference::Truth;
use crate::study::StudyError;
use glam::DVec3;

/// A pair of the file.
#[derive(Debug, Clone)]
pub(crate) struct KnownPair {
    /// The kind of the pair, from its name.
    pub(crate) kind: String,
    pub(crate) pair: OccludedPair,
    /// The exchange area of the pair past its blockers.
    pub(crate) truth: Truth,
}

/// All pairs of the file, in its order.
pub(crate) fn pairs() -> Result<Vec<KnownPair>, StudyError> {
    const TABLE: &str = include_str!("../../../../data/reference/occlusion.json");
    let table: Table = serde_json::from_str(TABLE).map_err(StudyError::OccludedPairs)?;
    table.cases.iter().map(known).collect()
}

fn known(record: &Record) -> Result<KnownPair, StudyError> {
    let patch = |corners: &Vec<[f64; 3]>| {
        let corners = corners.iter().map(|corner| DVec3::from_array(*corner));
        Patch::try_new(corners.collect())
    };
    let blockers: Result<_, GeometryError> = record.blockers.iter().map(patch).collect();
    let pair = [patch(&record.first)?, patch(&record.second)?];
    // the file has form factors, and the area is rounded
    let uncertainty = record.uncertainty + f64::EPSILON;
    let truth = Truth::from_decimals(&record.value, uncertainty);
    let truth = truth.ok_or_else(|| StudyError::Number {
        id: record.id.clone(),
        text: record.value.clone(),
    })?;
    let kind = match record.id.split_once("_of_") {
        Some(_) => "rotated",
        None => record.id.rsplit_once('_').map_or("", |(kind, _)| kind),
    };
    Ok(KnownPair {
        kind: kind.replace('_', " "),
        truth: truth.times(pair[0].area()),
        pair: OccludedPair {
            pair,
            blockers: blockers?,
        },
    })
}

#[derive(Debug, serde::Deserialize)]
struct Table {
    cases: Vec<Record>,
}

/// A case as it is read.
#[derive(Debug, serde::Deserialize)]
struct Record {
    id: String,
    #[serde(rename = "P")]
    first: Vec<[f64; 3]>,
    #[serde(rename = "Q")]
    second: Vec<[f64; 3]>,
    blockers: Vec<Vec<[f64; 3]>>,
    value: String,
    uncertainty: f64,
}
