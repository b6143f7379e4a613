//! An outline as it is drawn, less what encloses nothing.
//!
//! ```text
//!   a a b …       a corner repeated: it counts once
//!   a b a …       a spike, out and back: its tip is left out, and then the repeated a
//!   a b c …       with c on the way back from b to a: likewise
//! ```
//!
//! **Not covered**: outlines that touch or cross themselves elsewhere; what of them is clear is
//! divided by [`weakly_simple`](super::weakly_simple).

use crate::numeric::{power_of_two_near, tolerance};
use glam::DVec3;
use std::collections::VecDeque;

/// An outline without repeated corners and spikes.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct CleanOutline {
    /// The corners that remain, in order; fewer than three if nothing is enclosed.
    pub corners: Vec<DVec3>,
    /// Whether a corner was repeated.
    pub has_repeats: bool,
    /// Whether there was a spike.
    pub has_spikes: bool,
}

impl CleanOutline {
    /// The outline with these corners, all of them finite.
    pub(crate) fn of(corners: &[DVec3]) -> Self {
        // in units of the diameter, so that products stay in range
        let unit = power_of_two_near(diameter(corners));
        let slack = tolerance::PLANARITY * diameter(corners) / unit;
        let unrepeated = reduced(corners, |_, _, _| false);
        let has_repeats = unrepeated.len() < corners.len();
        let clean = reduced(&unrepeated, |a, b, c| {
            a == c || turns_back((b - a) / unit, (c - b) / unit, slack)
        });
        Self {
            has_repeats,
            has_spikes: clean.len() < unrepeated.len(),
            corners: clean,
        }
    }
}

/// Whether all corners lie on one line, to within the tolerance of planarity.
pub(crate) fn is_on_one_line(corners: &[DVec3]) -> bool {
    let Some(origin) = corners.first() else {
        return true;
    };
    let diameter = diameter(corners);
    let far = |one: &&DVec3, other: &&DVec3| {
        let [one, other] = [one, other].map(|corner| corner.distance(*origin));
        one.total_cmp(&other)
    };
    let along = corners.iter().max_by(far).map_or(DVec3::ZERO, |farthest| {
        (*farthest - *origin) / diameter.max(f64::MIN_POSITIVE)
    });
    corners.iter().all(|corner| {
        let height = (*corner - *origin).cross(along).length();
        height <= tolerance::PLANARITY * diameter
    })
}

/// The cyclic list without what equals its neighbour and without the tips of spikes.
pub(crate) fn reduced<P: Copy + PartialEq>(
    outline: &[P],
    is_spike: impl Fn(P, P, P) -> bool,
) -> Vec<P> {
    let mut kept: VecDeque<P> = VecDeque::with_capacity(outline.len());
    // drops what the last corners make superfluous, until nothing is
    let settle = |kept: &mut VecDeque<P>| {
        loop {
            let from_end = |steps: usize| Some(kept[kept.len().checked_sub(steps)?]);
            match [3, 2, 1].map(from_end) {
                [_, Some(b), Some(c)] if b == c => {
                    kept.pop_back();
                }
                [Some(a), Some(b), Some(c)] if is_spike(a, b, c) => {
                    kept.pop_back();
                    kept.pop_back();
                    kept.push_back(c);
                }
                _ => break,
            }
        }
    };
    for corner in outline {
        kept.push_back(*corner);
        settle(&mut kept);
    }
    // across the ends: each corner once more, as the last one
    let mut unchanged = 0;
    while kept.len() > 1 && unchanged < kept.len() {
        let before = kept.len();
        kept.rotate_left(1);
        settle(&mut kept);
        unchanged = if kept.len() < before {
            0
        } else {
            unchanged + 1
        };
    }
    // from the corner that it began with
    let first = outline
        .first()
        .and_then(|first| kept.iter().position(|corner| corner == first));
    kept.rotate_left(first.unwrap_or(0));
    kept.into()
}

/// Whether an edge runs back along the one before it, to within a slack across it.
fn turns_back(out: DVec3, back: DVec3, slack: f64) -> bool {
    let height = out.cross(back).length() / out.length().max(back.length());
    out.dot(back) < 0.0 && height <= slack
}

/// The largest distance of a corner from the first.
fn diameter(corners: &[DVec3]) -> f64 {
    let from = |corner: &DVec3| corner.distance(corners[0]);
    corners.iter().map(from).fold(0.0, f64::max)
}
