//! Exact sums and products of doubles.
//!
//! An expansion is an unevaluated sum of doubles whose significands do not overlap. Sums and
//! products of expansions are exact as long as nothing over- or underflows, so that a difference
//! like `J_k w − J w_k` keeps every digit however much of it cancels.
//!
//! **Not covered**: quotients; products below about 1e-290, whose last bits leave `f64`'s range.
//!
//! Reference: Shewchuk, "Adaptive precision floating-point arithmetic", *Discrete & Computational
//! Geometry* 18 (1997), 305–363.

use std::ops::{Add, Mul, Neg, Sub};

/// An exact real number, as a sum of doubles that do not overlap, smallest first.
#[derive(Debug, Clone, PartialEq)]
pub struct Expansion {
    components: Vec<f64>,
}

impl Expansion {
    /// The sum of `terms`, exactly.
    #[must_use]
    pub fn sum(terms: impl IntoIterator<Item = f64>) -> Self {
        let mut sum = Self {
            components: Vec::new(),
        };
        for term in terms {
            sum.grow(term);
        }
        sum
    }

    /// The nearest double, to within one unit in the last place.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        self.components.iter().sum()
    }

    /// Times a power of two, exactly unless a component leaves `f64`'s normal range.
    #[must_use]
    pub fn times_power(mut self, power: i32) -> Self {
        // in two steps, so that no factor leaves the range before the product does
        let power = power.clamp(-2200, 2200);
        let factors = [power / 2, power - power / 2].map(|power| 2f64.powi(power));
        for component in &mut self.components {
            *component = *component * factors[0] * factors[1];
        }
        self
    }

    fn grow(&mut self, term: f64) {
        let mut carry = term;
        self.components.retain_mut(|component| {
            let (sum, lost) = two_sum(carry, *component);
            carry = sum;
            *component = lost;
            lost.abs() > 0.0
        });
        if carry.abs() > 0.0 {
            self.components.push(carry);
        }
    }
}

impl From<f64> for Expansion {
    fn from(value: f64) -> Self {
        Self::sum([value])
    }
}

impl Neg for Expansion {
    type Output = Self;
    fn neg(mut self) -> Self {
        self.components
            .iter_mut()
            .for_each(|component| *component = -*component);
        self
    }
}

impl Add<&Expansion> for Expansion {
    type Output = Self;
    fn add(mut self, other: &Self) -> Self {
        other
            .components
            .iter()
            .for_each(|component| self.grow(*component));
        self
    }
}

impl Sub<&Expansion> for Expansion {
    type Output = Self;
    fn sub(mut self, other: &Self) -> Self {
        other
            .components
            .iter()
            .for_each(|component| self.grow(-component));
        self
    }
}

impl Mul for &Expansion {
    type Output = Expansion;
    fn mul(self, other: Self) -> Expansion {
        let pairs = self
            .components
            .iter()
            .flat_map(|a| other.components.iter().map(move |b| two_product(*a, *b)));
        Expansion::sum(pairs.flat_map(|(product, lost)| [lost, product]))
    }
}

/// The rounded sum `a + b`, and the rounding error, exactly (Knuth).
#[inline(always)]
pub(crate) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let from_b = sum - a;
    (sum, (a - (sum - from_b)) + (b - from_b))
}

/// `a · b` rounded, and what the rounding lost, exactly unless it underflows.
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    (product, a.mul_add(b, -product))
}
