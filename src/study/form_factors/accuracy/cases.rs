//! The cases of the study, with their exact values.

use super::HALFWAY;
use crate::form_factor::Polygon;
use crate::geometry::Patch;
use crate::numeric::try_parallel_map;
use crate::reference::{Truth, exchange_area_past};
use crate::study::StudyError;
use crate::study::form_factors::families::Family;
use crate::study::form_factors::occluded::{OccludedFamily, OccludedPair, halfway, known};
use glam::DVec3;

/// Two polygons, what is in the way, and what they exchange past it.
#[derive(Debug)]
pub(super) struct Pair {
    pub(super) patches: [Patch; 2],
    pub(super) blockers: Vec<Patch>,
    pub(super) polygons: [Polygon; 2],
    pub(super) blocking: Vec<Polygon>,
    pub(super) truth: Truth,
}

impl Pair {
    fn new(patches: [Patch; 2], truth: Truth) -> Self {
        let bare = OccludedPair {
            pair: patches,
            blockers: Vec::new(),
        };
        Self::past(bare, truth)
    }

    fn past(occluded: OccludedPair, truth: Truth) -> Self {
        let OccludedPair { pair, blockers } = occluded;
        Self {
            polygons: pair.each_ref().map(Polygon::new),
            blocking: blockers.iter().map(Polygon::new).collect(),
            patches: pair,
            blockers,
            truth,
        }
    }
}

/// Pairs under a name.
#[derive(Debug)]
pub(super) struct Case {
    pub(super) name: String,
    pub(super) family: String,
    pub(super) pairs: Vec<Pair>,
}

/// So many pairs of each family, each family a case.
pub(super) fn random_cases(count: usize, is_quick: bool) -> Result<Vec<Case>, StudyError> {
    let case = |family: Family| {
        let name = family.name();
        let pairs = try_parallel_map(count, &|number| {
            let patches = family.pair(number as u64)?;
            let truth = if is_quick {
                Truth::by_double_double(&patches)
            } else {
                Truth::of(&patches)
            };
            let truth = truth.map_err(|source| StudyError::FormFactor {
                case: format!("{name} {number}"),
                source,
            });
            Ok::<_, StudyError>(Pair::new(patches, truth?))
        })?;
        Ok(Case {
            name: format!("{count} pairs: {name}"),
            family: name.to_owned(),
            pairs,
        })
    };
    Family::ALL.into_iter().map(case).collect()
}

/// Pairs past others: those of a file, plates half-way between two squares, and pairs of each
/// family, judged by the slow road.
///
/// `is_quick`: of each kind in the file one with at most two blockers, few plates, and no families,
/// whose slow road takes minutes.
pub(super) fn occluded_cases(is_quick: bool) -> Result<Vec<Case>, StudyError> {
    let mut cases = Vec::new();
    let all = known::pairs()?;
    for kind in all.chunk_by(|a, b| a.kind == b.kind) {
        let few = kind.iter().filter(|known| known.pair.blockers.len() <= 2);
        let taken: Vec<_> = if is_quick {
            few.take(1).collect()
        } else {
            kind.iter().collect()
        };
        let pairs = taken.iter();
        let pairs = pairs.map(|known| Pair::past(known.pair.clone(), known.truth.clone()));
        let pairs: Vec<Pair> = pairs.collect();
        if let Some(known) = taken.first() {
            cases.push(Case {
                name: format!("{} known: {}", pairs.len(), known.kind),
                family: format!("past others, known: {}", known.kind),
                pairs,
            });
        }
    }
    let count = if is_quick { 2 } else { 16 };
    let plates = try_parallel_map(count, &|number| {
        let (pair, truth) = halfway::case(number as u64)?;
        Ok::<_, StudyError>(Pair::past(pair, truth))
    })?;
    cases.push(Case {
        name: format!("{count} pairs: {HALFWAY}"),
        family: HALFWAY.to_owned(),
        pairs: plates,
    });
    if !is_quick {
        for family in OccludedFamily::ALL {
            cases.push(by_the_slow_road(family)?);
        }
    }
    Ok(cases)
}

/// The first pairs of a family of which the slow road knows three digits and more.
fn by_the_slow_road(family: OccludedFamily) -> Result<Case, StudyError> {
    const PAIRS: usize = 2;
    const TRIED: u64 = 8;
    let name = family.name();
    let mut pairs = Vec::new();
    for number in 0..TRIED {
        let case = family.case(number)?;
        let [first, second] = &case.pair;
        let found = exchange_area_past(first, second, &case.blockers, 1e-8);
        let found = found.map_err(|source| StudyError::FormFactor {
            case: format!("{name} {number}"),
            source,
        })?;
        if found.error < 1e-3 * found.value {
            let truth = Truth::by_estimate(found.value, found.error);
            pairs.push(Pair::past(case, truth));
        }
        if pairs.len() == PAIRS {
            break;
        }
    }
    Ok(Case {
        name: format!("{} pairs past others: {name}", pairs.len()),
        family: format!("past others: {name}"),
        pairs,
    })
}

/// The pairs of `form_factors.csv`, each a case.
pub(super) fn known_cases() -> Result<Vec<Case>, StudyError> {
    const TABLE: &str = include_str!("../../../../data/reference/form_factors.csv");
    /// Half a unit of the last of 30 significant digits.
    const UNCERTAINTY: f64 = 0.5e-29;
    let mut reader = csv::Reader::from_reader(TABLE.as_bytes());
    let mut cases = Vec::new();
    for record in reader.deserialize() {
        let record: Record = record?;
        let number = |text: &str| StudyError::Number {
            id: record.id.clone(),
            text: text.to_owned(),
        };
        let patch = |text: &str| -> Result<Patch, StudyError> {
            let texts: Vec<[String; 3]> = serde_json::from_str(text)?;
            let corner = |texts: &[String; 3]| {
                let mut parts = [0.0; 3];
                for (part, text) in parts.iter_mut().zip(texts) {
                    *part = text.parse().map_err(|_| number(text))?;
                }
                Ok(DVec3::from_array(parts))
            };
            let corners: Result<_, StudyError> = texts.iter().map(corner).collect();
            Ok(Patch::try_new(corners?)?)
        };
        let (first, second) = record
            .inputs
            .trim_start_matches("P=")
            .split_once(";Q=")
            .ok_or_else(|| number(&record.inputs))?;
        let truth = Truth::from_decimals(&record.exchange_area, UNCERTAINTY)
            .ok_or_else(|| number(&record.exchange_area))?;
        let family = match record.id.split('_').nth(1) {
            Some("par") => "known, parallel rectangles",
            Some("perp") => "known, perpendicular rectangles",
            Some("incl") => "known, inclined squares",
            _ => "known, other polygons",
        };
        cases.push(Case {
            pairs: vec![Pair::new([patch(first)?, patch(second)?], truth)],
            name: record.description,
            family: family.to_owned(),
        });
    }
    Ok(cases)
}

/// The columns of the file that are read.
#[derive(Debug, serde::Deserialize)]
struct Record {
    id: String,
    description: String,
    inputs: String,
    exchange_area: String,
}
