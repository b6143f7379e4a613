//! The error that is accepted of a form factor.
//!
//! ```text
//!   a pair is done   ⇔   error of F_ij ≤ max(absolute, relative · F_ij), and so for F_ji
//! ```
//!
//! The larger of the two directions is that from the smaller area, so that exchange areas are
//! judged by `max(absolute · min(A_i, A_j), relative · A_i F_ij)`.
//!
//! Unless it is given, the absolute error is `ε/n` for n rows: all pairs of a row together then
//! change its sum by less than the rounding of the number 1, which no sum can feel.
//!
//! A pair whose form factor cannot be large needs fewer digits for an absolute error. It is bounded
//! beforehand by
//!
//! ```text
//!   A_i F_ij ≤ min(A_i, A_j, A_i A_j / (π d²))        d: the distance of two spheres around them
//! ```
//!
//! and evaluated to the relative error that this leaves. By the default, which is there to judge
//! pairs and not to save time, every pair is evaluated to the relative error.

use crate::form_factor::{DEFAULT_TOLERANCE, ExchangeArea, Polygon};
use std::fmt;

/// The error that is accepted of a form factor: relative to it, or absolute, whichever is larger.
///
/// # Examples
/// ```
/// use infoscene::exchange::{Congruence, ScenePairs, Tolerance};
/// use infoscene::scene::{Occlusion, Scene};
/// let squares = Scene::built_in("two-squares")?;
/// // four digits after the point will do
/// let tolerance = Tolerance { relative: 1e-12, absolute: Some(1e-4) };
/// let pairs = ScenePairs::try_new(&squares, tolerance, Congruence::Shared, Occlusion::Exact)?;
/// assert!(pairs.row_pair(0, 1)?.exchange.error <= 1e-4);
/// # Ok::<(), infoscene::exchange::ExchangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// The error per form factor, > 0.
    pub relative: f64,
    /// The absolute error, ≥ 0; 2⁻⁵² divided by the number of rows if none is given.
    pub absolute: Option<f64>,
}

impl Default for Tolerance {
    /// [`DEFAULT_TOLERANCE`] relative, and no absolute error that a row sum could feel.
    fn default() -> Self {
        DEFAULT_TOLERANCE.into()
    }
}

impl From<f64> for Tolerance {
    /// A relative error.
    fn from(relative: f64) -> Self {
        Self {
            relative,
            absolute: None,
        }
    }
}

impl fmt::Display for Tolerance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:e}", self.relative)?;
        match self.absolute {
            Some(absolute) => write!(f, " relative, {absolute:e} absolute"),
            None => Ok(()),
        }
    }
}

/// The part of an absolute error that is used: the rest is for the rounding of bounds.
const USED: f64 = 0.99;

impl Tolerance {
    /// The absolute error that is accepted in a scene of so many rows.
    #[must_use]
    pub fn absolute_of(&self, rows: usize) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
        let default = f64::EPSILON / rows.max(1) as f64;
        self.absolute.unwrap_or(default)
    }

    /// Tells whether an exchange area is accepted in a scene of so many rows.
    pub(crate) fn accepts(&self, exchange: &ExchangeArea, smaller_area: f64, rows: usize) -> bool {
        exchange.error <= self.relative * exchange.value
            || exchange.error <= self.absolute_of(rows) * smaller_area
    }

    /// The relative error to which a pair of polygons must be evaluated.
    pub(crate) fn relative_of(&self, one: &Polygon, other: &Polygon) -> f64 {
        let Some(absolute) = self.absolute else {
            return self.relative;
        };
        self.relative
            .max(USED * absolute / one.largest_form_factor(other))
    }
}
