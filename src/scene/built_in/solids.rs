//! The insides of the regular solids.
//!
//! ```text
//!   tetrahedron   (1,1,1), (1,−1,−1), (−1,1,−1), (−1,−1,1)          edge √8
//!   octahedron    ±e_x, ±e_y, ±e_z                                  edge √2
//!   dodecahedron  (±1,±1,±1), (±1/φ, 0, ±φ) and cyclic              edge 2/φ, φ = (1 + √5)/2
//!   icosahedron   (0, ±1, ±φ) and cyclic                            edge 2
//! ```
//!
//! A face is what lies farthest in the direction of a vertex of the dual solid.

use crate::geometry::Patch;
use crate::scene::{NamedPatch, Scene, SceneError};
use glam::DVec3;

/// Heights that differ by less are one face's; the next vertex is 0.7 lower.
const APART: f64 = 1e-9;

/// The inside of a regular solid, or `None` if it is not the name of one: `tetrahedron`,
/// `octahedron`, `dodecahedron`, `icosahedron`.
pub(crate) fn regular_solid(name: &str) -> Option<Result<Scene, SceneError>> {
    let phi = 0.5 * (1.0 + 5f64.sqrt());
    let signs = || [1.0, -1.0].into_iter();
    let octants = || {
        signs()
            .flat_map(move |x| signs().flat_map(move |y| signs().map(move |z| DVec3::new(x, y, z))))
    };
    let cyclic = |point: DVec3| {
        [
            point,
            DVec3::new(point.z, point.x, point.y),
            DVec3::new(point.y, point.z, point.x),
        ]
    };
    let planes = |a: f64, b: f64| {
        signs().flat_map(move |s| signs().flat_map(move |t| cyclic(DVec3::new(s * a, 0.0, t * b))))
    };
    let tetrahedron =
        |sign: f64| octants().filter(move |point| point.x * point.y * point.z * sign > 0.0);
    let octahedron =
        || signs().flat_map(|sign| [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| sign * axis));
    let dodecahedron = || octants().chain(planes(1.0 / phi, phi));
    // (0, 1, φ) and cyclic, as (φ, 0, 1) and cyclic
    let icosahedron = || planes(phi, 1.0);
    let [vertices, directions]: [Vec<DVec3>; 2] = match name {
        "tetrahedron" => [tetrahedron(1.0).collect(), tetrahedron(-1.0).collect()],
        "octahedron" => [octahedron().collect(), octants().collect()],
        "dodecahedron" => [dodecahedron().collect(), icosahedron().collect()],
        "icosahedron" => [icosahedron().collect(), dodecahedron().collect()],
        _ => return None,
    };
    Some(solid(&vertices, &directions))
}

/// The faces of a convex solid around the origin, in these directions, fronts inward.
fn solid(vertices: &[DVec3], directions: &[DVec3]) -> Result<Scene, SceneError> {
    let face = |(index, direction): (usize, &DVec3)| {
        let height = |vertex: &DVec3| vertex.dot(*direction);
        let highest = vertices
            .iter()
            .map(height)
            .fold(f64::NEG_INFINITY, f64::max);
        let mut corners: Vec<DVec3> = vertices
            .iter()
            .copied()
            .filter(|v| height(v) > highest - APART)
            .collect();
        let across = direction.any_orthogonal_vector().normalize();
        // clockwise from outside, counter-clockwise from inside
        let up = -direction.normalize().cross(across);
        let turn = |corner: &DVec3| corner.dot(up).atan2(corner.dot(across));
        corners.sort_by(|a, b| turn(a).total_cmp(&turn(b)));
        let name = format!("face {index}");
        match Patch::try_new(corners) {
            Ok(shape) => Ok(NamedPatch::new(name, shape)),
            Err(source) => Err(SceneError::Patch {
                index,
                name,
                source,
            }),
        }
    };
    let faces = directions.iter().enumerate().map(face);
    Scene::try_new(faces.collect::<Result<_, _>>()?)
}
