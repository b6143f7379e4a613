//! Gauss–Legendre rules to 106 bits, and their nodes in other number types.
//!
//! ```text
//!   ∫_{−1}^{1} f ≈ Σ w_i f(x_i),   P_n(x_i) = 0,   w_i = 2 / ((1 − x_i²) P_n′(x_i)²)
//!   |error| ≤ (64/15) M ρ^(−2n) / (1 − ρ^(−2))      if |f| ≤ M inside the ellipse with foci ±1
//!                                                   and half-axes (ρ ± 1/ρ)/2
//! ```
//!
//! Reference: Trefethen, *Approximation Theory and Approximation Practice*, 2013, theorem 19.3.

use crate::numeric::{DoubleDouble, LANES, Lanes, Scalar, real};
use std::ops::{Div, Mul, Sub};
use std::sync::OnceLock;

/// The largest rule.
pub(crate) const MOST_POINTS: usize = 64;

/// Nodes and weights on `[−1, 1]`, as doubles and to 106 bits.
#[derive(Debug, Clone, PartialEq)]
pub struct GaussLegendre {
    /// The nodes, increasing.
    pub nodes: Vec<f64>,
    /// The weights; their sum is 2.
    pub weights: Vec<f64>,
    /// Nodes and weights side by side in vectors, of which the last is filled up with weights of 0
    /// at 0.
    pub lanes: Vec<[Lanes; 2]>,
    /// Nodes and weights to 106 bits.
    pub precise: Vec<[DoubleDouble; 2]>,
}

impl GaussLegendre {
    /// The rule with `points` nodes, computed once.
    ///
    /// **Arguments** `points` from 1 to 64; more are taken as 64, none as 1.
    #[must_use]
    pub fn with(points: usize) -> &'static Self {
        static RULES: [OnceLock<GaussLegendre>; MOST_POINTS + 1] =
            [const { OnceLock::new() }; MOST_POINTS + 1];
        let points = points.clamp(1, MOST_POINTS);
        RULES[points].get_or_init(|| Self::new(points))
    }

    fn new(points: usize) -> Self {
        let precise: Vec<[DoubleDouble; 2]> =
            (0..points).map(|i| legendre_node(points, i)).collect();
        let nodes: Vec<f64> = precise.iter().map(|[x, _]| x.to_f64()).collect();
        let weights: Vec<f64> = precise.iter().map(|[_, w]| w.to_f64()).collect();
        let filled = |numbers: &[f64]| {
            let mut lanes = [0.0; LANES];
            lanes[..numbers.len()].copy_from_slice(numbers);
            lanes
        };
        let blocks = nodes.chunks(LANES).zip(weights.chunks(LANES));
        let lanes = blocks.map(|(x, w)| [filled(x), filled(w)]).collect();
        Self {
            nodes,
            weights,
            lanes,
            precise,
        }
    }
}

/// The number types for which nodes can be computed.
pub(crate) trait NodeNumber:
    Copy + From<f64> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// Newton steps from two digits to all that the type holds; each doubles the digits.
    const STEPS: usize;
}

impl NodeNumber for DoubleDouble {
    // three would do
    const STEPS: usize = 6;
}

/// Computes node `i` of the rule with `n` points, in increasing order, and its weight, by Newton's
/// method from Tricomi's estimate.
#[must_use]
pub(crate) fn legendre_node<T: NodeNumber>(n: usize, i: usize) -> [T; 2] {
    debug_assert!(i < n, "node {i} of {n}");
    let one = T::from(1.0);
    let estimate = -(std::f64::consts::PI * (real(i) + 0.75) / (real(n) + 0.5)).cos();
    let mut x = T::from(estimate);
    let mut slope = one;
    for _ in 0..T::STEPS {
        let (value, derivative) = legendre(n, x);
        x = x - value / derivative;
        slope = derivative;
    }
    let weight = T::from(2.0) / ((one - x * x) * slope * slope);
    [x, weight]
}

/// `P_n(x)` and its derivative, by the three-term recurrence.
fn legendre<T: NodeNumber>(n: usize, x: T) -> (T, T) {
    let one = T::from(1.0);
    let (mut before, mut value) = (one, x);
    for k in 2..=n {
        let k = real(k);
        let next = (T::from(2.0 * k - 1.0) * x * value - T::from(k - 1.0) * before) / T::from(k);
        (before, value) = (value, next);
    }
    let slope = T::from(real(n)) * (x * value - before) / (x * x - one);
    (value, slope)
}
