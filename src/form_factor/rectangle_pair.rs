//! Which closed form two rectangles need, and what of them is not needed at all.
//!
//! Coplanar and back-facing rectangles exchange nothing; a rectangle that reaches behind the
//! other's plane is clipped there, which for edges along common axes shortens one side.
//!
//! **Not covered**: rectangles turned against each other; occlusion.

use super::parallel::{self, strip_exchange};
use super::perpendicular::{self, Plate, strip_exchange_at_depth, strip_exchange_at_width};
use super::{ExchangeArea, FormFactorError};
use crate::geometry::{Extent, GeometryError, Placement, Rectangle, Span, SplitAxis};

/// Two rectangles with edges along three common axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RectanglePair {
    first: [Span; 2],
    second: Second,
    unit: f64,
}

/// The second rectangle in the first one's frame, already clipped to its front.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Second {
    /// Nothing of it is visible from anywhere on the first one's plane.
    Dark,
    /// In a parallel plane.
    Parallel { spans: [Span; 2], distance: f64 },
    /// In the plane where the coordinate along `across` is `plane`; its front is where that
    /// coordinate is larger (`faces_along`) or smaller. Its width runs along the other axis.
    Perpendicular {
        across: SplitAxis,
        plane: f64,
        faces_along: bool,
        plate: Plate,
    },
}

impl RectanglePair {
    /// Recognises the configuration.
    ///
    /// # Errors
    /// [`FormFactorError::Geometry`] if the edges do not run along three common axes.
    pub fn try_new(first: &Rectangle, second: &Rectangle) -> Result<Self, FormFactorError> {
        let placement = Placement::try_new(first, second)?;
        Ok(Self {
            first: placement.first,
            second: Second::try_from(&placement)?,
            unit: placement.unit,
        })
    }

    /// The exchange area, with a bound on its error.
    ///
    /// # Errors
    /// [`FormFactorError::OutOfRange`] if the value leaves the range of `f64`;
    /// [`FormFactorError::NotResolved`] if rounding leaves no correct digit.
    pub fn exchange_area(&self) -> Result<ExchangeArea, FormFactorError> {
        let exchange = match &self.second {
            Second::Dark => {
                return Ok(ExchangeArea {
                    value: 0.0,
                    error_bound: 0.0,
                });
            }
            Second::Parallel { spans, distance } => {
                parallel::exchange_area(&self.first, spans, distance)?
            }
            Second::Perpendicular {
                across,
                plane,
                faces_along,
                plate,
            } => {
                let depth = self.depth(*across, *plane, *faces_along);
                let Some(depth) = depth.above(&0.0) else {
                    return Ok(ExchangeArea {
                        value: 0.0,
                        error_bound: 0.0,
                    });
                };
                let width = self.first[other(*across) as usize];
                perpendicular::exchange_area(&Plate::try_new(depth, width)?, plate)
            }
        };
        exchange.resolved(self.unit * self.unit)
    }

    /// The pair in which the first rectangle is only its part between two relative positions.
    ///
    /// # Errors
    /// [`FormFactorError::Geometry`] unless `0 ≤ from < to ≤ 1`.
    pub fn part(&self, axis: SplitAxis, from: f64, to: f64) -> Result<Self, FormFactorError> {
        for position in [from, to] {
            relative(position)?;
        }
        let mut part = *self;
        part.first[axis as usize] = self.first[axis as usize].part(&from, &to)?;
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
    pub fn strip_exchange(&self, axis: SplitAxis, position: f64) -> Result<f64, FormFactorError> {
        relative(position)?;
        let along = self.first[axis as usize];
        let at = along.lower() + position * along.length();
        let across = self.first[other(axis) as usize];
        let exchange = match &self.second {
            Second::Dark => return Ok(0.0),
            Second::Parallel { spans, distance } => {
                let [u, v] = *spans;
                let spans = if axis == SplitAxis::U { [u, v] } else { [v, u] };
                strip_exchange(&at, &across, &spans, distance)?
            }
            Second::Perpendicular {
                across: normal,
                plane,
                faces_along,
                plate,
            } => {
                if axis == *normal {
                    let depth = if *faces_along { at - plane } else { plane - at };
                    if depth < 0.0 {
                        return Ok(0.0);
                    }
                    strip_exchange_at_depth(&depth, &across, plate)
                } else {
                    let depth = self.depth(*normal, *plane, *faces_along);
                    let Some(depth) = depth.above(&0.0) else {
                        return Ok(0.0);
                    };
                    strip_exchange_at_width(&depth, &at, plate)
                }
            }
        };
        Ok(exchange.in_range(self.unit * self.unit)?.value * along.length())
    }

    /// The first rectangle's extent as a distance in front of the second one's plane.
    fn depth(&self, across: SplitAxis, plane: f64, faces_along: bool) -> Span {
        let extent = self.first[across as usize];
        if faces_along {
            extent.shifted(&-plane)
        } else {
            extent.mirrored(&plane)
        }
    }
}

impl TryFrom<&Placement> for Second {
    type Error = FormFactorError;

    fn try_from(placement: &Placement) -> Result<Self, FormFactorError> {
        let perpendicular = |across, plane, width, height: Span| {
            Ok(match height.above(&0.0) {
                None => Self::Dark,
                Some(depth) => Self::Perpendicular {
                    across,
                    plane,
                    faces_along: placement.faces_along,
                    plate: Plate::try_new(depth, width)?,
                },
            })
        };
        match placement.second {
            [Extent::Long(u), Extent::Long(v), Extent::Flat(distance)]
                if distance > 0.0 && !placement.faces_along =>
            {
                Ok(Self::Parallel {
                    spans: [u, v],
                    distance,
                })
            }
            [
                Extent::Flat(plane),
                Extent::Long(width),
                Extent::Long(height),
            ] => perpendicular(SplitAxis::U, plane, width, height),
            [
                Extent::Long(width),
                Extent::Flat(plane),
                Extent::Long(height),
            ] => perpendicular(SplitAxis::V, plane, width, height),
            // coplanar, behind, or turned away
            _ => Ok(Self::Dark),
        }
    }
}

fn relative(position: f64) -> Result<(), GeometryError> {
    let (lower, upper) = (0.0, 1.0);
    if (lower..=upper).contains(&position) {
        Ok(())
    } else {
        Err(GeometryError::PositionOutOfRange {
            position,
            lower,
            upper,
        })
    }
}

const fn other(axis: SplitAxis) -> SplitAxis {
    match axis {
        SplitAxis::U => SplitAxis::V,
        SplitAxis::V => SplitAxis::U,
    }
}
