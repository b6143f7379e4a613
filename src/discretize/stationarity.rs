//! The derivative of the gain of a cut, which every optimum of this room is a root of.
//!
//! With flux G(t) and weight W(t) before a cut at t, and the ratios a, b of flux to weight on its
//! two sides,
//!
//! ```text
//!   d/dt Σ_k G_k ln(G_k/W_k) = G′ ln(a/b) − W′ (a − b)
//! ```

use crate::numeric::Scalar;

/// `G′ ln(a/b) − W′ (a − b)`, the derivative of the gain in nats as a cut moves.
///
/// With `G′ = 0` the logarithm does not count, even where a or b is 0.
pub(super) fn stationarity<S: Scalar>(flux_rate: &S, weight_rate: &S, before: &S, after: &S) -> S {
    let difference = before.clone() - after;
    let logarithm = if flux_rate.is_zero() {
        flux_rate.clone()
    } else if difference.abs() < after.clone() * &after.constant(0.5) {
        (difference.clone() / after).ln_1p()
    } else {
        (before.clone() / after).ln()
    };
    logarithm * flux_rate - &(difference * weight_rate)
}
