//! The potentials of a box's faces: closed forms of what cells exchange, corner by corner.
//!
//! ```text
//!   J_ij = Σ_p Σ_q s_p s_q G(p, q)      p, q: corners of cells i and j of two faces, s = ±1
//!   F_xj = Σ_q s_q C(x, q)              x: a point of one of them;  X, Y instead of C: integrals
//!                                       of the coordinates from x, for what varies linearly
//!
//!   opposite faces, x and y apart, at distance z, with p = √(x² + z²), q = √(y² + z²)
//!     2π G = y p atan(y/p) + x q atan(x/q) − ½ z² ln(x² + y² + z²)
//!     2π C = (x/p) atan(y/p) + (y/q) atan(x/q)
//!     2π X = −(z²/p) atan(y/p),    2π Y = −(z²/q) atan(x/q)
//!
//!   faces with a common edge, x apart along it, u and v away from it, r² = u² + v²
//!     2π G = x r atan(x/r) − ¼ (r² − x²) ln(r² + x²)
//!     2π C = −(u/r) atan(x/r),    2π X = −½ u ln(r² + x²)
//! ```
//!
//! **Not covered**: Y of faces with a common edge, which takes dilogarithms.
//!
//! Reference: Howell, *A Catalog of Radiation Heat Transfer Configuration Factors*, B-3, B-4, C-13,
//! C-14.

use std::f64::consts::TAU;

/// G of opposite faces.
pub(super) fn opposite(x: f64, y: f64, z: f64) -> f64 {
    let (p, q) = (x.hypot(z), y.hypot(z));
    let square = x * x + y * y + z * z;
    (y * p * (y / p).atan() + x * q * (x / q).atan() - 0.5 * z * z * square.ln()) / TAU
}

/// C, X and Y of opposite faces.
pub(super) fn from_opposite(x: f64, y: f64, z: f64) -> [f64; 3] {
    let (p, q) = (x.hypot(z), y.hypot(z));
    let (along, across) = ((y / p).atan() / p / TAU, (x / q).atan() / q / TAU);
    [x * along + y * across, -z * z * along, -z * z * across]
}

/// G of faces with a common edge.
pub(super) fn adjacent(x: f64, u: f64, v: f64) -> f64 {
    let (square, r) = (u * u + v * v, u.hypot(v));
    let all = square + x * x;
    if all <= 0.0 {
        return 0.0;
    }
    let arc = if r > 0.0 { x * r * (x / r).atan() } else { 0.0 };
    (arc - 0.25 * (square - x * x) * all.ln()) / TAU
}

/// C and X of faces with a common edge, from which the point is u away.
pub(super) fn from_adjacent(x: f64, u: f64, v: f64) -> [f64; 2] {
    let r = u.hypot(v);
    // a point on the edge sees the other face edge on, or not at all
    if u <= 0.0 {
        return [0.0; 2];
    }
    [
        -u / r * (x / r).atan() / TAU,
        -0.5 * u * (r * r + x * x).ln() / TAU,
    ]
}
