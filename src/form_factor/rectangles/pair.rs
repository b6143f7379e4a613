//! The choice of the closed form that two rectangles need, and of the parts of them that exchange
//! nothing.
//!
//! Coplanar and back-facing rectangles exchange nothing; a rectangle that reaches behind the
//! other's plane is clipped there, which for edges along common axes shortens one side.
//!
//! **Not covered**: rectangles turned against each other; occlusion.

use super::far::exchange_by_rules;
use super::layout::Layout;
use super::parallel::strip_exchange;
use super::perpendicular::{strip_exchange_at_depth, strip_exchange_at_width};
use super::rounded_ends::rounding_of_ends;
use super::second::{Second, other};
use crate::form_factor::{Exchange, ExchangeArea, FormFactorError};
use crate::geometry::{
    AlignedRectangle, GeometryError, Offsets, Placement, Rectangle, Span, SplitAxis,
};
use crate::numeric::{Scalar, vectorised};

/// Two rectangles with edges along three common axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RectanglePair<S = f64> {
    first: [Span<S>; 2],
    second: Second<S>,
    unit: f64,
}

impl RectanglePair {
    /// Recognises the configuration.
    ///
    /// # Errors
    /// [`FormFactorError::Geometry`] if the edges do not run along three common axes.
    pub fn try_new(first: &Rectangle, second: &Rectangle) -> Result<Self, FormFactorError> {
        Self::placed(&Placement::try_new(first, second)?)
    }

    /// The pair of two rectangles with edges along the coordinate axes.
    #[inline(always)]
    pub(crate) fn along_axes(
        first: &AlignedRectangle,
        second: &AlignedRectangle,
    ) -> Result<Self, FormFactorError> {
        Self::placed(&Placement::along_axes(first, second)?)
    }

    #[inline(always)]
    fn placed(placement: &Placement) -> Result<Self, FormFactorError> {
        Ok(Self {
            first: placement.first,
            second: Second::try_from(placement)?,
            unit: placement.unit,
        })
    }

    /// The exchange area, with a bound on its error.
    ///
    /// Sides are meant from their lower ends over their lengths. The closed form takes the upper
    /// ends as rounded, and the bound covers that: where a side ends beside the other rectangle's,
    /// its rounding is much of the little distance between them.
    ///
    /// # Errors
    /// [`FormFactorError::OutOfRange`] if the value leaves the range of `f64`;
    /// [`FormFactorError::NotResolved`] if rounding leaves no correct digit.
    pub fn exchange_area(&self) -> Result<ExchangeArea, FormFactorError> {
        let exchange = vectorised(
            #[inline(always)]
            || self.closed_form(),
        )?;
        let value = exchange.value;
        let error =
            exchange.error + rounding_of_ends(&self.first, &self.second) * (self.unit * self.unit);
        if value > error || exchange == ExchangeArea::NOTHING {
            Ok(ExchangeArea { value, error })
        } else {
            Err(FormFactorError::NotResolved { value, error })
        }
    }

    /// [`exchange_area`](Self::exchange_area) of the ends as given, to be called where vector code
    /// is made.
    #[inline(always)]
    pub(crate) fn closed_form(&self) -> Result<ExchangeArea, FormFactorError> {
        match self.exchange()? {
            Some(exchange) => exchange.resolved(self.unit * self.unit),
            None => Ok(ExchangeArea::NOTHING),
        }
    }

    /// The exchange area by Gauss rules along the sides, if few points are certain to leave a
    /// relative error below `tolerance`: for rectangles far from each other.
    pub(crate) fn exchange_by_rules(&self, tolerance: f64) -> Option<ExchangeArea> {
        let exchange = self.with_layout(|layout| exchange_by_rules(layout, tolerance));
        let exchange = exchange.ok()???;
        let unit_area = self.unit * self.unit;
        let [value, error] = [exchange.value, exchange.error].map(|x| x * unit_area);
        (value.is_normal() && error.is_finite()).then_some(ExchangeArea { value, error })
    }

    /// Lifts the pair, as placed, to numbers of the type and precision of `like`.
    #[must_use]
    pub fn lifted<S: Scalar>(&self, like: &S) -> RectanglePair<S> {
        RectanglePair {
            first: self.first.map(|span| span.lifted(like)),
            second: self.second.lifted(like),
            unit: self.unit,
        }
    }
}

impl<S: Scalar> RectanglePair<S> {
    /// The exchange area in any number type: over intervals an enclosure.
    ///
    /// # Errors
    /// [`FormFactorError::OutOfRange`] if the value leaves the range or has no bounds;
    /// [`FormFactorError::NotResolved`] if rounding leaves no correct digit.
    pub fn exchange_value(&self) -> Result<S, FormFactorError> {
        let exchange = S::vectorised(
            #[inline(always)]
            || self.exchange(),
        );
        match exchange? {
            Some(exchange) => self.in_range(exchange.certain()?),
            None => Ok(self.first[0].lower().zero()),
        }
    }

    /// The pair in which the first rectangle is only its part between two relative positions.
    ///
    /// # Errors
    /// [`FormFactorError::Geometry`] unless `0 ≤ from < to ≤ 1`.
    pub fn part(&self, axis: SplitAxis, from: &S, to: &S) -> Result<Self, FormFactorError> {
        for position in [from, to] {
            relative(position)?;
        }
        let mut part = self.clone();
        part.first[axis as usize] = self.first[axis as usize].part(from, to)?;
        Ok(part)
    }

    /// The derivative of the exchange area of the part `[0, position]` by `position`: what a strip
    /// across `axis` exchanges, per relative width.
    ///
    /// **Arguments** `position` in `[0, 1]`.
    ///
    /// # Errors
    /// [`FormFactorError::Geometry`] if the position is not in `[0, 1]`;
    /// [`FormFactorError::OutOfRange`] if the value leaves the range of `f64`.
    pub fn strip_exchange(&self, axis: SplitAxis, position: &S) -> Result<S, FormFactorError> {
        relative(position)?;
        let along = &self.first[axis as usize];
        let at = along.length().clone() * position + along.lower();
        let across = &self.first[other(axis) as usize];
        let exchange = match &self.second {
            Second::Dark => return Ok(position.zero()),
            Second::Parallel { spans, distance } => {
                let [u, v] = spans.clone();
                let spans = if axis == SplitAxis::U { [u, v] } else { [v, u] };
                strip_exchange(&at, across, &spans, distance)?
            }
            Second::Perpendicular {
                across: normal,
                plane,
                faces_along,
                plate,
            } => {
                if axis == *normal {
                    let depth = if *faces_along {
                        at - plane
                    } else {
                        plane.clone() - &at
                    };
                    if depth < depth.zero() {
                        return Ok(position.zero());
                    }
                    in_front(&depth)?;
                    strip_exchange_at_depth(
                        &depth,
                        plate.depth(),
                        &Offsets::between(across, plate.width()),
                    )
                } else {
                    match self.depth(*normal, plane, *faces_along)? {
                        Some(depth) => {
                            let width = plate.width();
                            let offsets =
                                [width.lower(), width.upper()].map(|end| at.clone() - end);
                            strip_exchange_at_width([&depth, plate.depth()], &offsets)
                        }
                        None => return Ok(position.zero()),
                    }
                }
            }
        };
        self.in_range(exchange.value * along.length())
    }

    /// The sum over corners in units of the frame; `None` if nothing is exchanged. To be called
    /// where vector code is made.
    #[inline(always)]
    fn exchange(&self) -> Result<Option<Exchange<S>>, FormFactorError> {
        let exchange = self.with_layout(
            #[inline(always)]
            |layout| layout.form().map(Some),
        );
        exchange?.unwrap_or(Ok(None))
    }

    /// Hands over the layout of what faces each other, in units of the frame; `None` if there is
    /// nothing.
    #[inline(always)]
    fn with_layout<T>(
        &self,
        answer: impl FnOnce(&Layout<S>) -> T,
    ) -> Result<Option<T>, FormFactorError> {
        match &self.second {
            Second::Dark => Ok(None),
            Second::Parallel {
                spans: [xi, eta],
                distance,
            } => {
                let [x, y] = &self.first;
                Ok(Some(answer(&Layout::Parallel {
                    spans: [[x, xi], [y, eta]],
                    distance,
                })))
            }
            Second::Perpendicular {
                across,
                plane,
                faces_along,
                plate,
            } => match self.depth(*across, plane, *faces_along)? {
                Some(depth) => {
                    let widths = [&self.first[other(*across) as usize], plate.width()];
                    Ok(Some(answer(&Layout::Perpendicular {
                        depths: [&depth, plate.depth()],
                        widths,
                        offsets: &Offsets::between(widths[0], widths[1]),
                    })))
                }
                None => Ok(None),
            },
        }
    }

    /// Converts a value to squared units of length, if it stays a number.
    fn in_range(&self, value: S) -> Result<S, FormFactorError> {
        let value = value.clone() * &value.constant(self.unit * self.unit);
        if value.to_f64().is_finite() {
            Ok(value)
        } else {
            Err(FormFactorError::OutOfRange {
                value: value.to_f64(),
            })
        }
    }

    /// The part of the first rectangle in front of the second one's plane, as distances from it.
    #[inline(always)]
    fn depth(
        &self,
        across: SplitAxis,
        plane: &S,
        faces_along: bool,
    ) -> Result<Option<Span<S>>, FormFactorError> {
        let extent = &self.first[across as usize];
        let depth = if faces_along {
            extent.shifted(&-plane.clone())
        } else {
            extent.mirrored(plane)
        };
        let zero = plane.zero();
        let top = depth.upper();
        if (-top.clone()).is_nonnegative() {
            return Ok(None);
        }
        in_front(top)?;
        if *depth.lower() < zero {
            // clipped: what is left must certainly be something
            let is_left = *top > zero;
            if !is_left {
                let depth = top.to_f64();
                return Err(FormFactorError::Astride { depth });
            }
        } else {
            in_front(depth.lower())?;
        }
        Ok(depth.above(&zero))
    }
}

/// Refuses a position that is certainly not in `[0, 1]`.
fn relative<S: Scalar>(position: &S) -> Result<(), GeometryError> {
    let number = position.to_f64();
    if *position < position.zero() || *position > position.constant(1.0) || number.is_nan() {
        return Err(GeometryError::PositionOutOfRange {
            position: number,
            lower: 0.0,
            upper: 1.0,
        });
    }
    Ok(())
}

/// Refuses a depth that may be in front of a plane or behind it.
#[inline(always)]
fn in_front<S: Scalar>(depth: &S) -> Result<(), FormFactorError> {
    if !depth.is_nonnegative() {
        return Err(FormFactorError::Astride {
            depth: depth.to_f64(),
        });
    }
    Ok(())
}
