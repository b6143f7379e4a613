//! The cut of a patch whose radiosity grows as a power, by mutual information and by mean square
//! (§4.2).
//!
//! Radiosity `B ∝ lⁿ` and irradiance `∝ lᵐ` on a unit patch, 0 ≤ l ≤ 1. With p = n + 1 the flux up
//! to l is `G = lᵖ`, the weight `W = l^(p+m)`, and the gain per flux, in nats,
//!
//! ```text
//!   J(l) = G ln(G/W) + (1−G) ln((1−G)/(1−W))
//! ```
//!
//! m = 1 is what the paper prints; m = n follows from its own hypotheses (constant reflectance, no
//! emission). With a = G/W, b = (1−G)/(1−W) and y = b/a the stationarity condition
//! `G′ ln(a/b) = W′ (a − b)` reads `p/(p+m)·ln(1/y) = 1 − y`. With λ = −ln y and l = e^−τ it is
//! well conditioned for every p and m:
//!
//! ```text
//!   λ/(1−e^−λ) − 1 = m/p                 left side from 0 to ∞, between λ/2 and λ: one root
//!   λ = m τ − ln1p(−e^−pτ (1−e^−mτ)/(1−e^−(p+m)τ)) ≥ m τ,   so that τ ≤ 2/p
//! ```
//!
//! So the maximum is unique for every p, m > 0, and pτ depends on m/p alone
//! ([`GradientLimit`](crate::discretize::GradientLimit)). The mean-square error of two constants is
//! stationary where `B(l)` is the arithmetic mean of the two: `2n lⁿ (1 − l) = 1 − lⁿ`, l ≠ 1; for
//! whole n that is the paper's polynomial times (1 − l). It has one root for every n > 0: with l =
//! e^−τ, `n (1 − e^−τ)/(e^nτ − 1)` falls from 1, as its logarithm's slope is `1/(e^τ − 1) − n/(1 −
//! e^−nτ) < 1/τ − 1/τ`.
//!
//! **Not covered**: other profiles than powers; they are in
//! [`ProfileCut`](crate::discretize::ProfileCut).

use crate::discretize::error::DiscretizeError;
use crate::numeric::{Interval, IntervalFunction, NumericError, Scalar, certified_roots, root};

/// A patch with `B ∝ lⁿ` and irradiance `∝ lᵐ`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GradientCut {
    exponent: f64,
    irradiance_exponent: f64,
}

/// A cut of a patch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cut {
    /// Position l in (0, 1), 0 where the radiosity vanishes.
    pub position: f64,
    /// `1 − l`, to full relative precision.
    pub complement: f64,
    /// The value that is optimal there: the gain per flux in bits (mutual information), or the mean
    /// square error for `B = lⁿ` (mean square).
    pub value: f64,
    /// The residual of the stationarity condition, relative to its terms.
    pub residual: f64,
}

impl Cut {
    /// `τ = −ln l`, to full relative precision.
    #[must_use]
    pub fn tau(&self) -> f64 {
        if self.complement < 0.5 {
            -(-self.complement).ln_1p()
        } else {
            -self.position.ln()
        }
    }
}

/// An enclosed cut of a patch, the only one of its kind inside `(0, 1)`.
#[derive(Debug, Clone, PartialEq)]
pub struct CertifiedCut {
    /// Position l.
    pub position: Interval,
    /// `1 − l`.
    pub complement: Interval,
    /// The gain per flux in bits, or the mean square error for `B = lⁿ`.
    pub value: Interval,
    /// The number of evaluations of the stationarity condition on an interval.
    pub evaluations: u64,
}

/// The exponents that are accepted: (b) `cuts_agree_with_their_references` and
/// `mean_square_cuts_agree_with_256_bits` measure the accuracy at both ends.
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

    /// The exponent n of the radiosity.
    #[must_use]
    pub const fn exponent(&self) -> f64 {
        self.exponent
    }

    /// The exponent m of the irradiance.
    #[must_use]
    pub const fn irradiance_exponent(&self) -> f64 {
        self.irradiance_exponent
    }

    /// The gain of a cut at `e^−τ`, in bits per unit of flux: the expression that §4.2 maximises.
    ///
    /// **Arguments** `tau` > 0.
    /// **Accuracy** `f64`: a few ε relative, also where the gain is of order `1/n²`. `Interval`:
    /// encloses it.
    #[must_use]
    pub fn gain_at<S: Scalar>(&self, tau: &S) -> S {
        debug_assert!(*tau > tau.zero(), "τ must be positive");
        let Powers { p, m, .. } = self.powers(tau);
        let one = tau.constant(1.0);
        let (flux, rest) = (survival(&p, tau), loss(&p, tau));
        let shrink = self.shrink(tau);
        let growth = m.clone() * tau;
        let nats = if growth < one {
            let weight = survival(&(p.clone() + &m), tau);
            weight * &growth.exp_m1().divergence_kernel()
                + &(loss(&(p + &m), tau) * &shrink.divergence_kernel())
        } else {
            flux * &growth + &(rest * &shrink.ln_1p())
        };
        nats / &tau.constant(2.0).ln()
    }

    /// The cut that maximises mutual information.
    ///
    /// **Accuracy** position to 1e-14 absolute, complement to 1e-12 relative, gain to 1e-13
    /// relative, measured by `cuts_agree_with_their_references`.
    ///
    /// # Errors
    /// [`DiscretizeError::Numeric`] if a root is not found, which the bracket excludes.
    pub fn mutual_information_cut(&self) -> Result<Cut, DiscretizeError> {
        let (tau, residual) = StationaryCut::Information(*self).solved()?;
        Ok(Cut {
            position: survival(&1.0, &tau),
            complement: loss(&1.0, &tau),
            value: self.gain_at(&tau),
            residual,
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
        let (tau, residual) = StationaryCut::MeanSquare(*self).solved()?;
        Ok(Cut {
            position: survival(&1.0, &tau),
            complement: loss(&1.0, &tau),
            value: self.mean_square_error_at(&tau),
            residual,
        })
    }

    /// The cut that maximises mutual information, enclosed to about `bits` bits.
    ///
    /// # Errors
    /// [`DiscretizeError::Numeric`] if its root cannot be isolated.
    pub fn certified_mutual_information_cut(
        &self,
        bits: u32,
    ) -> Result<CertifiedCut, DiscretizeError> {
        StationaryCut::Information(*self).certified(bits, |tau| self.gain_at(tau))
    }

    /// The cut that minimises the mean square error, enclosed to about `bits` bits.
    ///
    /// # Errors
    /// [`DiscretizeError::Numeric`] if its root cannot be isolated.
    pub fn certified_mean_square_cut(&self, bits: u32) -> Result<CertifiedCut, DiscretizeError> {
        let condition = StationaryCut::MeanSquare(*self);
        condition.certified(bits, |tau| self.mean_square_error_at(tau))
    }

    /// The exponents in the type of `like`; p = n + 1.
    fn powers<S: Scalar>(&self, like: &S) -> Powers<S> {
        let (n, m) = (
            like.constant(self.exponent),
            like.constant(self.irradiance_exponent),
        );
        Powers {
            p: n.clone() + &like.constant(1.0),
            n,
            m,
        }
    }

    /// `b − 1 = −e^−pτ (1−e^−mτ)/(1−e^−(p+m)τ)`, b = (1−G)/(1−W).
    fn shrink<S: Scalar>(&self, tau: &S) -> S {
        let Powers { p, m, .. } = self.powers(tau);
        let narrowing = loss(&m, tau) / &loss(&(m + &p), tau);
        -(survival(&p, tau) * &narrowing)
    }

    /// The mean square error of two constants for `B = lⁿ`, cut at `e^−τ`: the variance less the
    /// part that the two means explain, `[ n²/(2n+1) − l (1−lⁿ)²/(1−l) ] / (n+1)²`.
    ///
    /// **Arguments** `tau` > 0.
    /// **Accuracy** `f64`: 1e-13 relative near the best cut. `Interval`: encloses it.
    #[must_use]
    pub fn mean_square_error_at<S: Scalar>(&self, tau: &S) -> S {
        debug_assert!(*tau > tau.zero(), "τ must be positive");
        let Powers { p, n, .. } = self.powers(tau);
        let one = tau.constant(1.0);
        // over n², which keeps small n from cancelling
        let drop = loss(&n, tau) / &n;
        let explained = drop.square() * &survival(&one, tau) / &loss(&one, tau);
        let share = one.clone() / &(n.clone() + &n + &one) - &explained;
        share * &(n / &p).square()
    }
}

/// The exponents of a cut.
struct Powers<S> {
    n: S,
    p: S,
    m: S,
}

/// `e^−kτ`.
fn survival<S: Scalar>(k: &S, tau: &S) -> S {
    (-(k.clone() * tau)).exp()
}

/// `1 − e^−kτ`.
fn loss<S: Scalar>(k: &S, tau: &S) -> S {
    -(-(k.clone() * tau)).exp_m1()
}

/// The stationarity condition of one of the two cuts, in a variable that brings its root between 0
/// and 1.
#[derive(Debug, Clone, Copy)]
enum StationaryCut {
    /// `(λ/(1−e^−λ) − 1)·p/m − 1` in the variable `τ p/2`: the cut of highest mutual information.
    ///
    /// At 1 the condition is ≥ 0, up to rounding. It depends on m/p only; where that is small the
    /// root is near 0.797, where it is large near 1/2.
    Information(GradientCut),
    /// `2n lⁿ (1 − l)/(1 − lⁿ) − 1` in the variable `τ n/ln(1 + 2n)`: the cut of least mean square
    /// error.
    ///
    /// The condition falls from 1 at l = 1, and where the variable is 1 it is `(1 − l) − 1 < 0`.
    /// Its root lies between 0.8 for small n and 0.04 for n = 1e12, where `nτ` is 1.256.
    MeanSquare(GradientCut),
}

/// The values of the variable between which the root of either condition lies: (a) the roots named
/// at [`StationaryCut`] leave a margin of 40 below; above, the rounding at 1 is some ε.
const ROOT_RANGE: (f64, f64) = (1e-3, 1.0 + 1e-9);

impl StationaryCut {
    /// τ = −ln l from the variable.
    fn tau<S: Scalar>(self, variable: &S) -> S {
        match self {
            Self::Information(patch) => {
                let Powers { p, .. } = patch.powers(variable);
                variable.clone() * &variable.constant(2.0) / &p
            }
            Self::MeanSquare(patch) => {
                let Powers { n, .. } = patch.powers(variable);
                (n.clone() + &n).ln_1p() / &n * variable
            }
        }
    }
}

impl StationaryCut {
    /// The root as τ, and the residual of the condition there.
    fn solved(self) -> Result<(f64, f64), NumericError> {
        let (lower, upper) = ROOT_RANGE;
        let value = |x: f64| self.value(&x).unwrap_or(f64::NAN);
        let found = root(value, lower, upper)?;
        Ok((self.tau(&found.position), found.residual))
    }

    /// The root, enclosed to about `bits` bits, with the `value` of the cut there.
    fn certified(
        self,
        bits: u32,
        value: impl Fn(&Interval) -> Interval,
    ) -> Result<CertifiedCut, DiscretizeError> {
        let (lower, upper) = ROOT_RANGE;
        let found = certified_roots(&self, ROOT_RANGE, bits);
        let [root] = found.roots.as_slice() else {
            return Err(NumericError::NotIsolated { lower, upper }.into());
        };
        if !found.undecided.is_empty() {
            return Err(NumericError::NotIsolated { lower, upper }.into());
        }
        let tau = self.tau(&root.enclosure);
        let one = tau.constant(1.0);
        Ok(CertifiedCut {
            position: survival(&one, &tau),
            complement: loss(&one, &tau),
            value: value(&tau),
            evaluations: found.evaluations,
        })
    }
}

impl IntervalFunction for StationaryCut {
    fn value<S: Scalar>(&self, variable: &S) -> Option<S> {
        let tau = self.tau(variable);
        let one = variable.constant(1.0);
        match self {
            Self::Information(patch) => {
                let Powers { p, m, .. } = patch.powers(variable);
                let lambda = m.clone() * &tau - &patch.shrink(&tau).ln_1p();
                let excess = if lambda < one {
                    // φ(e^λ − 1)/(e^λ − 1)
                    let growth = lambda.exp_m1();
                    growth.divergence_kernel() / &growth
                } else {
                    lambda.clone() / &loss(&one, &lambda) - &one
                };
                Some(excess * &p / &m - &one)
            }
            Self::MeanSquare(patch) => {
                let Powers { n, .. } = patch.powers(variable);
                let ratio = loss(&one, &tau) / &loss(&n, &tau);
                Some((n.clone() + &n) * &survival(&n, &tau) * &ratio - &one)
            }
        }
    }
}
