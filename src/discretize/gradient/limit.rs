//! The limits of the cuts of §4.2 as the exponent grows: `n (1 − l)` tends to a number, and differs
//! from it by a multiple of 1/n.
//!
//! In x = pτ, p = n + 1, l = e^−τ, the condition on the cut of highest mutual information depends
//! on r = m/p alone,
//!
//! ```text
//!   λ/(1−e^−λ) = 1 + r,     e^λ = (e^((1+r)x) − 1)/(eˣ − 1)
//! ```
//!
//! so that `l = exp(−X(m/p)/p)` for every n and m with one falling function X. As n grows r tends
//! to 0 where m is fixed, and to 1 where m = n. The mean-square condition is `eʸ = 1 + 2 n (1 − l)`
//! with y = nτ. Hence the limits x and, by expanding once more, the rate `n (n (1 − l) − x)`:
//!
//! ```text
//!   m = 1         x = 2 (1 − e^−x)               X′(0) − x − x²/2,
//!                                     X′(0) = x (4/3 − x) / (2 (x − 1))
//!   m = n         (1 + eˣ) ln(1 + eˣ) = 2 eˣ    −X′(1) − x − x²/2,    λ = ln(1 + eˣ),
//!                                     X′(1) = (λ/(2 (λ − 1)) − x/(1 − e^−2x)) (1 + e^−x)
//!   mean square   eˣ = 1 + 2x                    eˣ x² / (2 (2 − eˣ))
//! ```
//!
//! The λ of the second row solves `λ = 2 (1 − e^−λ)`: it is the x of the first. That first
//! condition is also the one for two classes of least square error of a position distributed as
//! e^−x: where the irradiance hardly varies, mutual information groups *positions*, weighted by
//! flux, and the mean square groups *radiosities*.
//!
//! At the other end, n → 0, radiosity goes as 1 + n ln l: with m = n both cuts tend to e^−x, x the
//! first limit again.
//!
//! **Not covered**: higher terms.

use crate::discretize::error::DiscretizeError;
use crate::numeric::{Interval, IntervalFunction, NumericError, Scalar, certified_roots};

/// A cut of §4.2 in the limit of a large exponent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GradientLimit {
    /// The cut of highest mutual information, irradiance ∝ l, as printed; the limit is that of any
    /// fixed power.
    FixedIrradiance,
    /// The cut of highest mutual information, irradiance ∝ lⁿ as the radiosity.
    EqualExponents,
    /// The cut of least mean square error.
    MeanSquare,
}

/// A limit and the rate at which it is approached, enclosed.
#[derive(Debug, Clone, PartialEq)]
pub struct LimitingCut {
    /// The limit x of `n (1 − l)`.
    pub limit: Interval,
    /// The limit of `n (n (1 − l) − x)`.
    pub rate: Interval,
}

impl GradientLimit {
    /// All limits.
    pub const ALL: [Self; 3] = [
        Self::FixedIrradiance,
        Self::EqualExponents,
        Self::MeanSquare,
    ];

    /// The limit and the rate, enclosed to about `bits` bits.
    ///
    /// # Errors
    /// [`DiscretizeError::Numeric`] if the root cannot be isolated.
    ///
    /// # Examples
    /// ```
    /// use infoscene::discretize::GradientLimit;
    /// // 1.2564312086…, −1/2 less the other branch of Lambert's W at −e^(−1/2)/2
    /// let found = GradientLimit::MeanSquare.enclosed(128)?;
    /// let digits = found.limit.to_decimal(30).ok_or("bounded")?;
    /// assert!(digits.lower.starts_with("1.25643120862616967698273761660"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn enclosed(self, bits: u32) -> Result<LimitingCut, DiscretizeError> {
        let found = certified_roots(&self, ROOT_RANGE, bits);
        let [root] = found.roots.as_slice() else {
            return Err(not_isolated());
        };
        if !found.undecided.is_empty() {
            return Err(not_isolated());
        }
        let limit = root.enclosure.clone();
        let rate = self.rate(&limit);
        Ok(LimitingCut { limit, rate })
    }

    fn rate<S: Scalar>(self, x: &S) -> S {
        let number = |value: f64| x.constant(value);
        let one = number(1.0);
        // the term of 1/n in x (1 − 1/n)(1 − x/2n)
        let shrinking = x.clone() + &(x.square() * &number(0.5));
        match self {
            Self::FixedIrradiance => {
                let left = number(4.0) / &number(3.0) - x;
                let slope = left * x / &(number(2.0) * &(x.clone() - &one));
                slope - &shrinking
            }
            Self::EqualExponents => {
                let lambda = x.exp().ln_1p();
                let with_ratio = lambda.clone() / &(number(2.0) * &(lambda - &one));
                let doubled = -(x.clone() + x);
                let explicit = x.clone() / &-doubled.exp_m1();
                let slope = (with_ratio - &explicit) * &(one + &(-x.clone()).exp());
                -(slope + &shrinking)
            }
            Self::MeanSquare => {
                let power = x.exp();
                let fall = number(2.0) * &(number(2.0) - &power);
                power * &x.square() / &fall
            }
        }
    }
}

/// The range of the roots: (a) all three conditions are negative at 1 and positive at 2, and have
/// one root between.
const ROOT_RANGE: (f64, f64) = (1.0, 2.0);

fn not_isolated() -> DiscretizeError {
    let (lower, upper) = ROOT_RANGE;
    NumericError::NotIsolated { lower, upper }.into()
}

impl IntervalFunction for GradientLimit {
    fn value<S: Scalar>(&self, x: &S) -> Option<S> {
        let two = x.constant(2.0);
        Some(match self {
            Self::FixedIrradiance => two * &(-x.clone()).exp_m1() + x,
            Self::EqualExponents => {
                let power = x.exp();
                (power.clone() + &x.constant(1.0)) * &power.ln_1p() - &(two * &power)
            }
            Self::MeanSquare => x.exp_m1() - &(two * x),
        })
    }
}
