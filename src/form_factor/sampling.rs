//! Form factors by lines at random: estimates with a standard error, of any two polygons.
//!
//! ```text
//!   local lines     from uniform points of the first polygon, directions by cosine:
//!                   F = P(the line hits the second's front)
//!   global lines    uniform among the lines that meet a sphere around both:
//!                   F = P(the line hits the second's front | it leaves the first's)
//!   quasi-random    local lines from a lattice-like sequence in four dimensions, shifted at random
//!                   16 times
//! ```
//!
//! Uniform lines meet a surface by cosine and in proportion to its area (Crofton's formula: a line
//! through a sphere of radius R meets a flat patch of area A with probability `A/(2πR²)`), so that
//! both kinds of lines know the same F. What a polygon has behind the other's plane is never hit,
//! and concave outlines are hit as they are.
//!
//! With h hits among n lines the standard error is that of the posterior of a uniform prior,
//! `√((h+1)(n−h+1)/((n+2)²(n+3)))`: next to `√(F(1−F)/n)` where there are hits, and not 0 where
//! there are none. All this is evidence by *sample*.
//!
//! Local lines are told, too, what stands in the way ([`local_lines_past`],
//! [`quasi_random_lines_past`]): a line that meets it before the second polygon does not hit.
//!
//! **Not covered**: global lines past others.
//!
//! References: Sbert, *An Integral Geometry Based Method for Fast Form-Factor Computation*,
//! Eurographics 1993; Santaló, *Integral Geometry and Geometric Probability*, 1976, ch. 12; Cranley
//! and Patterson, SIAM J. Numer. Anal. 13, 1976 (random shifts).

use crate::geometry::{Facet, LocalLine, Patch, bounds, line_through_sphere};
use glam::DVec3;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::TAU;

/// An estimate of a form factor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// The form factor from the first polygon to the second, estimated; dimensionless.
    pub value: f64,
    /// Standard error of the value.
    pub standard_error: f64,
    /// Lines that left the first polygon.
    pub lines: u32,
}

impl Sample {
    fn of(hits: u32, lines: u32) -> Option<Self> {
        if lines == 0 {
            return None;
        }
        let (h, n) = (f64::from(hits), f64::from(lines));
        let variance = (h + 1.0) * (n - h + 1.0) / ((n + 2.0) * (n + 2.0) * (n + 3.0));
        Some(Self {
            value: h / n,
            standard_error: variance.sqrt(),
            lines,
        })
    }
}

/// The form factor from the first polygon to the second by local lines; `None` for no lines.
///
/// **Arguments** `lines`: how many; `seed`: the same one gives the same estimate.
///
/// # Examples
/// ```
/// use glam::DVec3;
/// use infoscene::form_factor::sampling::local_lines;
/// use infoscene::geometry::Patch;
/// // the corner of a cube cut off: from one leg to another, (1 − 1/√3)/2
/// let (o, x, y, z) = (DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z);
/// let (floor, wall) = (Patch::try_new(vec![o, x, y])?, Patch::try_new(vec![o, y, z])?);
/// let sample = local_lines(&floor, &wall, 10_000, 1).expect("there are lines");
/// let exact = (1.0 - 1.0 / 3f64.sqrt()) / 2.0;
/// assert!((sample.value - exact).abs() < 5.0 * sample.standard_error);
/// # Ok::<(), infoscene::geometry::GeometryError>(())
/// ```
#[must_use]
pub fn local_lines(first: &Patch, second: &Patch, lines: u32, seed: u64) -> Option<Sample> {
    local_lines_past([first, second], &[], lines, seed)
}

/// The form factor from the first polygon to the second past others, which block from both sides,
/// by local lines; `None` for no lines.
///
/// **Arguments** as of [`local_lines`].
#[must_use]
pub fn local_lines_past(
    pair: [&Patch; 2],
    blockers: &[Patch],
    lines: u32,
    seed: u64,
) -> Option<Sample> {
    let targets = Targets::new(pair, blockers);
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let hits = (0..lines).map(|_| u32::from(targets.is_hit(random.random())));
    Sample::of(hits.sum(), lines)
}

/// Independent shifts of the sequence.
const SHIFTS: u32 = 16;

/// The form factor from the first polygon to the second by quasi-random lines; `None` for no lines.
///
/// The sequence is `i·(1/φ, 1/φ², 1/φ³, 1/φ⁴) mod 1` with `φ⁵ = φ + 1`, a badly approximable
/// direction. The standard error is that of the mean of 16 independent shifts, and at least one
/// line in all.
///
/// **Arguments** `lines`: how many, rounded up to a multiple of 16; `seed`: the same one gives the
/// same estimate.
#[must_use]
pub fn quasi_random_lines(first: &Patch, second: &Patch, lines: u32, seed: u64) -> Option<Sample> {
    quasi_random_lines_past([first, second], &[], lines, seed)
}

/// The form factor from the first polygon to the second past others, which block from both sides,
/// by quasi-random lines; `None` for no lines.
///
/// **Arguments** as of [`quasi_random_lines`].
#[must_use]
pub fn quasi_random_lines_past(
    pair: [&Patch; 2],
    blockers: &[Patch],
    lines: u32,
    seed: u64,
) -> Option<Sample> {
    let each = lines.div_ceil(SHIFTS);
    let lines = each.checked_mul(SHIFTS).filter(|lines| *lines > 0)?;
    let targets = Targets::new(pair, blockers);
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let phi = 1.167_303_978_261_418_7_f64;
    let steps: [f64; 4] = std::array::from_fn(|k| [1.0, phi, phi * phi, phi * phi * phi][k])
        .map(|power: f64| (power * phi).recip());
    let means: Vec<f64> = (0..SHIFTS)
        .map(|_| {
            let shift: [f64; 4] = random.random();
            let hits = (0..each).map(|i| {
                let point = std::array::from_fn(|k| (shift[k] + f64::from(i) * steps[k]).fract());
                u32::from(targets.is_hit(point))
            });
            f64::from(hits.sum::<u32>()) / f64::from(each)
        })
        .collect();
    let shifts = f64::from(SHIFTS);
    let value = means.iter().sum::<f64>() / shifts;
    let squares: f64 = means.iter().map(|mean| (mean - value).powi(2)).sum();
    let spread = (squares / (shifts * (shifts - 1.0))).sqrt();
    Some(Sample {
        value,
        standard_error: spread.max(f64::from(lines).recip()),
        lines,
    })
}

/// The counts of lines through a sphere around two polygons.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GlobalLines {
    /// Lines through the sphere.
    pub lines: u32,
    /// Numbers of the lines that met the first polygon, and of those that met the second.
    pub met: [u32; 2],
    /// Number of the lines that left the front of the first and arrived at the front of the second.
    pub joined: u32,
    /// Area of the sphere, in squared units of length.
    pub sphere_area: f64,
}

impl GlobalLines {
    /// The form factor from the first polygon to the second; `None` if no line met the first.
    #[must_use]
    pub fn form_factor(&self) -> Option<Sample> {
        Sample::of(self.joined, self.met[0])
    }

    /// The area of the first or second polygon, with its standard error: half the sphere's times
    /// the part of the lines that met it; `None` without lines.
    #[must_use]
    pub fn area(&self, which: usize) -> Option<[f64; 2]> {
        let part = Sample::of(*self.met.get(which)?, self.lines)?;
        Some([part.value, part.standard_error].map(|number| 0.5 * self.sphere_area * number))
    }
}

/// Counts what uniform lines through a sphere around both polygons meet.
///
/// **Arguments** `lines`: how many; `seed`: the same one gives the same counts.
#[must_use]
pub fn global_lines(first: &Patch, second: &Patch, lines: u32, seed: u64) -> GlobalLines {
    let targets = Targets::new([first, second], &[]);
    let [leaving, arriving] = &targets.polygons;
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let (mut met, mut joined) = ([0; 2], 0);
    for _ in 0..lines {
        let [start, direction] = line_through_sphere(targets.radius, random.random());
        let crossings = [leaving, arriving].map(|polygon| polygon.facet.crossing(start, direction));
        for (count, crossing) in met.iter_mut().zip(crossings) {
            *count += u32::from(crossing.is_some());
        }
        if let [Some(from), Some(to)] = crossings {
            // the line has no direction of its own: along it as it leaves the first one's front
            let out = direction.dot(leaving.facet.normal()).signum();
            let arrives =
                out * direction.dot(arriving.facet.normal()) < 0.0 && out * (to - from) > 0.0;
            joined += u32::from(arrives);
        }
    }
    let radius = targets.radius * targets.unit;
    GlobalLines {
        lines,
        met,
        joined,
        sphere_area: 2.0 * TAU * radius * radius,
    }
}

/// The two polygons and what is in the way, from the middle between the two and in units of their
/// size.
struct Targets {
    polygons: [Target; 2],
    blockers: Vec<Facet>,
    radius: f64,
    unit: f64,
}

impl Targets {
    fn new([first, second]: [&Patch; 2], blockers: &[Patch]) -> Self {
        let corners = first.corners().iter().chain(second.corners());
        let [lowest, highest] = bounds(corners.copied());
        let unit = (0.5 * highest - 0.5 * lowest).max_element();
        let middle = 0.5 * lowest + 0.5 * highest;
        let polygons = [first, second].map(|patch| Target::new(patch, middle, unit));
        let radius = polygons
            .iter()
            .flat_map(|polygon| polygon.facet.corners())
            .map(|corner| corner.length())
            .fold(0.0, f64::max);
        let place = |corner: DVec3| (corner - middle) / unit;
        let blockers = blockers.iter();
        let blockers = blockers.map(|patch| Facet::new(patch.corners(), patch.normal(), place));
        Self {
            polygons,
            blockers: blockers.collect(),
            radius,
            unit,
        }
    }

    /// Tells whether a line from the first polygon hits the front of the second.
    ///
    /// **Arguments** two numbers for the point, two for the direction.
    fn is_hit(&self, numbers: [f64; 4]) -> bool {
        let [leaving, arriving] = &self.polygons;
        let LocalLine {
            origin, direction, ..
        } = leaving.line(numbers);
        let faces = direction.dot(arriving.facet.normal()) < 0.0;
        let distance = arriving.facet.crossing(origin, direction);
        let Some(distance) = distance.filter(|distance| faces && *distance > 0.0) else {
            return false;
        };
        let is_between = |facet: &Facet| {
            let met = facet.crossing(origin, direction);
            met.is_some_and(|met| 0.0 < met && met < distance)
        };
        !self.blockers.iter().any(is_between)
    }
}

/// A polygon to leave from and to hit.
struct Target {
    facet: Facet,
    /// The part of the area in each triangle and those before it.
    parts: Vec<f64>,
}

impl Target {
    fn new(patch: &Patch, middle: DVec3, unit: f64) -> Self {
        let place = |corner: DVec3| (corner - middle) / unit;
        let corners: Vec<DVec3> = patch.corners().iter().map(|c| place(*c)).collect();
        let facet = Facet::new(&corners, patch.normal(), |corner| corner);
        // in units of its own size, so that squares stay in range
        let own = corners.iter().map(|c| c.distance(corners[0]));
        let own = own.fold(0.0, f64::max);
        let mut sum = 0.0;
        let mut parts: Vec<f64> = facet
            .triangles()
            .iter()
            .map(|[a, b, c]| {
                sum += ((*b - *a) / own).cross((*c - *a) / own).length();
                sum
            })
            .collect();
        parts.iter_mut().for_each(|part| *part /= sum);
        Self { facet, parts }
    }

    /// A line that leaves the front: uniform points, directions by cosine for uniform numbers.
    fn line(&self, [along, aside, square, around]: [f64; 4]) -> LocalLine {
        let triangles = self.facet.triangles();
        let last = triangles.len() - 1;
        let k = self.parts.partition_point(|part| *part <= along).min(last);
        let before = if k > 0 { self.parts[k - 1] } else { 0.0 };
        // the number that has chosen the triangle is uniform within its part, and serves again
        let within = ((along - before) / (self.parts[k] - before)).clamp(0.0, 1.0);
        let numbers = [within, aside, square, around];
        LocalLine::leaving(triangles[k], self.facet.normal(), numbers)
    }
}
