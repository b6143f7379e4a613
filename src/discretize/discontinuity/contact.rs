//! The way past blockers that a line of sight touches, if there is one.
//!
//! Seen along the line, each blocker that holds the point fills a sector around it, a half-plane at
//! an edge, all at an inner point. Sectors that fill the whole circle leave no way past.

use super::section::edges;
use crate::geometry::Patch;
use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// Angles below this are 0.
const SMALLEST: f64 = 1e-7;

/// The way past blockers at a point, as it is seen along a direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum WayPast {
    /// Blockers are all around.
    None,
    /// One half is free, as beside an edge: if the point is a corner, it is a straight one.
    Half,
    /// Any other part, or parts.
    Other,
}

/// The way past blockers at a point.
pub(super) fn way_past(blockers: &[Patch], at: DVec3, direction: DVec3, noise: f64) -> WayPast {
    let Some(direction) = direction.try_normalize() else {
        return WayPast::Other;
    };
    let (across, up) = direction.any_orthonormal_pair();
    let flat = |arm: DVec3| DVec2::new(arm.dot(across), arm.dot(up));
    let sectors = blockers
        .iter()
        .filter_map(|blocker| sector(blocker, at, direction, noise, &flat));
    let mut sectors: Vec<[f64; 2]> = sectors
        .map(|[from, width]| [from.rem_euclid(TAU), width])
        .collect();
    if sectors.iter().any(|[_, width]| *width >= TAU) {
        return WayPast::None;
    }
    sectors.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let Some([first, _]) = sectors.first().copied() else {
        return WayPast::Other;
    };
    // twice around, as a sector may reach over the start; gaps count the second time
    let mut gaps = Vec::new();
    let mut reached = first;
    for turn in [0.0, TAU] {
        gaps.clear();
        for [from, width] in &sectors {
            let from = from + turn;
            if from > reached + SMALLEST {
                gaps.push(from - reached);
            }
            reached = reached.max(from + width);
        }
    }
    match gaps.as_slice() {
        [] => WayPast::None,
        [gap] if (gap - PI).abs() <= SMALLEST => WayPast::Half,
        _ => WayPast::Other,
    }
}

/// The start and the width of the sector of a blocker around a point; `None` if it does not hold
/// the point, or is seen edge-on.
fn sector(
    blocker: &Patch,
    at: DVec3,
    direction: DVec3,
    noise: f64,
    flat: &dyn Fn(DVec3) -> DVec2,
) -> Option<[f64; 2]> {
    let normal = blocker.normal();
    let facing = normal.dot(direction);
    let height = (at - blocker.corners()[0]).dot(normal);
    if facing.abs() < SMALLEST || height.abs() > noise {
        return None;
    }
    let angle = |arm: DVec3| {
        let arm = flat(arm);
        arm.y.atan2(arm.x)
    };
    // counter-clockwise as it is seen: the inside is left of an edge
    let swept = |from: DVec3, to: DVec3| {
        let [from, to] = if facing > 0.0 { [from, to] } else { [to, from] };
        let width = (angle(to) - angle(from)).rem_euclid(TAU);
        [angle(from), width]
    };
    let corners = blocker.corners();
    let n = corners.len();
    for (index, corner) in corners.iter().enumerate() {
        if corner.distance(at) <= noise {
            let [before, after] = [corners[(index + n - 1) % n], corners[(index + 1) % n]];
            return Some(swept(after - *corner, before - *corner));
        }
    }
    let mut turns = 0.0;
    for [a, b] in edges(blocker) {
        let along = b - a;
        let share = (at - a).dot(along) / along.length_squared();
        if (0.0..=1.0).contains(&share) && at.distance(a + along * share) <= noise {
            return Some(swept(along, -along));
        }
        let (from, to) = (a - at, b - at);
        turns += from.cross(to).dot(normal).atan2(from.dot(to));
    }
    (turns.abs() > 1.0).then_some([0.0, TAU])
}
