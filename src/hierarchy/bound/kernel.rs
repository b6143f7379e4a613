//! Lower bounds on the kernel between the points of two polygons.
//!
//! ```text
//!   k = a b/(π r⁴)      a, b: the heights of each point over the other's plane, r: their distance
//! ```
//!
//! Heights over planes are least and distances largest at corners, so that
//! `min a · min b/(π max r⁴)` over pairs of corners is below the kernel. It is 0 where the minimum
//! of a height is not positive, and where something may stand between.

use super::sight::{End, Sight};
use crate::hierarchy::Visibility;
use std::f64::consts::PI;

/// A lower bound on the kernel between the points of two polygons.
pub(super) fn least_kernel(first: End<'_>, second: End<'_>, sight: &Sight) -> f64 {
    let kernel = unveiled(first, second);
    if kernel > 0.0 && sight.between([first, second]) == Visibility::Clear {
        kernel
    } else {
        0.0
    }
}

/// A lower bound on the kernel between the points of two polygons, if nothing is in the way.
fn unveiled(first: End<'_>, second: End<'_>) -> f64 {
    let (mut up, mut down, mut farthest) = (f64::MAX, f64::MAX, 0.0f64);
    for x in first.corners {
        for y in second.corners {
            let along = *y - *x;
            up = up.min(along.dot(first.normal));
            down = down.min(-along.dot(second.normal));
            farthest = farthest.max(along.length_squared());
        }
        if up <= 0.0 || down <= 0.0 {
            return 0.0;
        }
    }
    up * down / (PI * farthest * farthest)
}
