//! The formula that timings are multiples of.

use std::f64::consts::TAU;

/// The sum of Howell's C-13 as it is usually typed in, without a thought for cancellation.
pub(crate) fn textbook_parallel(
    x: [f64; 2],
    y: [f64; 2],
    xi: [f64; 2],
    eta: [f64; 2],
    z: f64,
) -> f64 {
    let mut sum = 0.0;
    for (i, x) in x.into_iter().enumerate() {
        for (j, y) in y.into_iter().enumerate() {
            for (k, xi) in xi.into_iter().enumerate() {
                for (l, eta) in eta.into_iter().enumerate() {
                    let (u, v) = (x - xi, y - eta);
                    let (p, q) = (u.hypot(z), v.hypot(z));
                    let sign = if (i + j + k + l) % 2 == 0 { 1.0 } else { -1.0 };
                    sum += sign
                        * (v * p * (v / p).atan() + u * q * (u / q).atan()
                            - 0.5 * z * z * (u * u + v * v + z * z).ln());
                }
            }
        }
    }
    sum / TAU
}
