//! Where a second rectangle lies in the frame of the first.
//!
//! The frame has its origin at the first rectangle's `v0`, axes along its edges u and v, and the
//! third along its normal. If the edges of both run along these axes, the second rectangle is a
//! box that is flat in one of the three directions.
//!
//! All lengths are divided by a power of two near the largest of them, so that squares neither
//! overflow nor underflow; [`Placement::unit`] undoes it exactly.

use super::{GeometryError, Rectangle, Span, SplitAxis};
use crate::numeric::tolerance;

/// The extent of a rectangle along one axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Extent {
    /// It lies in the plane at this coordinate.
    Flat(f64),
    /// It covers this span.
    Long(Span),
}

/// The second rectangle in the first one's frame, in units of [`unit`](Self::unit).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement {
    /// The first rectangle: its extent along u and v.
    pub first: [Span; 2],
    /// The second rectangle's extent along u, v and the normal; [`Extent::Flat`] in one of them.
    pub second: [Extent; 3],
    /// Does the second rectangle's normal point along the axis in which it is flat (else against it)?
    pub faces_along: bool,
    /// Length of one unit of the spans: a power of two.
    pub unit: f64,
}

impl Placement {
    /// Places `second` in the frame of `first`.
    ///
    /// Coordinates within [`tolerance::ALIGNMENT`] of a plane of the frame are put on it, unless all edges run along the
    /// coordinate axes: then coordinates are taken as they are.
    ///
    /// # Errors
    /// [`GeometryError::NotAligned`] if the edges do not run along three common axes;
    /// [`GeometryError::EmptySpan`] if the sizes differ by more than `f64` can hold.
    pub fn try_new(first: &Rectangle, second: &Rectangle) -> Result<Self, GeometryError> {
        if let (Some(axes), Some(others)) = (first.axes(), second.axes()) {
            return Self::along_axes((first, axes), (second, others));
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
        let unit = extent.log2().round().exp2();
        let second = [0, 1, 2].map(|k| {
            let (lower, upper) = ranges[k];
            if k == flat {
                return Ok(Extent::Flat(snap(k, 0.5 * (lower + upper)) / unit));
            }
            // one edge runs along this axis, the other across it: the edge knows its own length best
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

    /// Rectangles with edges along the coordinate axes: nothing is turned, so only differences are rounded.
    fn along_axes(
        (first, axes): (&Rectangle, [usize; 2]),
        (second, others): (&Rectangle, [usize; 2]),
    ) -> Result<Self, GeometryError> {
        let [u, v] = SplitAxis::ALL.map(|axis| first.edge(axis).to_array()[axes[axis as usize]]);
        let [p, q] = SplitAxis::ALL.map(|axis| second.edge(axis).to_array()[others[axis as usize]]);
        // the third axis, and whether two make a right-handed system with it
        let normal = 3 - axes[0] - axes[1];
        let flat = 3 - others[0] - others[1];
        let up = handedness(axes) * u.signum() * v.signum();
        let other_up = handedness(others) * p.signum() * q.signum();
        let frame = [(axes[0], u.signum()), (axes[1], v.signum()), (normal, up)];
        let from_origin = (second.origin() - first.origin()).to_array();
        let lengths = [u.abs(), v.abs()];
        let starts = frame.map(|(k, sign)| sign * from_origin[k]);
        let sides = frame.map(|(k, sign)| {
            let side = if k == others[0] { p } else { q };
            if k == flat { 0.0 } else { sign * side }
        });
        let extent = (0..3)
            .flat_map(|k| [starts[k].abs(), (starts[k] + sides[k]).abs()])
            .chain(lengths)
            .fold(0.0, f64::max);
        // the power of two at or below it
        let unit = f64::from_bits(extent.to_bits() & 0x7ff0_0000_0000_0000);
        let extent_along = |k: usize| {
            if frame[k].0 == flat {
                return Ok(Extent::Flat(starts[k] / unit));
            }
            let lower = if sides[k] < 0.0 {
                starts[k] + sides[k]
            } else {
                starts[k]
            };
            Span::with_length(lower / unit, sides[k].abs() / unit).map(Extent::Long)
        };
        let faces = frame
            .iter()
            .find(|(k, _)| *k == flat)
            .map_or(1.0, |(_, sign)| *sign);
        Ok(Self {
            first: [
                Span::with_length(0.0, lengths[0] / unit)?,
                Span::with_length(0.0, lengths[1] / unit)?,
            ],
            second: [extent_along(0)?, extent_along(1)?, extent_along(2)?],
            faces_along: faces * other_up > 0.0,
            unit,
        })
    }
}

/// +1 if the third axis follows these two as z follows x and y, else −1.
const fn handedness([a, b]: [usize; 2]) -> f64 {
    if (b + 3 - a) % 3 == 1 { 1.0 } else { -1.0 }
}
