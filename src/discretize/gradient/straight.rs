//! Straight cuts of the unit square in any direction, where radiosity grows along one axis (§4.2).
//!
//! The square carries `B ∝ lⁿ` and irradiance `∝ lᵐ`, both constant across the other axis, t. Left
//! of the line `l cos θ + t sin θ = c` lies the share `s(l)` of each strip, which falls from s₀ at
//! l = 0 to s₁ at l = 1, linearly from a to b, where the line leaves the square, and not elsewhere.
//! By parts, flux and weight are closed forms:
//!
//! ```text
//!   M_k = k ∫ l^(k−1) s(l) dl = s₁ + (s₀ − s₁) · mean of l^k over [a, b]
//!   G = M_(n+1),  W = M_(n+m+1)
//!   s(l) = (c − l cos θ)/sin θ, not below 0 nor above 1
//!   dM_k/dc ∝ mean of k l^(k−1) over [a, b]                     the same factor for G and W
//! ```
//!
//! No line gains more than the best perpendicular to the gradient, and that needs no order of B and
//! irradiance, only that both vary along l alone: s falls, so it is a mixture of steps,
//! `s = ∫ 1[l < c] dμ(c)`; the pair (G, W) is the same mixture of those of perpendicular cuts; and
//! the gain is a convex function of the pair. For divisions of *any* shape the order counts
//! (`strip_beats_every_straight_cut` in `proofs/`).
//!
//! **Not covered**: curved cuts. Values are estimates: closed forms in `f64`.

use super::cut::GradientCut;
use crate::discretize::error::DiscretizeError;
use crate::discretize::stationarity::stationarity;
use crate::information::divergence;
use crate::numeric::maximum;

/// A straight line through the unit square.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StraightCut {
    degrees: f64,
    offset: f64,
}

/// The best of all parallel straight cuts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BestStraightCut {
    /// The cut.
    pub cut: StraightCut,
    /// The gain of the cut, in bits per unit of flux.
    pub gain: f64,
}

impl StraightCut {
    /// The cut that leans by an angle from the perpendicular to the gradient.
    ///
    /// **Arguments** `degrees`: 0 cuts across the gradient, 90 along it (leaning to the other side
    /// is the mirror image); `offset`: the place of the line between the corner where l = t = 0 and
    /// the opposite one, between 0 and 1; across the gradient that is the l, along it the t, of the
    /// line.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] unless `0 ≤ degrees ≤ 90` and `0 < offset < 1`.
    pub fn try_new(degrees: f64, offset: f64) -> Result<Self, DiscretizeError> {
        if !(0.0..=90.0).contains(&degrees) {
            return Err(DiscretizeError::out_of_range(
                "the angle",
                degrees,
                "from 0 to 90 degrees",
            ));
        }
        if !(offset > 0.0 && offset < 1.0) {
            return Err(DiscretizeError::out_of_range(
                "the offset",
                offset,
                "between 0 and 1",
            ));
        }
        Ok(Self { degrees, offset })
    }

    /// The angle, 0 to 90 degrees; 0 is across the gradient.
    #[must_use]
    pub const fn degrees(&self) -> f64 {
        self.degrees
    }

    /// The offset, 0 to 1.
    #[must_use]
    pub const fn offset(&self) -> f64 {
        self.offset
    }

    /// The gain of this cut in bits per unit of flux.
    ///
    /// **Accuracy** a few ε absolute, measured by
    /// `straight_cuts_agree_with_quadrature_the_other_way` and
    /// `straight_cuts_agree_with_the_closed_form`.
    #[must_use]
    pub fn gain(&self, patch: &GradientCut) -> f64 {
        let [flux, weight] = self.near(patch);
        divergence(&[flux, 1.0 - flux], &[weight, 1.0 - weight])
    }

    /// The best cut at this angle.
    ///
    /// Along the gradient every cut gains 0, and the one in the middle is returned.
    ///
    /// **Accuracy** a local maximum, found by a scan of the derivative in the offset: an estimate
    /// of the highest.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] unless `0 ≤ degrees ≤ 90`; [`DiscretizeError::Numeric`] if
    /// no maximum is found.
    pub fn best(degrees: f64, patch: &GradientCut) -> Result<BestStraightCut, DiscretizeError> {
        let middle = Self::try_new(degrees, 0.5)?;
        if degrees >= 90.0 {
            let (cut, gain) = (middle, 0.0);
            return Ok(BestStraightCut { cut, gain });
        }
        let at = |offset: f64| Self { degrees, offset };
        let found = maximum(
            |offset| at(offset).gain(patch),
            |offset| at(offset).slope(patch),
            (0.0, 1.0),
            SCANNED_OFFSETS,
        )?;
        Ok(BestStraightCut {
            cut: at(found.position),
            gain: found.value,
        })
    }

    /// The flux and the weight before the line.
    fn near(&self, patch: &GradientCut) -> [f64; 2] {
        let section = self.section();
        let p = patch.exponent() + 1.0;
        [p, p + patch.irradiance_exponent()].map(|power| {
            let leaning = section.drop * section.mean(power);
            (section.end + leaning).clamp(0.0, 1.0)
        })
    }

    /// The derivative of the gain in the offset, over a factor > 0 that does not depend on flux and
    /// weight.
    fn slope(&self, patch: &GradientCut) -> f64 {
        let section = self.section();
        let p = patch.exponent() + 1.0;
        let q = p + patch.irradiance_exponent();
        let [flux, weight] = self.near(patch);
        if weight <= 0.0 {
            return 1.0; // too near to the dark corner for f64: the gain still rises
        }
        let rates = [p, q].map(|power| power * section.mean(power - 1.0));
        let far = (1.0 - flux) / (1.0 - weight);
        stationarity(&rates[0], &rates[1], &(flux / weight), &far)
    }

    /// The section of the square that the line crosses.
    fn section(&self) -> Section {
        let (sine, cosine) = if self.degrees < 90.0 {
            self.degrees.to_radians().sin_cos()
        } else {
            (1.0, 0.0)
        };
        let reach = self.offset * (sine + cosine);
        // the quotients may be infinite, never 0/0: reach lies between 0 and the sum
        let crossing = |height: f64| ((reach - height) / cosine).clamp(0.0, 1.0);
        let share = |l: f64| ((reach - l * cosine) / sine).clamp(0.0, 1.0);
        let end = if sine > 0.0 { share(1.0) } else { 0.0 };
        let start = if sine > 0.0 { share(0.0) } else { 1.0 };
        let (from, to) = if cosine > 0.0 {
            (crossing(sine), crossing(0.0))
        } else {
            (0.0, 1.0)
        };
        Section {
            from,
            to,
            end,
            drop: start - end,
        }
    }
}

/// Offsets at which the derivative is scanned: (b) `no_straight_cut_beats_the_perpendicular` misses
/// no higher maximum with so many.
const SCANNED_OFFSETS: u32 = 64;

/// The part of a strip before a line: it falls by `drop` between `from` and `to`, down to `end`.
struct Section {
    from: f64,
    to: f64,
    end: f64,
    drop: f64,
}

impl Section {
    /// The mean of `l^k` between the crossings a, b: `b^k (1 − (1−ρ)^(k+1)) / ((k+1) ρ)`, ρ = 1 −
    /// a/b.
    fn mean(&self, k: f64) -> f64 {
        let height = self.to.powf(k);
        let narrowing = (self.to - self.from) / self.to;
        if narrowing > 0.0 {
            let power = k + 1.0;
            height * -(power * (-narrowing).ln_1p()).exp_m1() / (power * narrowing)
        } else {
            height
        }
    }
}
