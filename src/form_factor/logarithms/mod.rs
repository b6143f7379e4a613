//! Logarithms of the distance and of the two cosines, integrated over the exchange of two polygons.
//!
//! ```text
//!   F = cos θ cos θ'/(π r²),   E = ∫∫ F,   R = ∫∫ F ln r,
//!   C = ∫∫ F ln cos θ,         C' = ∫∫ F ln cos θ'
//!   ∫∫ F ln F = C + C' − 2 R − E ln π
//! ```
//!
//! The integrands are singular where the polygons touch; none of them is evaluated. With h(z) the
//! height of a point of the second outline over the plane of the first, `H dφ` with
//! `H = ∫_c¹ c ln c dc` is the inner integral of C around a point, and the outer one goes to the
//! first outline by the divergence theorem, because `H/ρ` has a primitive in the plane:
//!
//! ```text
//!   C = −E/2 + (1/8π) ∮∮ Li₂(1 − h(z)²/r²) dl·dl'                                     (a)
//!   R = ∫ F_x ln h(x) dA_x − C',     h(x) = r cos θ' the height of x over the second plane    (b)
//! ```
//!
//! In (b) ln h is constant for parallel planes, and nearly so for nearly parallel ones, where a
//! rule in two dimensions integrates the small rest. Where the planes meet, `F ln r` is homogeneous
//! but for the logarithm about any point o of the line in which they meet, and Euler's identity
//! takes the outer integral to the edges, at the distances p from o:
//!
//! ```text
//!   2 R = −E + Σ_e p_e ∫_e m'(x) dl + Σ_e' p_e' ∫_e' m(y) dl,   m'(x) = ∫ F ln r dA_y       (c)
//!   m'(x) = F_x/2 + (n·n'/2π) ∫ dA_y/r² − (1/2π) Σ_b n·(a × t)/q ∫_b q ln r/r² ds           (d)
//!   ∫ dA_y/r² = Σ_b ∫_b ½ ln((cos²t + λ²)/cos²t) dt,   λ = |p_b|/d, with the sign of p_b    (e)
//! ```
//!
//! The integrals in (d) and (e) are imaginary parts of the
//! [dilogarithm](crate::numeric::imaginary_dilogarithm). The remaining integrals, in one dimension
//! in (c) and two in (a), take Gauss rules on panels short against the distance of the nearest
//! singularity.
//! For (d) take `∮ (ln r/r²) r × dl'` and Stokes' theorem: the kernel `1/r²` without a logarithm is
//! Lambert's formula.
//!
//! **Errors** are *estimates*: the change from a smaller rule on the same panels, and the rounding
//! of what cancels.
//!
//! **Not covered**: polygons that reach behind each other's plane.
//!
//! Reference: (c), (d) as Schröder and Hanrahan, *On the form factor between two polygons*,
//! SIGGRAPH 1993, do for F.

pub(crate) mod cosines;
pub(crate) mod distances;
pub(crate) mod face;
pub(crate) mod panels;

use super::{ExchangeArea, FormFactorError, Polygon};
use crate::geometry::Patch;
use crate::numeric::functions::elementary::ln;
use crate::numeric::{Bounded, GaussLegendre, tolerance};
use face::Face;
use std::f64::consts::PI;

/// Points of the rule on a panel, and of the one that its error is estimated by.
const POINTS: [usize; 2] = [13, 10];

/// Planes count as nearly parallel where heights of one polygon over the other's plane vary by at
/// most this part: Euler's identity would lose more than a digit there.
const LEVEL: f64 = 0.05;

/// The relative error asked for of the exchange area.
const EXCHANGE: f64 = 1e-13;

/// Integrals of ln r and ln cos θ over the exchange of two polygons, in squared units of length;
/// divided by the exchange area they are means.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LogMeans {
    /// `E = ∫∫ F`, the exchange area.
    pub exchange: ExchangeArea,
    /// `∫∫ F ln r`.
    pub distance: f64,
    /// `∫∫ F ln cos θ` of the angle at the first polygon and at the second, ≤ 0.
    pub cosines: [f64; 2],
    /// The error of [`kernel`](Self::kernel).
    kernel_error: f64,
}

impl LogMeans {
    /// `∫∫ F ln(u F)`, with an estimate of its error; `u` > 0 an area, that lengths are compared
    /// with.
    #[must_use]
    pub fn kernel(&self, unit: f64) -> Bounded {
        let [first, second] = self.cosines;
        let of_unit = self.exchange.value * ln(unit / PI);
        Bounded::estimate(
            first + second - 2.0 * self.distance + of_unit,
            self.kernel_error,
        )
    }

    /// The logarithms of two polygons, each in front of the other's plane.
    ///
    /// **Accuracy** about 1e-14 of the exchange area for polygons of moderate shape, touching or
    /// not; the error of [`kernel`](Self::kernel) says what cancels.
    ///
    /// # Errors
    /// [`FormFactorError::BehindPlane`] if one reaches behind the plane of the other; those of
    /// [`Polygon::exchange_area`].
    ///
    /// # Examples
    /// ```
    /// use infoscene::form_factor::LogMeans;
    /// use infoscene::geometry::Patch;
    /// use glam::DVec3;
    /// let (o, x, y, z) = (DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z);
    /// let floor = Patch::try_new(vec![o, x, x + y, y])?;
    /// let ceiling = Patch::try_new(vec![z, y + z, x + y + z, x + z])?;
    /// let there = LogMeans::of(&floor, &ceiling)?;
    /// // parallel at distance 1: r = 1/cos θ
    /// assert!((there.distance + there.cosines[0]).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of(first: &Patch, second: &Patch) -> Result<Self, FormFactorError> {
        let sides = [Face::new(first), Face::new(second)];
        let [one, other] = &sides;
        let extent = one.extent(other);
        let flat = 4.0 * tolerance::ALIGNMENT * extent;
        for (above, below) in [(one, other), (other, one)] {
            let [lower, _] = below.heights(above);
            if lower < -flat {
                return Err(FormFactorError::BehindPlane { lower });
            }
        }
        let exchange = Polygon::new(first).exchange_area(&Polygon::new(second), EXCHANGE)?;
        let exchange = exchange.exchange;
        if exchange.value <= 0.0 {
            return Ok(Self {
                exchange,
                distance: 0.0,
                cosines: [0.0; 2],
                kernel_error: exchange.error,
            });
        }
        let [low, high] = other.heights(one);
        let variation = high - low;
        let is_level = variation <= flat.max(LEVEL * high);
        let mut values = [[0.0; 3]; 2];
        let mut magnitude = 0.0;
        for (rule, values) in values.iter_mut().enumerate() {
            let gauss = GaussLegendre::with(POINTS[rule]);
            let cosine = |from: &Face, to: &Face| {
                let [sum, size] = from.cosine_part(to, flat, exchange.value, gauss);
                (sum / (8.0 * PI) - 0.5 * exchange.value, size / (8.0 * PI))
            };
            let ((at_first, size), (at_second, other_size)) =
                (cosine(one, other), cosine(other, one));
            let [distance, distance_size] = if is_level {
                let height = high.max(one.least);
                let leading = exchange.value * ln(height);
                let varying = if variation > flat {
                    one.by_heights(other, height, gauss)
                } else {
                    0.0
                };
                // the normal's components are rounded each for itself
                let rounded = exchange.value * other.rise(one) / height;
                [leading + varying - at_second, leading.abs() + rounded]
            } else {
                one.by_euler(other, exchange.value, flat, gauss)
            };
            *values = [at_first, at_second, distance];
            magnitude = size + other_size + distance_size;
        }
        let [[at_first, at_second, distance], coarse] = values;
        let change = (at_first - coarse[0]).abs()
            + (at_second - coarse[1]).abs()
            + 2.0 * (distance - coarse[2]).abs();
        // E enters each of C, C' and R by half, and the logarithm of the unit
        let from_exchange = exchange.error * (2.0 + ln(extent).abs());
        Ok(Self {
            exchange,
            distance,
            cosines: [at_first, at_second],
            kernel_error: change + 4.0 * f64::EPSILON * magnitude + from_exchange,
        })
    }
}
