//! Bounds on the integrand along a stretch, for complex places near the middle of a panel.
//!
//! The corners X are rational functions of t, of degree at most 2. Where they stay within δ of
//! their places at a panel's middle as t takes complex values up to R from it, and r is the least
//! distance of a side from y,
//!
//! ```text
//!   |∫ ½ ln q ds| ≤ max |ln r| + ½ |ln(1 − κ)|,     κ = 2 δ/r + (δ/r)² < 1,   q = X·X on the side
//!   |W| ≤ M = Σ (|v·ΔX| + 2 |v| δ) (max |ln r| + ½ |ln(1 − κ)|)
//! ```
//!
//!
//! As ∮dX = 0, distances may be taken in any unit, and in units of h(t), too: then nothing is
//! singular as y comes down to P.

use super::corner::Corner;
use glam::DVec2;
use smallvec::SmallVec;

/// A side of the boundary: its corners, and whether its line goes through y.
#[derive(Debug, Clone, Copy)]
pub(super) struct BoundarySide {
    pub corners: [usize; 2],
    pub is_through: bool,
}

/// A boundary as it is at the middle of a panel, with what does not depend on the reach.
#[derive(Debug)]
pub(super) struct Outline<'a> {
    corners: &'a [Corner],
    /// The corners' N/D, and their places in the unit at hand.
    places: SmallVec<[[DVec2; 2]; 16]>,
    sides: SmallVec<[Measured; 16]>,
    named: &'a [BoundarySide],
    v: DVec2,
    height: f64,
    /// |v_z|.
    rise: f64,
    unit: f64,
    is_per_height: bool,
}

/// A side: `|v·ΔX|`, its least distance, and the largest |ln r|; for lines through y the same of
/// both ends.
#[derive(Debug, Clone, Copy)]
enum Measured {
    Apart([f64; 3]),
    Through([[f64; 3]; 2]),
}

impl<'a> Outline<'a> {
    /// **Arguments** `stretch`: height at the middle, and |v_z|.
    pub(super) fn new(
        corners: &'a [Corner],
        named: &'a [BoundarySide],
        v: DVec2,
        [height, rise]: [f64; 2],
        unit: f64,
    ) -> Self {
        let mut outline = Self {
            corners,
            places: SmallVec::new(),
            sides: SmallVec::new(),
            named,
            v,
            height,
            rise,
            unit,
            is_per_height: false,
        };
        outline.measure();
        outline
    }

    /// The outline in units of the height.
    pub(super) fn per_height(mut self) -> Self {
        self.is_per_height = true;
        self.measure();
        self
    }

    fn measure(&mut self) {
        let (height, is_per_height) = (self.height, self.is_per_height);
        let places = self.corners.iter().map(|corner| {
            let place = corner.per_denominator();
            let here = match (corner.is_per_height, is_per_height) {
                (true, false) => height * place,
                (false, true) => place / height,
                _ => place,
            };
            [place, here]
        });
        self.places = places.collect();
        let (level, unit) = if is_per_height {
            (1.0, self.unit / height)
        } else {
            (height, self.unit)
        };
        let log = |distance: f64| (distance / unit).ln().abs();
        let sides = self.named.iter().map(|side| {
            let [from, to] = side.corners.map(|corner| self.places[corner][1]);
            if side.is_through {
                return Measured::Through([from, to].map(|end| {
                    let distance = end.length();
                    [self.v.dot(end).abs(), distance, log(distance)]
                }));
            }
            let nearest = distance([from, to], level);
            let square = from.length_squared().max(to.length_squared());
            let farthest = (square + level * level).sqrt();
            let along = self.v.dot(to - from).abs();
            Measured::Apart([along, nearest, log(nearest).max(log(farthest))])
        });
        self.sides = sides.collect();
    }

    /// A bound on |W| for complex t up to `reach` from the middle.
    pub(super) fn largest(&self, reach: f64) -> f64 {
        let (height, rise, speed) = (self.height, self.rise * reach, self.v.length());
        let least_height = height - rise;
        if self.is_per_height && least_height <= 0.0 {
            return f64::INFINITY;
        }
        let moved = self
            .corners
            .iter()
            .zip(&self.places)
            .map(|(corner, [place, here])| {
                let moved = corner.displacement(*place, reach);
                match (corner.is_per_height, self.is_per_height) {
                    (true, false) => (height + rise) * moved + place.length() * rise,
                    (false, true) => (moved + here.length() * rise) / least_height,
                    _ => moved,
                }
            });
        let moved: SmallVec<[f64; 16]> = moved.collect();
        let tilt = if self.is_per_height { 0.0 } else { rise };
        let mut sum = 0.0;
        for (side, measured) in self.named.iter().zip(&self.sides) {
            let ends = side.corners.map(|corner| moved[corner]);
            match measured {
                Measured::Apart([along, nearest, log]) => {
                    let most = ends[0].max(ends[1]);
                    let most = (most * most + tilt * tilt).sqrt();
                    sum += (along + speed * (ends[0] + ends[1])) * (log + widened(most / nearest));
                }
                Measured::Through(each) => {
                    for ([along, distance, log], moved) in each.iter().zip(ends) {
                        if *distance > 0.0 {
                            sum += (along + speed * moved) * (log + widened(moved / distance));
                        }
                    }
                }
            }
        }
        if self.is_per_height {
            (height + rise) * sum
        } else {
            sum
        }
    }
}

/// The least distance of y from a side that is `height` below it.
pub(super) fn distance([from, to]: [DVec2; 2], height: f64) -> f64 {
    let run = to - from;
    let square = run.length_squared();
    let share = if square > 0.0 {
        (-from.dot(run) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    ((from + share * run).length_squared() + height * height).sqrt()
}

/// The growth of the logarithm of a distance by a displacement, a share of that distance.
fn widened(share: f64) -> f64 {
    let kappa = share * (2.0 + share);
    if kappa < MOST_WIDENED {
        -0.5 * (1.0 - kappa).ln()
    } else {
        // what is not a number comes here, too
        f64::INFINITY
    }
}

/// The largest κ that is made use of.
const MOST_WIDENED: f64 = 0.95;
