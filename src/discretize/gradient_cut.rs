//! The cut of a patch whose radiosity grows as a power, by mutual information and by mean square (§4.2).
//!
//! Radiosity `B ∝ lⁿ` and irradiance `∝ lᵐ` on a unit patch, 0 ≤ l ≤ 1. With p = n + 1 the flux up to l is
//! `G = lᵖ`, the weight `W = l^(p+m)`, and the gain per flux, in nats,
//!
//! ```text
//!   J(l) = G ln(G/W) + (1−G) ln((1−G)/(1−W))
//! ```
//!
//! m = 1 is what the paper prints; m = n follows from its own hypotheses (constant reflectance, no
//! emission). With a = G/W, b = (1−G)/(1−W) and y = b/a the stationarity condition
//! `G′ ln(a/b) = W′ (a − b)` reads `p/(p+m)·ln(1/y) = 1 − y`, which no longer contains l. With λ = −ln y
//! it becomes two monotone equations in turn, both well conditioned for every p and m:
//!
//! ```text
//!   λ/(1−e^−λ) − 1 = m/p                 left side from 0 to ∞, between λ/2 and λ: one root
//!   m τ − ln1p(−e^−pτ (1−e^−mτ)/(1−e^−(p+m)τ)) = λ,   l = e^−τ
//! ```
//!
//! So the maximum is unique for every p, m > 0. The mean-square error of two constants is stationary where
//! `B(l)` is the arithmetic mean of the two: `2n lⁿ (1 − l) = 1 − lⁿ`, l ≠ 1; for whole n that is the paper's
//! polynomial times (1 − l).
//!
//! **Not covered**: other profiles than powers.

use super::DiscretizeError;
use crate::numeric::{NumericError, divergence_kernel, root};
use std::f64::consts::LN_2;

/// A patch with `B ∝ lⁿ` and irradiance `∝ lᵐ`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GradientCut {
    exponent: f64,
    irradiance_exponent: f64,
}

/// Where a patch is cut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cut {
    /// Position l in (0, 1), 0 where the radiosity vanishes.
    pub position: f64,
    /// `1 − l`, to full relative precision.
    pub complement: f64,
    /// The value that is optimal there: the gain per flux in bits (mutual information), or the mean
    /// square error for `B = lⁿ` (mean square).
    pub value: f64,
    /// What is left of the stationarity condition, relative to its terms.
    pub residual: f64,
}

/// The exponents that are accepted; the accuracy is measured at both ends.
const EXPONENTS: std::ops::RangeInclusive<f64> = 1e-6..=1e12;

impl GradientCut {
    /// The patch with these exponents.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] unless both lie in `[1e-6, 1e12]`.
    pub fn try_new(exponent: f64, irradiance_exponent: f64) -> Result<Self, DiscretizeError> {
        let both = [
            ("the exponent", exponent),
            ("the irradiance exponent", irradiance_exponent),
        ];
        for (parameter, value) in both {
            if !EXPONENTS.contains(&value) {
                let condition = "> 0, from 1e-6 to 1e12";
                return Err(DiscretizeError::OutOfRange {
                    parameter,
                    value,
                    condition,
                });
            }
        }
        Ok(Self {
            exponent,
            irradiance_exponent,
        })
    }

    /// The gain of a cut at `e^−τ`, in bits per unit of flux: the expression that §4.2 maximises.
    ///
    /// **Arguments** `tau` > 0.
    /// **Accuracy** a few ε relative, also where the gain is of order `1/n²`.
    #[must_use]
    pub fn gain_at(&self, tau: f64) -> f64 {
        let (p, m) = (self.exponent + 1.0, self.irradiance_exponent);
        let shrink = -(-p * tau).exp() * self.narrowing(tau); // b − 1
        let nats = if m * tau < 1.0 {
            let weight = (-(p + m) * tau).exp();
            let rest = -(-(p + m) * tau).exp_m1();
            weight * divergence_kernel((m * tau).exp_m1()) + rest * divergence_kernel(shrink)
        } else {
            (-p * tau).exp() * m * tau - (-p * tau).exp_m1() * shrink.ln_1p()
        };
        nats / LN_2
    }

    /// The cut that maximises mutual information.
    ///
    /// **Accuracy** position to 1e-14 absolute, complement to 1e-12 relative, gain to 1e-13 relative,
    /// measured by `cuts_agree_with_their_references`.
    ///
    /// # Errors
    /// [`DiscretizeError::Numeric`] if a root is not found, which the brackets exclude.
    pub fn mutual_information_cut(&self) -> Result<Cut, DiscretizeError> {
        let (p, m) = (self.exponent + 1.0, self.irradiance_exponent);
        let ratio = m / p;
        // λ/(1−e^−λ) − 1 = φ(e^λ − 1)/(e^λ − 1) lies between λ/2 and λ
        let excess = |lambda: f64| {
            if lambda < 1.0 {
                let growth = lambda.exp_m1();
                divergence_kernel(growth) / growth
            } else {
                lambda / -(-lambda).exp_m1() - 1.0
            }
        };
        let lambda = bracketed_root(|lambda| excess(lambda) / ratio - 1.0, ratio, 2.0 * ratio)?;
        let condition = |tau: f64| {
            let shrink = -(-p * tau).exp() * self.narrowing(tau);
            (m * tau - shrink.ln_1p()) / lambda - 1.0
        };
        let largest = lambda / m;
        let tau = bracketed_root(condition, largest * 1e-9, largest)?;
        Ok(Cut {
            position: (-tau).exp(),
            complement: -(-tau).exp_m1(),
            value: self.gain_at(tau),
            residual: condition(tau),
        })
    }

    /// The cut that minimises the mean square error of two constants.
    ///
    /// **Accuracy** as [`mutual_information_cut`](Self::mutual_information_cut), measured by
    /// `mean_square_cuts_agree_with_256_bits`.
    ///
    /// # Errors
    /// [`DiscretizeError::Numeric`] if a root is not found, which the bracket excludes.
    pub fn mean_square_cut(&self) -> Result<Cut, DiscretizeError> {
        let n = self.exponent;
        // 2n lⁿ (1−l)/(1−lⁿ) falls from 2 at l = 1
        let condition =
            |tau: f64| 2.0 * n * (-n * tau).exp() * (-tau).exp_m1() / (-n * tau).exp_m1() - 1.0;
        // at l = (2n+1)^(−1/n) it is 1 − l < 1
        let largest = (2.0 * n).ln_1p() / n;
        let tau = bracketed_root(condition, largest * 1e-3, largest)?;
        let (l, complement) = ((-tau).exp(), -(-tau).exp_m1());
        // variance less what the two means explain: [ n²/(2n+1) − l (1−lⁿ)²/(1−l) ] / (n+1)², over n²
        let drop = -(-n * tau).exp_m1() / n;
        let share = 1.0 / (2.0 * n + 1.0) - l * drop * drop / complement;
        let value = share * (n / (n + 1.0)).powi(2);
        Ok(Cut {
            position: l,
            complement,
            value,
            residual: condition(tau),
        })
    }

    /// `(1−e^−mτ)/(1−e^−(p+m)τ)`, from m/(p+m) at τ = 0 to 1.
    fn narrowing(&self, tau: f64) -> f64 {
        let (p, m) = (self.exponent + 1.0, self.irradiance_exponent);
        (-m * tau).exp_m1() / (-(p + m) * tau).exp_m1()
    }
}

/// A root whose bracket is known up to rounding: an end that already is the root is accepted.
fn bracketed_root(
    function: impl Fn(f64) -> f64,
    lower: f64,
    upper: f64,
) -> Result<f64, NumericError> {
    Ok(root(function, lower * (1.0 - 1e-9), upper * (1.0 + 1e-9))?.position)
}
