//! Pairs of patches that see nothing of each other, as convex bodies stand between.
//!
//! ```text
//!   hidden  ⇐  some body cuts every segment from a corner of i⁺ to a corner of j⁺,
//!              or this holds of each of the pairs into which i⁺ and j⁺ are halved
//! ```
//!
//! with i⁺ and j⁺ as in [`blockers`](crate::scene::Blockers), and the bodies of [`Bodies`]. They are
//! looked for along the segment between the middles of the two; a segment that nothing cuts settles
//! that the pair is not hidden. The exchange area of a hidden pair is 0: as what enters by no more
//! than the noise of the coordinates takes nothing away, a slit no wider lets nothing through.
//!
//! **Not covered**: pairs that are hidden by solids side by side whose common face is seen edge on,
//! and by bodies that are not convex.

use super::bodies::Bodies;
use super::surfaces::Surfaces;
use crate::geometry::{Shaft, clipped};
use crate::numeric::real;
use crate::scene::Scene;
use glam::DVec3;
use std::collections::VecDeque;

/// Most pairs of halves that are looked at: some microseconds each, less than an evaluation takes.
const MOST_HALVES: usize = 48;

/// The search for bodies that hide patches from each other, made ready.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hiding<'a> {
    surfaces: &'a Surfaces,
    bodies: &'a Bodies,
    noise: f64,
}

/// The ends of a shaft, or halves of them.
type Ends = [Vec<DVec3>; 2];

/// What bodies do to all segments between two ends.
enum Cut {
    /// One of them cuts all.
    All,
    /// Some cut the segment between the middles.
    Some,
    /// None cuts that.
    None,
}

impl<'a> Hiding<'a> {
    /// The search among the bodies of a scene, which are found once.
    pub(crate) fn of(scene: &'a Scene) -> Self {
        Self {
            surfaces: scene.outlined(),
            bodies: scene.bodies(),
            noise: scene.planes().noise(),
        }
    }

    /// Tells whether it is certain that two patches, which see each other otherwise, see nothing
    /// of each other.
    pub(crate) fn hides(&self, first: usize, second: usize) -> bool {
        let [one, other] = [first.min(second), first.max(second)];
        let [one, other] = [one, other].map(|patch| self.surfaces.outline(patch));
        let noise = self.noise;
        if !(one.rises_above(other.plane(), noise) && other.rises_above(one.plane(), noise)) {
            return false;
        }
        // cheapest first: of most pairs that are not hidden, the middles see each other
        let middles = [one, other].map(|outline| middle(outline.corners()));
        let mut near = self.bodies.near(middles);
        if !near.any(|body| body.cuts(middles, self.noise)) {
            return false;
        }
        let Some(shaft) = Shaft::between(one, other, self.noise) else {
            return false;
        };
        let may_be_halved = [one, other]
            .iter()
            .all(|outline| outline.pieces().len() == 1);
        self.are_hidden(shaft.corners(), may_be_halved)
    }

    fn are_hidden(&self, ends: Ends, may_be_halved: bool) -> bool {
        let mut open = VecDeque::from([ends]);
        let mut left = MOST_HALVES;
        while let Some(ends) = open.pop_front() {
            match self.cut(&ends) {
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

    fn cut(&self, [ones, others]: &Ends) -> Cut {
        let middles = [middle(ones), middle(others)];
        let mut is_cut = false;
        for body in self.bodies.near(middles) {
            if body.cuts(middles, self.noise) {
                is_cut = true;
                if body.cuts_all([ones, others], self.noise) {
                    return Cut::All;
                }
            }
        }
        if is_cut { Cut::Some } else { Cut::None }
    }
}

/// The mean of some corners.
fn middle(corners: &[DVec3]) -> DVec3 {
    corners.iter().sum::<DVec3>() / real(corners.len())
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
        let at = middle(corners);
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
