//! The bound on the change of an exchange area by displaced corners.
//!
//! ```text
//!   an edge of length L that moves by δ changes the exchange area by at most  δ L Ω/π
//!   Ω ≤ 2π (1 − h/√(h² + A/π)),   Ω ≤ A/d²       A: area of P or Q, from a place at the height h
//!                                                over its plane and the distance d
//! ```
//!
//! with the solid angle Ω that P or Q subtends from the edge's points, the smaller of the two: as
//! the edge moves, what a point x sees changes by `cos θ_x δ ds/(π r²)` at most, and
//! `cos θ_x dx/r²` is the solid angle of dx from the edge. Of all sets of one area in a plane the
//! disc below the point subtends most. Long edges count as long as they are near.
//!
//! δ is measured: what was lost as a corner was rounded, cut off or taken for another one.

use crate::form_factor::occlusion::view::outer::Outer;
use crate::form_factor::occlusion::view::setting::{Face, Setting};
use crate::numeric::real;
use glam::DVec3;
use std::f64::consts::PI;

/// The most that displaced corners can change.
pub(crate) fn slack(setting: &Setting, stretches: &[Outer]) -> f64 {
    let (Some(first), Some(second)) = (
        Outline::of(setting, &setting.first),
        Outline::of(setting, &setting.second),
    ) else {
        return 0.0;
    };
    let outer = stretches.iter().map(|outer| {
        let ends = [outer.sight.start, outer.sight.point(1.0)];
        outer.displaced * first.swept(ends).min(second.swept(ends))
    });
    let sides = setting.first.iter().flat_map(|face| &face.sides);
    let inner = sides.map(|side| {
        let ends = side.corners.map(|corner| setting.corners[corner]);
        let displaced = setting.lines[side.line].displaced;
        displaced * second.swept(ends)
    });
    outer.sum::<f64>() + inner.sum::<f64>()
}

/// P or Q, as a plane, an area and a sphere around it.
struct Outline<'a> {
    plane: &'a Face,
    area: f64,
    centre: DVec3,
    radius: f64,
}

impl<'a> Outline<'a> {
    fn of(setting: &Setting, faces: &'a [Face]) -> Option<Self> {
        let corners = || {
            let corners = faces.iter().flat_map(Face::corners);
            corners.map(|corner| setting.corners[corner])
        };
        let centre = corners().sum::<DVec3>() / real(corners().count().max(1));
        let radius = corners()
            .map(|corner| corner.distance(centre))
            .fold(0.0, f64::max);
        let area = faces.iter().map(|face| {
            let corners: Vec<DVec3> = face.corners().map(|c| setting.corners[c]).collect();
            let fans = corners
                .windows(2)
                .map(|pair| (pair[0] - corners[0]).cross(pair[1] - corners[0]).length());
            0.5 * fans.sum::<f64>()
        });
        Some(Self {
            plane: faces.first()?,
            area: area.sum(),
            centre,
            radius,
        })
    }

    /// A bound on ∫ Ω/π ds along an edge.
    ///
    /// With the largest Ω/π = w on it, and A/π = a: farther than r + s from the foot of the centre
    /// Ω/π is below a/s², so that the integral is below `2 (w (r + s) + a/s)`, least at s² = a/w.
    fn swept(&self, ends: [DVec3; 2]) -> f64 {
        let weight = self.weight(ends);
        let share = self.area / PI;
        let long = 2.0 * (weight * self.radius + 2.0 * (share * weight).sqrt());
        (ends[0].distance(ends[1]) * weight).min(long)
    }

    /// Ω/π at most, from the points of an edge.
    fn weight(&self, ends: [DVec3; 2]) -> f64 {
        let [from, to] = ends;
        let along = to - from;
        let share = (self.centre - from).dot(along) / along.length_squared();
        let nearest = if share.is_finite() {
            from + share.clamp(0.0, 1.0) * along
        } else {
            from
        };
        let distance = (self.centre.distance(nearest) - self.radius).max(0.0);
        let height = ends.map(|end| self.plane.height(end));
        let height = height[0].min(height[1]).max(0.0);
        let sine = height / (height * height + self.area / PI).sqrt();
        (2.0 * (1.0 - sine)).min(self.area / (PI * distance * distance))
    }
}
