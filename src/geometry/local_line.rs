//! Random lines that leave a polygon, and where a line meets a polygon.
//!
//! ```text
//!   origin      a + √s·(1 − t)·(b − a) + √s·t·(c − a)        uniform in the triangle a, b, c
//!   direction   √u·(cos 2πv·across + sin 2πv·up) + √(1 − u)·normal        by cosine
//! ```
//!
//! for numbers s, t, u, v uniform from 0 to 1. A line meets a triangle if it passes all edges on
//! one side; neighbours with a common edge decide by the same numbers on which side of it a line
//! passes, so that no line slips between them.
//!
//! **Not covered**: the source of the numbers, and lines through a whole sphere
//! ([`line_through_sphere`](super::line_through_sphere)).

use super::triangulated;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// A line that leaves the front of a polygon.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LocalLine {
    /// A point of the polygon.
    pub origin: DVec3,
    /// The unit direction.
    pub direction: DVec3,
    /// The cosine of the angle between direction and normal, ≥ 0.
    pub cosine: f64,
}

impl LocalLine {
    /// The line that leaves a triangle with this normal; uniform for uniform numbers from 0 to 1.
    ///
    /// **Arguments** two numbers for the point, two for the direction.
    pub(crate) fn leaving([a, b, c]: [DVec3; 3], normal: DVec3, [s, t, u, v]: [f64; 4]) -> Self {
        debug_assert!((0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t));
        let root = s.sqrt();
        let origin = a + root * (1.0 - t) * (b - a) + root * t * (c - a);
        let (across, up) = normal.any_orthonormal_pair();
        let Slope {
            around,
            sine,
            cosine,
        } = Slope::by_cosine([u, v]);
        let direction = sine * (around.x * across + around.y * up) + cosine * normal;
        Self {
            origin,
            direction,
            cosine,
        }
    }
}

/// A direction in the frame of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Slope {
    /// The unit vector along the direction's projection on the surface.
    pub around: DVec2,
    /// The sine of the angle to the normal.
    pub sine: f64,
    /// The cosine of the angle to the normal.
    pub cosine: f64,
}

impl Slope {
    /// The direction that is distributed by cosine if both numbers are uniform from 0 to 1.
    #[inline]
    pub(crate) fn by_cosine([u, v]: [f64; 2]) -> Self {
        debug_assert!((0.0..=1.0).contains(&u), "{u}");
        let (y, x) = (TAU * v).sin_cos();
        Self {
            around: DVec2::new(x, y),
            sine: u.sqrt(),
            cosine: (1.0 - u).sqrt(),
        }
    }
}

/// A planar polygon as triangles, to leave from and to meet.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Facet {
    triangles: Vec<[DVec3; 3]>,
    normal: DVec3,
}

impl Facet {
    /// The polygon with these corners and this normal, its triangles placed by a similarity.
    pub(crate) fn new(corners: &[DVec3], normal: DVec3, place: impl Fn(DVec3) -> DVec3) -> Self {
        let triangles = triangulated(corners, normal);
        let placed = |triangle: [usize; 3]| triangle.map(|corner| place(corners[corner]));
        Self {
            triangles: triangles.into_iter().map(placed).collect(),
            normal,
        }
    }

    /// The triangles, which do not overlap.
    pub(crate) fn triangles(&self) -> &[[DVec3; 3]] {
        &self.triangles
    }

    /// The corners of all triangles.
    pub(crate) fn corners(&self) -> impl Iterator<Item = &DVec3> {
        self.triangles.iter().flatten()
    }

    /// The unit normal.
    pub(crate) const fn normal(&self) -> DVec3 {
        self.normal
    }

    /// The signed distance at which a line meets the polygon.
    pub(crate) fn crossing(&self, origin: DVec3, direction: DVec3) -> Option<f64> {
        let corner = self.triangles.first()?[0];
        let distance = self.normal.dot(corner - origin) / self.normal.dot(direction);
        (distance.is_finite() && self.is_met(origin, direction)).then_some(distance)
    }

    /// Tells whether a line passes the edges of a triangle all on one side.
    pub(crate) fn is_met(&self, origin: DVec3, direction: DVec3) -> bool {
        self.triangles.iter().any(|triangle| {
            let [a, b, c] = triangle.map(|corner| corner - origin);
            let sides = [(a, b), (b, c), (c, a)].map(|(p, q)| side(p, q, direction));
            sides.iter().all(|s| *s >= 0.0) || sides.iter().all(|s| *s <= 0.0)
        })
    }
}

/// The side of the edge from p to q on which a line from the origin passes; exactly the negative
/// from q to p.
fn side(p: DVec3, q: DVec3, direction: DVec3) -> f64 {
    let is_first = p.to_array() <= q.to_array();
    if is_first {
        p.cross(q).dot(direction)
    } else {
        -q.cross(p).dot(direction)
    }
}
