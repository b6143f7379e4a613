//! What displaced corners can change of an exchange area.
//!
//! ```text
//!   an edge of length L that moves by δ changes the exchange area by at most  δ L Ω/π ≤ 2 δ L
//! ```
//!
//! with the solid angle Ω that P or Q subtends from its points, the smaller of the two: as the
//! edge moves, what a point x sees changes by `cos θ_x δ ds/(π r²)` at most, and `cos θ_x dx/r²` is
//! the solid angle of dx from the edge.

use super::outer::Outer;
use super::setting::{Face, Setting};
use crate::numeric::real;
use glam::DVec3;
use std::f64::consts::PI;

/// The most that displaced corners can change.
pub(super) fn slack(setting: &Setting, stretches: &[Outer]) -> f64 {
    let [first, second] =
        [&setting.first, &setting.second].map(|faces| Sphere::around(setting, faces));
    let weight = |from: DVec3, to: DVec3, sphere: &Sphere| {
        let near = sphere.centre.distance(0.5 * (from + to)) - 0.5 * from.distance(to);
        let distance = (near - sphere.radius).max(0.0);
        (sphere.area / (PI * distance * distance)).min(2.0)
    };
    let outer = stretches.iter().map(|outer| {
        let (from, to) = (outer.sight.start, outer.sight.point(1.0));
        from.distance(to) * weight(from, to, &first).min(weight(from, to, &second))
    });
    let inner = setting
        .first
        .iter()
        .flat_map(|face| &face.sides)
        .map(|side| {
            let [from, to] = side.corners.map(|corner| setting.corners[corner]);
            from.distance(to) * weight(from, to, &second)
        });
    setting.displaced * (outer.sum::<f64>() + inner.sum::<f64>())
}

/// A sphere around a polygon, and its area.
struct Sphere {
    centre: DVec3,
    radius: f64,
    area: f64,
}

impl Sphere {
    fn around(setting: &Setting, faces: &[Face]) -> Self {
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
        Self {
            centre,
            radius,
            area: area.sum(),
        }
    }
}
