//! Profiles of radiosity along a patch, with closed forms of their flux and square flux over any
//! part.
//!
//! ```text
//!   power l^n          ∫ = (b^(n+1) − a^(n+1))/(n+1)                  the square: power 2n
//!   exponential e^kl   ∫ = e^ka (e^(k(b−a)) − 1)/k                    the square: rate 2k
//!   ramp o + l         ∫ = (b−a)(u+v)/2,                          u = o+a,  v = o+b
//!                      ∫ of the square = (b−a)(u² + uv + v²)/3
//!   step               ∫ = length before × one level + length after × the other
//!   bump e^(−x²/2), x = (l−c)/σ                                       the square: width σ/√2
//! ```
//!
//! All terms are ≥ 0 and nothing cancels, so that each part is known to its own relative precision.
//! The integral of the bump is not elementary: Gauss–Legendre, 16 points on each piece of at most 2
//! σ.
//!
//! **Not covered**: radiosity that varies along two axes.

use crate::discretize::error::DiscretizeError;
use crate::numeric::GaussLegendre;

/// Radiosity along a patch of length 1, in any unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Profile {
    /// `lⁿ`, n from 1e-3 to 60; beyond, see [`GradientCut`](crate::discretize::GradientCut).
    Power {
        /// The exponent n.
        exponent: f64,
    },
    /// `e^(kl)`, |k| from 0.01 to 100.
    Exponential {
        /// The rate k.
        rate: f64,
    },
    /// `offset + l`, offset from 0 to 100.
    Ramp {
        /// The radiosity at l = 0; it grows by 1.
        offset: f64,
    },
    /// One level, then another, each from 1e-3 to 1e3.
    Step {
        /// The place of the step, between 0 and 1.
        at: f64,
        /// The level before.
        before: f64,
        /// The level after.
        after: f64,
    },
    /// `e^(−(l−c)²/(2σ²))`, c from 0 to 1 and σ from 0.05 to 2.
    Bump {
        /// The centre c.
        centre: f64,
        /// The width σ.
        width: f64,
    },
}

impl Profile {
    /// Checks that the parameters lie in their ranges.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`].
    pub fn checked(self) -> Result<Self, DiscretizeError> {
        let mut checks = self.checks().into_iter();
        match checks.find(|(_, _, is_right, _)| !is_right) {
            Some((parameter, value, _, condition)) => Err(DiscretizeError::OutOfRange {
                parameter,
                value,
                condition,
            }),
            None => Ok(self),
        }
    }

    /// The checks of the parameters: name, value, whether it lies in its range, and the range.
    fn checks(self) -> Vec<(&'static str, f64, bool, &'static str)> {
        let levels = 1e-3..=1e3;
        match self {
            Self::Power { exponent } => {
                let is_right = (1e-3..=60.0).contains(&exponent);
                vec![("the exponent", exponent, is_right, "from 1e-3 to 60")]
            }
            Self::Exponential { rate } => {
                let is_right = (0.01..=100.0).contains(&rate.abs());
                vec![(
                    "the rate",
                    rate,
                    is_right,
                    "from 0.01 to 100 or the negative",
                )]
            }
            Self::Ramp { offset } => {
                let is_right = (0.0..=100.0).contains(&offset);
                vec![("the offset", offset, is_right, "from 0 to 100")]
            }
            Self::Step { at, before, after } => {
                let differs = (before - after).abs() > 0.0;
                vec![
                    ("the step", at, at > 0.0 && at < 1.0, "between 0 and 1"),
                    (
                        "the level before",
                        before,
                        levels.contains(&before),
                        "from 1e-3 to 1e3",
                    ),
                    (
                        "the level after",
                        after,
                        levels.contains(&after),
                        "from 1e-3 to 1e3",
                    ),
                    ("the level after", after, differs, "another than before"),
                ]
            }
            Self::Bump { centre, width } => vec![
                (
                    "the centre",
                    centre,
                    (0.0..=1.0).contains(&centre),
                    "from 0 to 1",
                ),
                (
                    "the width",
                    width,
                    (0.05..=2.0).contains(&width),
                    "from 0.05 to 2",
                ),
            ],
        }
    }

    /// The radiosity at l.
    #[must_use]
    pub fn radiosity(&self, l: f64) -> f64 {
        match *self {
            Self::Power { exponent } => l.powf(exponent),
            Self::Exponential { rate } => (rate * l).exp(),
            Self::Ramp { offset } => offset + l,
            Self::Step { at, before, after } => {
                if l < at {
                    before
                } else {
                    after
                }
            }
            Self::Bump { centre, width } => bell((l - centre) / width),
        }
    }

    /// The lowest radiosity between 0 and 1.
    #[must_use]
    pub fn lowest(&self) -> f64 {
        self.radiosity(0.0).min(self.radiosity(1.0))
    }

    /// The place where the radiosity jumps, if there is one.
    #[must_use]
    pub const fn jump(&self) -> Option<f64> {
        match self {
            Self::Step { at, .. } => Some(*at),
            _ => None,
        }
    }

    /// Whether the profile is its own mirror image.
    #[must_use]
    pub fn is_symmetric(&self) -> bool {
        matches!(self, Self::Bump { centre, .. } if (centre - 0.5).abs() <= 0.0)
    }

    /// The flux `∫ B` from `from` to `to`, `0 ≤ from ≤ to ≤ 1`.
    ///
    /// **Accuracy** a few ε relative to the integral; of the bump 1e-14, measured by
    /// `parts_of_profiles_agree_with_quadrature`.
    #[must_use]
    pub fn flux(&self, from: f64, to: f64) -> f64 {
        check_part(from, to);
        match *self {
            Self::Power { exponent } => power_integral(exponent, from, to),
            Self::Exponential { rate } => exponential_integral(rate, from, to),
            Self::Ramp { offset } => (to - from) * (offset + 0.5 * (from + to)),
            Self::Step { at, before, after } => step_integral(at, [before, after], from, to),
            Self::Bump { centre, width } => bump_integral(centre, width, from, to),
        }
    }

    /// The square flux `∫ B²` from `from` to `to`, with the arguments and accuracy of
    /// [`flux`](Self::flux).
    #[must_use]
    pub fn square_flux(&self, from: f64, to: f64) -> f64 {
        check_part(from, to);
        match *self {
            Self::Power { exponent } => power_integral(2.0 * exponent, from, to),
            Self::Exponential { rate } => exponential_integral(2.0 * rate, from, to),
            Self::Ramp { offset } => {
                let (u, v) = (offset + from, offset + to);
                (to - from) * (u * u + u * v + v * v) / 3.0
            }
            Self::Step { at, before, after } => {
                step_integral(at, [before * before, after * after], from, to)
            }
            Self::Bump { centre, width } => {
                bump_integral(centre, width / std::f64::consts::SQRT_2, from, to)
            }
        }
    }
}

/// Asserts the precondition of all integrals.
fn check_part(from: f64, to: f64) {
    debug_assert!(0.0 <= from && from <= to && to <= 1.0, "{from} to {to}");
}

/// The points of the Gauss rule on each piece of a bump: (b) measured by
/// `parts_of_profiles_agree_with_quadrature`.
const BUMP_POINTS: usize = 16;

/// The bell `e^(−x²/2)`.
fn bell(x: f64) -> f64 {
    (-0.5 * x * x).exp()
}

fn power_integral(exponent: f64, from: f64, to: f64) -> f64 {
    if to <= from {
        return 0.0;
    }
    let power = exponent + 1.0;
    // 1 − (a/b)^p
    let share = -(power * (-(to - from) / to).ln_1p()).exp_m1();
    to.powf(power) * share / power
}

fn exponential_integral(rate: f64, from: f64, to: f64) -> f64 {
    (rate * from).exp() * (rate * (to - from)).exp_m1() / rate
}

fn step_integral(at: f64, [before, after]: [f64; 2], from: f64, to: f64) -> f64 {
    let middle = at.clamp(from, to);
    before * (middle - from) + after * (to - middle)
}

fn bump_integral(centre: f64, width: f64, from: f64, to: f64) -> f64 {
    let rule = GaussLegendre::with(BUMP_POINTS);
    let length = (to - from) / width;
    let pieces = (0.5 * length).ceil().max(1.0);
    let half = 0.5 * (to - from) / pieces;
    let mut sum = 0.0;
    let mut piece = 0.5;
    while piece < pieces {
        let middle = from + 2.0 * half * piece;
        for (x, weight) in rule.nodes.iter().zip(&rule.weights) {
            sum += weight * bell((middle + half * x - centre) / width);
        }
        piece += 1.0;
    }
    sum * half
}
