//! Two rectangles in perpendicular planes, edges along common axes, at any offset.
//!
//! ```text
//!   first  depth [x0,x1], width [y0,y1];  second depth [z0,z1], width [η0,η1]
//!   (depth: distance from the line where the planes meet, ≥ 0; width: along that line)
//!   v = y − η,  s² = x² + z²,  r² = s² + v²
//!   2π A F = −Σ ± G,     G = v s atan(v/s) − ¼ (s² − v²) ln r²
//!   ∂G/∂x = x [ (v/s) atan(v/s) − ½ ln r² ]       ∂G/∂v = s atan(v/s) + ½ v ln r²
//! ```
//!
//! (the derivatives up to functions that the remaining differences cancel.) One of the four
//! differences is taken in closed form, along the shortest side, so that slivers keep their digits.
//! What remains is the cancellation of distance, about `(distance/size)³` in relative error.
//!
//! A corner has four terms; along a depth, Δ = x1 − x0 (ς = s1 − s0 = Δ (x0 + x1)/(s0 + s1)), or
//! along a width, Δ = y1 − y0,
//!
//! ```text
//!   ς v atan(v/s1)  −  v s0 atan2(v ς, s0 s1 + v²)
//!     −  ¼ (s1² − v²) ln(r1²/r0²)  −  ¼ (s1² − s0²) ln r0²
//!   Δ s atan(v1/s)  +  v0 s atan2(Δ s, s² + v0 v1)
//!     −  ¼ (s² − v1²) ln(r1²/r0²)  +  ¼ (v1² − v0²) ln r0²
//! ```
//!
//! with 16, 23, 21 and 5 roundings, or 11, 16, 21 and 6 (`exchange`); of the first line the second
//! is never larger than the first, as in [`parallel`](super::parallel). The third is relative to
//! `s² + v²` in place of `s² − v²`. What the logarithm of r0² is off by, 4 roundings of 1, counts a
//! quarter of its coefficient; in the second line this covers, too, that the sum of v0 and v1 is
//! uncertain by `|v0| + |v1|`.
//!
//! Source: Howell, *A Catalog of Radiation Heat Transfer Configuration Factors*, C-15.

use super::corner_sum::{Exchange, Sign, log_ratio};
use super::parallel::second_difference;
use crate::form_factor::FormFactorError;
use crate::geometry::{Offsets, Span};
use crate::numeric::Scalar;
use std::array::from_fn;

/// A rectangle seen from the line in which its plane meets the other one's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plate<S = f64> {
    depth: Span<S>,
    width: Span<S>,
}

impl Plate {
    /// Lifts the plate to numbers of the type and precision of `like`.
    #[must_use]
    pub fn lifted<S: Scalar>(&self, like: &S) -> Plate<S> {
        Plate {
            depth: self.depth.lifted(like),
            width: self.width.lifted(like),
        }
    }
}

impl<S: Scalar> Plate<S> {
    /// The plate between two distances from the line and two positions along it.
    ///
    /// # Errors
    /// [`FormFactorError::BehindPlane`] if the depth starts below 0.
    #[inline(always)]
    pub fn try_new(depth: Span<S>, width: Span<S>) -> Result<Self, FormFactorError> {
        if !depth.lower().is_nonnegative() {
            return Err(FormFactorError::BehindPlane {
                lower: depth.lower().to_f64(),
            });
        }
        Ok(Self { depth, width })
    }

    /// Distances from the line.
    #[must_use]
    pub const fn depth(&self) -> &Span<S> {
        &self.depth
    }

    /// Positions along the line.
    #[must_use]
    pub const fn width(&self) -> &Span<S> {
        &self.width
    }
}

/// Exchange area of two perpendicular rectangles.
///
/// **Arguments** both plates, in any one unit, widths measured on the same axis.
/// **Returns** `A_1 F_12 = A_2 F_21`, in squared units, and the magnitude its error is relative to.
/// **Accuracy** `f64`: within [`RECTANGLE_TERMS`]·ε·magnitude, held by
/// `perpendicular_bound_is_never_below_the_error`. Logarithms are taken of lengths in the given
/// unit: a unit near the largest length is best.
///
/// [`RECTANGLE_TERMS`]: crate::numeric::tolerance::RECTANGLE_TERMS
///
/// # Examples
/// ```
/// use infoscene::form_factor::rectangles::perpendicular::{Plate, exchange_area};
/// use infoscene::geometry::Span;
/// let unit = Span::try_new(0.0, 1.0)?;
/// let square = Plate::try_new(unit, unit)?;
/// // Unit squares with a common edge, from a 60-digit evaluation.
/// let exchange = exchange_area(&square, &square);
/// assert!((exchange.value - 0.200_043_776_075_403_15).abs() < 1e-15);
/// # Ok::<(), infoscene::form_factor::FormFactorError>(())
/// ```
#[must_use]
pub fn exchange_area<S: Scalar>(first: &Plate<S>, second: &Plate<S>) -> Exchange<S> {
    let widths = Offsets::between(&first.width, &second.width);
    exchange_area_at([&first.depth, &second.depth], &widths)
}

/// [`exchange_area`] of plates at these depths, whose widths lie to each other by `widths`.
#[must_use]
pub fn exchange_area_at<S: Scalar>(depths: [&Span<S>; 2], widths: &Offsets<S>) -> Exchange<S> {
    S::vectorised(
        #[inline(always)]
        || form(depths, widths),
    )
}

/// [`exchange_area_at`], to be called where vector code is made.
#[inline(always)]
pub(crate) fn form<S: Scalar>(depths: [&Span<S>; 2], widths: &Offsets<S>) -> Exchange<S> {
    let lengths = [
        depths[0].length(),
        depths[1].length(),
        widths.first_length(),
        widths.second_length(),
    ];
    let shortest = (0..4).fold(
        0,
        |best, k| if lengths[k] < lengths[best] { k } else { best },
    );
    // exchanging the plates turns z into x and mirrors v, in which G is even
    let is_first = shortest % 2 == 0;
    let thin = Span::either(is_first, depths[0], depths[1]);
    let other = Span::either(is_first, depths[1], depths[0]);
    let widths = widths.swapped_unless(is_first);
    let [d00, d01, d10, d11] = from_fn(|k| widths.difference(k / 2, k % 2));
    let sum = if shortest < 2 {
        let numbers = [
            thin.lower(),
            thin.upper(),
            thin.length(),
            other.upper(),
            other.lower(),
            d00,
            d01,
            d10,
            d11,
        ];
        Exchange::over_corners(
            &numbers.map(Clone::clone),
            // plus, minus in z; minus, plus, plus, minus in v
            |k| [Sign::Minus, Sign::Plus][(k / 4 + k / 2 + k) % 2],
            #[inline(always)]
            |[_, _, _, z0, z1, v @ ..]| {
                let (z, v) = ([z0, z1], v);
                [from_fn(|k| z[k / 4].clone()), from_fn(|k| v[k % 4].clone())]
            },
            #[inline(always)]
            |[x0, x1, delta, ..], [z, v], i| difference_in_depth([x0, x1, delta], &z[i], &v[i]),
        )
    } else {
        let numbers = [
            widths.first_length(),
            thin.upper(),
            thin.lower(),
            other.upper(),
            other.lower(),
            d00,
            d01,
            d10,
            d11,
        ];
        Exchange::over_corners(
            &numbers.map(Clone::clone),
            // plus, minus in x and in z; in v the lower end of η is the plus
            |k| [Sign::Plus, Sign::Minus][(k / 4 + k / 2 + k) % 2],
            #[inline(always)]
            |[_, x0, x1, z0, z1, d00, d01, d10, d11]| {
                let (x, z, v0, v1) = ([x0, x1], [z0, z1], [d00, d01], [d10, d11]);
                [
                    from_fn(|k| x[k / 4].clone()),
                    from_fn(|k| z[k / 2 % 2].clone()),
                    from_fn(|k| v0[k % 2].clone()),
                    from_fn(|k| v1[k % 2].clone()),
                ]
            },
            #[inline(always)]
            |[delta, ..], [x, z, v0, v1], i| {
                difference_in_width(&x[i], &z[i], delta, [&v0[i], &v1[i]])
            },
        )
    };
    sum.over_two_pi(Sign::Minus)
}

/// `∂(A F)/∂x` as the first plate's edge at depth `x` moves away from the line: the exchange per
/// unit depth of the strip `{x} × width` with the whole second plate.
///
/// **Arguments** `depth` ≥ 0; `second_depth` and `widths` as for [`exchange_area_at`].
#[must_use]
pub fn strip_exchange_at_depth<S: Scalar>(
    depth: &S,
    second_depth: &Span<S>,
    widths: &Offsets<S>,
) -> Exchange<S> {
    let half = depth.constant(0.5);
    let mut sum = Exchange::new(depth);
    for (z, sign_z) in ends(second_depth) {
        for (v, sign_v) in second_difference(widths) {
            let s2 = depth.square() + &z.square();
            let s = s2.sqrt();
            let r2 = s2 + &v.square();
            let mut corner = Exchange::new(depth);
            // x/s is a cosine, 1 at z = 0 also in the limit x → 0
            let cosine = if z.is_zero() {
                depth.constant(1.0)
            } else {
                depth.clone() / &s
            };
            corner.add(v.atan2(&s) * v * &cosine);
            let log_term = if z.is_zero() && v.is_zero() {
                depth.x_ln_x() // r = x
            } else {
                depth.clone() * &half * &r2.ln()
            };
            corner.add_uncertain(-log_term.clone(), || log_size(&log_term, depth));
            let sign = if sign_z == sign_v {
                Sign::Plus
            } else {
                Sign::Minus
            };
            sum.add_signed(sign, &corner);
        }
    }
    sum.over_two_pi(Sign::Minus)
}

/// `∂(A F)/∂y` as the first plate's edge at `y` along the line moves outwards: the exchange per
/// unit width of the strip `depth × {y}` with the whole second plate.
///
/// **Arguments** `depths` from 0 up; `offsets`: y less the second plate's lower and upper end along
/// the line.
#[must_use]
pub fn strip_exchange_at_width<S: Scalar>(depths: [&Span<S>; 2], offsets: &[S; 2]) -> Exchange<S> {
    let half = offsets[0].constant(0.5);
    let mut sum = Exchange::new(&half);
    for (x, sign_x) in ends(depths[0]) {
        for (z, sign_z) in ends(depths[1]) {
            for (v, sign_eta) in offsets.iter().zip([Sign::Minus, Sign::Plus]) {
                let s2 = x.square() + &z.square();
                let s = s2.sqrt();
                let r2 = s2 + &v.square();
                let mut corner = Exchange::new(v);
                corner.add(v.atan2(&s) * &s);
                let log_term = if s.is_zero() {
                    v.x_ln_x() // r = |v|
                } else {
                    v.clone() * &half * &r2.ln()
                };
                corner.add_uncertain(log_term.clone(), || log_size(&log_term, v));
                let plus = (sign_x == sign_z) != (sign_eta == Sign::Plus);
                sum.add_signed(if plus { Sign::Plus } else { Sign::Minus }, &corner);
            }
        }
    }
    sum.over_two_pi(Sign::Minus)
}

fn ends<S: Scalar>(span: &Span<S>) -> [(&S, Sign); 2] {
    [(span.upper(), Sign::Plus), (span.lower(), Sign::Minus)]
}

/// The size that the rounding of `coefficient · ln r²` is relative to: near r² = 1 the logarithm is
/// small but its error is not.
#[inline(always)]
fn log_size<S: Scalar>(term: &S, coefficient: &S) -> S {
    term.abs() + &coefficient.abs()
}

/// `G(x1, z, v) − G(x0, z, v)`, each term to its own relative precision; where x0, z and v are 0,
/// r0² ln r0² is.
#[inline(always)]
fn difference_in_depth<S: Scalar>([x0, x1, delta]: [&S; 3], z: &S, v: &S) -> Exchange<S> {
    let quarter = v.constant(0.25);
    let (z2, v2) = (z.square(), v.square());
    let (s2_0, s2_1) = (x0.square() + &z2, x1.square() + &z2);
    let (r2_0, r2_1) = (s2_0.clone() + &v2, s2_1.clone() + &v2);
    // s1² − s0²
    let squares = delta.clone() * &(x1.clone() + x0);
    // −¼ (s² − v²) ln r²
    let is_origin = r2_0.is_zero();
    let from = if is_origin { &r2_1 } else { &r2_0 };
    let log = squares.ln_ratio(from, &r2_1);
    let log = if is_origin { v.zero() } else { log };
    let coefficient = squares.clone() * &quarter;
    let third = -(log.clone() * &((s2_1.clone() - &v2) * &quarter));
    let fourth = -(from.ln() * &coefficient);

    let (s0, s1) = (s2_0.sqrt(), s2_1.sqrt());
    let s_step = squares / &(s1.clone() + &s0);
    // v s atan(v/s); an enclosure that reaches to the line does not know its angle, which has no
    // weight for v = 0
    let [first, second] = if S::TRACKS_ROUNDING || !v.is_zero() {
        let [end, narrowing] = S::angles([
            [v, &s1],
            [&(v.clone() * &s_step), &(s0.clone() * &s1 + &v2)],
        ]);
        [end * v * &s_step, -(narrowing * &(s0 * v))]
    } else {
        [v.zero(), v.zero()]
    };

    let magnitude = if S::TRACKS_ROUNDING {
        let logs = log.abs() * &(r2_1 * &quarter) + &fourth.abs();
        first.abs() + &second.abs() + &(logs + &(coefficient * &quarter))
    } else {
        v.zero()
    };
    Exchange {
        value: (first + &second) + &(third + &fourth),
        magnitude,
    }
}

/// `G(x, z, y1 − η) − G(x, z, y0 − η)`, each term to its own relative precision; where s and one v
/// are 0, its r² ln r² is.
#[inline(always)]
fn difference_in_width<S: Scalar>(x: &S, z: &S, delta: &S, [v0, v1]: [&S; 2]) -> Exchange<S> {
    let quarter = x.constant(0.25);
    let s2 = x.square() + &z.square();
    let (v2_0, v2_1) = (v0.square(), v1.square());
    let (r2_0, r2_1) = (s2.clone() + &v2_0, s2.clone() + &v2_1);
    // v1² − v0²
    let squares = delta.clone() * &(v1.clone() + v0);
    // −¼ (s² − v²) ln r²
    let (starts, ends) = (r2_0.is_zero(), r2_1.is_zero());
    let from = if starts { &r2_1 } else { &r2_0 };
    let to = if ends { &r2_0 } else { &r2_1 };
    let log = log_ratio(&squares, from, to);
    let log = if starts || ends { x.zero() } else { log };
    let third = -(log.clone() * &((s2.clone() - &v2_1) * &quarter));
    let base = from.ln();
    let fourth = base.clone() * &(squares * &quarter);

    let s = s2.sqrt();
    // v s atan(v/s); on the line an enclosure does not know its angles, which have no weight there
    let [first, second] = if S::TRACKS_ROUNDING || !s.is_zero() {
        let step = delta.clone() * &s;
        let [end, turn] = S::angles([[v1, &s], [&step, &(s2.clone() + &(v0.clone() * v1))]]);
        [end * &step, turn * &(s * v0)]
    } else {
        [x.zero(), x.zero()]
    };

    let magnitude = if S::TRACKS_ROUNDING {
        let size = delta.clone() * &(v1.abs() + &v0.abs()) * &quarter;
        let logs = log.abs() * &(r2_1 * &quarter) + &(size * &(base.abs() + &quarter));
        first.abs() + &second.abs() + &logs
    } else {
        x.zero()
    };
    Exchange {
        value: (first + &second) + &(third + &fourth),
        magnitude,
    }
}
