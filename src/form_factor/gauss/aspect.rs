//! An a-priori bound on the error of a Gauss rule along the lines of a quadrilateral, relative to
//! the value: by a series in powers of half a line over its distance.
//!
//! ```text
//!   K = h g / (π r⁴);   along a line x(z), z in [−1, 1]:   h J = h0 J0 (1 + η z)(1 + ι z)
//!   r² = L² |z − a|²    L half the line, L |a| the distance of its middle from a point y of the
//!                       other polygon, θ the angle between the line and the way to y
//! ```
//!
//! Gegenbauer's polynomials are the coefficients of `1/r⁴`, with u = |a|,
//!
//! ```text
//!   1/|z − a|⁴ = u^(−4) Σ_k C_k(cos θ) (z/u)^k
//!   C_k(cos θ) = ((k+3) sin (k+1)θ − (k+1) sin (k+3)θ)/(4 sin³ θ)
//!   |C_k| ≤ (k+1)(k+2)(k+3)/6      end on,        |C_k| ≤ (k+2)/(2 sin³ θ)      from aside
//! ```
//!
//! A rule of n points is right for odd powers and those below 2n; it takes too little of the
//! others, `∫ z^k dz = (rule) + 2 E_k` with
//!
//! ```text
//!   β_j = j²/(4j² − 1),   E_2n = β_1 ⋯ β_n,   E_(2n+2) = E_2n (n(n−1)/(2n−1) + β_n + β_(n+1))
//! ```
//!
//! from the squared norm of Legendre's polynomial and its recurrence. What the line exchanges is at
//! least, by Jensen's inequality for 1/x² and the mean of r² weighted by h J,
//!
//! ```text
//!   ∫ ≥ 2 h0 J0 u^(−4) (1 − |ηι|/3) (1 + 2 m/u + 2/(5u²))^(−2),   m = (|η| + |ι|)/(3 − |ηι|)
//! ```
//!
//! so that with y = 1/u, largest where the distance is least and the angle smallest,
//!
//! ```text
//!   |error| ≤ e ∫,   e = (1 + 2my + ⅖y²)²/(1 − |ηι|/3) (S_0 + (|η| + |ι|) S_1 + |ηι| S_2)
//!   S_d = Σ_(k = 2n, 2n+2, …) E_k |C_(k−d)| y^(k−d)
//! ```
//!
//! of which three terms are taken, the third with all that follow at y = ½. One direction after
//! the other, with the weights and K positive, the errors of all add up to
//!
//! ```text
//!   |rule − A F| ≤ (Π (1 + e_i) − 1) A F ≤ (e + e²) A F,    e = Σ e_i ≤ 1
//! ```
//!
//! Nothing here depends on how K varies over the polygons: only on how it does along one line.
//!
//! Reference: Szegő, *Orthogonal Polynomials*, 1939, §4.7.

use super::points::MOST_PER_DIRECTION;
use crate::numeric::{GaussLegendre, LANES, Lanes, across, real};
use std::sync::LazyLock;

/// Half a line over its distance up to which there is a bound.
const NEAREST: f64 = 0.5;

/// The least sine that the bound from aside is asked for. That end on is the smaller one wherever
/// the cube is below 3/((k+1)(k+3)), as this one's is for every power k that counts.
const LEAST_SINE: f64 = 1e-3;

/// More than the bounds' own rounding, relative: some hundred operations, and 2n factors y.
const ROUNDING: f64 = 1024.0 * f64::EPSILON;

/// The lines of a quadrilateral as they are seen from another polygon.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Aspect {
    /// `y`, the largest half of a line over its distance.
    y: f64,
    /// `|η| + |ι|` and `|ηι|`.
    changes: [f64; 2],
    /// `1/sin³ θ` at most, for both directions.
    aside: [f64; 2],
    /// The factor of the sums, times `y^(2n−2)`.
    factor: f64,
}

/// Measures of two polygons that an aspect is made of.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Placing {
    /// The distance of their centres, and the other polygon's radius.
    pub distance: f64,
    pub radius: f64,
    /// A lower bound on the distance of the other polygon from the middles of lines.
    pub gap: f64,
    /// The cosines between the lines' directions and the way from centre to centre.
    pub cosines: [f64; 2],
    /// The least and largest heights of the corners above the other plane, and their rounding.
    pub heights: [f64; 2],
    pub noise: f64,
    /// Half the longest line, the middles' distance from the centre, `|ι|`, and the directions'
    /// spread: those of [`CellLines`](crate::form_factor::clipped_pair::shape::CellLines).
    pub half: f64,
    pub middle: f64,
    pub unevenness: f64,
    pub spreads: [f64; 2],
}

impl Aspect {
    /// The aspect of lines so placed; without a branch, so that it serves in the lanes of vectors.
    #[inline(always)]
    pub(crate) fn of(placing: &Placing) -> Self {
        let away = placing.radius + placing.middle;
        let noise = 8.0 * f64::EPSILON * (placing.distance + away);
        let (gap, from_centres) = (placing.gap, placing.distance - away);
        let gap = if gap > from_centres {
            gap
        } else {
            from_centres
        };
        let y = placing.half / (gap - noise);
        // what is near, or infinite, or not a number, has no bound
        let y = if y > 0.0 && y <= NEAREST { y } else { 1.0 };
        let [least, most] = placing.heights;
        let tilt = (most - least + 4.0 * placing.noise) / (most + least);
        // heights are not negative
        let tilt = if tilt < 1.0 { tilt } else { 1.0 };
        let changes = [tilt + placing.unevenness, tilt * placing.unevenness];
        let mean = changes[0] / (3.0 - changes[1]);
        let spread = 1.0 + 2.0 * mean * y + 0.4 * (y * y);
        let turned = away / placing.distance;
        let cube = |k: usize| {
            let cosine = placing.cosines[k];
            let aside = (1.0 - cosine * cosine).sqrt();
            // the way to any point differs from that between centres, and lines from their mean
            let off = turned + placing.spreads[k];
            let sine = aside * (1.0 - off * off).sqrt() - cosine.abs() * off - SINE_ERROR;
            let sine = if sine > LEAST_SINE { sine } else { LEAST_SINE };
            1.0 / (sine * sine * sine)
        };
        Self {
            y,
            changes,
            aside: [cube(0), cube(1)],
            factor: (1.0 + ROUNDING) * spread * spread / (1.0 - changes[1] * (1.0 / 3.0)),
        }
    }

    /// `e`, for the rule of a series if the factor is that of its points.
    #[inline(always)]
    fn error(&self, series: &Series) -> f64 {
        let (y, square) = (self.y, self.y * self.y);
        let [once, twice] = self.changes;
        let sum = |terms: &[[f64; 3]; 3]| {
            let at = |d: usize| terms[d][0] + square * (terms[d][1] + square * terms[d][2]);
            square * at(0) + once * y * at(1) + twice * at(2)
        };
        let (end_on, beside) = (sum(&series.end_on), sum(&series.aside));
        let along = |aside: f64| {
            let beside = beside * aside;
            if beside < end_on { beside } else { end_on }
        };
        self.factor * (along(self.aside[0]) + along(self.aside[1]))
    }
}

/// A sine from a cosine within 4 ε of itself, which is within its root of 8 ε.
const SINE_ERROR: f64 = 1e-7;

/// The terms of `S_d`, d = 0, 1, 2, over `y^(2n−d)`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Series {
    end_on: [[f64; 3]; 3],
    aside: [[f64; 3]; 3],
}

impl Series {
    /// The series of a rule with so many points.
    fn of(points: usize) -> Self {
        let beta = |j: usize| real(j * j) / real(4 * j * j - 1);
        let first: f64 = (1..=points).map(beta).product();
        let second = real(points * (points - 1)) / real(2 * points - 1);
        let second = first * (second + beta(points) + beta(points + 1));
        let rule = GaussLegendre::with(points);
        // 0.5 Σ w |x|^k, each factor within ε of itself
        let missed = |k: usize| {
            let power = |x: &f64| x.powi(i32::try_from(k).unwrap_or(i32::MAX));
            let terms = rule.nodes.iter().zip(&rule.weights);
            let sum: f64 = terms.map(|(x, w)| 0.5 * w * power(x)).sum();
            1.0 / real(k + 1) - sum + 64.0 * f64::EPSILON
        };
        // terms so far on that what follows is less than their rounding
        const FOLLOWING: usize = 100;
        let terms = |largest: fn(usize) -> f64| {
            [0, 1, 2].map(|d| {
                let at = |j: usize| largest(2 * (points + j) - d);
                let following = (2..FOLLOWING).map(|j| {
                    let shrunk = NEAREST.powi(i32::try_from(2 * j - 4).unwrap_or(i32::MAX));
                    missed(2 * (points + j)) * at(j) * shrunk
                });
                [first * at(0), second * at(1), following.sum()]
            })
        };
        Self {
            end_on: terms(|k| real((k + 1) * (k + 2) * (k + 3)) / 6.0),
            aside: terms(|k| 0.5 * real(k + 2)),
        }
    }
}

/// The series by points, from 1 on.
pub(crate) static SERIES: LazyLock<Vec<Series>> =
    LazyLock::new(|| (1..MOST_PER_DIRECTION).map(Series::of).collect());

/// Points a direction, and the error of both directions with them, relative to the value.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Rung {
    /// None where there is no bound, or none that is small enough.
    pub points: usize,
    pub error: f64,
}

impl Aspect {
    /// The rung of the fewest points whose error is within that wanted.
    pub(crate) fn rung(mut self, wanted: f64) -> Rung {
        if self.y > NEAREST {
            return Rung::default();
        }
        for (points, series) in (1..).zip(SERIES.iter()) {
            let error = self.error(series);
            if error <= wanted {
                return Rung { points, error };
            }
            self.factor *= self.y * self.y;
        }
        Rung::default()
    }
}

/// The aspects of eight polygons.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct AspectLanes {
    y: Lanes,
    changes: [Lanes; 2],
    aside: [Lanes; 2],
    factor: Lanes,
}

/// The rungs of eight polygons, points as real numbers.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct RungLanes {
    points: Lanes,
    error: Lanes,
}

impl RungLanes {
    /// The rung of one.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a small whole number"
    )]
    pub(crate) const fn at(&self, lane: usize) -> Rung {
        Rung {
            points: self.points[lane] as usize,
            error: self.error[lane],
        }
    }
}

impl AspectLanes {
    /// Puts one aspect among the others.
    #[inline(always)]
    pub(crate) fn put(&mut self, lane: usize, aspect: &Aspect) {
        self.y[lane] = aspect.y;
        for k in 0..2 {
            self.changes[k][lane] = aspect.changes[k];
            self.aside[k][lane] = aspect.aside[k];
        }
        self.factor[lane] = aspect.factor;
    }

    #[inline(always)]
    fn at(&self, lane: usize) -> Aspect {
        Aspect {
            y: self.y[lane],
            changes: [self.changes[0][lane], self.changes[1][lane]],
            aside: [self.aside[0][lane], self.aside[1][lane]],
            factor: self.factor[lane],
        }
    }

    /// The [rungs](Aspect::rung) of all, to be called where vector code is made.
    #[inline(always)]
    pub(crate) fn rungs(&mut self, wanted: &Lanes, series: &[Series]) -> RungLanes {
        let (mut found, mut number) = (RungLanes::default(), 0.0);
        for series in series {
            number += 1.0;
            let mut open = [0.0; LANES];
            for l in 0..LANES {
                let aspect = self.at(l);
                let error = aspect.error(series);
                let is_open = found.points[l] <= 0.0 && aspect.y <= NEAREST;
                let is_found = is_open && error <= wanted[l];
                found.points[l] = if is_found { number } else { found.points[l] };
                found.error[l] = if is_found { error } else { found.error[l] };
                self.factor[l] = aspect.factor * (aspect.y * aspect.y);
                open[l] = if is_open && !is_found { 1.0 } else { 0.0 };
            }
            if across(open) <= 0.0 {
                break;
            }
        }
        found
    }
}
