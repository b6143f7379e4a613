//! A bound on what an exchange area may differ by from that of rectangles that stand for the two.
//!
//! Two rectangles P and Q along the axes of a frame stand for two polygons whose corners are within
//! `δ` of theirs along each axis. Q is moved first along its normal, by a height that is linear
//! over it, then in its plane; then P. In its plane an edge sweeps at most `δ` times its length,
//! and the wall between the boundaries of a motion along the normal is as large. The flux through
//! either is no more than its area times the kernel:
//!
//! ```text
//!   |Δ(A F)| ≤ Σ_e δ |e| (D_k + D_w) [+ δ l],     D_k ≤ min(c_k, Σ_p A_p h d_k/(π r⁴))
//! ```
//!
//! The sums are over pieces e of the edges of Q and parts p of P, and over those of the edges of P
//! and parts of Q; `k` is the normal of Q, `w` the axis across the edge in its plane; `h` the
//! height of e over P's plane, `d_k` the largest distance of a point of p from one of e along k,
//! and `r` the distance of the two. At a place whose front runs along the plane of P, P fills half
//! the sky at most: `c_k` is ½, and 1 where k is the normal of P.
//!
//! Where part of P is behind the plane of Q, the line in which this plane cuts P moves as well. Q
//! shows that line its edge and receives nothing from it, unless it runs through Q itself, where
//! the plane moves by at most `δ`, and P fills half the sky: the last term, of perpendicular
//! rectangles that may touch in a line of length `l`. Parallel ones do not touch, as their planes
//! are apart.
//!
//! The models of congruent pairs differ, too: put together at the middle of each axis, their ends
//! are within the spread `ω` of the lattice of each other, as two of the four ends of an axis have
//! differences equal within `ω`, or are two such steps apart. Their polygons are off by `δ + ω`.
//!
//! **Not covered**: rectangles shorter than a million times `δ`.

use crate::geometry::FlatBox;
use crate::numeric::real;
use std::f64::consts::PI;

/// Rectangles are so many times longer than corners are off, at least.
const SHORTEST: f64 = 1e6;

/// The change of factors of an area, a distance or a cap while corners move, six of them in a row.
const MOVED: f64 = 1.0 + 1e-4;

/// A bound on the difference of the exchange areas of two rectangles along the axes of a frame and
/// of two polygons whose corners are within `offset` of theirs along each axis; infinite where
/// there is none.
pub(crate) fn offset_allowance(offset: f64, first: &FlatBox, second: &FlatBox) -> f64 {
    if offset <= 0.0 {
        return 0.0;
    }
    let lengths = |flat: &FlatBox| sides(flat).map(|axis| flat.upper[axis] - flat.lower[axis]);
    let [[a, b], [c, d]] = [lengths(first), lengths(second)];
    if a.min(b).min(c).min(d) < SHORTEST * offset {
        return f64::INFINITY;
    }
    let distance = gap(first, second);
    let longest = a.max(b).max(c).max(d);
    let pieces = match distance / longest {
        far if far > 4.0 => 1,
        far if far > 1.0 => 2,
        _ => 4,
    };
    // of either one, along each axis
    let reach = 4.0 * offset;
    let mut bound = swept(first, second, reach, pieces) + swept(second, first, reach, pieces);
    if distance <= reach {
        if first.axis == second.axis {
            return f64::INFINITY;
        }
        let along = 3 - first.axis - second.axis;
        let lengths = [first, second].map(|flat| flat.upper[along] - flat.lower[along]);
        bound += lengths[0].min(lengths[1]);
    }
    let bound = MOVED * offset * bound;
    if bound.is_nan() { f64::INFINITY } else { bound }
}

/// The axes of the sides.
const fn sides(flat: &FlatBox) -> [usize; 2] {
    [(flat.axis + 1) % 3, (flat.axis + 2) % 3]
}

/// The distance of two boxes.
fn gap(one: &FlatBox, other: &FlatBox) -> f64 {
    let squares = (0..3).map(|axis| {
        let apart = (other.lower[axis] - one.upper[axis]).max(one.lower[axis] - other.upper[axis]);
        apart.max(0.0).powi(2)
    });
    squares.sum::<f64>().sqrt()
}

/// A box cut into equal parts along an axis.
fn cut(whole: FlatBox, axis: usize, pieces: usize) -> impl Iterator<Item = FlatBox> {
    let length = whole.upper[axis] - whole.lower[axis];
    let at = move |k: usize| match k == pieces {
        true => whole.upper[axis],
        false => whole.lower[axis] + length * real(k) / real(pieces),
    };
    (0..pieces).map(move |piece| {
        let mut part = whole;
        (part.lower[axis], part.upper[axis]) = (at(piece), at(piece + 1));
        part
    })
}

/// The flux from a source through what the edges of another rectangle sweep, per distance.
fn swept(moved: &FlatBox, source: &FlatBox, reach: f64, pieces: usize) -> f64 {
    let [u, v] = sides(source);
    let rows = cut(*source, u, pieces);
    let parts: Vec<FlatBox> = rows.flat_map(|row| cut(row, v, pieces)).collect();
    let [one, other] = sides(moved);
    let mut sum = 0.0;
    for (along, across) in [(one, other), (other, one)] {
        for end in [moved.lower[across], moved.upper[across]] {
            let mut edge = *moved;
            (edge.lower[across], edge.upper[across]) = (end, end);
            for piece in cut(edge, along, pieces) {
                let length = piece.upper[along] - piece.lower[along];
                for axis in [moved.axis, across] {
                    sum += length * density(&piece, axis, &parts, reach);
                }
            }
        }
    }
    sum
}

/// The flux density from the parts of a source through a surface at a piece of an edge, whose
/// normal is along an axis.
fn density(edge: &FlatBox, axis: usize, parts: &[FlatBox], reach: f64) -> f64 {
    let cap = if axis == parts[0].axis { 1.0 } else { 0.5 };
    let mut sum = 0.0;
    for part in parts {
        let distance = gap(edge, part) - reach;
        if distance <= 0.0 {
            return cap;
        }
        let [u, v] = sides(part).map(|axis| part.upper[axis] - part.lower[axis]);
        let normal = part.axis;
        let height = if part.faces_along {
            edge.upper[normal] - part.lower[normal]
        } else {
            part.lower[normal] - edge.lower[normal]
        };
        let [above, below] = [
            part.upper[axis] - edge.lower[axis],
            edge.upper[axis] - part.lower[axis],
        ];
        let apart = match (axis == edge.axis, edge.faces_along) {
            // no more than is in front
            (true, true) => above.max(0.0),
            (true, false) => below.max(0.0),
            (false, _) => above.max(below),
        };
        sum += u * v * (height.max(0.0) + reach) * (apart + reach) / distance.powi(4);
    }
    (sum / PI).min(cap)
}
