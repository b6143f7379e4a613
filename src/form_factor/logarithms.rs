//! Logarithms of the distance and of the two cosines, averaged over what two polygons exchange.
//!
//! ```text
//!   F = cos θ cos θ'/(π r²),   E = ∫∫ F,   R = ∫∫ F ln r,   C = ∫∫ F ln cos θ,   C' = ∫∫ F ln cos θ'
//!   ∫∫ F ln F = C + C' − 2 R − E ln π
//! ```
//!
//! The integrands are singular where the polygons touch; none of them is evaluated. With h(z) the height of a point of the
//! second outline over the plane of the first, `H dφ` with `H = ∫_c¹ c ln c dc` is the inner integral of C around a point, and the
//! outer one goes to the first outline by the divergence theorem, because `H/ρ` has a primitive in the plane:
//!
//! ```text
//!   C = −E/2 + (1/8π) ∮∮ Li₂(1 − h(z)²/r²) dl·dl'                                                         (a)
//!   parallel planes at distance d:   R = E ln d − C'                                                    (b)
//! ```
//!
//! Where the planes meet, `F ln r` is homogeneous but for the logarithm about any point o of the line in which they meet, and Euler's
//! identity takes the outer integral to the edges, at the distances p from o:
//!
//! ```text
//!   2 R = −E + Σ_e p_e ∫_e m'(x) dl + Σ_e' p_e' ∫_e' m(y) dl,     m'(x) = ∫ F ln r dA_y                      (c)
//!   m'(x) = F_x/2 + (n·n'/2π) ∫ dA_y/r² − (1/2π) Σ_b n·(a × t)/q ∫_b q ln r/r² ds                            (d)
//!   ∫ dA_y/r² = Σ_b ∫_b ½ ln((cos²t + λ²)/cos²t) dt,     λ = |p_b|/d, with the sign of p_b                    (e)
//! ```
//!
//! The integrals in (d) and (e) are imaginary parts of the [dilogarithm](crate::numeric::imaginary_dilogarithm). What is left,
//! one dimension in (c) and two in (a), is done by Gauss rules on panels short against the distance of the nearest singularity.
//! For (d) take `∮ (ln r/r²) r × dl'` and Stokes' theorem: the kernel `1/r²` without a logarithm is Lambert's formula.
//!
//! **Errors** are *estimates*: the change from a smaller rule on the same panels, and the rounding of what cancels.
//!
//! **Not covered**: polygons that reach behind each other's plane; planes at an angle below 1e-6 or so, where (c) cancels, as
//! the estimate says.
//!
//! Reference: (c), (d) as Schröder and Hanrahan, *On the form factor between two polygons*, SIGGRAPH 1993, do for F.

use super::{ExchangeArea, FormFactorError, Polygon};
use crate::geometry::Patch;
use crate::numeric::elementary::{angle, ln};
use crate::numeric::{
    CompensatedSum, GaussLegendre, SQUARED_EPSILON, dilogarithm_of_complement,
    imaginary_dilogarithm, tolerance,
};
use glam::DVec3;
use std::f64::consts::{LN_2, PI, TAU};

/// Points of the rule on a panel, and of the one that its error is estimated by.
const POINTS: [usize; 2] = [13, 10];

/// Half a panel is at most this part of the distance to the nearest singularity: (a) with ρ = 2.5 + √5.25 = 4.79 the rule of 13
/// points leaves 2e-18.
const REACH: f64 = 0.4;

/// Shortest panels, relative to their edge (positions along it are known to ε), where the integrand is unbounded like a logarithm,
/// and where it is bounded and only the square of the length counts.
const SHORTEST: [f64; 2] = [1e-15, 1e-8];

/// The relative error asked for of the exchange area.
const EXCHANGE: f64 = 1e-13;

/// Logarithms integrated over what two polygons exchange, in squared units of length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Logarithms {
    /// `E = ∫∫ F`, the exchange area.
    pub exchange: ExchangeArea,
    /// `∫∫ F ln r`.
    pub distance: f64,
    /// `∫∫ F ln cos θ` of the angle at the first polygon and at the second, ≤ 0.
    pub cosines: [f64; 2],
    /// Estimated absolute error of `∫∫ F ln F`.
    pub error_estimate: f64,
}

impl Logarithms {
    /// `∫∫ F ln(u F)`; `u` > 0 an area, that lengths are compared with.
    #[must_use]
    pub fn kernel(&self, unit: f64) -> f64 {
        let [first, second] = self.cosines;
        first + second - 2.0 * self.distance + self.exchange.value * (unit / PI).ln()
    }

    /// Of two polygons, each in front of the other's plane.
    ///
    /// **Accuracy** about 1e-14 of the exchange area for polygons of moderate shape, touching or not; `error_estimate` says what cancels.
    ///
    /// # Errors
    /// [`FormFactorError::BehindPlane`] if one reaches behind the plane of the other; those of
    /// [`Polygon::exchange_area`].
    ///
    /// # Examples
    /// ```
    /// use infoscene::form_factor::Logarithms;
    /// use infoscene::geometry::Patch;
    /// use glam::DVec3;
    /// let (o, x, y, z) = (DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z);
    /// let floor = Patch::try_new(vec![o, x, x + y, y])?;
    /// let ceiling = Patch::try_new(vec![z, y + z, x + y + z, x + z])?;
    /// let there = Logarithms::of(&floor, &ceiling)?;
    /// // parallel at distance 1: r = 1/cos θ
    /// assert!((there.distance + there.cosines[0]).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of(first: &Patch, second: &Patch) -> Result<Self, FormFactorError> {
        let sides = [Side::new(first), Side::new(second)];
        let [one, other] = &sides;
        let extent = one.extent(other);
        let flat = 4.0 * tolerance::ALIGNMENT * extent;
        for (above, below) in [(one, other), (other, one)] {
            let lower = below.lowest(above);
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
                error_estimate: exchange.error_bound,
            });
        }
        let across = one.normal.cross(other.normal);
        let is_parallel = across.length() <= tolerance::ALIGNMENT;
        let mut values = [[0.0; 3]; 2];
        let mut magnitude = 0.0;
        for (rule, values) in values.iter_mut().enumerate() {
            let gauss = GaussLegendre::with(POINTS[rule]);
            let cosine = |from: &Side, to: &Side| {
                let [sum, size] = from.cosine_part(to, flat, gauss);
                (sum / (8.0 * PI) - 0.5 * exchange.value, size / (8.0 * PI))
            };
            let ((at_first, size), (at_second, other_size)) =
                (cosine(one, other), cosine(other, one));
            let (distance, distance_size) = if is_parallel {
                let gap = one.height(other.corners[0]).max(one.least);
                let gap = ln(gap);
                let leading = exchange.value * gap;
                (leading - at_second, leading.abs())
            } else {
                let origin = one.meeting_point(other, across);
                let [there, there_size] = one.distance_part(other, origin, flat, gauss);
                let [back, back_size] = other.distance_part(one, origin, flat, gauss);
                let boundary = there + back;
                (
                    0.5 * (boundary - exchange.value),
                    0.5 * (there_size + back_size),
                )
            };
            *values = [at_first, at_second, distance];
            magnitude = size + other_size + distance_size;
        }
        let [[at_first, at_second, distance], coarse] = values;
        let change = (at_first - coarse[0]).abs()
            + (at_second - coarse[1]).abs()
            + 2.0 * (distance - coarse[2]).abs();
        // E enters each of C, C' and R by half, and the logarithm of the unit
        let from_exchange = exchange.error_bound * (2.0 + extent.ln().abs());
        Ok(Self {
            exchange,
            distance,
            cosines: [at_first, at_second],
            error_estimate: change + 4.0 * f64::EPSILON * magnitude + from_exchange,
        })
    }
}

/// An edge: start, direction, length.
#[derive(Debug, Clone, Copy)]
struct Edge {
    start: DVec3,
    along: DVec3,
    length: f64,
}

impl Edge {
    fn at(&self, s: f64) -> DVec3 {
        self.start + s * self.along
    }

    fn distance(&self, point: DVec3) -> f64 {
        let foot = (point - self.start).dot(self.along).clamp(0.0, self.length);
        self.at(foot).distance(point)
    }
}

/// A polygon with its edges.
struct Side {
    corners: Vec<DVec3>,
    edges: Vec<Edge>,
    normal: DVec3,
    /// Heights below are rounding: so little of an edge is that low that the logarithm does not count.
    least: f64,
}

impl Side {
    fn new(patch: &Patch) -> Self {
        let corners = patch.corners().to_vec();
        let ends = corners.iter().cycle().skip(1);
        let edges = corners.iter().zip(ends).map(|(start, end)| {
            let edge = *end - *start;
            let length = edge.length();
            let along = edge / length;
            Edge {
                start: *start,
                along,
                length,
            }
        });
        Self {
            edges: edges.filter(|edge| edge.length > 0.0).collect(),
            least: patch.area().sqrt() * SQUARED_EPSILON,
            corners,
            normal: patch.normal(),
        }
    }

    fn height(&self, point: DVec3) -> f64 {
        self.normal.dot(point - self.corners[0])
    }

    /// The lowest corner of another one, over the plane of this one.
    fn lowest(&self, other: &Self) -> f64 {
        let heights = other.corners.iter().map(|corner| self.height(*corner));
        heights.fold(f64::INFINITY, f64::min)
    }

    fn extent(&self, other: &Self) -> f64 {
        let corners = self.corners.iter().chain(&other.corners);
        corners
            .map(|corner| corner.abs().max_element())
            .fold(f64::MIN_POSITIVE, f64::max)
    }

    /// Where the planes meet, below the corner nearest to that line: distances from there vanish for most edges that touch.
    fn meeting_point(&self, other: &Self, across: DVec3) -> DVec3 {
        let (sine, cosine) = (across.length_squared(), self.normal.dot(other.normal));
        let below = |corner: &DVec3| {
            let [h, k] = [self.height(*corner), other.height(*corner)];
            let step =
                (cosine * k - h) / sine * self.normal + (cosine * h - k) / sine * other.normal;
            (*corner + step, step.length_squared())
        };
        let corners = self.corners.iter().chain(&other.corners).map(below);
        let nearest = corners.min_by(|a, b| a.1.total_cmp(&b.1));
        nearest.map_or(self.corners[0], |(point, _)| point)
    }

    /// `∮∮ Li₂(1 − h²/r²) dl·dl'`, h the height over this plane, and the sum of the magnitudes.
    fn cosine_part(&self, other: &Self, flat: f64, gauss: &GaussLegendre) -> [f64; 2] {
        let mut sum = CompensatedSum::default();
        let mut size = 0.0;
        for outer in &other.edges {
            let start = self.height(outer.start);
            let slope = self.normal.dot(outer.along);
            let is_in_plane = start.abs() <= flat && (start + slope * outer.length).abs() <= flat;
            for inner in &self.edges {
                let dot = outer.along.dot(inner.along);
                if dot.abs() <= f64::EPSILON {
                    continue;
                }
                let term = dot
                    * if is_in_plane {
                        PI * PI / 6.0 * outer.length * inner.length
                    } else {
                        edge_pair(outer, inner, [start, slope], gauss)
                    };
                sum.add(term);
                size += term.abs();
            }
        }
        [sum.total(), size]
    }

    /// `Σ_e p_e ∫_e m'(x) dl` over the edges of this one, and the sum of the magnitudes.
    fn distance_part(
        &self,
        other: &Self,
        origin: DVec3,
        flat: f64,
        gauss: &GaussLegendre,
    ) -> [f64; 2] {
        let mut sum = CompensatedSum::default();
        let mut size = 0.0;
        for edge in &self.edges {
            let away = edge.along.cross(self.normal).dot(edge.start - origin);
            if away.abs() <= flat {
                continue;
            }
            let gap = |s: f64| other.distance(edge.at(s));
            let inner = |s: f64| other.moment(edge.at(s), self.normal);
            let term = away * over_panels(edge.length, SHORTEST[0], gap, inner, gauss);
            sum.add(term);
            size += term.abs();
        }
        [sum.total(), size]
    }

    /// The distance of a point in front of this polygon.
    fn distance(&self, point: DVec3) -> f64 {
        let mut nearest = f64::INFINITY;
        let mut winding = 0.0;
        for edge in &self.edges {
            nearest = nearest.min(edge.distance(point));
            let start = edge.start - point;
            let from_foot = start.cross(edge.along).dot(self.normal);
            let along = start.dot(edge.along);
            let seen = [along + edge.length, along].map(|s| angle(s, from_foot.abs()));
            winding += from_foot.signum() * (seen[0] - seen[1]);
        }
        if winding > PI {
            nearest.min(self.height(point).max(0.0))
        } else {
            nearest
        }
    }

    /// `∫ F ln r` over this polygon, from a point of a plane with this normal: (d).
    fn moment(&self, point: DVec3, normal: DVec3) -> f64 {
        let height = self.height(point).max(self.least);
        let cosine = normal.dot(self.normal);
        let (mut received, mut logarithm, mut spread) = (0.0, 0.0, 0.0);
        for edge in &self.edges {
            let start = edge.start - point;
            let turn = start.cross(edge.along);
            let q = turn.length();
            if q <= 0.0 {
                continue;
            }
            let ends = [0.0, edge.length].map(|s| start.dot(edge.along) + s);
            let part = normal.dot(turn) / q;
            let [a, b] = ends.map(|s| Angle::new(s, q));
            let seen = b.angle - a.angle;
            // ∫ ln cos = −t ln 2 − ½ Im Li₂(−e^(2it))
            let cosines = -LN_2 * seen - 0.5 * (b.clausen() - a.clausen());
            received -= part * seen;
            logarithm -= part * (ln(q) * seen - cosines);
            if cosine.abs() > f64::EPSILON {
                let p = turn.dot(self.normal);
                if p.abs() > 0.0 {
                    let sinh = p.abs() / height;
                    let exp = sinh + (1.0 + sinh * sinh).sqrt();
                    let (ratio, complement) = (ln(exp), 2.0 * sinh / exp);
                    let [a, b] = ends.map(|s| Angle::new(s, p.abs()));
                    let primitive = |end: &Angle| {
                        ratio * end.angle
                            + 0.5 * (end.clausen() - imaginary_dilogarithm(complement, end.of))
                    };
                    spread += p.signum() * (primitive(&b) - primitive(&a));
                }
            }
        }
        (0.5 * received + logarithm + cosine * spread) / TAU
    }
}

/// The angle under which a length is seen from beside its start, and its cosine and sine.
struct Angle {
    angle: f64,
    of: [f64; 2],
}

impl Angle {
    fn new(length: f64, beside: f64) -> Self {
        let hypotenuse = (length * length + beside * beside).sqrt();
        Self {
            angle: angle(length, beside),
            of: [beside / hypotenuse, length / hypotenuse],
        }
    }

    fn clausen(&self) -> f64 {
        imaginary_dilogarithm(0.0, self.of)
    }
}

/// `∫∫ Li₂(1 − h²/r²)` along two edges; h starts at `start` and grows by `slope` along the outer one.
///
/// The outer integrand is singular at the ends of the inner edge, where h = 0, and where the lines are nearest, as far off the
/// real line as their distance over the sine of their angle.
fn edge_pair(outer: &Edge, inner: &Edge, [start, slope]: [f64; 2], gauss: &GaussLegendre) -> f64 {
    let between = inner.start - outer.start;
    let turn = outer.along.cross(inner.along);
    let sine = turn.length();
    let crossing = if sine > tolerance::ALIGNMENT {
        let at = between.cross(inner.along).dot(turn) / (sine * sine);
        Some([at, between.dot(turn) / (sine * sine)])
    } else {
        None
    };
    let ends = [inner.start, inner.at(inner.length)];
    let gap = |s: f64| {
        let point = outer.at(s);
        let mut gap = ends[0].distance(point).min(ends[1].distance(point));
        if let Some([at, aside]) = crossing {
            gap = gap.min((s - at).hypot(aside));
        }
        let height = start + slope * s;
        if slope.abs() > f64::EPSILON {
            gap = gap.min((height / slope).abs());
        }
        gap
    };
    let along = |s: f64| {
        let point = outer.at(s);
        let height = start + slope * s;
        let square = height * height;
        let from = point - inner.start;
        let foot = from.dot(inner.along);
        let beside = from.cross(inner.along).length();
        let gap = |t: f64| (t - foot).hypot(beside);
        let kernel = |t: f64| {
            let r = (t - foot) * (t - foot) + beside * beside;
            dilogarithm_of_complement(if r > 0.0 { square / r } else { 1.0 })
        };
        over_panels(inner.length, SHORTEST[1], gap, kernel, gauss)
    };
    over_panels(outer.length, SHORTEST[1], gap, along, gauss)
}

/// The integral from 0 to `length`, on panels at most [`REACH`] of the distance to the nearest singularity each way.
fn over_panels(
    length: f64,
    shortest: f64,
    gap: impl Fn(f64) -> f64,
    integrand: impl Fn(f64) -> f64,
    gauss: &GaussLegendre,
) -> f64 {
    let mut sum = CompensatedSum::default();
    let mut open = vec![[0.0, length]];
    while let Some([start, end]) = open.pop() {
        let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
        if half > REACH * gap(middle) && half > shortest * length {
            open.push([middle, end]);
            open.push([start, middle]);
            continue;
        }
        let rule = gauss.nodes.iter().zip(&gauss.weights);
        let values = rule.map(|(node, weight)| weight * integrand(middle + half * node));
        sum.add(half * values.sum::<f64>());
    }
    sum.total()
}
