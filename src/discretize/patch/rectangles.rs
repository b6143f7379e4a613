//! A split whose patches are all rectangles with edges along common axes: closed forms, enclosures.
//!
//! ```text
//!   G(a, b) = A F of the part between positions a and b,     r(t) = ∂G(0, t)/∂t
//! ```
//!
//! Both are closed forms ([`RectanglePair`]) in every number type. Over intervals a gain is an
//! enclosure, and the best cut into two parts can be proved to be it.
//!
//! **Not covered**: other polygons, whose exchange areas are known in `f64` only.

use super::part_exchange;
use super::part_exchange::{PartExchange, SplitWeights};
use crate::discretize::error::DiscretizeError;
use crate::discretize::stationarity::stationarity;
use crate::form_factor::{FormFactorError, RectanglePair};
use crate::geometry::SplitAxis;
use crate::numeric::{
    CertifiedMaximum, Dual, EndPoint, Interval, Maximand, Scalar, certified_maximum,
};

/// A rectangle to be cut across one of its axes, judged by aligned rectangles.
///
/// [`PatchSplit::rectangles`](crate::discretize::PatchSplit::rectangles) returns it; over intervals
/// its gains are enclosures.
#[derive(Debug, Clone, PartialEq)]
pub struct RectangleSplit<S = f64> {
    pairs: Vec<RectanglePair<S>>,
    axis: SplitAxis,
    pub(crate) weights: SplitWeights<S>,
}

/// Largest rounding of a part's exchange area, as a share of the whole patch's, at which a part
/// without a correct digit counts as dark: (a) corners rounded to ε bring a part that ends at the
/// other's plane before it by some ε of the patch; the rest of the 4500 ε is for the terms that
/// cancel. No gain shows it, as such a part carries 1e-12 of the flux at most.
const DARK: f64 = 1e-12;

/// An exchange area in which a part that is dark up to rounding has none.
pub(crate) fn or_dark<S: Scalar>(
    exchange: Result<S, FormFactorError>,
    whole: impl FnOnce() -> Result<S, DiscretizeError>,
    like: &S,
) -> Result<S, DiscretizeError> {
    match exchange {
        Err(FormFactorError::NotResolved { error, .. }) if error <= DARK * whole()?.to_f64() => {
            Ok(like.zero())
        }
        exchange => Ok(exchange?),
    }
}

impl RectangleSplit {
    pub(crate) const fn new(
        pairs: Vec<RectanglePair>,
        axis: SplitAxis,
        weights: SplitWeights<f64>,
    ) -> Self {
        Self {
            pairs,
            axis,
            weights,
        }
    }

    /// The split in numbers of the type and precision of `like`.
    #[must_use]
    pub fn lifted<S: Scalar>(&self, like: &S) -> RectangleSplit<S> {
        RectangleSplit {
            pairs: self.pairs.iter().map(|pair| pair.lifted(like)).collect(),
            axis: self.axis,
            weights: self.weights.lifted(like),
        }
    }

    /// The cut into two parts that gains the most, enclosed to about `bits` bits, with what is
    /// proved about it.
    ///
    /// The scene is the one in `f64`: its pairs as placed (coordinates in the frame of the patch,
    /// rounded to ε of themselves) and its areas as rounded count as exact. For coordinates whose
    /// differences and products are doubles, as in the paper's scenes of two and three squares,
    /// that is the scene itself; else the true position and gain may miss the enclosures by the
    /// effect of this rounding. The total area does not enter the position.
    ///
    /// # Errors
    /// [`DiscretizeError::Numeric`] if no interior maximum is found.
    pub fn certified_best(&self, bits: u32) -> Result<CertifiedMaximum, DiscretizeError> {
        Ok(certified_maximum(self, (0.0, 1.0), bits)?)
    }
}

impl<S: Scalar> RectangleSplit<S> {
    /// The gain of cuts at increasing relative positions, in bits.
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] unless `0 < t_1 < … < 1`.
    pub fn gain(&self, positions: &[S]) -> Result<S, DiscretizeError> {
        part_exchange::gain(self, positions)
    }

    /// The derivative of the gain as cut `k` moves, in bits per relative position.
    ///
    /// # Errors
    /// As [`gain`](Self::gain); [`DiscretizeError::OutOfRange`] if there is no cut `k`.
    pub fn gain_derivative(&self, positions: &[S], k: usize) -> Result<S, DiscretizeError> {
        part_exchange::gain_derivative(self, positions, k)
    }

    /// The largest gain that a regular division into `parts` could bring at all, eqs. (6), (7).
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] if an exchange area leaves the range of the numbers.
    pub fn maximum_gain(&self, parts: u32) -> Result<S, DiscretizeError> {
        part_exchange::maximum_gain(self, parts)
    }
}

impl<S: Scalar> PartExchange<S> for RectangleSplit<S> {
    fn weights(&self) -> &SplitWeights<S> {
        &self.weights
    }

    fn whole_flux(&self, pair: usize) -> Result<S, DiscretizeError> {
        Ok(self.pairs[pair].exchange_value()?)
    }

    fn flux(&self, pair: usize, [from, to]: &[S; 2]) -> Result<S, DiscretizeError> {
        let part = self.pairs[pair].part(self.axis, from, to)?;
        or_dark(part.exchange_value(), || self.whole_flux(pair), from)
    }

    fn flux_rate(&self, pair: usize, position: &S) -> Result<S, DiscretizeError> {
        Ok(self.pairs[pair].strip_exchange(self.axis, position)?)
    }

    fn share(&self, [from, to]: &[S; 2]) -> S {
        to.clone() - from
    }

    fn share_rate(&self, position: &S) -> S {
        position.constant(1.0)
    }
}

/// The gain of one cut.
///
/// Next to an end the ratio of flux to weight of the small part is a mean of the strips' exchange,
/// so that it lies between the least and the largest of these.
impl Maximand for RectangleSplit {
    fn value<S: Scalar>(&self, x: &S) -> Option<S> {
        self.lifted(x).gain(std::slice::from_ref(x)).ok()
    }

    fn slope<S: Scalar>(&self, x: &S) -> Option<S> {
        let split = self.lifted(x);
        split.gain_derivative(std::slice::from_ref(x), 0).ok()
    }

    /// Encloses the slope on a box X with middle m, where r is the exchange of a strip and G that
    /// of `[0, t]`:
    ///
    /// ```text
    ///   r′(X) ⊂ r′(m) + r″(X) (X − m)
    ///   r(X)  ⊂ r(m) + r′(X) (X − m)
    ///   G(X)  ⊂ G(m) + r(X) (X − m)
    /// ```
    ///
    /// which far from the other patches is much narrower than closed forms of X, whose terms
    /// cancel.
    fn slope_on_box(&self, domain: &Interval<f64>) -> Option<Dual<Interval<f64>>> {
        let middle = Interval::point(domain.midpoint());
        let aside = *domain - middle;
        let (zero, one) = (domain.zero(), domain.constant(1.0));
        let twice = Dual::variable(Dual::variable(*domain));
        let once = Dual::variable(middle);
        let (on_box, at_middle) = (self.lifted(&twice), self.lifted(&once));
        let split = self.lifted(domain);
        let area = Dual::constant_like(&split.weights.area);
        let before = Dual::variable(*domain);
        let after = Dual::constant_like(&one) - before;
        let mut derivative = Dual::constant_like(&zero);
        for (pair, brightness) in split.weights.brightness.iter().enumerate() {
            let wide = on_box.flux_rate(pair, &twice).ok()?;
            let point = at_middle.flux_rate(pair, &once).ok()?;
            let slope = point.slope + wide.slope.slope * aside;
            let value = point.value + slope * aside;
            let rate = Dual { value, slope };
            let moved = value * aside;
            let flux = |part: [Interval<f64>; 2], change: Interval<f64>, slope| {
                let at_middle = split.flux(pair, &part).ok()?;
                let value = at_middle + change;
                Some(Dual { value, slope })
            };
            let near = flux([zero, middle], moved, value)? / (area * before);
            let far = flux([middle, one], -moved, -value)? / (area * after);
            let term = stationarity(&rate, &area, &near, &far);
            derivative = derivative + term * Dual::constant_like(brightness);
        }
        Some(derivative * Dual::constant_like(&split.weights.bits_per_nat()))
    }

    fn slope_near<S: Scalar>(&self, end: EndPoint, distance: &S) -> Option<S> {
        let split = self.lifted(distance);
        let weights = &split.weights;
        let rest = distance.constant(1.0) - distance;
        let position = match end {
            EndPoint::Lower => distance,
            EndPoint::Upper => &rest,
        };
        let mut derivative = distance.zero();
        for (pair, brightness) in weights.brightness.iter().enumerate() {
            let rate = split.flux_rate(pair, position).ok()?;
            let whole = split.whole_flux(pair).ok()?;
            let small = rate.clone() / &weights.area;
            let large = (whole - &(rate.clone() * distance)) / &(rest.clone() * &weights.area);
            let (before, after) = match end {
                EndPoint::Lower => (small, large),
                EndPoint::Upper => (large, small),
            };
            let term = stationarity(&rate, &weights.area, &before, &after);
            derivative = derivative + &(term * brightness);
        }
        Some(derivative * &weights.bits_per_nat())
    }
}
