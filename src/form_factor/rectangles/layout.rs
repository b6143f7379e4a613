//! Two rectangles with edges along common axes, parallel or perpendicular, and their closed form.
//!
//! ```text
//!   parallel         spans [x, ξ] and [y, η] on two common axes, z apart
//!   perpendicular    a depth each over the line in which the planes meet, spans [y, η] along it
//! ```
//!
//! **Not covered**: what of a rectangle is behind the other one's plane;
//! [`RectanglePair`](crate::form_factor::RectanglePair) clips it.

use super::corner_sum::Exchange;
use super::{parallel, perpendicular};
use crate::form_factor::FormFactorError;
use crate::geometry::{Offsets, Span};
use crate::numeric::Scalar;

/// The places of two rectangles that face each other, in any one unit.
#[derive(Debug)]
pub(crate) enum Layout<'a, S> {
    /// Rectangles in parallel planes.
    Parallel {
        /// The spans of both on each common axis, those of the first rectangle first.
        spans: [[&'a Span<S>; 2]; 2],
        /// The distance between the planes, > 0.
        distance: &'a S,
    },
    /// Rectangles in perpendicular planes.
    Perpendicular {
        /// The distances of each from the other one's plane, ≥ 0.
        depths: [&'a Span<S>; 2],
        /// The spans along the line in which the planes meet.
        widths: [&'a Span<S>; 2],
        /// The differences of these spans' ends.
        offsets: &'a Offsets<S>,
    },
}

impl<S: Scalar> Layout<'_, S> {
    /// The product of both areas.
    pub(crate) fn areas(&self) -> S {
        let product = |[one, other]: &[&Span<S>; 2]| one.length().clone() * other.length();
        match self {
            Self::Parallel { spans: [u, v], .. } => product(u) * &product(v),
            Self::Perpendicular { depths, widths, .. } => {
                let [first, second] = depths.map(Span::length);
                product(widths) * first * second
            }
        }
    }

    /// The exchange area in closed form, in squared units of the spans.
    ///
    /// # Errors
    /// [`FormFactorError::NonPositiveLength`] if the distance is not finite and > 0.
    pub(crate) fn closed_form(&self) -> Result<Exchange<S>, FormFactorError> {
        S::vectorised(
            #[inline(always)]
            || self.form(),
        )
    }

    /// [`closed_form`](Self::closed_form), to be called where vector code is made.
    #[inline(always)]
    pub(crate) fn form(&self) -> Result<Exchange<S>, FormFactorError> {
        match self {
            Self::Parallel {
                spans: [[x, xi], [y, eta]],
                distance,
            } => parallel::form([x, y], [xi, eta], distance),
            Self::Perpendicular {
                depths, offsets, ..
            } => Ok(perpendicular::form(*depths, offsets)),
        }
    }
}
