//! The cone of directions in which a convex polygon is seen from a point.
//!
//! ```text
//!   cone = { d : d·N_i ≥ 0 },   N_i = a_i × b_i        a_i, b_i: rays to the ends of side i
//! ```
//!
//! Rays are differences of doubles, exact in 106 bits and scaled by powers of two, and normals have
//! 106 bits. A clip at a plane makes the ray `a |h_b| + b |h_a|` of two whose heights h have
//! opposite signs.
//!
//! **Not covered**: a point in the polygon's plane, whose cone is none.

use crate::geometry::{ClippedCorner, Vector, clip};
use crate::numeric::{DoubleDouble, Scalar, power_of_two_below, vector_value};
use glam::DVec3;
use smallvec::SmallVec;

/// A direction, to the corner of a polygon.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ray {
    /// The corner from the point, times a power of two that makes it about 1 long.
    pub exact: Vector<DoubleDouble>,
    pub unit: DVec3,
    /// The distance of the corner, and the power of two; 0 of a direction that leads to none.
    pub distance: f64,
    pub scale: f64,
}

impl Ray {
    /// The ray from a point to another one; `None` if they are the same.
    pub(super) fn between(point: DVec3, corner: DVec3) -> Option<Self> {
        let [from, to] = [point.to_array(), corner.to_array()];
        let apart = Vector([0, 1, 2].map(|axis| DoubleDouble::difference(to[axis], from[axis])));
        let distance = apart.to_doubles().length();
        (distance > 0.0).then(|| Self {
            distance,
            scale: inverse_unit(distance),
            ..Self::along(apart)
        })
    }

    /// The ray in a direction that is not zero, at no distance.
    fn along(direction: Vector<DoubleDouble>) -> Self {
        let rounded = direction.to_doubles();
        let scale = inverse_unit(rounded.length());
        Self {
            exact: direction.times(DoubleDouble::from(scale)),
            unit: rounded.normalize(),
            distance: 0.0,
            scale: 0.0,
        }
    }
}

fn inverse_unit(length: f64) -> f64 {
    1.0 / power_of_two_below(length)
}

/// A side of a cone: the part of a great circle from one ray to the next, less than half of it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Side {
    /// The rays at its ends.
    pub ends: [Ray; 2],
    /// `N = a × b`, which points inwards.
    pub normal: Vector<DoubleDouble>,
    pub unit: DVec3,
    /// `|a| |b|`, of which the rounding of N is a multiple.
    pub scale: f64,
    /// `|N|`, `a·b` and `a·a`.
    pub products: [DoubleDouble; 3],
}

impl Side {
    /// The side between two rays; `None` if they are one.
    fn between(ends: [Ray; 2]) -> Option<Self> {
        let [a, b] = ends.map(|end| end.exact);
        let zero = DoubleDouble::from(0.0);
        let (normal, products) = vector_value!((Vector([zero; 3]), [zero; 3]), {
            let normal = a.cross(b);
            (normal, [normal.length(), a.dot(b), a.dot(a)])
        });
        let scale = a.to_doubles().length() * b.to_doubles().length();
        (products[0].to_f64() > super::ON_A_CIRCLE * scale).then(|| Self {
            ends,
            normal,
            unit: (normal.to_doubles() / products[0].to_f64()).normalize(),
            scale,
            products,
        })
    }
}

/// The directions in which a convex polygon is seen.
#[derive(Debug, Clone)]
pub(super) struct Cone {
    pub sides: SmallVec<[Side; 6]>,
}

impl Cone {
    /// The cone with these rays, counter-clockwise as the point sees them; `None` if it has no
    /// width.
    pub(super) fn of(rays: &[Ray]) -> Option<Self> {
        let next = rays.iter().cycle().skip(1);
        let pairs = rays.iter().zip(next);
        let sides: SmallVec<_> = pairs.filter_map(|(a, b)| Side::between([*a, *b])).collect();
        (sides.len() > 2).then_some(Self { sides })
    }

    /// The rays to the corners, in order.
    pub(super) fn rays(&self) -> impl Iterator<Item = &Ray> + Clone {
        self.sides.iter().map(|side| &side.ends[0])
    }

    /// The part of the cone whose rays have heights ≥ 0, if any is left; `height` is linear in the
    /// corner that a ray leads to, or in its direction.
    pub(super) fn clipped(&self, height: impl Fn(&Ray) -> DoubleDouble) -> Option<Self> {
        let rays: SmallVec<[Ray; 8]> = self.rays().copied().collect();
        let heights: SmallVec<[DoubleDouble; 8]> = rays.iter().map(height).collect();
        let mut kept: SmallVec<[Ray; 8]> = SmallVec::new();
        clip(&heights, |corner| {
            kept.push(match corner {
                ClippedCorner::Kept(i) => rays[i],
                ClippedCorner::Crossing {
                    edge: [i, j],
                    share: _,
                } => {
                    let [a, b] = [heights[i], heights[j]].map(|height| height.abs());
                    Ray::along(rays[i].exact.times(b).plus(rays[j].exact, a))
                }
            });
        });
        Self::of(&kept)
    }
}
