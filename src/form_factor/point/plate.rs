//! The form factor from a point to what it sees of a polygon past convex plates, in doubles.
//!
//! ```text
//!   F(P \ ∪_k S_k) = F(P) − Σ_k F(P ∩ S_k \ ∪_{l>k} S_l)       S_k: shadow of plate k
//!   S_k = { y : y in the cone of the plate as the point sees it, and beyond its plane }
//! ```
//!
//! each hidden place counting with the last plate that hides it. A shadow is an intersection of
//! half-spaces, so that a polygon is cut by one after the other, and the cut polygons are never
//! more than the plates whose shadows overlap; where one shadow holds all that is left, nothing is.
//!
//! **Not covered**: a bound ([`point_form_factor_past`] has one); many plates whose shadows overlap
//! without one holding another, whose terms double with each.
//!
//! [`point_form_factor_past`]: crate::form_factor::point_form_factor_past

use super::edge::{Rays, above_horizon, cut, edges};
use glam::DVec3;
use smallvec::SmallVec;
use std::f64::consts::TAU;

/// A convex polygon that hides what is behind it, from both sides.
#[derive(Debug, Clone)]
pub(crate) struct Plate {
    corners: SmallVec<[DVec3; 4]>,
    normal: DVec3,
}

/// Sines of angles below this are none: parts so thin are left out.
const THIN: f64 = 1e-12;

impl Plate {
    /// The plate with these corners, counter-clockwise about its unit normal.
    pub(crate) fn new(corners: &[DVec3], normal: DVec3) -> Self {
        Self {
            corners: corners.into(),
            normal,
        }
    }

    /// The corners, counter-clockwise about the normal.
    pub(crate) fn corners(&self) -> &[DVec3] {
        &self.corners
    }

    /// The unit normal.
    pub(crate) const fn normal(&self) -> DVec3 {
        self.normal
    }

    /// The height of a point over the plane.
    pub(crate) fn height(&self, point: DVec3) -> f64 {
        (point - self.corners[0]).dot(self.normal)
    }

    /// Whether the plate stands between two points that are off its plane.
    pub(crate) fn stands_between(&self, [from, to]: [DVec3; 2], touching: f64) -> bool {
        let [above, below] = [from, to].map(|point| self.height(point));
        if above.min(below) >= -touching || above.max(below) <= touching {
            return false;
        }
        let met = from.lerp(to, above / (above - below));
        let next = self.corners.iter().cycle().skip(1);
        let mut sides = self.corners.iter().zip(next);
        sides.all(|(from, to)| (*to - *from).cross(met - *from).dot(self.normal) > 0.0)
    }

    /// The part of a polygon, seen from a point, that is in the shadow; empty if there is none.
    fn shadow(&self, point: DVec3, polygon: &Rays, touching: f64) -> Rays {
        let height = self.height(point);
        if height.abs() <= touching {
            return Rays::new();
        }
        let side = height.signum();
        let mut part = polygon.clone();
        // beyond the plane
        let beyond = |ray: DVec3| -side * (height + ray.dot(self.normal));
        if part.iter().all(|ray| beyond(*ray) <= touching) {
            return Rays::new();
        }
        cut(&mut part, beyond);
        let mut from = self.corners[self.corners.len() - 1] - point;
        for corner in &self.corners {
            let to = *corner - point;
            let inward = to.cross(from) * side;
            from = to;
            let thin = THIN * inward.abs().element_sum();
            if part
                .iter()
                .all(|ray| ray.dot(inward) <= thin * ray.abs().max_element())
            {
                return Rays::new();
            }
            cut(&mut part, |ray| ray.dot(inward));
        }
        part
    }
}

/// A point of a surface, with its unit normal.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PointView {
    pub point: DVec3,
    pub normal: DVec3,
    /// The distance up to which the point is on a plane.
    pub touching: f64,
}

/// The part of a polygon that a point sees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Seen {
    /// Nothing is hidden.
    Whole,
    /// A part, with its form factor; 0 if all is hidden.
    Part(f64),
}

impl PointView {
    /// The form factor to a simple polygon whose front faces the point.
    pub(crate) fn form_factor(&self, corners: &[DVec3]) -> f64 {
        self.factor(&above_horizon(self.point, self.normal, corners))
    }

    /// The part that plates leave of a simple polygon whose front faces the point.
    pub(crate) fn visible(&self, corners: &[DVec3], plates: &[&Plate]) -> Seen {
        self.past(&above_horizon(self.point, self.normal, corners), plates)
    }

    fn past(&self, rays: &Rays, plates: &[&Plate]) -> Seen {
        let mut shadows: SmallVec<[(usize, Rays); 2]> = SmallVec::new();
        for (index, plate) in plates.iter().enumerate() {
            let shadow = plate.shadow(self.point, rays, self.touching);
            if !shadow.is_empty() {
                if shadow == *rays {
                    return Seen::Part(0.0);
                }
                shadows.push((index, shadow));
            }
        }
        if shadows.is_empty() {
            return Seen::Whole;
        }
        let hidden =
            shadows.iter().map(
                |(index, shadow)| match self.past(shadow, &plates[index + 1..]) {
                    Seen::Whole => self.factor(shadow),
                    Seen::Part(value) => value,
                },
            );
        // shadows may make up the whole, but for rounding
        Seen::Part((self.factor(rays) - hidden.sum::<f64>()).max(0.0))
    }

    /// `−(1/2π) Σ q n·c`.
    fn factor(&self, rays: &Rays) -> f64 {
        let mut sum = 0.0;
        edges(rays, |edge| {
            sum += edge.angle_per_length * self.normal.dot(edge.across);
        });
        sum / -TAU
    }
}
