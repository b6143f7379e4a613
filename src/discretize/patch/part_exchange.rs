//! The exchange areas of the parts of one patch, and the gain that follows from them, eq. (7).
//!
//! ```text
//!   ΔI(t) = (2/Σw) Σ_j β_j [ Σ_k G_j(k) log2( G_j(k)/s_k ) − G_j log2 G_j ]
//!   G_j(k) = A_k F_kj,  s_k: share of part k in the area,  β_j: product of two brightnesses
//! ```
//!
//! [`PartExchange`] holds the terms of the formula: flux and share of a part, and their rates as a
//! cut moves. [`RectangleSplit`](crate::discretize::RectangleSplit) has them in every number type,
//! [`PolygonSplit`](super::polygons::PolygonSplit) in `f64`; so only the first can be enclosed.

use crate::discretize::error::DiscretizeError;
use crate::discretize::measure::CutMeasure;
use crate::discretize::stationarity::stationarity;
use crate::numeric::{Scalar, real};

/// The weights with which the pairs of a split enter its gain.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SplitWeights<S> {
    /// `B_i B_j` of each pair; 1 for visibility.
    pub brightness: Vec<S>,
    /// The area of the patch that is cut.
    pub area: S,
    /// `Σw`: the total area for visibility.
    pub total: S,
}

impl SplitWeights<f64> {
    pub(crate) fn lifted<S: Scalar>(&self, like: &S) -> SplitWeights<S> {
        let constant = |value: &f64| like.constant(*value);
        SplitWeights {
            brightness: self.brightness.iter().map(constant).collect(),
            area: constant(&self.area),
            total: constant(&self.total),
        }
    }
}

impl<S: Scalar> SplitWeights<S> {
    /// `2/(Σw ln 2)`.
    pub(crate) fn bits_per_nat(&self) -> S {
        let two = self.area.constant(2.0);
        two.clone() / &(two.ln() * &self.total)
    }
}

/// Flux and share of the parts of a patch, for each of the patches that it is judged by.
///
/// Positions are relative, from 0 to 1; `pair` counts from 0, one for each of
/// [`SplitWeights::brightness`].
pub(crate) trait PartExchange<S> {
    /// The weights of the pairs.
    fn weights(&self) -> &SplitWeights<S>;

    /// The exchange area of the whole patch.
    fn whole_flux(&self, pair: usize) -> Result<S, DiscretizeError>;

    /// The exchange area of the part between two positions.
    fn flux(&self, pair: usize, part: &[S; 2]) -> Result<S, DiscretizeError>;

    /// The derivative of the exchange area of `[0, position]`: that of a strip, per relative width.
    fn flux_rate(&self, pair: usize, position: &S) -> Result<S, DiscretizeError>;

    /// The share of a part in the area.
    fn share(&self, part: &[S; 2]) -> S;

    /// The derivative of the share of `[0, position]`.
    fn share_rate(&self, position: &S) -> S;
}

/// The gain of cuts at increasing relative positions, in bits.
pub(crate) fn gain<S: Scalar>(
    split: &(impl PartExchange<S> + ?Sized),
    positions: &[S],
) -> Result<S, DiscretizeError> {
    gain_by(CutMeasure::Information, split, positions)
}

/// The gain of cuts at increasing relative positions, by a measure: in bits, or in squared form
/// factors.
pub(crate) fn gain_by<S: Scalar>(
    measure: CutMeasure,
    split: &(impl PartExchange<S> + ?Sized),
    positions: &[S],
) -> Result<S, DiscretizeError> {
    let [gain] = gains_by([measure], split, positions)?;
    Ok(gain)
}

/// The gains by several measures.
pub(crate) fn gains_by<S: Scalar, const N: usize>(
    measures: [CutMeasure; N],
    split: &(impl PartExchange<S> + ?Sized),
    positions: &[S],
) -> Result<[S; N], DiscretizeError> {
    let weights = split.weights();
    let parts = parts_between(positions, &weights.area);
    let zero = weights.area.zero();
    let mut gains = measures.map(|_| zero.clone());
    for (pair, brightness) in weights.brightness.iter().enumerate() {
        let parts = parts
            .iter()
            .map(|part| Ok([split.flux(pair, part)?, split.share(part)]))
            .collect::<Result<Vec<[S; 2]>, DiscretizeError>>()?;
        let flux = parts.iter().fold(zero.clone(), |sum, part| sum + &part[0]);
        for (gain, measure) in gains.iter_mut().zip(measures) {
            *gain = gain.clone() + &(measure.gain(&flux, &parts) * brightness);
        }
    }
    let mut scales = measures.into_iter().map(|measure| match measure {
        CutMeasure::Information => [weights.area.constant(2.0), weights.total.clone()],
        CutMeasure::MeanSquare => [weights.area.constant(1.0), weights.area.square()],
    });
    Ok(gains.map(|gain| match scales.next() {
        Some([factor, divisor]) => gain * &factor / &divisor,
        None => gain,
    }))
}

/// The derivative of the gain as cut `k` moves, in bits per relative position.
pub(crate) fn gain_derivative<S: Scalar>(
    split: &(impl PartExchange<S> + ?Sized),
    positions: &[S],
    k: usize,
) -> Result<S, DiscretizeError> {
    gain_derivative_by(CutMeasure::Information, split, positions, k)
}

/// The derivative of the gain by a measure as cut `k` moves, per relative position.
pub(crate) fn gain_derivative_by<S: Scalar>(
    measure: CutMeasure,
    split: &(impl PartExchange<S> + ?Sized),
    positions: &[S],
    k: usize,
) -> Result<S, DiscretizeError> {
    let weights = split.weights();
    let parts = parts_between(positions, &weights.area);
    let (Some(before), Some(after)) = (parts.get(k), parts.get(k + 1)) else {
        let (parameter, condition) = ("the index of a cut", "that of one of the positions");
        let value = real(k);
        return Err(DiscretizeError::OutOfRange {
            parameter,
            value,
            condition,
        });
    };
    let cut = &before[1];
    let weight_rate = split.share_rate(cut) * &weights.area;
    let ratio = |pair: usize, part: &[S; 2]| {
        let area = split.share(part) * &weights.area;
        split.flux(pair, part).map(|flux| flux / &area)
    };
    let mut derivative = weights.area.zero();
    for (pair, brightness) in weights.brightness.iter().enumerate() {
        let rate = split.flux_rate(pair, cut)?;
        let [before, after] = [ratio(pair, before)?, ratio(pair, after)?];
        let term = match measure {
            CutMeasure::Information => stationarity(&rate, &weight_rate, &before, &after),
            CutMeasure::MeanSquare => measure.slope(&rate, &weight_rate, &before, &after),
        };
        derivative = derivative + &(term * brightness);
    }
    Ok(match measure {
        CutMeasure::Information => derivative * &weights.bits_per_nat(),
        CutMeasure::MeanSquare => derivative / &weights.area,
    })
}

/// The largest gain that a regular division into `parts` could bring at all, eqs. (6), (7).
pub(crate) fn maximum_gain<S: Scalar>(
    split: &(impl PartExchange<S> + ?Sized),
    parts: u32,
) -> Result<S, DiscretizeError> {
    let weights = split.weights();
    let mut exchanged = weights.area.zero();
    for (pair, brightness) in weights.brightness.iter().enumerate() {
        exchanged = exchanged + &(split.whole_flux(pair)? * brightness);
    }
    let two = weights.area.constant(2.0);
    let log = weights.area.constant(f64::from(parts)).ln() / &two.ln();
    Ok(exchanged * &two * &log / &weights.total)
}

/// The parts between cuts, as relative positions from and to.
fn parts_between<S: Scalar>(positions: &[S], like: &S) -> Vec<[S; 2]> {
    let (zero, one) = (like.zero(), like.constant(1.0));
    let from = std::iter::once(&zero).chain(positions);
    let to = positions.iter().chain(std::iter::once(&one));
    from.zip(to)
        .map(|(from, to)| [from.clone(), to.clone()])
        .collect()
}
