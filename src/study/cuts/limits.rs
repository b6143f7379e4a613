//! The approach of the cuts of §4.2 to their limits as the exponent grows.
//!
//! Both `n (1 − l)` and the [limit](GradientLimit) are enclosed with so many bits that their
//! difference keeps its digits up to the largest exponent.

use crate::discretize::{DiscretizeError, GradientCut, GradientLimit, LimitingCut};
use crate::numeric::{Interval, Scalar};
use std::time::Instant;

/// A cut at one exponent, against its limit.
#[derive(Debug, Clone, PartialEq)]
pub struct LimitRow {
    /// The cut.
    pub cut: GradientLimit,
    /// The exponent n.
    pub exponent: f64,
    /// `n (1 − l)`.
    pub scaled: Interval,
    /// `n (n (1 − l) − limit)`, which tends to the [rate](LimitingCut::rate).
    pub scaled_difference: Interval,
    /// The limits of both.
    pub limits: LimitingCut,
    /// Time of the certified cut, in seconds.
    pub seconds: f64,
}

/// Bits of the enclosures: 1e12² of the difference's digits are lost, 80 bits.
const BITS: u32 = 320;

/// Exponents 1, 10, … 1e12 for each of the three cuts.
///
/// # Errors
/// [`DiscretizeError::Numeric`] if a cut cannot be isolated.
pub fn gradient_limits() -> Result<Vec<LimitRow>, DiscretizeError> {
    let mut rows = Vec::new();
    for cut in GradientLimit::ALL {
        let limits = cut.enclosed(BITS)?;
        for power in 0..=12 {
            let n = 10f64.powi(power);
            let start = Instant::now();
            let certified = match cut {
                GradientLimit::FixedIrradiance => {
                    GradientCut::try_new(n, 1.0)?.certified_mutual_information_cut(BITS)?
                }
                GradientLimit::EqualExponents => {
                    GradientCut::try_new(n, n)?.certified_mutual_information_cut(BITS)?
                }
                GradientLimit::MeanSquare => {
                    GradientCut::try_new(n, 1.0)?.certified_mean_square_cut(BITS)?
                }
            };
            let seconds = start.elapsed().as_secs_f64();
            let exponent = certified.complement.constant(n);
            let scaled = certified.complement * &exponent;
            let scaled_difference = (scaled.clone() - &limits.limit) * &exponent;
            rows.push(LimitRow {
                cut,
                exponent: n,
                scaled,
                scaled_difference,
                limits: limits.clone(),
                seconds,
            });
        }
    }
    Ok(rows)
}
