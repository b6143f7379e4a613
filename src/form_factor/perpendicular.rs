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
//! Source: Howell, *A Catalog of Radiation Heat Transfer Configuration Factors*, C-15.

use super::FormFactorError;
use super::exchange::{Exchange, Sign, log_ratio, log_ratio_size};
use super::parallel::second_difference;
use crate::geometry::{Offsets, Span};
use crate::numeric::Scalar;

/// A rectangle seen from the line in which its plane meets the other one's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plate<S = f64> {
    depth: Span<S>,
    width: Span<S>,
}

impl Plate {
    /// The same plate as numbers of the type and precision of `like`.
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
/// use infoscene::{form_factor::perpendicular::{Plate, exchange_area}, geometry::Span};
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
    let swapped = widths.swapped();
    let (thin, other, widths) = if shortest % 2 == 0 {
        (depths[0], depths[1], widths)
    } else {
        (depths[1], depths[0], &swapped)
    };
    let (heights, depths) = (ends(other), ends(thin));
    let sum = if shortest < 2 {
        let across = second_difference(widths);
        let corners = std::array::from_fn(|k| {
            let ((z, sign_z), (v, sign_v)) = (heights[k / 4], across[k % 4]);
            ([z.clone(), v.clone()], sign_z.times(sign_v))
        });
        Exchange::over_corners(
            &corners,
            [thin.lower(), thin.upper(), thin.length()].map(Clone::clone),
            #[inline(always)]
            |thin, [z, v], i| difference_in_depth(thin, &z[i], &v[i]),
            |[z, v]| at_the_line_in_depth(thin, z, v),
        )
    } else {
        let corners = std::array::from_fn(|k| {
            let ((x, sign_x), (z, sign_z)) = (depths[k / 4], heights[k / 2 % 2]);
            // in v the lower end of η is the plus
            let sign = sign_x.times(sign_z).times([Sign::Plus, Sign::Minus][k % 2]);
            let [v0, v1] = [0, 1].map(|end| widths.difference(end, k % 2).clone());
            ([x.clone(), z.clone(), v0, v1], sign)
        });
        let delta = widths.first_length();
        Exchange::over_corners(
            &corners,
            [delta.clone()],
            #[inline(always)]
            |[delta], [x, z, v0, v1], i| difference_in_width(&x[i], &z[i], delta, [&v0[i], &v1[i]]),
            |[x, z, v0, v1]| at_the_line_in_width(x, z, delta, [v0, v1]),
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
/// **Arguments** `depths` from 0 up; `offsets`: y less the second plate's lower and upper end along the line.
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

/// What the rounding of `coefficient · ln r²` is relative to: near r² = 1 the logarithm is small
/// but its error is not.
#[inline(always)]
#[allow(
    clippy::inline_always,
    reason = "vector code is made where it is called"
)]
fn log_size<S: Scalar>(term: &S, coefficient: &S) -> S {
    term.abs() + &coefficient.abs()
}

/// `G(x1, z, v) − G(x0, z, v)`, each term to its own relative precision; not for a corner on the common line.
#[inline(always)]
#[allow(
    clippy::inline_always,
    reason = "vector code is made where it is called"
)]
fn difference_in_depth<S: Scalar>([x0, x1, delta]: &[S; 3], z: &S, v: &S) -> Exchange<S> {
    let delta = delta.clone();
    let (z2, v2) = (z.square(), v.square());
    let (s2_0, s2_1) = (x0.square() + &z2, x1.square() + &z2);
    let (s0, s1) = (s2_0.sqrt(), s2_1.sqrt());
    let (r2_0, r2_1) = (s2_0.clone() + &v2, s2_1.clone() + &v2);
    let squares = delta * &(x1.clone() + x0);

    let mut sum = Exchange::new(v);
    // v s atan(v/s)
    let s_step = squares.clone() / &(s1.clone() + &s0);
    sum.add(v.atan2(&s1) * v * &s_step);
    let denominator = s0.clone() * &s1 + &v2;
    sum.add(-((v.clone() * &s_step).atan2(&denominator) * v * &s0));
    add_logs_in_depth(&mut sum, [s2_1, v2], squares, [&r2_0, &r2_1]);
    sum
}

/// `−¼ (s² − v²) ln r²`, as a difference.
#[inline(always)]
#[allow(
    clippy::inline_always,
    reason = "vector code is made where it is called"
)]
fn add_logs_in_depth<S: Scalar>(
    sum: &mut Exchange<S>,
    [s2_1, v2]: [S; 2],
    squares: S,
    [r2_0, r2_1]: [&S; 2],
) {
    let quarter = v2.constant(0.25);
    let log = log_ratio(&squares, r2_0, r2_1);
    let difference = (s2_1.clone() - &v2) * &quarter;
    sum.add_uncertain(-(log.clone() * &difference), || {
        log_ratio_size(&log, &squares, r2_0, r2_1) * &((s2_1 + &v2) * &quarter)
    });
    let coefficient = squares * &quarter;
    let log_term = r2_0.ln() * &coefficient;
    sum.add_uncertain(-log_term.clone(), || log_size(&log_term, &coefficient));
}

/// [`difference_in_depth`] for v = 0, where the angles have no weight: on the common line G is 0; elsewhere an interval
/// that reaches to the line would not know its angle.
fn at_the_line_in_depth<S: Scalar>(x: &Span<S>, z: &S, v: &S) -> Option<Exchange<S>> {
    let on_the_line = z.is_zero() && x.lower().is_zero();
    if !v.is_zero() || (S::TRACKS_ROUNDING && !on_the_line) {
        return None;
    }
    let mut sum = Exchange::new(v);
    let [s2_0, s2_1] = [x.lower(), x.upper()].map(|end| end.square() + &z.square());
    if on_the_line {
        let coefficient = s2_1.clone() * &v.constant(0.25);
        let log_term = s2_1.ln() * &coefficient;
        sum.add_uncertain(-log_term.clone(), || log_size(&log_term, &coefficient));
    } else {
        let squares = x.length().clone() * &(x.upper().clone() + x.lower());
        add_logs_in_depth(&mut sum, [s2_1.clone(), v.zero()], squares, [&s2_0, &s2_1]);
    }
    Some(sum)
}

/// `G(x, z, y1 − η) − G(x, z, y0 − η)`, each term to its own relative precision; not for a corner on the common line.
#[inline(always)]
#[allow(
    clippy::inline_always,
    reason = "vector code is made where it is called"
)]
fn difference_in_width<S: Scalar>(x: &S, z: &S, delta: &S, [v0, v1]: [&S; 2]) -> Exchange<S> {
    let quarter = x.constant(0.25);
    let s2 = x.square() + &z.square();
    let s = s2.sqrt();
    let (v2_0, v2_1) = (v0.square(), v1.square());
    let (r2_0, r2_1) = (s2.clone() + &v2_0, s2.clone() + &v2_1);

    let mut sum = Exchange::new(x);
    // v s atan(v/s)
    sum.add(v1.atan2(&s) * &s * delta);
    let angle = (delta.clone() * &s).atan2(&(s2.clone() + &(v0.clone() * v1)));
    sum.add(angle * v0 * &s);
    // −¼ (s² − v²) ln r²
    let squares = delta.clone() * &(v1.clone() + v0);
    let squares_size = delta.clone() * &(v1.abs() + &v0.abs());
    let log = log_ratio(&squares, &r2_0, &r2_1);
    let difference = (s2.clone() - &v2_1) * &quarter;
    sum.add_uncertain(-(log.clone() * &difference), || {
        log_ratio_size(&log, &squares_size, &r2_0, &r2_1) * &((s2 + &v2_1) * &quarter)
    });
    let log = r2_0.ln();
    sum.add_uncertain(log.clone() * &squares * &quarter, || {
        (log.abs() + &log.constant(1.0)) * &squares_size * &quarter
    });
    sum
}

/// [`difference_in_width`] on the common line, where the angles have no weight, and a corner at r = 0 contributes 0.
fn at_the_line_in_width<S: Scalar>(
    x: &S,
    z: &S,
    delta: &S,
    [v0, v1]: [&S; 2],
) -> Option<Exchange<S>> {
    if !x.is_zero() || !z.is_zero() {
        return None;
    }
    let quarter = x.constant(0.25);
    let mut sum = Exchange::new(x);
    if v0.is_zero() || v1.is_zero() {
        for (v, sign) in [(v1, Sign::Plus), (v0, Sign::Minus)] {
            if !v.is_zero() {
                let coefficient = v.square() * &quarter;
                let log_term = v.square().ln() * &coefficient;
                let signed = match sign {
                    Sign::Plus => log_term.clone(),
                    Sign::Minus => -log_term.clone(),
                };
                sum.add_uncertain(signed, || log_size(&log_term, &coefficient));
            }
        }
        return Some(sum);
    }
    let (v2_0, v2_1) = (v0.square(), v1.square());
    let squares = delta.clone() * &(v1.clone() + v0);
    let squares_size = delta.clone() * &(v1.abs() + &v0.abs());
    let log = log_ratio(&squares, &v2_0, &v2_1);
    let difference = v2_1.clone() * &quarter;
    sum.add_uncertain(log.clone() * &difference, || {
        log_ratio_size(&log, &squares_size, &v2_0, &v2_1) * &difference
    });
    let log = v2_0.ln();
    sum.add_uncertain(log.clone() * &squares * &quarter, || {
        (log.abs() + &log.constant(1.0)) * &squares_size * &quarter
    });
    Some(sum)
}
