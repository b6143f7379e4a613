//! The boundary at the middle of a panel, as bounds on the integrand need it.

use super::corner::{Corner, Drift};
use glam::{DVec2, DVec3};

/// A side of the boundary: its corners, and whether its line goes through y.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BoundarySide {
    pub corners: [usize; 2],
    pub is_through: bool,
}

/// A boundary as it is at the middle of a panel, with what does not depend on the reach.
#[derive(Debug)]
pub(crate) struct Outline {
    pub drifts: Vec<Drift>,
    pub sides: Vec<Measured>,
    along: DVec2,
    pub speed: f64,
    pub height: f64,
    /// |v_z|.
    pub rise: f64,
    /// The unit of distances, a geometric mean of those of sides and corners from y.
    pub unit: f64,
    /// Whether the stretch lies in P's plane: then no height is a unit.
    pub is_level: bool,
}

/// A side at the middle of a panel.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Measured {
    pub side: BoundarySide,
    /// `|v·ΔX|`; for a line through y `|v·X|` of both ends.
    pub along: [f64; 2],
    /// The least distance from y; of a line through y those of both ends.
    pub nearest: [f64; 2],
    farthest: f64,
    /// The largest |ln r|; for a line through y that of each end.
    pub log: [f64; 2],
    /// The way from the corner that is nearer to y to the other one.
    run: DVec2,
    /// The squared distance from y of the side, `q0 + 2 q1 s + q2 s²` for s from 0, at the corner
    /// that is nearer, to 1.
    pub square: [f64; 3],
    /// The corner that is nearer, and the other one.
    pub ends: [usize; 2],
}

impl Measured {
    /// The unit normal of the side; none of a side without length.
    pub(crate) fn normal(&self) -> DVec2 {
        self.run.perp().normalize_or_zero()
    }
}

impl Outline {
    /// No sides yet, of a stretch along v.
    pub(crate) fn along(v: DVec3, is_level: bool) -> Self {
        Self {
            drifts: Vec::new(),
            sides: Vec::new(),
            along: v.truncate(),
            speed: v.truncate().length(),
            height: 0.0,
            rise: v.z.abs(),
            unit: 1.0,
            is_level,
        }
    }

    /// Takes other sides.
    ///
    /// **Arguments** `places`: the corners' places at the middle; `height`: the height there.
    pub(crate) fn set(
        &mut self,
        (corners, places): (&[Corner], &[DVec2]),
        sides: &[BoundarySide],
        height: f64,
    ) {
        let v = self.along;
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
            let [start, end] = side.corners;
            let (ends, near, run) = if squares[1] < squares[0] {
                ([end, start], to, -run)
            } else {
                (side.corners, from, run)
            };
            Measured {
                side: *side,
                along,
                nearest,
                farthest: (squares[0].max(squares[1]) + height * height).sqrt(),
                log: [0.0; 2],
                run,
                square: [
                    near.length_squared() + height * height,
                    near.dot(run),
                    run.length_squared(),
                ],
                ends,
            }
        });
        self.drifts.clear();
        self.drifts.extend(corners.iter().map(Corner::drift));
        self.sides.clear();
        self.sides.extend(measured);
        self.height = height;
        self.unit = 1.0;
        self.take_logarithms();
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

    /// Bounds the change of W by a gap that the sides leave open.
    pub(crate) fn gap(&self, width: f64) -> f64 {
        let logs = self.sides.iter().flat_map(|measured| measured.log);
        let most = logs.filter(|log| log.is_finite()).fold(0.0, f64::max);
        self.speed * width * (1.0 + most)
    }

    /// Bounds how far rounding moves the corners of each side on a panel of this half: along,
    /// and across the side, in sums of both ends. Where a side may touch y, and on lines through y,
    /// it is in the answer: what it changes of W.
    ///
    /// A side whose corners move by δ, and by η across it, sweeps over
    /// `½ (L + δ0 + δ1)(η0 + η1)` at most; its ends alone change W by δ (1 + |ln r|). The height is
    /// off, too: by 2u of itself, as much for all corners.
    pub(crate) fn shifts(&self, corners: &[Corner], half: f64, shifts: &mut Vec<[f64; 2]>) -> f64 {
        let tilt = half * self.rise;
        let highest = self.height + tilt;
        let noise = |corner: usize| {
            let (corner, drift) = (&corners[corner], &self.drifts[corner]);
            let (unit, place, tilted) = if corner.is_per_height {
                let place = drift.place.length();
                (highest, place, place * tilt)
            } else {
                (1.0, 0.0, 0.0)
            };
            let lifted = f64::EPSILON * highest * (1.0 + place);
            let [moved, across] = [corner.noise, corner.beside].map(|noise| noise * unit + lifted);
            [moved, across, drift.displacement(half) * unit + tilted]
        };
        let mut rest = 0.0;
        shifts.clear();
        shifts.extend(self.sides.iter().map(|measured| {
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
        }));
        rest
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
