//! Two parallel rectangles that face each other, edges along common axes, at any offset.
//!
//! ```text
//!   first  [x0,x1] × [y0,y1],  second [ξ0,ξ1] × [η0,η1],  distance z,
//!   u = x − ξ,  v = y − η,  p² = u² + z²,  q² = v² + z²,  r² = u² + v² + z²
//!   2π A F = Σ ± G(u, v),     G = v p atan(v/p) + u q atan(u/q) − (z²/2) ln r²
//!   ∂G/∂u  = (u v/p) atan(v/p) + q atan(u/q)      (up to functions of u or v alone)
//! ```
//!
//! The difference in `y` is taken in closed form (`exchange`'s building blocks), so a side
//! `y1 − y0` of 1e-12 costs no digits; the caller's shortest side is put there. What remains is the
//! cancellation of distance: three differences remain, about `(distance/size)³` in relative
//! error.
//!
//! A corner has five terms (Δ = y1 − y0; q, q' the smaller and the larger of q0, q1; ν = q1 − q0 =
//! Δ (v0 + v1)/(q0 + q1)),
//!
//! ```text
//!   Δ p atan(v1/p)   +   v0 p atan2(Δ p, p² + v0 v1)
//!     +   ν u atan(u/q')   −   u q atan2(u ν, q q' + u²)   −   (z²/2) ln(r1²/r0²)
//! ```
//!
//! with 13, 19, 20, 23 and 21 roundings (`exchange`). The fourth is never larger than the third, as
//! `a/(1 + a²) ≤ atan a` for a = u/q', so that both together take 22. Where v0 and v1 have
//! different signs, their sum is uncertain by `|v0| + |v1|`: with e = Δ (|v0| + |v1| − |v0 + v1|),
//! 3 roundings each of the third and the fourth are relative to at most
//! `e/(q0+q1) |u| atan(|u|/q')` more, and 4.5 of the fifth to `(z²/2) e/r²`, r² the larger, more; a
//! quarter of the one and `(z²/2) e/(q0+q1)²` are in the magnitude.
//!
//! Source: Howell, *A Catalog of Radiation Heat Transfer Configuration Factors*, C-13.

use super::corner_sum::{Exchange, Sign, log_ratio};
use crate::form_factor::FormFactorError;
use crate::geometry::{Offsets, Span};
use crate::numeric::Scalar;
use std::array::from_fn;

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
/// use infoscene::form_factor::rectangles::parallel;
/// use infoscene::geometry::Span;
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
    S::vectorised(
        #[inline(always)]
        || form(first.each_ref(), second.each_ref(), distance),
    )
}

/// [`exchange_area`], to be called where vector code is made.
#[inline(always)]
pub(crate) fn form<S: Scalar>(
    first: [&Span<S>; 2],
    second: [&Span<S>; 2],
    distance: &S,
) -> Result<Exchange<S>, FormFactorError> {
    positive_distance(distance)?;
    // The four sides trade places by symmetry (x ↔ y; first ↔ second mirrors u and v):
    // the shortest becomes `y` of the first.
    let sides = [first[0], first[1], second[0], second[1]].map(Span::length);
    let shortest = (0..4).fold(1, |best, k| if sides[k] < sides[best] { k } else { best });
    let (is_first, is_y) = (shortest < 2, shortest % 2 == 1);
    let along = |k: usize| {
        let one = Span::either(is_first, first[k], second[k]);
        [one, Span::either(is_first, second[k], first[k])]
    };
    let ([a, b], [c, d]) = (along(0), along(1));
    let (x, xi) = (Span::either(is_y, &a, &c), Span::either(is_y, &b, &d));
    let (y, eta) = (Span::either(is_y, &c, &a), Span::either(is_y, &d, &b));
    let numbers = [
        y.length(),
        distance,
        x.lower(),
        x.upper(),
        xi.lower(),
        xi.upper(),
        y.lower(),
        y.upper(),
        eta.lower(),
        eta.upper(),
    ];
    let sum = Exchange::over_corners(
        &numbers.map(Clone::clone),
        // minus, plus, plus, minus in u; in v the lower end of η is the plus
        |k| [Sign::Minus, Sign::Plus][(k / 4 + k / 2 + k) % 2],
        #[inline(always)]
        |[_, _, x @ .., y0, y1, eta0, eta1]| {
            let v = |y: &S, k: usize| y.clone() - [eta0, eta1][k % 2];
            [
                from_fn(|k| x[k / 4].clone() - &x[2 + k / 2 % 2]),
                from_fn(|k| v(y0, k)),
                from_fn(|k| v(y1, k)),
            ]
        },
        #[inline(always)]
        |[delta, z, ..], [u, v0, v1], i| difference_in_v(&u[i], delta, [&v0[i], &v1[i]], z),
    );
    Ok(sum.over_two_pi(Sign::Plus))
}

/// `∂(A F)/∂x` as the first rectangle's edge at `x` moves outwards: the exchange per unit width
/// of the strip `{x} × [y0, y1]` of the first rectangle with the whole second one.
///
/// **Arguments** as for [`exchange_area`]; `x` is measured on the second's first axis, and may be
/// the coordinate along either axis if the second's spans are swapped with it.
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

#[inline(always)]
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
pub(crate) fn second_difference<S: Scalar>(offsets: &Offsets<S>) -> [(&S, Sign); 4] {
    [
        (offsets.difference(0, 0), Sign::Minus),
        (offsets.difference(0, 1), Sign::Plus),
        (offsets.difference(1, 0), Sign::Plus),
        (offsets.difference(1, 1), Sign::Minus),
    ]
}

/// `G(u, v1) − G(u, v0)`, Δ apart, each term to its own relative precision.
#[inline(always)]
fn difference_in_v<S: Scalar>(u: &S, delta: &S, [v0, v1]: [&S; 2], z: &S) -> Exchange<S> {
    let (u2, z2) = (u.square(), z.square());
    let (v2_0, v2_1) = (v0.square(), v1.square());
    let p2 = u2.clone() + &z2;
    // v1² − v0²
    let squares = delta.clone() * &(v1.clone() + v0);
    // −(z²/2) ln r²
    let log = log_ratio(&squares, &(p2.clone() + &v2_0), &(p2.clone() + &v2_1));
    let fifth = -(log * &(z2.clone() * &z.constant(0.5)));

    let p = p2.sqrt();
    let (q0, q1) = ((v2_0 + &z2).sqrt(), (v2_1 + &z2).sqrt());
    let inverse = u.constant(1.0) / &(q0.clone() + &q1);
    let q_step = squares.clone() * &inverse;
    // v p atan(v/p) and u q atan(u/q)
    let (near, far) = if q0 < q1 { (q0, q1) } else { (q1, q0) };
    let step = delta.clone() * &p;
    let [end, turn, angle, narrowing] = S::angles([
        [v1, &p],
        [&step, &(p2 + &(v0.clone() * v1))],
        [u, &far],
        [&(u.clone() * &q_step), &(near.clone() * &far + &u2)],
    ]);
    let first = end * &step;
    let second = turn * &(p * v0);
    let angle = angle * u;
    let third = angle.clone() * &q_step;
    let fourth = -(narrowing * &(near * u));

    let magnitude = if S::TRACKS_ROUNDING {
        let terms = first.abs() + &second.abs() + &(third.abs() + &fourth.abs()) + &fifth.abs();
        // what the rounding of v1 + v0 is relative to, beyond itself
        let excess = delta.clone() * &(v1.abs() + &v0.abs()) - &squares.abs();
        let weight = angle * &z.constant(0.25) + &(z2 * &inverse * &z.constant(0.5));
        terms + &(excess * &inverse * &weight)
    } else {
        u.zero()
    };
    Exchange {
        value: (first + &second) + &((third + &fourth) + &fifth),
        magnitude,
    }
}
