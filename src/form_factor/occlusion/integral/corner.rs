//! Corners of boundaries in P's plane, as rational functions of the place along a stretch.
//!
//! ```text
//!   a corner w of space   ξ = (w − y)/(h − w_z), or X = w − y if it lies in P's plane
//!   two lines             α1·X = γ1, α2·X = γ2:  X (α1 × α2) = γ1 ⊥α2 − γ2 ⊥α1, ⊥(x, y) = (y, −x)
//! ```
//!
//! Numerators and denominators have degree 2 at most. With ξ = N/D about t, for complex τ up to R:
//!
//! ```text
//!   |ξ(t + τ) − ξ(t)| ≤ (|N1 − ξ D1| R + |N2 − ξ D2| R²) / (|D0| − |D1| R − |D2| R²)
//! ```
//!
//! **Rounding.** The parts of degree 0 of N and D are within 3u of themselves, u = ε/2, and the
//! others within some u of the products in them, 9u with all sums. Of lines that are nearly
//! parallel these cancel, too; all parts are then taken from 106 bits. What is uncertain of the
//! lines moves a corner far along both, and little across: the two are kept apart.

use crate::form_factor::occlusion::view::sight::Sight;
use crate::form_factor::occlusion::view::trace::{Middle, product_difference};
use crate::numeric::functions::elementary::logarithms;
use crate::numeric::{DoubleDouble, LANES, Lanes, Scalar, vector_value};
use glam::{DVec2, DVec3};

/// A corner of the boundary as a function of t, about the middle of a panel: X, or X/h.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Corner {
    numerator: [DVec2; 3],
    denominator: [f64; 3],
    pub is_per_height: bool,
    /// The distance of the corner from its exact place, in the same unit.
    pub noise: f64,
    /// The distance of the corner from each of its two lines.
    pub beside: f64,
}

impl Corner {
    /// The corner where two lines cross, on a panel.
    pub(crate) fn at_crossing(sight: &Sight, lines: [usize; 2], middle: &Middle) -> Self {
        if let Some(place) = sight.common(lines[0], lines[1]) {
            return Self::of_space(sight, place, middle);
        }
        let is_cone = |line: usize| sight.traces[line].edge.is_none();
        let cones = lines.map(is_cone);
        if sight.is_level && cones[0] && cones[1] {
            // lines through y
            return Self::new([DVec2::ZERO; 3], [1.0, 0.0, 0.0], false, [0.0; 2]);
        }
        let is_per_height = cones[0] && cones[1];
        let form = |line: usize| Form::of(sight, line, middle, is_per_height);
        Self::where_cross([form(lines[0]), form(lines[1])], middle, is_per_height)
    }

    fn new(
        numerator: [DVec2; 3],
        denominator: [f64; 3],
        is_per_height: bool,
        [noise, beside]: [f64; 2],
    ) -> Self {
        Self {
            numerator,
            denominator,
            is_per_height,
            noise,
            beside,
        }
    }

    /// A corner of space, or what it casts on P's plane.
    ///
    /// Differences of 106 bits leave 2u of each, and a sum of two terms as much.
    fn of_space(sight: &Sight, place: DVec3, middle: &Middle) -> Self {
        let (from, v) = (middle.to(place), sight.along);
        let numerator = [from.truncate(), -v.truncate(), DVec2::ZERO];
        let across = from.truncate().length() + middle.half * v.truncate().length();
        if place.z == 0.0 {
            let noise = 4.0 * UNIT * across;
            return Self::new(numerator, [1.0, 0.0, 0.0], false, [noise; 2]);
        }
        let rise = middle.half * v.z.abs();
        let least = from.z.abs() - rise;
        let most = across / least;
        let noise = 4.0 * UNIT * ((across + most * (from.z.abs() + rise)) / least + most);
        Self::new(
            numerator,
            [-from.z, v.z, 0.0],
            true,
            where_apart(least, [noise; 2]),
        )
    }

    /// The corner where two lines cross.
    fn where_cross(forms: [Form; 2], middle: &Middle, is_per_height: bool) -> Self {
        let half = middle.half;
        let largest = |parts: [f64; 3]| parts[0] + half * (parts[1] + half * parts[2]);
        let (mut numerator, mut denominator) = solved(forms, 0.0);
        let leading = vector_value!((DVec2::ZERO, 0.0), leading(forms));
        (numerator[0], denominator[0]) = leading;
        let firsts = forms.map(|form| form.alpha[0].length());
        let alphas = [0, 1].map(|k| firsts[k] + half * forms[k].alpha[1].length());
        let gammas = forms.map(|form| largest(form.gamma.map(f64::abs)));
        let [one, other] = forms.map(|form| form.gamma[0].abs());
        let mut lost = [
            gammas[0] * alphas[1] + gammas[1] * alphas[0] - one * firsts[1] - other * firsts[0],
            alphas[0] * alphas[1] - firsts[0] * firsts[1],
        ];
        lost = lost.map(|rest| 9.0 * UNIT * rest);
        if denominator[0].abs() < NEARLY_PARALLEL * firsts[0] * firsts[1] {
            (numerator, denominator) = vector_value!(
                ([DVec2::ZERO; 3], [0.0; 3]),
                solved(forms, DoubleDouble::from(0.0))
            );
            lost = [0.0; 2];
        }
        // of the parts themselves
        lost[0] += 6.0 * UNIT * largest(numerator.map(DVec2::length));
        lost[1] += 6.0 * UNIT * largest(denominator.map(f64::abs));
        let corner = Self::new(numerator, denominator, is_per_height, [0.0; 2]);
        let (least, most) = corner.drift().limits(half);
        let rounding = (lost[0] + most * lost[1]) / least + 4.0 * UNIT * most;
        let beside = [0, 1].map(|k| {
            let form = &forms[k];
            let turned = form.alpha[0].length() - half * form.alpha[1].length();
            let length = turned.max(least / alphas[1 - k]);
            (form.error[0] * most + form.error[1]) / length
        });
        let along = (beside[0] + beside[1]) * alphas[0] * alphas[1] / least;
        let noise = [rounding + along, rounding + beside[0].max(beside[1])];
        Self::new(
            numerator,
            denominator,
            is_per_height,
            where_apart(least, noise),
        )
    }

    /// The displacement of the corner as t leaves the middle.
    pub(crate) fn drift(&self) -> Drift {
        let ([n0, n1, n2], [d0, d1, d2]) = (self.numerator, self.denominator);
        let place = n0 / d0;
        Drift {
            moves: [n1 - place * d1, n2 - place * d2],
            denominator: [d0.abs(), d1.abs(), d2.abs()],
            place,
            is_per_height: self.is_per_height,
        }
    }

    /// X at places relative to the middle, and the logarithms of its distances from y.
    #[inline(always)]
    pub(crate) fn lanes(&self, tau: &Lanes, height: &Lanes, inverse_square: f64) -> [Lanes; 3] {
        let ([n0, n1, n2], [d0, d1, d2]) = (self.numerator, self.denominator);
        let (mut x, mut y, mut square) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
        for l in 0..LANES {
            let (t, h) = (tau[l], height[l]);
            let scale = if self.is_per_height { h } else { 1.0 };
            let scale = scale / (d0 + t * (d1 + t * d2));
            x[l] = (n0.x + t * (n1.x + t * n2.x)) * scale;
            y[l] = (n0.y + t * (n1.y + t * n2.y)) * scale;
            let distance = x[l] * x[l] + y[l] * y[l] + h * h;
            square[l] = distance * inverse_square + f64::MIN_POSITIVE;
        }
        let mut logs = logarithms(square);
        for log in &mut logs {
            *log *= 0.5;
        }
        [x, y, logs]
    }

    /// X at a place relative to the middle.
    pub(crate) fn at(&self, tau: f64, height: f64) -> DVec2 {
        let ([n0, n1, n2], [d0, d1, d2]) = (self.numerator, self.denominator);
        let place = (n0 + tau * (n1 + tau * n2)) / (d0 + tau * (d1 + tau * d2));
        if self.is_per_height {
            height * place
        } else {
            place
        }
    }
}

/// The terms that bound the displacement of a corner.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Drift {
    /// The parts of degree 1 and 2 of the displacement's numerator.
    pub moves: [DVec2; 2],
    denominator: [f64; 3],
    /// X, or X/h, at the middle.
    pub place: DVec2,
    pub is_per_height: bool,
}

impl Drift {
    /// The least of the denominator and the farthest that the corner is, up to a `reach`.
    fn limits(&self, reach: f64) -> (f64, f64) {
        let [d0, d1, d2] = self.denominator;
        let least = d0 - reach * (d1 + reach * d2);
        (least, self.place.length() + self.displacement(reach))
    }

    /// The distance by which it moves for t up to `reach` from the middle.
    pub(crate) fn displacement(&self, reach: f64) -> f64 {
        let [d0, d1, d2] = self.denominator;
        let left = d0 - reach * (d1 + reach * d2);
        let moved = reach * (self.moves[0].length() + reach * self.moves[1].length());
        if left > 0.0 {
            moved / left
        } else {
            f64::INFINITY
        }
    }

    /// The distances by which it moves for complex t up to each `reach` from the middle, from the
    /// sizes of the parts that displace it.
    #[inline(always)]
    pub(crate) fn displacements(&self, [n1, n2]: [f64; 2], reach: &Lanes) -> Lanes {
        let [d0, d1, d2] = self.denominator;
        let mut moved = [f64::INFINITY; LANES];
        for l in 0..LANES {
            let reach = reach[l];
            let left = d0 - reach * (d1 + reach * d2);
            let far = reach * (n1 + reach * n2) / left;
            moved[l] = if left > 0.0 { far } else { f64::INFINITY };
        }
        moved
    }
}

/// A line about the middle of a panel: `α·ξ = γ`, or `α·X = γ`, with polynomials in τ.
#[derive(Debug, Clone, Copy)]
struct Form {
    alpha: [DVec2; 2],
    gamma: [f64; 3],
    /// Bounds on the errors of α and γ on the panel.
    error: [f64; 2],
}

impl Form {
    fn of(sight: &Sight, line: usize, middle: &Middle, is_per_height: bool) -> Self {
        let trace = &sight.traces[line];
        let Middle { t, half, .. } = *middle;
        let lost = trace.error[0] + (t.abs() + half) * trace.error[1];
        if let Some((alpha, [gamma, slope])) = trace.edge {
            let rounding = 2.0 * UNIT * (gamma.abs() + (t.abs() + half) * slope.abs());
            return Self {
                alpha: [alpha, DVec2::ZERO],
                gamma: [gamma + t * slope, slope, 0.0],
                error: [UNIT * alpha.length(), lost + rounding],
            };
        }
        let [start, slope] = trace.normal;
        let normal = start + t * slope;
        let lost = lost + UNIT * ((t * slope).length() + normal.length());
        let alpha = [normal.truncate(), slope.truncate()];
        if is_per_height {
            return Self {
                alpha,
                gamma: [normal.z, slope.z, 0.0],
                error: [lost; 2],
            };
        }
        let (height, rise) = (middle.height(), sight.along.z);
        let gamma = [
            height * normal.z,
            height * slope.z + rise * normal.z,
            rise * slope.z,
        ];
        let level = normal.z.abs() + half * slope.z.abs();
        let highest = height.abs() + half * rise.abs();
        Self {
            alpha,
            gamma,
            error: [lost, highest * (lost + 5.0 * UNIT * level)],
        }
    }
}

/// Numerators and denominators of the place where two lines cross:
/// `X (α1 × α2) = γ1 ⊥α2 − γ2 ⊥α1`.
#[inline(always)]
fn solved<S: Scalar + Copy>(forms: [Form; 2], like: S) -> ([DVec2; 3], [f64; 3]) {
    let zero = like.constant(0.0);
    let lifted = forms.map(|Form { alpha, gamma, .. }| {
        let alpha = alpha.map(|alpha| [like.constant(alpha.x), like.constant(alpha.y)]);
        (alpha, gamma.map(|gamma| like.constant(gamma)))
    });
    let [(a, c), (b, k)] = lifted;
    let (mut numerator, mut denominator) = ([[zero; 2]; 3], [zero; 3]);
    for i in 0..3 {
        for j in 0..(3 - i).min(2) {
            let [x, y] = &mut numerator[i + j];
            *x = *x + c[i] * b[j][1] - k[i] * a[j][1];
            *y = *y + k[i] * a[j][0] - c[i] * b[j][0];
            if i < 2 {
                let cross = a[i][0] * b[j][1] - a[i][1] * b[j][0];
                denominator[i + j] = denominator[i + j] + cross;
            }
        }
    }
    (
        numerator.map(|[x, y]| DVec2::new(x.to_f64(), y.to_f64())),
        denominator.map(|part| part.to_f64()),
    )
}

/// The parts of degree 0 of these, within 3u of themselves.
#[inline(always)]
fn leading([one, other]: [Form; 2]) -> (DVec2, f64) {
    let ([a, b], [c, k]) = (
        [one.alpha[0], other.alpha[0]],
        [one.gamma[0], other.gamma[0]],
    );
    let numerator = DVec2::new(
        product_difference([c, b.y], [k, a.y]),
        product_difference([k, a.x], [c, b.x]),
    );
    (numerator, product_difference([a.x, b.y], [a.y, b.x]))
}

/// Half a unit in the last place of 1: the error of one operation, relatively.
const UNIT: f64 = 0.5 * f64::EPSILON;

/// The sine below which a crossing is taken from 106 bits.
const NEARLY_PARALLEL: f64 = 1.0 / 64.0;

/// The noise of a corner whose denominator is `least` or more on the panel; nothing bounds it where
/// that may vanish.
fn where_apart(least: f64, noise: [f64; 2]) -> [f64; 2] {
    if least > 0.0 {
        noise
    } else {
        [f64::INFINITY; 2]
    }
}
