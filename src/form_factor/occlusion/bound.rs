//! Bounds on the integrand along a stretch, for complex places near the middle of a panel.
//!
//! The corners X are rational functions of t, of degree at most 2. Where they stay within δ of
//! their places at a panel's middle as t takes complex values up to R from it, and r is the least
//! distance of a side from y,
//!
//! ```text
//!   |∫ ½ ln q ds| ≤ max |ln r| + ½ |ln(1 − κ)|,     κ = 2 δ/r + (δ/r)² < 1,   q = X·X on the side
//!   |W| ≤ M = Σ (|v·ΔX| + 2 |v| δ) (max |ln r| + ½ |ln(1 − κ)|)
//!   |ln(1 − κ)| ≤ κ (1 − κ/2)/(1 − κ)
//! ```
//!
//! As ∮dX = 0, distances may be taken in any unit, and in units of h(t), too: then nothing is
//! singular as y comes down to P.

use super::corner::{Corner, Drift};
use crate::numeric::{LANES, Lanes};
use glam::DVec2;

/// A side of the boundary: its corners, and whether its line goes through y.
#[derive(Debug, Clone, Copy)]
pub(super) struct BoundarySide {
    pub corners: [usize; 2],
    pub is_through: bool,
}

/// A boundary as it is at the middle of a panel, with what does not depend on the reach.
#[derive(Debug)]
pub(super) struct Outline {
    drifts: Vec<Drift>,
    sides: Vec<Measured>,
    speed: f64,
    height: f64,
    /// |v_z|.
    rise: f64,
    /// The unit of distances, a geometric mean of those of sides and corners from y.
    pub unit: f64,
    /// Whether the stretch lies in P's plane: then no height is a unit.
    is_level: bool,
}

/// A side at the middle of a panel.
#[derive(Debug, Clone, Copy)]
struct Measured {
    side: BoundarySide,
    /// `|v·ΔX|`; for a line through y `|v·X|` of both ends.
    along: [f64; 2],
    /// The least distance from y; of a line through y those of both ends.
    nearest: [f64; 2],
    farthest: f64,
    /// The largest |ln r|; for a line through y that of each end.
    log: [f64; 2],
}

impl Outline {
    /// **Arguments** `places`: the corners' places at the middle; `height`: the height there, and
    /// v_z.
    pub(super) fn new(
        (corners, places): (&[Corner], &[DVec2]),
        sides: &[BoundarySide],
        v: DVec2,
        [height, rise]: [f64; 2],
        is_level: bool,
    ) -> Self {
        let height = height.abs();
        let measured = sides.iter().map(|side| {
            let [from, to] = side.corners.map(|corner| places[corner]);
            let squares = [from.length_squared(), to.length_squared()];
            let run = to - from;
            let (along, nearest) = if side.is_through {
                let ends = [from, to].map(|end| v.dot(end).abs());
                (ends, squares.map(f64::sqrt))
            } else {
                let nearest = distance([from, to], height);
                ([v.dot(run).abs(), 0.0], [nearest, 0.0])
            };
            Measured {
                side: *side,
                along,
                nearest,
                farthest: (squares[0].max(squares[1]) + height * height).sqrt(),
                log: [0.0; 2],
            }
        });
        let mut outline = Self {
            drifts: corners.iter().map(Corner::drift).collect(),
            sides: measured.collect(),
            speed: v.length(),
            height,
            rise: rise.abs(),
            unit: 1.0,
            is_level,
        };
        outline.take_logarithms();
        outline
    }

    fn take_logarithms(&mut self) {
        let (mut least, mut most) = (f64::INFINITY, 0.0f64);
        for measured in &self.sides {
            most = most.max(measured.farthest);
            for distance in measured.nearest {
                if distance > 0.0 {
                    least = least.min(distance);
                }
            }
        }
        let mean = (least * most).sqrt();
        if mean.is_finite() && mean > 0.0 {
            self.unit = mean;
        }
        for measured in &mut self.sides {
            let log = |distance: f64| (distance / self.unit).ln().abs();
            measured.log = if measured.side.is_through {
                measured.nearest.map(log)
            } else {
                let far = log(measured.farthest);
                [log(measured.nearest[0]).max(far), 0.0]
            };
        }
    }

    /// Bounds on |W| for complex t up to each `reach` from the middle, from distances and from
    /// distances per height.
    #[inline(always)]
    pub(super) fn largest(&self, reach: &Lanes) -> Lanes {
        let (height, speed) = (self.height, self.speed);
        let mut tilt = [0.0; LANES];
        for l in 0..LANES {
            tilt[l] = self.rise * reach[l];
        }
        let mut moved: Vec<[Lanes; 2]> = Vec::with_capacity(self.drifts.len());
        for drift in &self.drifts {
            let mut own = drift.displacements(reach);
            let mut other = own;
            let place = drift.place / if drift.is_per_height { 1.0 } else { height };
            for l in 0..LANES {
                if drift.is_per_height {
                    own[l] = (height + tilt[l]) * own[l] + place * tilt[l];
                } else {
                    other[l] = (other[l] + place * tilt[l]) / (height - tilt[l]);
                }
            }
            moved.push([own, other]);
        }
        let (mut plain, mut per_height) = ([0.0; LANES], [0.0; LANES]);
        for Measured {
            side,
            along,
            nearest,
            log,
            ..
        } in &self.sides
        {
            let [from, to] = side.corners.map(|corner| &moved[corner]);
            if side.is_through {
                for (end, moved) in [from[0], to[0]].into_iter().enumerate() {
                    for l in 0..LANES {
                        if nearest[end] > 0.0 {
                            plain[l] += (along[end] + speed * moved[l])
                                * (log[end] + widened(moved[l] / nearest[end]));
                        }
                    }
                }
                continue;
            }
            let inverse = 1.0 / nearest[0];
            for l in 0..LANES {
                let most = from[0][l].max(to[0][l]);
                let share = (most * most + tilt[l] * tilt[l]).sqrt() * inverse;
                plain[l] +=
                    (along[0] + speed * (from[0][l] + to[0][l])) * (log[0] + widened(share));
                let share = from[1][l].max(to[1][l]) * height * inverse;
                per_height[l] += (along[0] / height + speed * (from[1][l] + to[1][l]))
                    * (log[0] + widened(share));
            }
        }
        for l in 0..LANES {
            if !self.is_level && tilt[l] < height {
                plain[l] = plain[l].min((height + tilt[l]) * per_height[l]);
            }
        }
        plain
    }

    /// What a gap that the sides leave open changes of W.
    pub(super) fn gap(&self, width: f64) -> f64 {
        let logs = self.sides.iter().flat_map(|measured| measured.log);
        let most = logs.filter(|log| log.is_finite()).fold(0.0, f64::max);
        self.speed * width * (1.0 + most)
    }

    /// How far rounding moves the corners of each side, at most, on a panel of this half: along, and
    /// across the side, in sums of both ends. Where a side may touch y, and on lines through y, it is
    /// in the second answer: what it changes of W.
    ///
    /// A side whose corners move by δ, and by η across it, sweeps over
    /// `½ (L + δ0 + δ1)(η0 + η1)` at most; its ends alone change W by δ (1 + |ln r|). The height is
    /// off, too: by 2u of itself, as much for all corners.
    pub(super) fn shifts(&self, corners: &[Corner], half: f64) -> (Vec<[f64; 2]>, f64) {
        let tilt = half * self.rise;
        let highest = self.height + tilt;
        let noise = |corner: usize| {
            let (corner, drift) = (&corners[corner], &self.drifts[corner]);
            let (unit, place, tilted) = if corner.is_per_height {
                (highest, drift.place, drift.place * tilt)
            } else {
                (1.0, 0.0, 0.0)
            };
            let lifted = f64::EPSILON * highest * (1.0 + place);
            let [moved, across] = [corner.noise, corner.beside].map(|noise| noise * unit + lifted);
            [moved, across, drift.displacement(half) * unit + tilted]
        };
        let mut rest = 0.0;
        let shifts = self.sides.iter().map(|measured| {
            let [from, to] = measured.side.corners.map(noise);
            let [log, last] = measured.log.map(|log| 2.0 + log.min(MOST_LOG));
            if measured.side.is_through {
                rest += self.speed * (from[0] * log + to[0] * last);
                return [0.0; 2];
            }
            let moved = from[0] + to[0];
            if measured.nearest[0] > 2.0 * moved + from[2].max(to[2]) + tilt {
                return [moved, from[1] + to[1]];
            }
            rest += self.speed * moved * log;
            [0.0; 2]
        });
        (shifts.collect(), rest)
    }
}

/// A logarithm that no distance between doubles exceeds.
const MOST_LOG: f64 = 1e3;

/// The least distance of y from a side that is `height` below it.
fn distance([from, to]: [DVec2; 2], height: f64) -> f64 {
    let run = to - from;
    let square = run.length_squared();
    let share = if square > 0.0 {
        (-from.dot(run) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    ((from + share * run).length_squared() + height * height).sqrt()
}

/// A bound on the growth of the logarithm of a distance by a displacement, a share of it.
#[inline(always)]
fn widened(share: f64) -> f64 {
    let kappa = share * (2.0 + share);
    if kappa < MOST_WIDENED {
        0.5 * kappa * (1.0 - 0.5 * kappa) / (1.0 - kappa)
    } else {
        // what is not a number comes here, too
        f64::INFINITY
    }
}

/// The largest κ that is made use of.
const MOST_WIDENED: f64 = 0.95;
