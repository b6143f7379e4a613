//! Gauss rules on panels short against the distance of the nearest singularity.

use super::face::Edge;
use crate::numeric::{CompensatedSum, GaussLegendre, tolerance};
use glam::DVec3;

/// Half a panel is at most this part of the distance to the nearest singularity: (a) with ρ = 2.5 +
/// √5.25 = 4.79 the rule of 13 points leaves 2e-18.
pub(super) const REACH: f64 = 0.4;

/// The integral from 0 to `length`, on panels at most [`REACH`] of the distance to the nearest
/// singularity each way, but not shorter than `shortest`, nor than what places are known to.
pub(super) fn over_panels(
    length: f64,
    shortest: f64,
    gap: impl Fn(f64) -> f64,
    integrand: impl Fn(f64) -> f64,
    gauss: &GaussLegendre,
) -> f64 {
    debug_assert!(length >= 0.0, "{length}");
    let shortest = shortest.max(f64::EPSILON * length);
    let mut sum = CompensatedSum::default();
    let mut open = vec![[0.0, length]];
    while let Some([start, end]) = open.pop() {
        let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
        if half > REACH * gap(middle) && half > shortest {
            open.push([middle, end]);
            open.push([start, middle]);
            continue;
        }
        let rule = gauss.nodes.iter().zip(&gauss.weights);
        let values = rule.map(|(node, weight)| weight * integrand(middle + half * node));
        sum.add(half * values.sum::<f64>());
    }
    sum.total()
}

/// The places on a path at which an integral along an edge is singular: at the ends of the edge,
/// and where the lines are nearest, as far off the real line as their distance over the sine of
/// their angle.
pub(super) struct Singularities {
    ends: [DVec3; 2],
    /// The place on the path, and the distance off it.
    crossing: Option<[f64; 2]>,
}

impl Singularities {
    pub(super) fn new(path: &Edge, edge: &Edge) -> Self {
        let between = edge.start - path.start;
        let turn = path.along.cross(edge.along);
        let sine = turn.length();
        let crossing = (sine > tolerance::ALIGNMENT).then(|| {
            let at = between.cross(edge.along).dot(turn) / (sine * sine);
            [at, between.dot(turn) / (sine * sine)]
        });
        Self {
            ends: [edge.start, edge.at(edge.length)],
            crossing,
        }
    }

    /// The distance of the nearest one from the place `s` of the path.
    pub(super) fn gap(&self, path: &Edge, s: f64) -> f64 {
        let point = path.at(s);
        let ends = self.ends.map(|end| end.distance(point));
        let gap = ends[0].min(ends[1]);
        self.crossing
            .map_or(gap, |[at, aside]| gap.min((s - at).hypot(aside)))
    }
}

/// The distance along a path to the plane that it rises from: `height` at its start, `slope` along
/// it.
pub(super) fn to_plane([start, slope]: [f64; 2], s: f64) -> f64 {
    if slope.abs() > f64::EPSILON {
        (start / slope + s).abs()
    } else {
        f64::INFINITY
    }
}
