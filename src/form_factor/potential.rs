//! The logarithmic potential of an edge, `∫ ln|x − y| dy`, in closed form.
//!
//! ```text
//!   edge from C to D, L = |D − C|, a = C − x, c = D − x
//!   e = (D − C)/L:   s0 = a·e, s1 = c·e, h = |a×e|, θ = angle between a and c
//!   ∫ ln|x − y| dy = s1 ln|c| − s0 ln|a| + h θ − L
//! ```
//!
//! In units of u = ε/2: a and c are within u of themselves, the directions within 3 u, s and h within 6 u r, the logarithm of r²
//! (5 u before it is halved) within 2.5 u + 3 u |ln r|; θ within 5 u sin θ from its cosine, 6 u L/min(|a|,|c|) from its sine
//! and 5 u θ from its function. With r sin θ ≤ L, and r θ ≤ t L where t = θ/sin θ (at most π, where θ > π/2 and so r ≤ L),
//!
//! ```text
//!   error ≤ u [ 2.5 (|s0| + |s1|) + 18 max r |ln r| + (12 + 12 t) L ]
//! ```

use crate::geometry::Vector;
use crate::numeric::Scalar;
use glam::DVec3;
use std::sync::LazyLock;

/// The potential of an edge at a point, from the vectors `a`, `c` to its ends, its direction and length,
/// and `ln|a|`, `ln|c|`.
#[inline(always)]
#[allow(
    clippy::inline_always,
    reason = "vector code is made where it is called"
)]
pub(super) fn potential<S: Scalar + Copy>(
    a: Vector<S>,
    c: Vector<S>,
    direction: Vector<S>,
    length: S,
    logs: [S; 2],
) -> S {
    let height = a.cross(direction).length();
    let angle = (height * length).atan2(&a.dot(c));
    c.dot(direction) * logs[1] - a.dot(direction) * logs[0] + height * angle - length
}

/// `ln(|a|/unit)` from `1/unit²`, kept finite where `a` is 0.
#[inline(always)]
#[allow(
    clippy::inline_always,
    reason = "vector code is made where it is called"
)]
pub(super) fn log_distance<S: Scalar + Copy>(a: Vector<S>, inverse_square: S) -> S {
    let square = a.dot(a) * inverse_square + inverse_square.constant(f64::MIN_POSITIVE);
    square.ln() * square.constant(0.5)
}

/// Points as three columns.
#[derive(Debug, Default, Clone)]
pub(super) struct Points {
    pub x: Vec<f64>,
    pub y: Vec<f64>,
    pub z: Vec<f64>,
}

impl Points {
    pub(super) fn clear(&mut self) {
        self.x.clear();
        self.y.clear();
        self.z.clear();
    }

    pub(super) fn push(&mut self, point: DVec3) {
        self.x.push(point.x);
        self.y.push(point.y);
        self.z.push(point.z);
    }

    pub(super) fn len(&self) -> usize {
        self.x.len()
    }

    /// Repeats the last point until the processor's vectors are full: what is left over would take as long as all of them.
    pub(super) fn pad(&mut self) {
        for column in [&mut self.x, &mut self.y, &mut self.z] {
            let last = column.last().copied().unwrap_or(0.0);
            column.resize(padded(column.len()), last);
        }
    }
}

/// The next multiple of eight doubles, a vector of today's widest processors.
pub(super) const fn padded(len: usize) -> usize {
    len.next_multiple_of(8)
}

static VECTOR_UNIT: LazyLock<pulp::Arch> = LazyLock::new(pulp::Arch::new);

/// Runs `work`, compiled for what this processor can do.
#[inline(always)]
#[allow(
    clippy::inline_always,
    reason = "vector code is made where it is called"
)]
pub(super) fn vectorised(work: impl FnOnce()) {
    VECTOR_UNIT.dispatch(work);
}

/// The potentials of all edges of a closed polygon at all points, edge by edge.
///
/// **Arguments** `logs`: room for the work; `out`: `corners × points` values.
pub(super) fn potentials(
    points: &Points,
    corners: &[DVec3],
    inverse_square: f64,
    logs: &mut Vec<f64>,
    out: &mut Vec<f64>,
) {
    let (n, k) = (points.len(), corners.len());
    logs.clear();
    logs.resize(2 * n, 0.0);
    out.clear();
    out.resize(n * k, 0.0);
    let coordinates = || points.x.iter().zip(&points.y).zip(&points.z);
    vectorised(
        #[inline(always)]
        || {
            let (mut before, mut after) = logs.split_at_mut(n);
            for (log, ((x, y), z)) in before.iter_mut().zip(coordinates()) {
                *log = log_distance(seen(corners[0], *x, *y, *z), inverse_square);
            }
            for (b, out) in out.chunks_exact_mut(n).enumerate() {
                let (start, end) = (corners[b], corners[(b + 1) % k]);
                let edge = end - start;
                let length = edge.length();
                let direction = Vector((edge / length).to_array());
                for (log, ((x, y), z)) in after.iter_mut().zip(coordinates()) {
                    *log = log_distance(seen(end, *x, *y, *z), inverse_square);
                }
                let logs = before.iter().zip(&*after);
                for ((out, (before, after)), ((x, y), z)) in
                    out.iter_mut().zip(logs).zip(coordinates())
                {
                    let (a, c) = (seen(start, *x, *y, *z), seen(end, *x, *y, *z));
                    *out = potential(a, c, direction, length, [*before, *after]);
                }
                std::mem::swap(&mut before, &mut after);
            }
        },
    );
}

/// The vector from a point to a corner.
#[inline(always)]
#[allow(
    clippy::inline_always,
    reason = "vector code is made where it is called"
)]
fn seen(corner: DVec3, x: f64, y: f64, z: f64) -> Vector<f64> {
    Vector([corner.x - x, corner.y - y, corner.z - z])
}
