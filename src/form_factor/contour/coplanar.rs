//! `∫∫ ln|x − y| dx dy` over two edges in one plane, in closed form.
//!
//! Edges on lines that meet: with s, t measured from the meeting point, r² is homogeneous, so that
//!
//! ```text
//!   ∫∫ (2 ln r + 1) ds dt = s1 U(x(s1)) − s0 U(x(s0)) + t1 V(y(t1)) − t0 V(y(t0))
//!   s = (w×v)·(u×v)/|u×v|²,  t = (w×u)·(u×v)/|u×v|²
//!       w = A − B from the nearest ends A, B, where s and t are
//! ```
//!
//! where U and V are the [potentials](super::potential) of the two edges. Parallel edges, h apart,
//! p and q along them:
//!
//! ```text
//!   ∫∫ ½ ln((p−q)² + h²) = Σ ± G(p − q),   G(w) = ((w² − h²)/4) ln(w² + h²) + h w atan(w/h) − ¾ w²
//! ```
//!
//! Lines that miss each other by δ count as meeting if δ is lost in rounding: with true and
//! computed r² apart by δ² at most, `∫ ½ ln(1 + δ²/t²) dt = π δ` bounds what each potential is off
//! by.

use super::edge::{Edge, PairIntegral, Precision};
use super::potential::log_distance;
use crate::geometry::Vector;
use crate::numeric::Scalar;
use std::f64::consts::PI;

/// The relation of two edges: skew, or in one plane.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Relation<S> {
    /// The edges lie on lines that meet, as far as rounding tells, or are parallel.
    Coplanar(Coplanar<S>),
    /// The edges lie on lines that miss each other, or meet too far away.
    Skew,
}

/// Two edges in one plane.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Coplanar<S> {
    /// The coordinates of their ends from where their lines meet.
    Meeting {
        s: [S; 2],
        t: [S; 2],
        /// The distance by which the lines miss each other.
        miss: f64,
        /// A bound on the displacement of the meeting point.
        shift: f64,
        reach: f64,
    },
    /// Parallel, this far apart; the sine is what is left of their angle.
    Parallel { apart: S, sine: f64 },
}

/// The size of what is lost in rounding: the sine of an angle, and the distance of two lines. Edges
/// within both are taken as coplanar, and the error of that is bounded.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rounding {
    pub epsilon: f64,
    pub sine: f64,
    pub miss: f64,
}

impl Rounding {
    /// The rounding of coordinates up to `largest`, by `factor` roundings of `epsilon` each.
    pub(crate) const fn new(epsilon: f64, factor: f64, largest: f64) -> Self {
        let sine = factor * epsilon;
        Self {
            epsilon,
            sine,
            miss: sine * largest,
        }
    }
}

/// Finds the relation of two edges.
#[inline(always)]
pub(crate) fn relation<S: Scalar + Copy>(
    [a, b]: [&Edge<S>; 2],
    Rounding {
        epsilon,
        sine: straight,
        miss: touching,
    }: Rounding,
) -> Relation<S> {
    let across = a.direction.cross(b.direction);
    let square = across.dot(across);
    let (mut farthest, mut nearest) = (0.0, f64::INFINITY);
    let (mut i, mut j, mut w) = (0, 0, a.ends[0].minus(b.ends[0]));
    for (k, x) in a.ends.into_iter().enumerate() {
        for (l, y) in b.ends.into_iter().enumerate() {
            let between = x.minus(y);
            let distance = between.dot(between).to_f64();
            farthest = f64::max(farthest, distance);
            if distance < nearest {
                (i, j, w, nearest) = (k, l, between, distance);
            }
        }
    }
    let (reach, near) = (farthest.sqrt(), nearest.sqrt());
    let ends = |near: S, k: usize, length: S| {
        if k == 0 {
            [near, near + length]
        } else {
            [near - length, near]
        }
    };
    let sine = square.to_f64().sqrt();
    if sine <= straight {
        let apart = if near > 0.0 {
            w.cross(a.direction).length()
        } else {
            a.length.zero()
        };
        return Relation::Coplanar(Coplanar::Parallel { apart, sine });
    }
    if near <= 0.0 {
        let zero = a.length.zero();
        return Relation::Coplanar(Coplanar::Meeting {
            s: ends(zero, i, a.length),
            t: ends(zero, j, b.length),
            miss: 0.0,
            shift: 0.0,
            reach,
        });
    }
    let miss = w.dot(across).to_f64().abs() / sine;
    if miss > touching {
        return Relation::Skew;
    }
    let s = w.cross(b.direction).dot(across) / square;
    let t = w.cross(a.direction).dot(across) / square;
    let nearest = s.to_f64().abs().max(t.to_f64().abs());
    if nearest > 4.0 * a.length.to_f64().max(b.length.to_f64()) {
        return Relation::Skew;
    }
    let shift = 4.0 * epsilon * (near + s.to_f64().abs() + t.to_f64().abs()) / sine;
    let (s, t) = (ends(s, i, a.length), ends(t, j, b.length));
    Relation::Coplanar(Coplanar::Meeting {
        s,
        t,
        miss,
        shift,
        reach,
    })
}

/// The closed form of two edges in one plane, from the potentials of each at the other's ends.
#[inline(always)]
pub(crate) fn coplanar<S: Scalar + Copy>(
    [a, b]: [&Edge<S>; 2],
    relation: Coplanar<S>,
    at_a: [S; 2],
    at_b: [S; 2],
    precision: Precision<S>,
) -> PairIntegral<S> {
    let (s, t, miss, shift, reach) = match relation {
        Coplanar::Parallel { apart, sine } => return parallel([a, b], apart, sine, precision),
        Coplanar::Meeting {
            s,
            t,
            miss,
            shift,
            reach,
        } => (s, t, miss, shift, reach),
    };
    let boundary = s[1] * at_a[1] - s[0] * at_a[0] + t[1] * at_b[1] - t[0] * at_b[0];
    let value = (boundary - a.length * b.length) * boundary.constant(0.5);
    let (mut weights, mut potentials) = (0.0, 0.0);
    for [pair, potential] in [[s, at_a], [t, at_b]] {
        for k in 0..2 {
            weights += pair[k].to_f64().abs();
            potentials += potential[k].to_f64().abs();
        }
    }
    let (a_length, b_length) = (a.length.to_f64(), b.length.to_f64());
    let longer = a_length.max(b_length);
    // s and t shift together by what the meeting point is off
    let error = 0.5 * weights * (precision.of_any_potential(reach, longer) + 2.0 * PI * miss)
        + 0.5 * shift * potentials
        + 2.0 * precision.epsilon * (weights * potentials / 4.0 + a_length * b_length);
    PairIntegral { value, error }
}

#[inline(always)]
fn parallel<S: Scalar + Copy>(
    [a, b]: [&Edge<S>; 2],
    apart: S,
    sine: f64,
    precision: Precision<S>,
) -> PairIntegral<S> {
    let along = a.direction.dot(b.direction).to_f64() > 0.0;
    let mut steps = [apart; 4];
    for (i, start) in a.ends.into_iter().enumerate() {
        for (j, end) in b.ends.into_iter().enumerate() {
            steps[2 * i + j] = start.minus(end).dot(a.direction);
        }
    }
    let (mut terms, mut sizes) = ([apart; 4], [0.0; 4]);
    let (out, inverse_square) = ((&mut terms, &mut sizes), precision.inverse_square);
    S::vectorised(
        #[inline(always)]
        move || {
            let (mut terms, mut sizes) = ([apart; 4], [0.0; 4]);
            let h2 = apart * apart;
            for l in 0..4 {
                let p = steps[l];
                let p2 = p * p;
                let log = log_distance(Vector([p, apart, apart.zero()]), inverse_square);
                terms[l] = (p2 - h2) * p.constant(0.5) * log + apart * p * p.atan2(&apart)
                    - p2 * p.constant(0.75);
                sizes[l] = (p2 + h2).to_f64() * (log.to_f64().abs() + 4.0);
            }
            (*out.0, *out.1) = (terms, sizes);
        },
    );
    // + for the differences p1 − q_min and p0 − q_max
    let same = terms[0] + terms[3];
    let opposite = terms[1] + terms[2];
    let sum = if along {
        opposite - same
    } else {
        same - opposite
    };
    let size = sizes[0] + sizes[1] + sizes[2] + sizes[3];
    // a turn by the sine moves a point of one by at most that times its length, against all of the
    // other
    let turned = 2.0 * PI * sine * a.length.to_f64() * b.length.to_f64();
    PairIntegral {
        value: sum,
        error: 4.0 * precision.epsilon * size + turned,
    }
}
