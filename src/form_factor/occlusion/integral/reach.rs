//! Bounds on the integrand along a stretch, for complex places near the middle of a panel.
//!
//! The corners X are rational functions of t, of degree at most 2. Where those of a side move by at
//! most δ0 and δ1 as t takes complex values up to R from the middle of a panel, the points between
//! move by `δ(s) = (1 − s) δ0 + s δ1`, and
//!
//! ```text
//!   |½ ln q| ≤ |ln r| − ½ ln g(δ/r)     q = X·X on the side, r = |X| in the middle
//!   g(x) = (1 − x)² up to x = ½,  ½ − x² from there to √½
//!   |W| ≤ M = Σ (|v·ΔX| + |v| (δ0 + δ1)) (max |ln r| − ½ ln g(max δ/r))
//! ```
//!
//! as on the plane that holds X, of length 1, and its displacement Δ, `(X + Δ)² = (1 + a)(1 + b)`
//! with `|a|² + |b|² = 2 |Δ|²`, and `|ln (1 + a)| ≤ −ln(1 − |a|)`; the product `(1 − |a|)(1 − |b|)`
//! is least at `|a| = |b|` while |Δ| is below ½, at `|a| + |b| = 1` from there.
//!
//! **Corners that slide along their side.** The integral is the same along any path on the side's
//! line between zeros of q: from the corner to where it was in the direction of the side, across
//! which that is displaced by `η + m δ` with the line's slope `m ≤ (η0 + η1)/(L − δ0 − δ1)` against
//! the side of length L, to the same place by the other corner, and to that. The path at either end
//! is not longer than `(1 + m) δ`, and as near to y as the corner, but for that and η.
//!
//! As ∮dX = 0, distances may be taken in any unit, and in units of h(t), too: then nothing is
//! singular as y comes down to P.

use super::bound::{Measured, Outline};
use super::corner::Drift;
use crate::numeric::{LANES, Lanes};
use glam::DVec2;
use smallvec::SmallVec;

impl Outline {
    /// Bounds on |W| for complex t up to each `reach` from the middle, from distances.
    #[inline(always)]
    pub(crate) fn largest(&self, reach: &Lanes) -> Lanes {
        let tilt = self.tilts(reach);
        let mut moved: SmallVec<[Lanes; 12]> = SmallVec::new();
        for drift in &self.drifts {
            moved.push(self.moved(drift, drift.sizes(), reach, &tilt)[0]);
        }
        let mut sum = [0.0; LANES];
        for side in &self.sides {
            let [near, far] = [&moved[side.ends[0]], &moved[side.ends[1]]];
            if side.side.is_through {
                self.add_through(side, [near, far], &mut sum);
                continue;
            }
            for l in 0..LANES {
                let lifted = |moved: f64| (moved * moved + tilt[l] * tilt[l]).sqrt();
                let share = largest_share([lifted(near[l]), lifted(far[l])], side.square);
                let length = side.along[0] + self.speed * (near[l] + far[l]);
                sum[l] += length * (side.log[0] + widened(share));
            }
        }
        sum
    }

    /// Bounds the largest change with corners that slide along their sides, from distances or from
    /// distances per height.
    #[inline(always)]
    pub(crate) fn largest_with_slides(&self, reach: &Lanes) -> Lanes {
        let tilt = self.tilts(reach);
        let (mut plain, mut per_height) = ([0.0; LANES], [0.0; LANES]);
        for side in &self.sides {
            let normal = side.normal();
            let [near, far] = [&self.drifts[side.ends[0]], &self.drifts[side.ends[1]]];
            let whole = [
                self.moved(near, near.sizes(), reach, &tilt),
                self.moved(far, far.sizes(), reach, &tilt),
            ];
            if side.side.is_through {
                self.add_through(side, [&whole[0][0], &whole[1][0]], &mut plain);
                continue;
            }
            let across = [
                self.moved(near, near.across(normal), reach, &tilt),
                self.moved(far, far.across(normal), reach, &tilt),
            ];
            for l in 0..LANES {
                let near = [whole[0][0][l], across[0][0][l]];
                let far = [whole[1][0][l], across[1][0][l]];
                plain[l] += bound(side, [near, far], tilt[l], self.speed);
            }
            for l in 0..LANES {
                let near = [whole[0][1][l], across[0][1][l]];
                let far = [whole[1][1][l], across[1][1][l]];
                per_height[l] += bound(side, [near, far], 0.0, self.speed);
            }
        }
        for l in 0..LANES {
            if !self.is_level && tilt[l] < self.height {
                plain[l] = plain[l].min((1.0 + tilt[l] / self.height) * per_height[l]);
            }
        }
        plain
    }

    #[inline(always)]
    fn tilts(&self, reach: &Lanes) -> Lanes {
        let mut tilt = [0.0; LANES];
        for l in 0..LANES {
            tilt[l] = self.rise * reach[l];
        }
        tilt
    }

    /// The distances by which a corner moves, as it is and per height, times the middle height.
    ///
    /// **Arguments** `sizes`: of what displaces it and of its place, at all or in one direction.
    #[inline(always)]
    fn moved(&self, drift: &Drift, sizes: [f64; 3], reach: &Lanes, tilt: &Lanes) -> [Lanes; 2] {
        let mut own = drift.displacements([sizes[0], sizes[1]], reach);
        let mut other = [0.0; LANES];
        let (height, place) = (self.height, sizes[2]);
        for l in 0..LANES {
            if drift.is_per_height {
                other[l] = own[l] * height;
                own[l] = (height + tilt[l]) * own[l] + place * tilt[l];
            } else {
                other[l] = (own[l] * height + place * tilt[l]) / (height - tilt[l]);
            }
        }
        [own, other]
    }

    /// Adds what a side on a line through y has.
    #[inline(always)]
    fn add_through(&self, side: &Measured, [near, far]: [&Lanes; 2], sum: &mut Lanes) {
        let [from, to] = if side.ends == side.side.corners {
            [near, far]
        } else {
            [far, near]
        };
        for (end, moved) in [from, to].into_iter().enumerate() {
            for l in 0..LANES {
                if side.nearest[end] > 0.0 {
                    let share = moved[l] / side.nearest[end];
                    sum[l] += (side.along[end] + self.speed * moved[l])
                        * (side.log[end] + widened(share));
                }
            }
        }
    }
}

/// The bound on one side, from what its corners move by, at all and across it.
#[inline(always)]
fn bound(side: &Measured, [near, far]: [[f64; 2]; 2], tilt: f64, speed: f64) -> f64 {
    let lifted = |moved: f64| (moved * moved + tilt * tilt).sqrt();
    let [along, log] = [side.along[0], side.log[0]];
    let [q0, q1, q2] = side.square;
    let share = largest_share([lifted(near[0]), lifted(far[0])], side.square);
    let whole = (along + speed * (near[0] + far[0])) * (log + widened(share));
    let left = q2.sqrt() - near[0] - far[0];
    let slope = (near[1] + far[1]) / left;
    let [one, other] = [near[1] + slope * near[0], far[1] + slope * far[0]];
    let share = largest_share([lifted(one), lifted(other)], side.square);
    let mut slid = (along + speed * (one + other)) * (log + widened(share));
    let [first, last] = [(1.0 + slope) * near[0], (1.0 + slope) * far[0]];
    let share = lifted(first + near[1]) / q0.sqrt();
    slid += speed * first * (log + widened(share));
    let share = lifted(last + far[1]) / (q0 + 2.0 * q1 + q2).sqrt();
    slid += speed * last * (log + widened(share));
    // what is not a number stays so
    if left > 0.0 && slid < whole {
        slid
    } else {
        whole
    }
}

/// The largest quotient of a displacement, `(1 − s) δ0 + s δ1`, and a distance, `√(q0 + 2 q1 s +
/// q2 s²)`, on a side.
///
/// Where the square's derivative vanishes, `s (δ0 q2 − (δ1 − δ0) q1) = (δ1 − δ0) q0 − δ0 q1`; there
/// is no other extremum but a zero, so that this is the largest if it lies on the side, and an end
/// is else. The square there is within 8ε of its terms.
#[inline(always)]
fn largest_share([from, to]: [f64; 2], [q0, q1, q2]: [f64; 3]) -> f64 {
    let growth = to - from;
    let place = (growth * q0 - from * q1) / (from * q2 - growth * q1);
    let place = if place > 0.0 && place < 1.0 {
        place
    } else {
        0.0
    };
    let moved = from + place * growth;
    let terms = q0 + place * (2.0 * q1.abs() + place * q2);
    let least = q0 + place * (2.0 * q1 + place * q2) - 8.0 * f64::EPSILON * terms;
    let inner = if least > 0.0 {
        moved * moved / least
    } else {
        f64::INFINITY
    };
    let (first, last) = (from * from / q0, to * to / (q0 + 2.0 * q1 + q2));
    // what is not a number stays so
    (first.max(last).max(inner) + 0.0 * (first + last)).sqrt()
}

/// A bound on the growth of the logarithm of a distance by a displacement, a share of it:
/// `−½ ln g ≤ ¼ (1/g − g)`.
#[inline(always)]
fn widened(share: f64) -> f64 {
    let least = if share < 0.5 {
        (1.0 - share) * (1.0 - share)
    } else {
        0.5 - share * share
    };
    if least > LEAST_LEFT {
        0.25 * (1.0 / least - least)
    } else {
        // what is not a number comes here, too
        f64::INFINITY
    }
}

/// The least share of a squared distance that is made use of.
const LEAST_LEFT: f64 = 0.05;

impl Drift {
    /// The sizes of what displaces the corner, and of its place.
    #[inline(always)]
    fn sizes(&self) -> [f64; 3] {
        let [first, second] = self.moves;
        [first.length(), second.length(), self.place.length()]
    }

    /// The sizes of the displacement in one direction.
    #[inline(always)]
    fn across(&self, direction: DVec2) -> [f64; 3] {
        let [first, second] = self.moves;
        [first, second, self.place].map(|part| part.dot(direction).abs())
    }
}
