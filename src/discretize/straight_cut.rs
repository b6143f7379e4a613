//! Straight cuts of the unit square in any direction, where radiosity grows along one axis (§4.2).
//!
//! The square carries `B ∝ lⁿ` and irradiance `∝ lᵐ`, both constant across the other axis. A line at
//! an angle θ to the direction across the gradient leaves the share `s(l)` of each strip on its near side;
//!
//! ```text
//!   G = (n+1) ∫ lⁿ s(l) dl,     W = (n+m+1) ∫ l^(n+m) s(l) dl
//! ```
//!
//! by quadrature on the pieces where s is linear. The values are estimates.
//!
//! **Not covered**: curved cuts.

use super::DiscretizeError;
use crate::information::divergence;
use crate::numeric::integral;

/// A straight line through the unit square.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StraightCut {
    /// Where the line crosses the middle of the square, 0 to 1 along the gradient.
    pub middle: f64,
    /// Its slope: how far it moves along the gradient from one side of the square to the other;
    /// 0 is perpendicular to the gradient.
    pub lean: f64,
}

impl StraightCut {
    /// The gain of this cut in bits per unit of flux, for `B ∝ lⁿ` and irradiance `∝ lᵐ`.
    ///
    /// # Errors
    /// [`DiscretizeError::Numeric`] if the quadrature misses 1e-12.
    pub fn gain(&self, exponent: f64, irradiance_exponent: f64) -> Result<f64, DiscretizeError> {
        let half = 0.5 * self.lean.abs();
        let (from, to) = (self.middle - half, self.middle + half);
        // share of the strip at l on the near side: 1 before `from`, falling to 0 at `to`
        let share = |l: f64| {
            if half > 0.0 {
                ((to - l) / (2.0 * half)).clamp(0.0, 1.0)
            } else {
                0.0
            }
        };
        let near = |power: f64| -> Result<f64, DiscretizeError> {
            let (start, end) = (from.clamp(0.0, 1.0), to.clamp(0.0, 1.0));
            let whole = start.powf(power + 1.0);
            if start >= end {
                return Ok(whole);
            }
            let leaning = integral(|l| l.powf(power) * share(l), (start, end), 1e-13)?;
            Ok(whole + (power + 1.0) * leaning.value)
        };
        let flux = near(exponent)?;
        let weight = near(exponent + irradiance_exponent)?;
        let parts = |near: f64| [near.clamp(0.0, 1.0), (1.0 - near).clamp(0.0, 1.0)];
        Ok(divergence(&parts(flux), &parts(weight)))
    }
}
