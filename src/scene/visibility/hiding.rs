//! Pairs of polygons that see nothing of each other, as convex bodies stand between.
//!
//! ```text
//!   hidden  ⇐  some body cuts every segment from a corner of i⁺ to a corner of j⁺,
//!              or this holds of each of the pairs into which i⁺ and j⁺ are halved
//! ```
//!
//! with i⁺ and j⁺ as in [`blockers`](crate::scene::Blockers), and the bodies of [`Bodies`]. They
//! are looked for along the segment between the middles of the two; a segment that nothing cuts
//! settles that the pair is not hidden. The exchange area of a hidden pair is 0: as what enters by
//! no more than the noise of the coordinates takes nothing away, a slit no wider lets nothing
//! through.
//!
//! **Not covered**: pairs that are hidden by solids side by side whose common face is seen edge on,
//! and by bodies that are not convex.

use super::bodies::Bodies;
use crate::geometry::{Outline, Shaft, clipped, mean};
use glam::DVec3;
use std::collections::VecDeque;

/// Most pairs of halves that are looked at.
const MOST_HALVES: usize = 48;

/// The search for bodies that hide polygons from each other, made ready.
#[derive(Debug, Clone, Copy)]
pub(super) struct Hiding<'a> {
    pub bodies: &'a Bodies,
    pub noise: f64,
}

/// The ends of a shaft, or halves of them.
pub(super) type Ends = [Vec<DVec3>; 2];

/// The effect of bodies on all segments between two ends.
enum Cut {
    /// One of them cuts all.
    All,
    /// Some may cut the segment between the middles.
    Some,
    /// None cuts that.
    None,
}

impl Hiding<'_> {
    /// Tells whether it is certain that two polygons, which see each other otherwise, see nothing
    /// of each other.
    pub(super) fn hides(&self, one: &Outline, other: &Outline) -> bool {
        let noise = self.noise;
        if !(one.rises_above(other.plane(), noise) && other.rises_above(one.plane(), noise)) {
            return false;
        }
        // cheapest first: of most pairs that are not hidden, the middles see each other
        if let Cut::None = self.cut([one, other].map(Outline::corners), false) {
            return false;
        }
        let Some(shaft) = Shaft::between(one, other, noise) else {
            return false;
        };
        let is_whole = |outline: &Outline| outline.pieces().len() == 1;
        self.are_hidden(shaft.corners(), is_whole(one) && is_whole(other))
    }

    /// Tells whether it is certain that every segment between two hulls of corners meets a body.
    ///
    /// **Arguments** `may_be_halved`: whether the corners go around convex polygons.
    pub(super) fn are_hidden(&self, ends: Ends, may_be_halved: bool) -> bool {
        let mut open = VecDeque::from([ends]);
        let mut left = MOST_HALVES;
        while let Some(ends) = open.pop_front() {
            match self.cut(ends.each_ref().map(Vec::as_slice), true) {
                Cut::All => {}
                Cut::Some if may_be_halved && left >= 2 => {
                    left -= 2;
                    open.extend(halves(ends));
                }
                Cut::Some | Cut::None => return false,
            }
        }
        true
    }

    fn cut(&self, ends: [&[DVec3]; 2], may_be_all: bool) -> Cut {
        let middles = ends.map(mean);
        let mut is_cut = false;
        for body in self.bodies.near(middles) {
            // halves of what touches a body touch it, too
            let is_touched = || ends.iter().any(|end| body.is_touched_by(end, self.noise));
            if !body.cuts(middles, self.noise) || is_touched() {
                continue;
            }
            is_cut = true;
            if !may_be_all {
                break;
            }
            if body.cuts_all(ends, self.noise) {
                return Cut::All;
            }
        }
        if is_cut { Cut::Some } else { Cut::None }
    }
}

/// The two pairs into which the longer end is halved, across its longest edge.
fn halves([ones, others]: Ends) -> [Ends; 2] {
    let longest = |corners: &[DVec3]| {
        let next = corners.iter().cycle().skip(1);
        let edges = corners.iter().zip(next).map(|(from, to)| *to - *from);
        edges.fold(DVec3::ZERO, |longest, edge| {
            if edge.length_squared() > longest.length_squared() {
                edge
            } else {
                longest
            }
        })
    };
    let half = |corners: &[DVec3], along: DVec3| {
        let at = mean(corners);
        let heights: Vec<f64> = corners.iter().map(|c| (*c - at).dot(along)).collect();
        clipped(corners, &heights, DVec3::lerp)
    };
    let [one, other] = [longest(&ones), longest(&others)];
    if one.length_squared() >= other.length_squared() {
        [one, -one].map(|along| [half(&ones, along), others.clone()])
    } else {
        [other, -other].map(|along| [ones.clone(), half(&others, along)])
    }
}
