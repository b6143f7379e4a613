//! Two parallel rectangles that face each other, edges along common axes, at any offset.
//!
//! ```text
//!   first  [x0,x1] × [y0,y1],  second [ξ0,ξ1] × [η0,η1],  distance z,
//!   u = x − ξ,  v = y − η,  p² = u² + z²,  q² = v² + z²,  r² = u² + v² + z²
//!   2π A F = Σ ± G(u, v),     G = v p atan(v/p) + u q atan(u/q) − (z²/2) ln r²
//!   ∂G/∂u  = (u v/p) atan(v/p) + q atan(u/q)      (up to functions of u or v alone)
//! ```
//!
//! The difference in `y` is taken in closed form (`exchange`'s building blocks), so a side `y1 − y0`
//! of 1e-12 costs no digits; the caller's shortest side is put there. What remains is the
//! cancellation of distance: three differences are left, about `(distance/size)³` in relative error.
//!
//! Source: Howell, *A Catalog of Radiation Heat Transfer Configuration Factors*, C-13.

use super::FormFactorError;
use super::exchange::{Exchange, Sign, log_ratio, log_ratio_size};
use crate::geometry::{Offsets, Span};
use crate::numeric::Scalar;

/// Exchange area of two parallel rectangles `distance` apart.
///
/// **Arguments** the extents of both along two common axes; `distance` > 0; any one unit.
/// **Returns** `A_1 F_12 = A_2 F_21`, in squared units, and the magnitude its error is relative to.
/// **Accuracy** `f64`: within [`RECTANGLE_TERMS`]·ε·magnitude, held by
/// `parallel_bound_is_never_below_the_error`.
///
/// [`RECTANGLE_TERMS`]: crate::numeric::tolerance::RECTANGLE_TERMS
///
/// # Errors
/// [`FormFactorError::NonPositiveLength`] if `distance` is not finite and > 0.
///
/// # Examples
/// ```
/// use infoscene::{form_factor::parallel, geometry::Span};
/// let unit = Span::try_new(0.0, 1.0)?;
/// let exchange = parallel::exchange_area(&[unit, unit], &[unit, unit], &1.0)?;
/// // Unit squares at distance 1, from a 60-digit evaluation.
/// assert!((exchange.value - 0.199_824_895_698_387_4).abs() < 1e-15);
/// # Ok::<(), infoscene::form_factor::FormFactorError>(())
/// ```
pub fn exchange_area<S: Scalar>(
    first: &[Span<S>; 2],
    second: &[Span<S>; 2],
    distance: &S,
) -> Result<Exchange<S>, FormFactorError> {
    positive_distance(distance)?;
    // The four sides trade places by symmetry (x ↔ y; first ↔ second mirrors u and v):
    // the shortest becomes `y` of the first.
    let sides = [&first[0], &first[1], &second[0], &second[1]].map(Span::length);
    let shortest = (0..4).fold(1, |best, k| if sides[k] < sides[best] { k } else { best });
    let (x, y, xi, eta) = match shortest {
        0 => (&first[1], &first[0], &second[1], &second[0]),
        1 => (&first[0], &first[1], &second[0], &second[1]),
        2 => (&second[1], &second[0], &first[1], &first[0]),
        _ => (&second[0], &second[1], &first[0], &first[1]),
    };
    let offsets = Offsets::between(x, xi);
    let across = second_difference(&offsets);
    let ends = [(eta.lower(), Sign::Plus), (eta.upper(), Sign::Minus)];
    let corners = std::array::from_fn(|k| {
        let ((u, sign_u), (eta, sign_eta)) = (across[k / 2], ends[k % 2]);
        let v = [y.lower(), y.upper()].map(|end| end.clone() - eta);
        let [v0, v1] = v;
        ([u.clone(), v0, v1], sign_u.times(sign_eta))
    });
    let sum = Exchange::over_corners(
        &corners,
        [y.length().clone(), distance.clone()],
        #[inline(always)]
        |[delta, z], [u, v0, v1], i| difference_in_v(&u[i], delta, [&v0[i], &v1[i]], z),
        |_| None,
    );
    Ok(sum.over_two_pi(Sign::Plus))
}

/// `∂(A F)/∂x` as the first rectangle's edge at `x` moves outwards: the exchange per unit width
/// of the strip `{x} × [y0, y1]` of the first rectangle with the whole second one.
///
/// **Arguments** as for [`exchange_area`]; `x` is measured on the second's first axis, and may be the
/// coordinate along either axis if the second's spans are swapped with it.
///
/// # Errors
/// [`FormFactorError::NonPositiveLength`] if `distance` is not finite and > 0.
pub fn strip_exchange<S: Scalar>(
    x: &S,
    y: &Span<S>,
    second: &[Span<S>; 2],
    distance: &S,
) -> Result<Exchange<S>, FormFactorError> {
    positive_distance(distance)?;
    let [xi, eta] = second;
    let z2 = distance.square();
    let mut sum = Exchange::new(distance);
    for (xi, sign_u) in [(xi.lower(), Sign::Plus), (xi.upper(), Sign::Minus)] {
        let u = x.clone() - xi;
        let p = (u.square() + &z2).sqrt();
        for (v, sign_v) in second_difference(&Offsets::between(y, eta)) {
            let q = (v.square() + &z2).sqrt();
            let mut corner = Exchange::new(distance);
            corner.add(u.clone() * v / &p * &v.atan2(&p));
            corner.add(u.atan2(&q) * &q);
            let sign = if sign_u == sign_v {
                Sign::Plus
            } else {
                Sign::Minus
            };
            sum.add_signed(sign, &corner);
        }
    }
    Ok(sum.over_two_pi(Sign::Plus))
}

fn positive_distance<S: Scalar>(distance: &S) -> Result<(), FormFactorError> {
    let value = distance.to_f64();
    if value.is_finite() && *distance > distance.zero() {
        Ok(())
    } else {
        Err(FormFactorError::NonPositiveLength {
            quantity: "the distance",
            value,
        })
    }
}

/// The four differences of two spans' ends, signed as in a second difference.
pub(super) fn second_difference<S: Scalar>(offsets: &Offsets<S>) -> [(&S, Sign); 4] {
    [
        (offsets.difference(0, 0), Sign::Minus),
        (offsets.difference(0, 1), Sign::Plus),
        (offsets.difference(1, 0), Sign::Plus),
        (offsets.difference(1, 1), Sign::Minus),
    ]
}

/// `G(u, v1) − G(u, v0)`, Δ apart, each term to its own relative precision.
#[inline(always)]
#[allow(
    clippy::inline_always,
    reason = "vector code is made where it is called"
)]
fn difference_in_v<S: Scalar>(u: &S, delta: &S, v: [&S; 2], z: &S) -> Exchange<S> {
    let (delta, [v0, v1]) = (delta.clone(), v.map(Clone::clone));
    let z2 = z.square();
    let p2 = u.square() + &z2;
    let p = p2.sqrt();
    let (q0, q1) = ((v0.square() + &z2).sqrt(), (v1.square() + &z2).sqrt());
    let (r2_0, r2_1) = (p2.clone() + &v0.square(), p2.clone() + &v1.square());
    // v1² − v0², and what its rounding is relative to
    let squares = delta.clone() * &(v1.clone() + &v0);
    let squares_size = delta.clone() * &(v1.abs() + &v0.abs());
    let q_sum = q0.clone() + &q1;
    let q_step = squares.clone() / &q_sum;
    let q_step_size = squares_size.clone() / &q_sum;

    let mut sum = Exchange::new(u);
    // v p atan(v/p)
    sum.add(delta.clone() * &p * &v1.atan2(&p));
    sum.add(v0.clone() * &p * &(delta * &p).atan2(&(p2 + &(v0 * &v1))));
    // u q atan(u/q)
    let angle = u.atan2(&q1) * u;
    sum.add_uncertain(angle.clone() * &q_step, || angle * &q_step_size);
    let denominator = q0.clone() * &q1 + &u.square();
    let narrowing = u.clone() * &q_step;
    let turn = narrowing.atan2(&denominator) * u * &q0;
    sum.add_uncertain(-turn, || u.square() * &q_step_size / &denominator * &q0);
    // −(z²/2) ln r²
    let log = log_ratio(&squares, &r2_0, &r2_1);
    let half_z2 = z2 / &z.constant(2.0);
    sum.add_uncertain(-(log.clone() * &half_z2), || {
        log_ratio_size(&log, &squares_size, &r2_0, &r2_1) * &half_z2
    });
    sum
}
