//! The part of a line that lies in a region, at one t.
//!
//! ```text
//!   line ℓ runs with its positive side on the left; half-plane k begins or ends on it at
//!   s_k = (γ_k − α_k·p)/(α_k·w)         p: a point of ℓ, w: its direction
//! ```
//!
//! A plane of sight cuts two sides of a convex cone or none; which, the heights of its corners over
//! the plane tell.

use super::validity::{NONE, Place, Validity};
use crate::form_factor::occlusion::view::region::{HalfPlane, Region};
use smallvec::SmallVec;

/// The ends of the part of a line in a region at the validity's t, but for what the line itself
/// bounds; none if it misses the region, which is certified.
pub(crate) fn chord(region: &Region, line: usize, validity: &mut Validity) -> Option<[Place; 2]> {
    let mut cut: SmallVec<[[usize; 2]; 4]> = SmallVec::new();
    if !validity.sight.is_level {
        for cone in &region.cones {
            let Some(sides) = validity.crossing(cone, line) else {
                validity.keeps_missing(cone, line);
                return None;
            };
            cut.push(sides);
        }
    }
    let mut ends = UNBOUNDED;
    for (k, cone) in region.cones.iter().enumerate() {
        let is_left = match cut.get(k) {
            Some(sides) => {
                (sides.iter()).all(|side| narrows(cone.sides[*side], line, &mut ends, validity))
            }
            None => (cone.sides.iter()).all(|side| narrows(*side, line, &mut ends, validity)),
        };
        if !is_left {
            return None;
        }
    }
    let mut halves = region.halves.iter();
    if !halves.all(|half| narrows(*half, line, &mut ends, validity)) {
        return None;
    }
    if ends[0].at < ends[1].at {
        return Some(ends);
    }
    // a beginning behind an end is enough
    validity.separates(line, ends.map(|end| end.line));
    None
}

/// Narrows a part of a line to a half-plane; whether that may leave anything.
fn narrows(half: HalfPlane, line: usize, ends: &mut [Place; 2], validity: &mut Validity) -> bool {
    if half.line == line {
        return true;
    }
    let (own, other) = (&validity.placed[line], &validity.placed[half.line]);
    if !other.is_line {
        // a plane of sight that is level: all of P is on one side of it, for a moment or always
        validity.is_certain &= validity.sight.traces[half.line].is_level;
        return half.sign * validity.level_height(half.line) >= 0.0;
    }
    let slope = half.sign * other.alpha.dot(own.direction);
    let height = half.sign * (other.alpha.dot(own.origin) - other.gamma);
    let is_nearly = slope.abs() <= NEARLY * other.alpha.length();
    if is_nearly && validity.is_parallel(line, half.line) {
        validity.stays_beside(line, half.line);
        return height >= 0.0;
    }
    let at = -height / slope;
    let end = usize::from(slope < 0.0);
    let known = ends[end].at;
    if if end == 0 { at > known } else { at < known } {
        ends[end] = Place {
            at,
            line: half.line,
        };
    }
    true
}

/// All of a line.
const UNBOUNDED: [Place; 2] = [
    Place {
        at: f64::NEG_INFINITY,
        line: NONE,
    },
    Place {
        at: f64::INFINITY,
        line: NONE,
    },
];

/// Lines that cross at more than this angle need not be asked whether they are parallel.
const NEARLY: f64 = 1e-6;
