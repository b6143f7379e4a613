//! Exchange areas of axis-parallel rectangles by one-dimensional quadrature.
//!
//! In the contour integral (see [`crate::contour`]) two parallel edges at distance d
//! leave the single variable u, the offset along them. With
//!
//! ```text
//! G(h, d²) = ∫₀ʰ (h − u) ½ ln(u² + d²) du,
//! ```
//!
//! the function with ∂²G/∂h² = ½ ln(h² + d²) that is even in h, the integral of ln r
//! over the edges `[a, b]` and `[a', b']` is
//!
//! ```text
//! G(b − a') + G(a − b') − G(b − b') − G(a − a').
//! ```
//!
//! G is integrated numerically: as h M₀ − M₁ with the moments of ½ ln(u² + d²), for
//! all h in one pass.

use crate::precision::Real;
use crate::quadrature::{Level, Singularity};

/// G(h, d²) for every `h` of an increasing list that starts with 0.
pub fn kernel(offsets: &[Real], distance_squared: &Real, level: &Level) -> Vec<Real> {
    let near = [Singularity {
        at: Real::int(0),
        height: distance_squared.sqrt(),
    }];
    let (mut zeroth, mut first) = (Real::int(0), Real::int(0));
    let mut values = vec![Real::int(0)];
    for pair in offsets.windows(2) {
        level.visit(&pair[0], &pair[1], &near, |u, weight| {
            let term = weight * (u.squared() + distance_squared).ln().half();
            first += u * &term;
            zeroth += term;
        });
        values.push(&pair[1] * &zeroth - &first);
    }
    values
}

/// A set of numbers in which those within rounding of each other count as one.
pub struct Distinct(Vec<Real>);

impl Distinct {
    /// The numbers in increasing order.
    pub fn new(mut numbers: Vec<Real>) -> Self {
        numbers.sort_by(|a, b| a.partial_cmp(b).unwrap());
        numbers.dedup_by(|b, a| same(a, b));
        Self(numbers)
    }

    /// The differences of any two coordinates, 0 included.
    pub fn differences(coordinates: &[Real]) -> Self {
        let pairs = coordinates
            .iter()
            .flat_map(|a| coordinates.iter().map(move |b| (a, b)));
        Self::new(pairs.map(|(a, b)| (a - b).abs()).collect())
    }

    /// The numbers.
    pub fn numbers(&self) -> &[Real] {
        &self.0
    }

    /// The place of a number.
    pub fn place(&self, number: &Real) -> usize {
        self.0.iter().position(|known| same(known, number)).unwrap()
    }
}

fn same(a: &Real, b: &Real) -> bool {
    (a - b).abs() < Real::decimal("1e-70")
}

/// An interval.
pub type Interval = [Real; 2];

/// The exchange area of two rectangles at right angles: x × y in the plane z = 0 and
/// z × v in the plane x = 0, y and v being intervals of the common line.
///
/// Only the edges along y are parallel; those at x and z lie √(x² + z²) apart.
pub fn perpendicular(
    x: &Interval,
    y: &Interval,
    z: &Interval,
    v: &Interval,
    level: &Level,
) -> Real {
    let offsets = Distinct::differences(&[&y[..], &v[..]].concat());
    let mut sum = Real::int(0);
    for (i, x) in x.iter().enumerate() {
        for (j, z) in z.iter().enumerate() {
            let values = kernel(offsets.numbers(), &(x.squared() + z.squared()), level);
            let pair = edge_pair(y, v, |h| values[offsets.place(&h)].clone());
            sum += if i == j { -pair } else { pair };
        }
    }
    sum / (Real::int(2) * Real::pi())
}

/// The double integral of ln r over two parallel edges, from G as a function of |h|.
pub fn edge_pair(y: &Interval, v: &Interval, g: impl Fn(Real) -> Real) -> Real {
    let g = |a: &Real, b: &Real| g((a - b).abs());
    g(&y[1], &v[0]) + g(&y[0], &v[1]) - g(&y[1], &v[1]) - g(&y[0], &v[0])
}

/// G(1, 1) = ∫₀¹ (1 − u) ½ ln(1 + u²) du = π/4 − 3/4 from the moments
/// ∫ ½ ln(1 + u²) = ½ ln 2 − 1 + π/4 and ∫ u ½ ln(1 + u²) = ½ ln 2 − ¼; and
/// G(1, 0) = ∫₀¹ (1 − u) ln u du = −3/4.
#[test]
fn the_kernel_has_known_values() {
    let offsets = [Real::int(0), Real::ratio(1, 3), Real::int(1)];
    let level = &crate::quadrature::FINE;
    let tolerance = Real::decimal("1e-48");
    let quarter = Real::ratio(3, 4);
    let at_one = kernel(&offsets, &Real::int(1), level).remove(2);
    assert!((at_one - Real::pi() / Real::int(4) + &quarter).abs() < tolerance);
    let at_zero = kernel(&offsets, &Real::int(0), level).remove(2);
    assert!((at_zero + quarter).abs() < tolerance);
}
