//! The two cuts of §4.2 side by side, each judged by the measure of the other.
//!
//! **Not covered**: other profiles than powers; see [`ProfileCut`](crate::discretize::ProfileCut).

use super::cut::{CertifiedCut, Cut, GradientCut};
use crate::discretize::error::DiscretizeError;

/// Both cuts of one patch, and their distance and cost.
#[derive(Debug, Clone, PartialEq)]
pub struct CutComparison {
    /// The patch.
    pub patch: GradientCut,
    /// The cut of highest mutual information.
    pub information: Cut,
    /// The cut of least mean square error.
    pub square: Cut,
    /// The gain of the mean-square cut, in bits per flux.
    pub gain_at_square: f64,
    /// The mean square error of the mutual-information cut, for `B = lⁿ`.
    pub error_at_information: f64,
    /// Both cuts enclosed, if enclosures were asked for: mutual information, mean square.
    pub certified: Option<[CertifiedCut; 2]>,
}

impl CutComparison {
    /// Finds both cuts, and encloses them to about so many bits if any are given.
    ///
    /// # Errors
    /// [`DiscretizeError::Numeric`] if a root is not found, which the brackets exclude, or cannot
    /// be isolated.
    pub fn try_new(patch: GradientCut, bits: Option<u32>) -> Result<Self, DiscretizeError> {
        let (information, square) = (patch.mutual_information_cut()?, patch.mean_square_cut()?);
        let certified = match bits {
            Some(bits) => Some([
                patch.certified_mutual_information_cut(bits)?,
                patch.certified_mean_square_cut(bits)?,
            ]),
            None => None,
        };
        Ok(Self {
            patch,
            information,
            square,
            gain_at_square: patch.gain_at(&square.tau()),
            error_at_information: patch.mean_square_error_at(&information.tau()),
            certified,
        })
    }

    /// The distance of the mean-square cut beyond the other one.
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.information.complement - self.square.complement
    }

    /// The share of the highest gain that the mean-square cut has, at most 1.
    #[must_use]
    pub fn gain_kept(&self) -> f64 {
        self.gain_at_square / self.information.value
    }

    /// The square error of the mutual-information cut above the least one, as a share of the least.
    #[must_use]
    pub fn error_excess(&self) -> f64 {
        self.error_at_information / self.square.value - 1.0
    }
}
