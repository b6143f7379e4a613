//! Plates half-way between two unit squares, whose exchange is known exactly.

use super::OccludedPair;
use crate::geometry::{GeometryError, Patch};
use crate::reference::{Truth, past_halfway_plates};
use crate::study::StudyError;
use glam::DVec3;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The spans of a plate along x and y.
pub(crate) type Plate = [[f64; 2]; 2];

/// A rectangle at a height that faces up or down.
pub(crate) fn level([x, y]: Plate, z: f64, is_up: bool) -> Result<Patch, GeometryError> {
    let around = [[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]];
    let mut corners = around.map(|[x, y]| DVec3::new(x, y, z)).to_vec();
    if !is_up {
        corners.reverse();
    }
    Patch::try_new(corners)
}

/// The unit square as a span.
pub(crate) const UNIT: Plate = [[0.0, 1.0]; 2];

/// Two unit squares at a distance, with plates half-way, and what they exchange.
pub(crate) fn pair(
    case: &str,
    height: f64,
    plates: &[Plate],
) -> Result<(OccludedPair, Truth), StudyError> {
    let plate = |plate: &Plate| level(*plate, 0.5 * height, true);
    let blockers: Result<Vec<Patch>, _> = plates.iter().map(plate).collect();
    let pair = OccludedPair {
        pair: [level(UNIT, 0.0, true)?, level(UNIT, height, false)?],
        blockers: blockers?,
    };
    let truth = past_halfway_plates(height, plates);
    let truth = truth.map_err(|source| StudyError::FormFactor {
        case: case.to_owned(),
        source,
    })?;
    Ok((pair, truth))
}

/// One to three plates of random sizes, side by side, at a distance of 1/4 to 2; always the same
/// for a number. Coordinates are multiples of 2⁻²⁰.
pub(crate) fn case(number: u64) -> Result<(OccludedPair, Truth), StudyError> {
    let mut random = ChaCha8Rng::seed_from_u64(number);
    let mut between = |lower: f64, upper: f64| {
        let steps = 20f64.exp2();
        ((lower + (upper - lower) * random.random::<f64>()) * steps).round() / steps
    };
    let height = between(0.25, 2.0);
    let mut plates = Vec::new();
    let mut start = between(-0.25, 0.25);
    for _ in 0..=number % 3 {
        let width = between(0.05, 0.3);
        let y = [between(-0.25, 0.5), between(0.55, 1.25)];
        plates.push([[start, start + width], y]);
        start += width + between(0.01, 0.2);
    }
    pair("plates half-way", height, &plates)
}
