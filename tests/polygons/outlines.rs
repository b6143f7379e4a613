//! Polygons that were once refused for the rounding of their own checks.

use glam::DVec3;
use infoscene::geometry::{GeometryError, Patch};

fn patch(corners: &[[f64; 3]]) -> Result<Patch, GeometryError> {
    Patch::try_new(corners.iter().map(|c| DVec3::from_array(*c)).collect())
}

/// Three corners lie in one plane, however thin the triangle.
#[test]
fn a_thin_triangle_is_planar() {
    let [base, apex] = [[-0.663, -0.534, -1.823], [-0.053, 0.832, -0.512]];
    for thickness in [1e-3, 1e-6, 1e-9, 1e-12] {
        let middle: [f64; 3] = std::array::from_fn(|k| 0.3 * base[k] + 0.7 * apex[k]);
        let aside = [middle[0] + thickness, middle[1], middle[2] - thickness];
        let thin = patch(&[base, apex, aside]).unwrap();
        assert!(thin.area() < 3.0 * thickness, "{}", thin.area());
    }
}

/// The arms of a U end on one line; rounding leaves the ends on either side of each other's line.
#[test]
fn collinear_edges_apart_do_not_cross() {
    let u = patch(&[
        [-3.146484851837158, -2.851800709962845, 2.598455011844635],
        [-3.0904374942183495, -2.7441484481096268, 2.721978332847357],
        [-3.1423797011375427, -3.0556379444897175, 2.839870434254408],
        [-3.0302849858999252, -2.8403334207832813, 3.0869170762598515],
        [-2.978342778980732, -2.5288439244031906, 2.9690249748528004],
        [-2.922295421361923, -2.4211916625499725, 3.092548295855522],
        [-3.0054029524326324, -2.9195748567581177, 3.281175658106804],
        [-3.2295923829078674, -3.35018390417099, 2.7870823740959167],
    ]);
    assert!(u.is_ok(), "{u:?}");
}

/// Edges that cross or overlap are still found.
#[test]
fn edges_that_meet_are_refused() {
    let bow = patch(&[
        [0.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 2.0, 0.0],
    ]);
    assert!(
        matches!(bow, Err(GeometryError::NotSimple { .. })),
        "{bow:?}"
    );
    let folded = patch(&[
        [0.0, 0.0, 0.0],
        [3.0, 0.0, 0.0],
        [3.0, 1.0, 0.0],
        [2.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
    ]);
    assert!(
        matches!(folded, Err(GeometryError::NotSimple { .. })),
        "{folded:?}"
    );
}
