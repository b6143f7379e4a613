//! The exact value of an exchange area, to judge computed ones by.
//!
//! Aligned rectangles whose coordinates are exact in a common frame: the closed form's enclosure
//! with 256 bits. All other polygons: the slow [reference](mod@super::exchange), with significands
//! of 256 bits and an error *estimate* of 1e-18, no bound. Both are of the corners as they are in
//! `f64`. What is seen past others comes from other places of this room.

use super::exchange as reference;
use crate::form_factor::{FormFactorError, Polygon, RectanglePair, Route};
use crate::geometry::{Patch, Rectangle};
use crate::numeric::{DoubleDouble, Interval, Scalar};

/// Bits of the enclosures.
pub(super) const BITS: u32 = 256;
/// Relative error asked of the reference, a hundredth of what a double can show.
const REFERENCE: f64 = 1e-18;

/// An exchange area with many digits.
#[derive(Debug, Clone)]
pub struct Truth {
    value: Interval,
    /// The uncertainty relative to the value.
    uncertainty: f64,
    origin: &'static str,
}

impl Truth {
    /// Computes the exchange area of the corners as given.
    ///
    /// # Errors
    /// [`FormFactorError`] if the value leaves the range of `f64`.
    pub fn of([first, second]: &[Patch; 2]) -> Result<Self, FormFactorError> {
        if let Some(pair) = aligned(first, second) {
            return Ok(Self::of_enclosure(enclosed(&pair)?));
        }
        let found = reference::exchange_area(first, second, REFERENCE)?;
        let zero = Interval::precise(0.0, BITS);
        let parts = found.doubles();
        Ok(Self {
            value: parts
                .iter()
                .fold(zero.clone(), |sum, part| sum + &zero.constant(*part)),
            uncertainty: found.estimate(),
            origin: "reference, 256 bits",
        })
    }

    /// Computes it by the contour in double-double, with its bound: hundreds of times faster than
    /// the reference, no judge of itself.
    ///
    /// # Errors
    /// [`FormFactorError`] if the route does not serve the pair.
    pub fn by_double_double(pair: &[Patch; 2]) -> Result<Self, FormFactorError> {
        let [first, second] = pair.each_ref().map(Polygon::new);
        let exchange = first
            .exchange_area_by(Route::DoubleDouble, &second, 0.0)?
            .exchange;
        Ok(Self {
            value: Interval::precise(exchange.value, BITS),
            uncertainty: exchange.error / exchange.value + f64::EPSILON,
            origin: "double-double",
        })
    }

    /// Reads its decimals, with their relative uncertainty; `None` if they are none.
    #[must_use]
    pub fn from_decimals(text: &str, uncertainty: f64) -> Option<Self> {
        Some(Self {
            value: Interval::parse(text, BITS)?,
            uncertainty,
            origin: "decimals",
        })
    }

    /// The truth of an enclosure.
    pub(super) fn of_enclosure(value: Interval) -> Self {
        Self {
            uncertainty: value.width() / value.to_f64(),
            value,
            origin: "enclosure, 256 bits",
        }
    }

    /// Takes the estimate of a slow road past others, in squared units of length.
    #[must_use]
    pub fn by_estimate(value: f64, error: f64) -> Self {
        Self {
            value: Interval::precise(value, BITS),
            uncertainty: error / value,
            origin: "rule over the area",
        }
    }

    /// Multiplies by a number that is exactly this double.
    #[must_use]
    pub fn times(&self, factor: f64) -> Self {
        Self {
            value: self.value.clone() * &self.value.constant(factor),
            ..self.clone()
        }
    }

    /// The value, to the nearest double or the next.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.value.to_f64()
    }

    /// `|value − exact| / exact`, 0 only where they are equal in all digits known.
    #[must_use]
    pub fn relative_error_of(&self, value: f64) -> f64 {
        let error = (self.value.constant(value) - &self.value) / &self.value;
        error.abs().to_f64()
    }

    /// The relative difference to another one.
    #[must_use]
    pub fn relative_difference(&self, other: &Self) -> f64 {
        let difference = (other.value.clone() - &self.value) / &self.value;
        difference.abs().to_f64()
    }

    /// The relative uncertainty of the value: an enclosure's width, a reference's estimate.
    #[must_use]
    pub const fn uncertainty(&self) -> f64 {
        self.uncertainty
    }

    /// The origin of the value.
    #[must_use]
    pub const fn origin(&self) -> &'static str {
        self.origin
    }
}

/// The exchange area of rectangles along common axes.
pub(super) fn enclosed(pair: &RectanglePair) -> Result<Interval, FormFactorError> {
    pair.lifted(&Interval::precise(1.0, BITS)).exchange_value()
}

/// Rectangles along common axes, if placing them rounds nothing.
fn aligned(first: &Patch, second: &Patch) -> Option<RectanglePair> {
    let [one, other] = [first, second].map(|patch| Rectangle::try_from(patch).ok());
    let (one, other) = (one?, other?);
    one.axes().and(other.axes())?;
    let corners = first.corners().iter().chain(second.corners());
    let origin = one.origin().to_array();
    let is_exact = corners.flat_map(|c| c.to_array().into_iter().zip(origin));
    is_exact
        .map(|(x, o)| DoubleDouble::difference(x, o).low())
        .all(|rounding| rounding == 0.0)
        .then(|| RectanglePair::try_new(&one, &other).ok())?
}
