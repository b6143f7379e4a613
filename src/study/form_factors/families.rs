//! Families of random pairs of polygons, each aimed at one difficulty; a pair is named by its
//! family and number.
//!
//! Triangles take any doubles as corners. Other polygons are `origin + i·a + j·b` with small whole
//! numbers i, j and with a, b, origin short enough that every corner is an exact double: so they
//! are planar exactly, and the input carries all digits of the answer. Each polygon is turned so
//! that its front faces the farthest corner of the other, so that every pair exchanges something.

use crate::geometry::{GeometryError, Patch};
use glam::DVec3;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// A family of pairs that share a difficulty.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// Anywhere within a few sizes, of very different sizes too.
    Free,
    /// One corner in common.
    SharedVertex,
    /// An edge, or a part of one, in common; opening angles near 0° and 180° too.
    SharedEdge,
    /// Parallel planes, down to gaps of 1e-9, the polygons often overlapping in projection.
    Parallel,
    /// Each partly behind the other's plane.
    Horizon,
    /// 30 to 1e6 sizes apart.
    Far,
    /// Needles and thin polygons, alone or at a shared edge.
    Sliver,
    /// Pairs with a shared edge or corner, moved apart by 1e-3 to 1e-12.
    Near,
}

impl Family {
    /// All, in the order of the tables.
    pub const ALL: [Self; 8] = [
        Self::Free,
        Self::SharedVertex,
        Self::SharedEdge,
        Self::Parallel,
        Self::Horizon,
        Self::Far,
        Self::Sliver,
        Self::Near,
    ];

    /// The name that tables and JSON use.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Free => "free",
            Self::SharedVertex => "shared vertex",
            Self::SharedEdge => "shared edge",
            Self::Parallel => "parallel planes",
            Self::Horizon => "horizon",
            Self::Far => "far",
            Self::Sliver => "sliver",
            Self::Near => "near",
        }
    }

    /// One of its pairs, always the same for a number.
    ///
    /// # Errors
    /// [`GeometryError`] if a polygon drawn is not planar and simple, which it is by construction.
    pub fn pair(self, number: u64) -> Result<[Patch; 2], GeometryError> {
        let mut draw = Draw(ChaCha8Rng::seed_from_u64(
            1_000_003 * (self as u64 + 1) + number,
        ));
        let [first, second] = match self {
            Self::Free => draw.free(),
            Self::SharedVertex => draw.shared_vertex(),
            Self::SharedEdge => draw.shared_edge(1.0),
            Self::Parallel => draw.parallel(),
            Self::Horizon => draw.horizon(),
            Self::Far => draw.far(),
            Self::Sliver => draw.sliver(),
            Self::Near => draw.near(),
        };
        let turned = [facing(&first, &second), facing(&second, &first)];
        let [first, second] = turned.map(Patch::try_new);
        Ok([first?, second?])
    }
}

/// The corners in the order that has the farthest corner of `other` in front.
pub(crate) fn facing(corners: &[DVec3], other: &[DVec3]) -> Vec<DVec3> {
    let arms = corners.windows(2);
    let doubled: DVec3 = arms
        .map(|pair| (pair[0] - corners[0]).cross(pair[1] - corners[0]))
        .sum();
    let heights = other.iter().map(|c| (*c - corners[0]).dot(doubled));
    let farthest = heights.fold(0.0, |far: f64, h| if h.abs() > far.abs() { h } else { far });
    let mut turned = corners.to_vec();
    if farthest < 0.0 {
        turned.reverse();
    }
    turned
}

/// Polygons by whole numbers from 0 to 8, all with the edge from (0, 0) to (8, 0).
const SHAPES: [&[[i32; 2]]; 6] = [
    &[[0, 0], [8, 0], [3, 7]],
    &[[0, 0], [8, 0], [8, 8], [0, 8]],
    &[[0, 0], [8, 0], [7, 5], [2, 8]],
    &[[0, 0], [8, 0], [8, 3], [4, 3], [4, 8], [0, 8]],
    &[[0, 0], [8, 0], [4, 2], [3, 8]],
    &[
        [0, 0],
        [8, 0],
        [8, 8],
        [6, 8],
        [6, 3],
        [2, 3],
        [2, 7],
        [0, 7],
    ],
];

/// A plane by a corner and two vectors.
#[derive(Debug, Clone, Copy)]
struct Frame {
    origin: DVec3,
    a: DVec3,
    b: DVec3,
}

impl Frame {
    fn at(&self, i: i32, j: i32) -> DVec3 {
        self.origin + f64::from(i) * self.a + f64::from(j) * self.b
    }

    fn polygon(&self, shape: &[[i32; 2]]) -> Vec<DVec3> {
        shape.iter().map(|[i, j]| self.at(*i, *j)).collect()
    }
}

struct Draw(ChaCha8Rng);

impl Draw {
    fn below(&mut self, count: u32) -> u32 {
        self.0.random_range(0..count)
    }

    fn between(&mut self, lower: f64, upper: f64) -> f64 {
        lower + (upper - lower) * f64::from(self.0.random::<u32>()) / 4_294_967_296.0
    }

    /// A power of two from `2^lower` to `2^upper`.
    fn power(&mut self, lower: i32, upper: i32) -> f64 {
        f64::from(self.0.random_range(lower..=upper)).exp2()
    }

    /// A vector with components from −1 to 1 in steps of 2^−bits, at least a half long in one of
    /// them.
    fn vector(&mut self, bits: i32) -> DVec3 {
        let steps = f64::from(bits).exp2();
        let mut parts = [0; 3].map(|_: i32| (self.between(-1.0, 1.0) * steps).round() / steps);
        let large = self.below(3) as usize;
        parts[large] = 0.5f64.copysign(parts[large]) + 0.5 * parts[large];
        DVec3::from_array(parts)
    }

    /// A vector at a clear angle to `other`, with components in steps of 2^−bits.
    fn across(&mut self, other: DVec3, bits: i32) -> DVec3 {
        let steps = f64::from(bits).exp2();
        let sideways = other
            .cross(self.vector(bits))
            .normalize_or(other.any_orthonormal_vector());
        let aslant = sideways + self.between(-0.7, 0.7) * other.normalize();
        (aslant * steps).round() / steps
    }

    fn shape(&mut self) -> &'static [[i32; 2]] {
        SHAPES[self.below(6) as usize]
    }

    /// A frame whose polygons are about 2 wide, with an origin within `reach`.
    fn frame(&mut self, reach: f64) -> Frame {
        let a = self.vector(24) * 0.25;
        let b = self.across(a, 24) * 0.25;
        let origin = self.vector(24) * reach;
        Frame { origin, a, b }
    }

    /// A triangle of any doubles, or a polygon on a frame.
    fn polygon(&mut self, frame: &Frame) -> Vec<DVec3> {
        if self.below(3) == 0 {
            let mut corner = |i: f64, j: f64| {
                let (i, j) = (i + self.between(-2.0, 2.0), j + self.between(-2.0, 2.0));
                frame.origin + i * frame.a + j * frame.b
            };
            vec![corner(0.0, 0.0), corner(8.0, 0.0), corner(4.0, 8.0)]
        } else {
            frame.polygon(self.shape())
        }
    }

    fn free(&mut self) -> [Vec<DVec3>; 2] {
        let (near, mut other) = (self.frame(1.0), self.frame(1.0));
        let size = self.power(-6, 2);
        other.origin += self.vector(20) * 4.0;
        other = Frame {
            a: other.a * size,
            b: other.b * size,
            ..other
        };
        [self.polygon(&near), self.polygon(&other)]
    }

    fn shared_vertex(&mut self) -> [Vec<DVec3>; 2] {
        let near = self.frame(1.0);
        let other = Frame {
            origin: near.origin,
            ..self.frame(1.0)
        };
        if self.below(2) == 0 {
            let mut corner = || near.origin + 2.0 * self.vector(40);
            let [a, b, c, d] = [corner(), corner(), corner(), corner()];
            return [vec![near.origin, a, b], vec![near.origin, c, d]];
        }
        [near.polygon(self.shape()), other.polygon(self.shape())]
    }

    /// Two frames with a common vector a, b at an angle down to 2^−20 from 0° or 180°.
    fn hinge(&mut self) -> [Frame; 2] {
        let near = self.frame(1.0);
        let b = match self.below(4) {
            0 => near.b + self.across(near.a, 10) * self.power(-20, -3),
            1 => -near.b + self.across(near.a, 10) * self.power(-20, -3),
            _ => self.across(near.a, 24) * 0.25,
        };
        [near, Frame { b, ..near }]
    }

    /// `thickness` is what the polygons' height is multiplied by.
    fn shared_edge(&mut self, thickness: f64) -> [Vec<DVec3>; 2] {
        let [mut near, mut other] = self.hinge();
        if thickness < 1.0 {
            // short numbers, so that thin corners stay exact
            near = Frame {
                origin: self.vector(12),
                a: self.vector(12) * 0.25,
                ..near
            };
            near.b = self.across(near.a, 6) * thickness;
            other = Frame {
                b: self.across(near.a, 6) * 0.25 * self.power(-6, 0),
                ..near
            };
        }
        if self.below(3) == 0 {
            // triangles with the whole edge in common
            let mut apex = |frame: &Frame| {
                frame.at(0, 0)
                    + 8.0 * self.between(-0.5, 1.5) * frame.a
                    + 8.0 * self.between(0.2, 1.0) * frame.b
            };
            let apices = [apex(&near), apex(&other)];
            let [start, end] = [near.at(0, 0), near.at(8, 0)];
            return apices.map(|apex| vec![start, end, apex]);
        }
        if self.below(2) == 0 {
            // a quarter of the edge only, inside or at its start
            let start = self.below(3) * 3;
            other.origin = near.at(start.cast_signed(), 0);
            other.a *= 0.25;
        }
        [near.polygon(self.shape()), other.polygon(self.shape())]
    }

    fn parallel(&mut self) -> [Vec<DVec3>; 2] {
        let near = self.frame(1.0);
        let mut place = || self.0.random_range(-6..=6);
        let shift = near.at(place(), place());
        let gap = self.across(near.a, 8).cross(near.a);
        let steps = 256.0;
        let gap = (gap.normalize() * steps).round() / steps * self.power(-28, 1);
        let (a, b) = match self.below(4) {
            0 => (near.a, near.b),
            1 => (near.a + near.b, near.b - near.a),
            2 => (near.b * 0.5, near.a * 0.5),
            _ => (near.a * 2.0 - near.b, near.b + near.a * 0.5),
        };
        let other = Frame {
            origin: shift + gap,
            a,
            b,
        };
        [near.polygon(self.shape()), other.polygon(self.shape())]
    }

    fn horizon(&mut self) -> [Vec<DVec3>; 2] {
        let near = self.frame(1.0);
        let turned = self.frame(1.0);
        // the middles about half a size apart
        let middle = near.at(4, 4) + self.vector(20) * 0.5;
        let other = Frame {
            origin: middle - 4.0 * turned.a - 4.0 * turned.b,
            ..turned
        };
        [self.polygon(&near), self.polygon(&other)]
    }

    fn far(&mut self) -> [Vec<DVec3>; 2] {
        let near = self.frame(1.0);
        let mut other = self.frame(1.0);
        other.origin = near.origin + self.vector(10) * self.power(6, 20);
        [self.polygon(&near), self.polygon(&other)]
    }

    fn sliver(&mut self) -> [Vec<DVec3>; 2] {
        let thickness = self.power(-30, -8);
        match self.below(3) {
            0 => self.shared_edge(thickness),
            1 => {
                // thin in the direction of short numbers, so that corners stay exact
                let a = self.vector(12) * 0.25;
                let b = self.across(a, 6) * thickness;
                let origin = self.vector(12);
                let thin = Frame { origin, a, b };
                let mut other = self.frame(1.0);
                other.origin += self.vector(12) * 2.0;
                [thin.polygon(self.shape()), self.polygon(&other)]
            }
            _ => {
                let near = self.frame(1.0);
                let tip = near.at(8, 0) + near.b * thickness;
                let mut other = self.frame(1.0);
                if self.below(2) == 0 {
                    other.origin = near.origin;
                }
                [
                    vec![near.at(0, 0), near.at(8, 0), tip],
                    other.polygon(self.shape()),
                ]
            }
        }
    }

    fn near(&mut self) -> [Vec<DVec3>; 2] {
        let [first, mut second] = if self.below(2) == 0 {
            self.shared_edge(1.0)
        } else {
            self.shared_vertex()
        };
        let shift = self.vector(4) * self.power(-40, -10);
        // a triangle is planar wherever its corners go; others only if they move exactly
        if second.len() == 3 || second.iter().all(|c| *c + shift - shift == *c) {
            second.iter_mut().for_each(|c| *c += shift);
        }
        [first, second]
    }
}
