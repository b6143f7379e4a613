//! The part of a line that lies in a region, and how long it ends where it does.
//!
//! ```text
//!   line ℓ runs with its positive side on the left; half-plane k begins or ends on it at
//!   s_k = (γ_k − α_k·p)/(α_k·w)         p: a point of ℓ, w: its direction
//! ```
//!
//! A plane of sight cuts two sides of a convex cone or none; which, the heights of its corners over
//! the plane tell.

use super::sight::{HalfPlane, Region};
use super::validity::{NONE, Validity};
use smallvec::SmallVec;

/// The part of a line in a region, but for what the line itself bounds.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chord {
    /// The lines at which it begins and ends; none if the line misses the region.
    pub ends: Option<[usize; 2]>,
    /// The t for which this is so.
    pub range: [f64; 2],
}

impl Chord {
    /// The chord of a line at the validity's t, and where it is the same; none if it cannot be
    /// told.
    pub(super) fn of(region: &Region, line: usize, validity: &Validity) -> Option<Self> {
        // what changes sign somewhere else may be a tie on all of the range
        [[0.0, 1.0], validity.range].into_iter().find_map(|range| {
            let mut validity = Validity { range, ..*validity };
            let ends = ends(region, line, &mut validity);
            validity.is_certain.then_some(Self {
                ends,
                range: validity.range,
            })
        })
    }
}

fn ends(region: &Region, line: usize, validity: &mut Validity) -> Option<[usize; 2]> {
    let mut halves: SmallVec<[HalfPlane; 8]> = SmallVec::new();
    let mut crossed: SmallVec<[[usize; 2]; 2]> = SmallVec::new();
    for cone in &region.cones {
        if validity.sight.is_level {
            halves.extend(cone.sides.iter().copied());
        } else if let Some(sides) = validity.crossing(cone, line) {
            halves.extend(sides.map(|side| cone.sides[side]));
            crossed.push(sides);
        } else {
            validity.keeps_missing(cone, line);
            return None;
        }
    }
    halves.extend(region.halves.iter().copied());
    let own = validity.placed[line];
    let mut ends = [(f64::NEG_INFINITY, NONE), (f64::INFINITY, NONE)];
    let mut bounds: SmallVec<[(usize, usize); 8]> = SmallVec::new();
    for half in halves.iter().filter(|half| half.line != line) {
        let other = validity.placed[half.line];
        if !other.is_line {
            // a plane of sight that is level: all of P is on one side of it
            if half.sign * validity.level_height(half.line) < 0.0 {
                return None;
            }
            continue;
        }
        let slope = half.sign * other.alpha.dot(own.direction);
        let height = half.sign * (other.alpha.dot(own.origin) - other.gamma);
        let is_nearly = slope.abs() <= NEARLY * other.alpha.length();
        if is_nearly && validity.is_parallel(line, half.line) {
            validity.stays_beside(line, half.line);
            if height < 0.0 {
                return None;
            }
            continue;
        }
        let at = -height / slope;
        let end = usize::from(slope < 0.0);
        bounds.push((end, half.line));
        let known = ends[end].0;
        if if end == 0 { at > known } else { at < known } {
            ends[end] = (at, half.line);
        }
    }
    let [low, high] = ends;
    if low.0 >= high.0 {
        // a beginning behind an end is enough
        validity.separates(line, [low.1, high.1]);
        return None;
    }
    for (cone, sides) in region.cones.iter().zip(crossed) {
        validity.keeps_crossing(cone, sides, line);
    }
    for (end, other) in bounds {
        validity.turns(line, other);
        validity.ordered(line, ends[end].1, other);
    }
    Some([low.1, high.1])
}

/// Lines that cross at more than this angle need not be asked whether they are parallel.
const NEARLY: f64 = 1e-6;
