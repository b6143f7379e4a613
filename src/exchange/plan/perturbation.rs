//! Bounds on the change of an exchange area when corners move by little.
//!
//! ```text
//!   |Δ(A F)| ≤ swept(Q) · E_P + swept(P) · E_Q,    E_P ≤ min(1, A_P h_P h_Q / (π r⁴))
//! ```
//!
//! `A F` is the flux that P (of exitance 1) sends through Q. Where an edge of Q moves in its own
//! plane, the flux changes by what passes the strip it sweeps: the strip's area times the
//! irradiance from P, which is at most 1, and at most the kernel `cos cos / (π r²)` times the area
//! of P, with r at least the distance of the two, the cosines at most the largest heights `h` of
//! either over the other's plane, over r. The same holds with P and Q exchanged. Where the plane
//! itself moves (parallel rectangles), the strip is a wall between the old and the new boundary,
//! one of the cosines is at most 1, and there are no sources in the space between.
//!
//! Two axis-parallel pairs put together at both planes, or at P's plane, and at the lower end of P
//! on the other axes: if their differences of lines are equal within `ω`, the ends of P move by at
//! most `ω`, those of Q by `ω` and `2 ω`. So edges sweep at most `3/2 ω` times the perimeter.

use crate::geometry::Patch;
use crate::numeric::tolerance;
use glam::DVec3;
use std::f64::consts::PI;

/// Part of the perimeter, in units of the spread, that edges sweep.
const SWEPT: f64 = 1.5;

/// A bound on the difference of the exchange areas of two pairs whose differences of lines differ
/// by `spread`.
pub(crate) fn allowance(spread: f64, first: &Patch, second: &Patch) -> f64 {
    if spread <= 0.0 {
        return 0.0;
    }
    // no nearer while the corners move
    let distance = (gap(first, second) - 4.0 * spread).max(0.0);
    let heights = height(first, second) * height(second, first);
    let irradiance = |from: &Patch| (from.area() * heights / (PI * distance.powi(4))).min(1.0);
    let strips = second.perimeter() * irradiance(first) + first.perimeter() * irradiance(second);
    let is_parallel = first.normal().dot(second.normal()).abs() > 0.5;
    let walls = if is_parallel {
        let height = height(first, second) / distance;
        second.perimeter() * (first.area() * height / (PI * distance.powi(2))).min(1.0)
    } else {
        0.0
    };
    let allowance = spread * (SWEPT * strips + walls);
    if allowance.is_nan() {
        f64::INFINITY
    } else {
        allowance
    }
}

/// Polygons are so many times wider than corners are off, at least.
const WIDEST: f64 = 1e6;

/// A bound on the difference of the exchange areas of two pairs of polygons, put together by a
/// motion or reflection, whose corners are within `offset` of each other along each axis; infinite
/// where there is none.
///
/// One is moved along its normal, by a height that is linear over it, then in its plane, and so is
/// the other. Strips and walls are as above. Where the plane of one cuts the other, the line of the
/// cut moves by no more than the corners do over the sine of the angle between the two, and
/// receives something only where it runs through the first: along half its perimeter at most.
pub(crate) fn corner_allowance(offset: f64, first: &Patch, second: &Patch) -> f64 {
    if offset <= 0.0 {
        return 0.0;
    }
    let moved = tolerance::SQRT_3 * offset;
    if first.width().min(second.width()) < WIDEST * moved {
        return f64::INFINITY;
    }
    let reach = 4.0 * moved;
    let distance = (gap(first, second) - reach).max(0.0);
    let heights = [height(first, second), height(second, first)].map(|height| height + reach);
    let received = |from: &Patch, height: f64| {
        let area = from.area();
        let strip = (area * heights[0] * heights[1] / (PI * distance.powi(4))).min(1.0);
        strip + (area * height / (PI * distance.powi(3))).min(1.0)
    };
    let mut strips = second.perimeter() * received(first, heights[1])
        + first.perimeter() * received(second, heights[0]);
    if distance <= 0.0 {
        let sine = first.normal().cross(second.normal()).length();
        strips += first.perimeter().min(second.perimeter()) / (sine - reach).max(0.0);
    }
    // areas, perimeters and heights change by less while corners move
    let allowance = (1.0 + 1e-4) * moved * strips;
    if allowance.is_nan() {
        f64::INFINITY
    } else {
        allowance
    }
}

/// A bound on the change of an exchange area when one of the two is moved by up to `distance` along
/// its normal: what passes the walls between its old and its new boundary, which are in front of no
/// more than all of the other.
pub(crate) fn shift_allowance(distance: f64, moved: &Patch, other: &Patch) -> f64 {
    let nearest = (gap(moved, other) - distance).max(0.0);
    let irradiance = (other.area() / (PI * nearest.powi(2))).min(1.0);
    distance * moved.perimeter() * irradiance
}

/// The largest height of a patch over the plane of another, at least 0.
fn height(patch: &Patch, plane: &Patch) -> f64 {
    let heights = patch
        .corners()
        .iter()
        .map(|corner| plane.normal().dot(*corner - plane.corners()[0]));
    heights.fold(0.0, f64::max)
}

/// A lower bound on the distance of two patches: that of the boxes around them.
fn gap(first: &Patch, second: &Patch) -> f64 {
    let ends = |patch: &Patch| {
        let ends = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        patch
            .corners()
            .iter()
            .fold(ends, |(lower, upper), c| (lower.min(*c), upper.max(*c)))
    };
    let ((lower, upper), (other_lower, other_upper)) = (ends(first), ends(second));
    (other_lower - upper)
        .max(lower - other_upper)
        .max(DVec3::ZERO)
        .length()
}
