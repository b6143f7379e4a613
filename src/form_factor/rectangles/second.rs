//! The second of two rectangles, as the first one sees it.

use super::perpendicular::Plate;
use crate::form_factor::FormFactorError;
use crate::geometry::{Extent, Placement, Span, SplitAxis};
use crate::numeric::Scalar;

/// The second rectangle in the first one's frame, already clipped to its front.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Second<S> {
    /// Nothing of it is visible from anywhere on the first one's plane.
    Dark,
    /// The second rectangle lies in a parallel plane.
    Parallel { spans: [Span<S>; 2], distance: S },
    /// The second rectangle lies in the plane where the coordinate along `across` is `plane`; its
    /// front is where that coordinate is larger (`faces_along`) or smaller. Its width runs along
    /// the other axis.
    Perpendicular {
        across: SplitAxis,
        plane: S,
        faces_along: bool,
        plate: Plate<S>,
    },
}

impl Second<f64> {
    /// Lifts the rectangle to numbers of the type and precision of `like`.
    pub(super) fn lifted<S: Scalar>(&self, like: &S) -> Second<S> {
        match self {
            Self::Dark => Second::Dark,
            Self::Parallel { spans, distance } => Second::Parallel {
                spans: spans.map(|span| span.lifted(like)),
                distance: like.constant(*distance),
            },
            Self::Perpendicular {
                across,
                plane,
                faces_along,
                plate,
            } => Second::Perpendicular {
                across: *across,
                plane: like.constant(*plane),
                faces_along: *faces_along,
                plate: plate.lifted(like),
            },
        }
    }
}

impl TryFrom<&Placement> for Second<f64> {
    type Error = FormFactorError;

    #[inline(always)]
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

/// The axis of a rectangle that is not this one.
#[inline(always)]
pub(super) const fn other(axis: SplitAxis) -> SplitAxis {
    match axis {
        SplitAxis::U => SplitAxis::V,
        SplitAxis::V => SplitAxis::U,
    }
}
