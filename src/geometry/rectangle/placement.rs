//! The place of a second rectangle in the frame of the first.
//!
//! The frame has its origin at the first rectangle's `v0`, axes along its edges u and v, and the
//! third along its normal. If the edges of both run along these axes, the second rectangle is a
//! box that is flat in one of the three directions.
//!
//! All lengths are divided by a power of two near the largest of them, so that squares neither
//! overflow nor underflow; [`Placement::unit`] undoes it exactly.

use crate::geometry::{AlignedRectangle, GeometryError, Rectangle, Span, SplitAxis};
use crate::numeric::{power_of_two_below, power_of_two_near, tolerance};

/// The extent of a rectangle along one axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Extent {
    /// The rectangle lies in the plane at this coordinate.
    Flat(f64),
    /// The rectangle covers this span.
    Long(Span),
}

/// The second rectangle in the first one's frame, in units of [`unit`](Self::unit).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement {
    /// The first rectangle: its extent along u and v.
    pub first: [Span; 2],
    /// The second rectangle's extent along u, v and the normal; [`Extent::Flat`] in one of them.
    pub second: [Extent; 3],
    /// Whether the second rectangle's normal points along the axis in which it is flat (else
    /// against it).
    pub faces_along: bool,
    /// Length of one unit of the spans: a power of two.
    pub unit: f64,
}

impl Placement {
    /// Places `second` in the frame of `first`.
    ///
    /// Coordinates within [`tolerance::ALIGNMENT`] of a plane of the frame are put on it, unless
    /// all edges run along the coordinate axes: then coordinates are taken as they are.
    ///
    /// # Errors
    /// [`GeometryError::NotAligned`] if the edges do not run along three common axes;
    /// [`GeometryError::EmptySpan`] if the sizes differ by more than `f64` can hold.
    pub fn try_new(first: &Rectangle, second: &Rectangle) -> Result<Self, GeometryError> {
        if let (Some(first), Some(second)) = (first.aligned(), second.aligned()) {
            return Self::along_axes(&first, &second);
        }
        let lengths = SplitAxis::ALL.map(|axis| first.edge(axis).length());
        let axes = [
            first.edge(SplitAxis::U) / lengths[0],
            first.edge(SplitAxis::V) / lengths[1],
            first.normal(),
        ];
        let seen = second.corners().map(|corner| {
            let from_origin = corner - first.origin();
            axes.map(|axis| from_origin.dot(axis))
        });
        let corners = || first.corners().into_iter().chain(second.corners());
        let largest = corners().map(|c| c.abs().max_element()).fold(0.0, f64::max);
        let allowed = tolerance::ALIGNMENT * largest;

        let normal = second.normal();
        let turned = axes.map(|axis| normal.dot(axis));
        let flat = (0..3).fold(0, |best, k| {
            if turned[k].abs() > turned[best].abs() {
                k
            } else {
                best
            }
        });
        let ranges = [0, 1, 2].map(|k| {
            let coordinates = seen.map(|corner| corner[k]);
            let lower = coordinates.into_iter().fold(f64::INFINITY, f64::min);
            let upper = coordinates.into_iter().fold(f64::NEG_INFINITY, f64::max);
            (lower, upper)
        });
        // every corner must lie at an end of every range, and the flat range must be flat
        let off = |corner: &[f64; 3], k: usize| {
            let to_ends = (corner[k] - ranges[k].0).min(ranges[k].1 - corner[k]);
            if k == flat {
                ranges[k].1 - ranges[k].0
            } else {
                to_ends
            }
        };
        let deviation = seen
            .iter()
            .flat_map(|corner| (0..3).map(move |k| off(corner, k)))
            .fold(0.0, f64::max);
        // a direction is known from an edge no better than its corners over its length
        let reach = seen
            .iter()
            .flatten()
            .fold(0.0, |most: f64, x| most.max(x.abs()));
        let shortest = lengths.into_iter().fold(f64::INFINITY, f64::min);
        let aligned = allowed * f64::max(1.0, reach / shortest);
        if deviation > aligned || deviation.is_nan() {
            return Err(GeometryError::NotAligned {
                deviation,
                allowed: aligned,
            });
        }
        let planes = |k: usize| [0.0, lengths.get(k).copied().unwrap_or(0.0)];
        let snap = |k: usize, value: f64| {
            planes(k)
                .into_iter()
                .find(|plane| (value - plane).abs() <= allowed)
                .unwrap_or(value)
        };
        let extent = ranges
            .iter()
            .flat_map(|(lower, upper)| [lower.abs(), upper.abs()])
            .chain(lengths)
            .fold(0.0, f64::max);
        let unit = power_of_two_near(extent);
        let second = [0, 1, 2].map(|k| {
            let (lower, upper) = ranges[k];
            if k == flat {
                return Ok(Extent::Flat(snap(k, 0.5 * (lower + upper)) / unit));
            }
            // one edge runs along this axis, the other across it: the edge knows its own length
            // best
            let along = SplitAxis::ALL.map(|axis| second.edge(axis).dot(axes[k]).abs());
            let length = along[0].max(along[1]) / unit;
            Span::with_length(snap(k, lower) / unit, length).map(Extent::Long)
        });
        let [u, v, height] = second;
        let [length_u, length_v] = lengths;
        Ok(Self {
            first: [
                Span::with_length(0.0, length_u / unit)?,
                Span::with_length(0.0, length_v / unit)?,
            ],
            second: [u?, v?, height?],
            faces_along: turned[flat] > 0.0,
            unit,
        })
    }

    /// Rectangles with edges along the coordinate axes: nothing is turned, so only differences are
    /// rounded.
    ///
    /// # Errors
    /// [`GeometryError::EmptySpan`] if the sizes differ by more than `f64` can hold.
    #[inline(always)]
    pub fn along_axes(
        first: &AlignedRectangle,
        second: &AlignedRectangle,
    ) -> Result<Self, GeometryError> {
        let (axes, flat) = (first.axes, second.axes[2]);
        let along = |k: usize| {
            let (axis, sign) = (axes[k], first.signs[k]);
            let start = sign * (second.origin[axis] - first.origin[axis]);
            (start, sign * second.sides[axis])
        };
        let places = [along(0), along(1), along(2)];
        let lengths = [first.sides[axes[0]].abs(), first.sides[axes[1]].abs()];
        let mut extent = lengths[0].max(lengths[1]);
        for (start, side) in places {
            extent = extent.max(start.abs()).max((start + side).abs());
        }
        // a unit and its inverse: a product with that is as exact as a quotient
        let unit = power_of_two_below(extent);
        let inverse = 1.0 / unit;
        let extent_along = |k: usize| {
            let (start, side) = places[k];
            if axes[k] == flat {
                return Ok(Extent::Flat(start * inverse));
            }
            let lower = if side < 0.0 { start + side } else { start };
            Span::with_length(lower * inverse, side.abs() * inverse).map(Extent::Long)
        };
        let faces = first.signs[if axes[0] == flat {
            0
        } else if axes[1] == flat {
            1
        } else {
            2
        }];
        Ok(Self {
            first: [
                Span::with_length(0.0, lengths[0] * inverse)?,
                Span::with_length(0.0, lengths[1] * inverse)?,
            ],
            second: [extent_along(0)?, extent_along(1)?, extent_along(2)?],
            faces_along: faces * second.signs[2] > 0.0,
            unit,
        })
    }
}
