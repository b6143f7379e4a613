//! The two measures of a cut that are compared: mutual information and mean square.
//!
//! ```text
//!   parts k of areas s_k, fluxes G_k, G = ΣG_k, s = Σs_k; F(x) the form factor from a point
//!   information   Σ_k G_k log2( (G_k/s_k)/(G/s) )          gain (7), times A_T/2
//!   mean square   (1/s) [ Σ_k G_k²/s_k − G²/s ]            part of the variance of F explained
//! ```
//!
//! The mean square error that constants on the parts leave of F is its variance less the second.
//! The derivatives as a cut moves, with the ratios a, b of flux to area on its two sides,
//!
//! ```text
//!   G′ ln(a/b) − s′ (a − b)  nats            (a − b) (2 G′ − s′ (a + b))
//! ```

use super::stationarity::stationarity;
use crate::information::relative_entropy;
use crate::numeric::Scalar;

/// A measure by which cuts of a patch are judged.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CutMeasure {
    /// The mutual information gained, in bits.
    Information,
    /// The part of the mean square error of the form factor from points that two constants remove.
    MeanSquare,
}

impl CutMeasure {
    /// Both measures.
    pub const ALL: [Self; 2] = [Self::Information, Self::MeanSquare];

    /// The gain of parts by flux and area, the areas adding up to 1.
    pub(crate) fn gain<S: Scalar>(self, flux: &S, parts: &[[S; 2]]) -> S {
        let one = flux.constant(1.0);
        match self {
            Self::Information => relative_entropy(flux, &one, parts),
            Self::MeanSquare => {
                // Σ s (G_k/s_k − G)²: no difference of nearly equal squares
                let terms = parts.iter().map(|[part, share]| {
                    let off = part.clone() / share - flux;
                    off.square() * share
                });
                terms.fold(flux.zero(), |sum, term| sum + &term)
            }
        }
    }

    /// The derivative of the gain, in its own unit, as a cut moves.
    pub(crate) fn slope<S: Scalar>(self, rate: &S, area_rate: &S, before: &S, after: &S) -> S {
        match self {
            Self::Information => {
                stationarity(rate, area_rate, before, after) / &rate.constant(2.0).ln()
            }
            Self::MeanSquare => {
                let mean = (before.clone() + after) * area_rate;
                let off = rate.constant(2.0) * rate - &mean;
                (before.clone() - after) * &off
            }
        }
    }
}
