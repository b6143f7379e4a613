//! Draws of random polygons in the way of a pair, a recipe for each family.

use super::OccludedFamily;
use crate::geometry::mean;
use glam::DVec3;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The corners of a polygon.
type Corners = Vec<DVec3>;
/// The corners of a pair, and of what is in its way.
pub(super) type Drawn = ([Corners; 2], Vec<Corners>);

/// The corners of a family's case, always the same for a number.
pub(super) fn drawn(family: OccludedFamily, number: u64) -> Drawn {
    let seed = 7_000_003 * (family as u64 + 1) + number;
    let mut draw = Draw(ChaCha8Rng::seed_from_u64(seed));
    match family {
        OccludedFamily::One => draw.free(1),
        OccludedFamily::TwoOverlapping => draw.two_overlapping(),
        OccludedFamily::Many => {
            let count = 3 + draw.below(6);
            draw.free(count)
        }
        OccludedFamily::WallOnFirst => draw.wall(0.1, 0.9),
        OccludedFamily::WallOnBoth => draw.wall(1.0, 1.0),
        OccludedFamily::ClosePlate => draw.close_plate(),
        OccludedFamily::Piercing => draw.piercing(),
        OccludedFamily::Concave => draw.concave(),
        OccludedFamily::Box => draw.boxed(),
        OccludedFamily::Patchwork => draw.patchwork(),
        OccludedFamily::Corner => draw.corner(),
        OccludedFamily::Cabinet => draw.cabinet(),
        OccludedFamily::NearlyTotal => draw.nearly_total(),
        OccludedFamily::Tiny => draw.tiny(),
        OccludedFamily::Horizon => draw.horizon(),
    }
}

struct Draw(ChaCha8Rng);

impl Draw {
    fn below(&mut self, count: usize) -> usize {
        self.0.random_range(0..count)
    }

    /// A multiple of 2⁻³⁰.
    fn between(&mut self, lower: f64, upper: f64) -> f64 {
        let steps = 30f64.exp2();
        let drawn = lower + (upper - lower) * self.0.random::<f64>();
        (drawn * steps).round() / steps
    }

    fn vector(&mut self, reach: f64) -> DVec3 {
        let mut part = || self.between(-reach, reach);
        DVec3::new(part(), part(), part())
    }

    /// A triangle or a parallelogram about a place, not thin.
    fn polygon(&mut self, place: DVec3, size: f64) -> Corners {
        loop {
            let (a, b) = (self.vector(size), self.vector(size));
            let is_wide = a.cross(b).length() > 0.3 * a.length() * b.length();
            if !is_wide || a.length() < 0.3 * size || b.length() < 0.3 * size {
                continue;
            }
            let shift = self.vector(0.3 * size);
            let origin = (place + shift) * 30f64.exp2();
            let origin = origin.round() / 30f64.exp2();
            return match self.below(2) {
                0 => vec![origin, origin + a, origin + b],
                _ => vec![origin - a, origin - b, origin + a, origin + b],
            };
        }
    }

    fn rectangle(x: [f64; 2], y: [f64; 2], z: f64) -> Corners {
        let corner = |x, y| DVec3::new(x, y, z);
        vec![
            corner(x[0], y[0]),
            corner(x[1], y[0]),
            corner(x[1], y[1]),
            corner(x[0], y[1]),
        ]
    }

    fn sorted(&mut self, lower: f64, upper: f64) -> [f64; 2] {
        let middle = 0.5 * (lower + upper);
        let edge = 0.05 * (upper - lower);
        [
            self.between(lower, middle - edge),
            self.between(middle + edge, upper),
        ]
    }

    fn base(&mut self) -> Corners {
        Self::rectangle([0.0, 1.0], [0.0, 1.0], 0.0)
    }

    /// A level rectangle at height 1 over the unit square, about.
    fn ceiling(&mut self) -> Corners {
        let (x, y) = (self.sorted(-0.5, 1.5), self.sorted(-0.5, 1.5));
        Self::rectangle(x, y, 1.0)
    }

    fn ends(&mut self) -> [Corners; 2] {
        let far = DVec3::new(0.0, 0.0, 1.5);
        let shift = self.vector(0.5);
        [
            self.polygon(DVec3::ZERO, 1.0),
            self.polygon(far + shift, 1.0),
        ]
    }

    /// A place between two polygons.
    fn amid(&mut self, pair: &[Corners; 2]) -> DVec3 {
        let share = self.between(0.2, 0.8);
        mean(&pair[0]).lerp(mean(&pair[1]), share)
    }

    fn free(&mut self, count: usize) -> Drawn {
        let pair = self.ends();
        let blockers = (0..count).map(|_| {
            let (place, size) = (self.amid(&pair), self.between(0.1, 0.7));
            self.polygon(place, size)
        });
        let blockers = blockers.collect();
        (pair, blockers)
    }

    fn two_overlapping(&mut self) -> Drawn {
        let pair = self.ends();
        let place = self.amid(&pair);
        let above = DVec3::new(0.0, 0.0, self.between(0.05, 0.2));
        let blockers = vec![self.polygon(place, 0.5), self.polygon(place + above, 0.5)];
        (pair, blockers)
    }

    /// A wall from height 0 up, under a ceiling at height 1.
    fn wall(&mut self, low: f64, high: f64) -> Drawn {
        let (x, y) = (self.sorted(0.0, 1.0), self.sorted(0.0, 1.0));
        let top = self.between(low, high);
        let [from, to] = [DVec3::new(x[0], y[0], 0.0), DVec3::new(x[1], y[1], 0.0)];
        let up = DVec3::new(0.0, 0.0, top);
        let pair = [self.base(), self.ceiling()];
        (pair, vec![vec![from, to, to + up, from + up]])
    }

    fn close_plate(&mut self) -> Drawn {
        let gap = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6][self.below(5)];
        let gap = (gap * 30f64.exp2()).round() / 30f64.exp2();
        let (x, y) = (self.sorted(-0.2, 1.2), self.sorted(0.0, 1.0));
        let pair = [self.base(), self.ceiling()];
        (pair, vec![Self::rectangle(x, y, gap)])
    }

    fn piercing(&mut self) -> Drawn {
        let mut inside = || DVec3::new(self.between(0.2, 0.8), self.between(0.2, 0.8), 0.0);
        let (below, one, other) = (inside(), inside(), inside());
        let down = DVec3::new(0.0, 0.0, self.between(0.1, 0.4));
        let up = DVec3::new(0.2, 0.0, self.between(0.3, 0.8));
        let pair = [self.base(), self.ceiling()];
        (
            pair,
            vec![vec![below - down, one + up, other + up * 0.5 + DVec3::Y]],
        )
    }

    fn concave(&mut self) -> Drawn {
        let pair = self.ends();
        let place = self.amid(&pair);
        let whole = loop {
            let found = self.polygon(place, 0.6);
            if found.len() == 4 {
                break found;
            }
        };
        let (origin, a, b) = (whole[0], whole[1] - whole[0], whole[3] - whole[0]);
        let at = |i: f64, j: f64| origin + i * a + j * b;
        let hook = vec![
            at(0.0, 0.0),
            at(1.0, 0.0),
            at(1.0, 0.375),
            at(0.5, 0.375),
            at(0.5, 1.0),
            at(0.0, 1.0),
        ];
        (pair, vec![hook])
    }

    /// The six faces of a parallelepiped.
    fn faces(origin: DVec3, edges: [DVec3; 3]) -> Vec<Corners> {
        let mut faces = Vec::new();
        for k in 0..3 {
            let [a, b, c] = [edges[k], edges[(k + 1) % 3], edges[(k + 2) % 3]];
            for start in [origin, origin + c] {
                faces.push(vec![start, start + a, start + a + b, start + b]);
            }
        }
        faces
    }

    fn boxed(&mut self) -> Drawn {
        let pair = self.ends();
        let place = self.amid(&pair);
        let base = loop {
            let found = self.polygon(place, 0.4);
            if found.len() == 4 {
                break found;
            }
        };
        let up = self.vector(0.1) + DVec3::new(0.0, 0.0, 0.25);
        let edges = [base[1] - base[0], base[3] - base[0], up];
        (pair, Self::faces(base[0], edges))
    }

    fn patchwork(&mut self) -> Drawn {
        let pair = self.ends();
        let z = self.between(0.5, 0.9);
        let (x, y) = (self.sorted(-0.6, 0.6), self.sorted(-0.6, 0.6));
        let (u, v) = (0.5 * (x[0] + x[1]), 0.5 * (y[0] + y[1]));
        let bend = self.between(0.0, 0.2);
        let mut middle = DVec3::new(u, v, z);
        middle.z += if self.below(2) == 0 { bend } else { 0.0 };
        let ring = Self::rectangle(x, y, z);
        let next = ring.iter().cycle().skip(1);
        let fan = ring.iter().zip(next).map(|(a, b)| vec![*a, *b, middle]);
        let mut blockers: Vec<Corners> = fan.collect();
        // one of the same plane beside them
        blockers.push(Self::rectangle([x[1], x[1] + 0.25], y, z));
        (pair, blockers)
    }

    fn hinge(&mut self) -> [Corners; 2] {
        let wall = vec![DVec3::ZERO, DVec3::Y, DVec3::new(0.0, 1.0, 1.0), DVec3::Z];
        [self.base(), wall]
    }

    fn corner(&mut self) -> Drawn {
        let y = self.between(0.2, 0.8);
        let along = self.between(-0.1, 0.1);
        let (x, z) = (self.between(0.2, 0.8), self.between(0.2, 0.8));
        let triangle = vec![
            DVec3::new(0.0, y, 0.0),
            DVec3::new(x, y + along, 0.0),
            DVec3::new(0.0, y - along, z),
        ];
        (self.hinge(), vec![triangle])
    }

    fn cabinet(&mut self) -> Drawn {
        let y = self.sorted(0.1, 0.9);
        let size = DVec3::new(self.between(0.1, 0.6), y[1] - y[0], self.between(0.1, 0.6));
        let edges = [DVec3::X * size, DVec3::Y * size, DVec3::Z * size];
        let faces = Self::faces(DVec3::new(0.0, y[0], 0.0), edges);
        (self.hinge(), faces)
    }

    fn nearly_total(&mut self) -> Drawn {
        let (place, z) = (self.between(0.3, 0.7), self.between(0.3, 0.7));
        let slit = [1e-2, 1e-3, 1e-4][self.below(3)];
        let slit = (slit * 30f64.exp2()).round() / 30f64.exp2();
        let plates = vec![
            Self::rectangle([-4.0, place], [-4.0, 5.0], z),
            Self::rectangle([place + slit, 5.0], [-4.0, 5.0], z),
        ];
        ([self.base(), self.ceiling()], plates)
    }

    fn tiny(&mut self) -> Drawn {
        let pair = self.ends();
        let place = self.amid(&pair);
        let size = [1e-3, 1e-4, 1e-5, 1e-6][self.below(4)];
        // on a grid of 2⁻⁴⁴
        let small = self.polygon(DVec3::ZERO, 0.5);
        let unit = (size * 14f64.exp2()).log2().round().exp2() / 14f64.exp2();
        let place = (place * 20f64.exp2()).round() / 20f64.exp2();
        (
            pair,
            vec![small.iter().map(|c| place + *c * unit).collect()],
        )
    }

    fn horizon(&mut self) -> Drawn {
        let first = self.base();
        let second = self.polygon(DVec3::new(0.5, 0.5, 0.2), 0.8);
        let place = DVec3::new(self.between(0.2, 0.8), self.between(0.2, 0.8), 0.2);
        let blocker = self.polygon(place, 0.3);
        ([first, second], vec![blocker])
    }
}
