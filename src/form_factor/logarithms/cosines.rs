//! The integrals of the logarithms of the cosines, formula (a) of the [module above](super).

use super::face::{Edge, Face};
use super::panels::{Singularities, over_panels, to_plane};
use crate::numeric::{
    CompensatedSum, GaussLegendre, dilogarithm_deficit, dilogarithm_of_complement,
};

/// Shortest panels, relative to the root of the exchange area: the integrand is bounded, so that
/// only the square of the length counts.
const SHORTEST_PANEL: f64 = 1e-8;

/// A constant added to the integrand of (a) changes nothing, so that it is counted from its value
/// where r is far above h, or where r is h.
#[derive(Debug, Clone, Copy)]
enum Level {
    /// `Li₂(1 − h²/r²) − π²/6`, small for r ≫ h.
    Far,
    /// `Li₂(1 − h²/r²)`, small for r ≈ h.
    Above,
}

/// Height of the lowest point, relative to the farthest distance, above which `h²/r²` is nearer to
/// 1 than to 0.
const ABOVE: f64 = 0.7;

impl Face {
    /// `∮∮ Li₂(1 − h²/r²) dl·dl'`, h the height over this plane, and the sum of the magnitudes.
    ///
    /// **Arguments** `flat`: heights up to it are 0; `exchange`: the exchange area, which sets the
    /// scale of what may be left out.
    pub(super) fn cosine_part(
        &self,
        other: &Self,
        flat: f64,
        exchange: f64,
        gauss: &GaussLegendre,
    ) -> [f64; 2] {
        let shortest = SHORTEST_PANEL * exchange.sqrt();
        let [lowest, _] = self.heights(other);
        let corners = || {
            self.corners
                .iter()
                .flat_map(|a| other.corners.iter().map(|b| a.distance(*b)))
        };
        let farthest = corners().fold(0.0, f64::max);
        let level = if lowest > ABOVE * farthest {
            Level::Above
        } else {
            Level::Far
        };
        let mut sum = CompensatedSum::default();
        let mut size = 0.0;
        for outer in &other.edges {
            let start = self.height(outer.start);
            let slope = self.normal.dot(outer.along);
            let is_in_plane = start.abs() <= flat && (start + slope * outer.length).abs() <= flat;
            if is_in_plane {
                continue;
            }
            for inner in &self.edges {
                let dot = outer.along.dot(inner.along);
                if dot.abs() <= f64::EPSILON {
                    continue;
                }
                let term = dot * edge_pair(outer, inner, [start, slope], level, shortest, gauss);
                sum.add(term);
                size += term.abs();
            }
        }
        [sum.total(), size]
    }
}

/// `∫∫ Li₂(1 − h²/r²)` along two edges, counted from the level; h starts at `height[0]` and grows
/// by `height[1]` along the outer one, and is singular at 0.
fn edge_pair(
    outer: &Edge,
    inner: &Edge,
    height: [f64; 2],
    level: Level,
    shortest: f64,
    gauss: &GaussLegendre,
) -> f64 {
    let singularities = Singularities::new(outer, inner);
    let gap = |s: f64| singularities.gap(outer, s).min(to_plane(height, s));
    let along = |s: f64| {
        let from = outer.at(s) - inner.start;
        let height = height[0] + height[1] * s;
        let square = height * height;
        let foot = from.dot(inner.along);
        let beside = from.cross(inner.along).length();
        let gap = |t: f64| (t - foot).hypot(beside);
        let kernel = |t: f64| {
            let r = (t - foot) * (t - foot) + beside * beside;
            let y = if r > 0.0 { square / r } else { 1.0 };
            match level {
                Level::Far => -dilogarithm_deficit(y),
                Level::Above => dilogarithm_of_complement(y),
            }
        };
        over_panels(inner.length, shortest, gap, kernel, gauss)
    };
    over_panels(outer.length, shortest, gap, along, gauss)
}
