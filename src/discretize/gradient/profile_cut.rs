//! The two best cuts of a patch for any profile of radiosity: by mutual information and by mean
//! square.
//!
//! As in §4.2 flux goes as ∫B and weight as ∫B H, H the irradiance. With constant reflectance R and
//! emission E, `B = E + R H`, so that `H ∝ B − E`; where the reflectance alone varies, H is
//! constant. With shares G, W before l, and the means B₁, B₂ of the radiosity before and after,
//!
//! ```text
//!   gain per flux   G log2(G/W) + (1−G) log2((1−G)/(1−W))         slope G′ ln(a/b) − W′ (a − b)
//!   explained       l (1−l) (B₂ − B₁)²                            slope (B₂ − B₁)(B₁ + B₂ − 2B)
//! ```
//!
//! where the square error of two constants is the unexplained part of the variance. A constant H
//! makes weights proportional to fluxes: every cut gains 0, and mutual information prefers none,
//! however radiosity varies.
//!
//! Between jumps of the radiosity the slopes are scanned for changes of sign, each is refined, and
//! the highest maximum, or jump, is taken.
//!
//! **Not covered**: a proof that it is the highest; for powers see
//! [`GradientCut`](crate::discretize::GradientCut).

use super::profile::Profile;
use crate::discretize::error::DiscretizeError;
use crate::discretize::stationarity::stationarity;
use crate::information::divergence;
use crate::numeric::{NumericError, maximum};

/// The irradiance that belongs to a radiosity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Irradiance {
    /// One irradiance everywhere: the reflectance varies.
    Constant,
    /// Proportional to `B − emission`: the reflectance is constant.
    Reflected {
        /// The emission everywhere, from 0 to the lowest radiosity; below that if a whole part has
        /// the lowest, as its weight would be 0.
        emission: f64,
    },
}

/// A patch with a profile of radiosity, to be cut across it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProfileCut {
    profile: Profile,
    irradiance: Irradiance,
    flux: f64,
    weight: f64,
    variance: f64,
}

/// A cut, judged by either measure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JudgedCut {
    /// The position l.
    pub position: f64,
    /// The gain per flux, in bits.
    pub gain: f64,
    /// The remaining share of the undivided patch's square error, 0 to 1.
    pub square_error: f64,
}

/// Pieces at whose ends the slope is scanned, besides powers of two towards the ends: (a) a profile
/// within its ranges has features no narrower than 0.05, some 25 pieces.
const SCANNED_PIECES: u32 = 512;

impl ProfileCut {
    /// The patch with this profile.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] if a parameter leaves its range, or the emission exceeds the
    /// lowest radiosity.
    pub fn try_new(profile: Profile, irradiance: Irradiance) -> Result<Self, DiscretizeError> {
        let profile = profile.checked()?;
        if let Irradiance::Reflected { emission } = irradiance
            && !(emission >= 0.0
                && (emission < profile.lowest()
                    || emission <= profile.lowest() && !matches!(profile, Profile::Step { .. })))
        {
            return Err(DiscretizeError::OutOfRange {
                parameter: "the emission",
                value: emission,
                condition: "from 0 to the lowest radiosity, and less than that of a whole part",
            });
        }
        let flux = profile.flux(0.0, 1.0);
        let mut patch = Self {
            profile,
            irradiance,
            flux,
            weight: 1.0,
            variance: profile.square_flux(0.0, 1.0) - flux * flux,
        };
        patch.weight = patch.weight_between(0.0, 1.0);
        Ok(patch)
    }

    /// The profile.
    #[must_use]
    pub const fn profile(&self) -> &Profile {
        &self.profile
    }

    /// Judges the cut at l, `0 < l < 1`, by either measure.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] if the position is not inside `(0, 1)`.
    pub fn judged(&self, position: f64) -> Result<JudgedCut, DiscretizeError> {
        if !(position > 0.0 && position < 1.0) {
            return Err(DiscretizeError::OutOfRange {
                parameter: "the cut",
                value: position,
                condition: "between 0 and 1",
            });
        }
        Ok(JudgedCut {
            position,
            gain: self.gain(position),
            // a variance that rounding may bring below 0
            square_error: (1.0 - self.explained(position) / self.variance).max(0.0),
        })
    }

    /// The cut of highest mutual information; `None` where every cut gains 0.
    ///
    /// If cuts gain the same, the one with the smallest l is returned; of a
    /// [symmetric](Profile::is_symmetric) profile `1 − l` is as good.
    ///
    /// **Accuracy** position to 1e-10, measured by `profile_cuts_agree_with_256_bits`.
    ///
    /// # Errors
    /// [`DiscretizeError::Numeric`] if none is found.
    pub fn mutual_information_cut(&self) -> Result<Option<JudgedCut>, DiscretizeError> {
        if self.irradiance == Irradiance::Constant {
            return Ok(None);
        }
        let highest = self.highest(|l| self.gain(l), |l| self.gain_slope(l))?;
        self.judged(highest).map(Some)
    }

    /// The cut of least mean square error.
    ///
    /// Accuracy, choice and errors as [`mutual_information_cut`](Self::mutual_information_cut).
    ///
    /// # Errors
    /// [`DiscretizeError::Numeric`] if none is found.
    pub fn mean_square_cut(&self) -> Result<JudgedCut, DiscretizeError> {
        let highest = self.highest(|l| self.explained(l), |l| self.explained_slope(l))?;
        self.judged(highest)
    }

    /// The position of the highest value: inside a piece between jumps of the radiosity, or at a
    /// jump.
    fn highest(
        &self,
        value: impl Fn(f64) -> f64,
        slope: impl Fn(f64) -> f64,
    ) -> Result<f64, DiscretizeError> {
        let jump = self.profile.jump();
        let ends: Vec<f64> = [0.0].into_iter().chain(jump).chain([1.0]).collect();
        let mut best = jump.map(|l| (l, value(l)));
        let nothing = NumericError::NoInteriorMaximum {
            lower: 0.0,
            upper: 1.0,
        };
        for piece in ends.windows(2) {
            match maximum(&value, &slope, (piece[0], piece[1]), SCANNED_PIECES) {
                Ok(found) if best.is_none_or(|(_, highest)| found.value > highest) => {
                    best = Some((found.position, found.value));
                }
                Ok(_) | Err(NumericError::NoInteriorMaximum { .. }) => {}
                Err(error) => return Err(error.into()),
            }
        }
        best.map(|(position, _)| position)
            .ok_or_else(|| nothing.into())
    }

    fn weight_between(&self, from: f64, to: f64) -> f64 {
        match self.irradiance {
            Irradiance::Constant => self.profile.flux(from, to),
            Irradiance::Reflected { emission } => {
                let glow = emission * self.profile.flux(from, to);
                self.profile.square_flux(from, to) - glow
            }
        }
    }

    /// The shares of flux and of weight, before and after l.
    fn shares(&self, l: f64) -> [[f64; 2]; 2] {
        let parts = [(0.0, l), (l, 1.0)];
        [
            parts.map(|(from, to)| self.profile.flux(from, to) / self.flux),
            parts.map(|(from, to)| self.weight_between(from, to) / self.weight),
        ]
    }

    fn gain(&self, l: f64) -> f64 {
        let [fluxes, weights] = self.shares(l);
        divergence(&fluxes, &weights)
    }

    fn gain_slope(&self, l: f64) -> f64 {
        let [fluxes, weights] = self.shares(l);
        let radiosity = self.profile.radiosity(l);
        let irradiance = match self.irradiance {
            Irradiance::Constant => 1.0,
            Irradiance::Reflected { emission } => radiosity - emission,
        };
        let rates = [radiosity / self.flux, radiosity * irradiance / self.weight];
        let [before, after] = [0, 1].map(|part| fluxes[part] / weights[part]);
        stationarity(&rates[0], &rates[1], &before, &after)
    }

    /// The means of the radiosity before and after l.
    fn means(&self, l: f64) -> [f64; 2] {
        [
            self.profile.flux(0.0, l) / l,
            self.profile.flux(l, 1.0) / (1.0 - l),
        ]
    }

    fn explained(&self, l: f64) -> f64 {
        let [before, after] = self.means(l);
        l * (1.0 - l) * (after - before).powi(2)
    }

    fn explained_slope(&self, l: f64) -> f64 {
        let [before, after] = self.means(l);
        (after - before) * (before + after - 2.0 * self.profile.radiosity(l))
    }
}
