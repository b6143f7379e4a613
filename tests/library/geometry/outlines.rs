//! Outlines of patches: which are refused, and which are not in spite of rounding.

use glam::DVec3;
use infoscene::geometry::{GeometryError, Patch, Rectangle};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn polygon(corners: &[[f64; 3]]) -> Result<Patch, GeometryError> {
    Patch::try_new(
        corners
            .iter()
            .map(|corner| DVec3::from_array(*corner))
            .collect(),
    )
}

#[test]
fn degenerate_polygons_are_refused() {
    let square = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
    ];
    assert!(polygon(&square).is_ok());
    assert_eq!(
        polygon(&square[..2]).unwrap_err(),
        GeometryError::TooFewCorners { corners: 2 }
    );
    let mut bad = square;
    bad[2] = [f64::NAN, 0.0, 0.0];
    assert!(matches!(
        polygon(&bad).unwrap_err(),
        GeometryError::NotFinite { corner: 2, .. }
    ));
    let line = [[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]];
    assert!(matches!(
        polygon(&line).unwrap_err(),
        GeometryError::NoArea { .. }
    ));
    let mut bent = square;
    bent[2][2] = 1e-3;
    assert!(matches!(
        polygon(&bent).unwrap_err(),
        GeometryError::NotPlanar { .. }
    ));
    let bow_tie = [
        [0.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 2.0, 0.0],
    ];
    let crossing = polygon(&bow_tie).unwrap_err();
    assert!(
        matches!(
            crossing,
            GeometryError::NotSimple {
                first: 0,
                second: 2
            }
        ),
        "{crossing}"
    );
}

#[test]
fn concave_polygons_are_accepted() {
    let l = [
        [0.0, 0.0, 0.0],
        [2.0, 0.0, 0.0],
        [2.0, 1.0, 0.0],
        [1.0, 1.0, 0.0],
        [1.0, 2.0, 0.0],
        [0.0, 2.0, 0.0],
    ];
    let patch = polygon(&l).unwrap();
    assert_eq!((patch.area(), patch.normal()), (3.0, DVec3::Z));
    assert!(
        Rectangle::try_from(&patch)
            .unwrap_err()
            .to_string()
            .contains("6 corners")
    );
}

/// Three corners lie in one plane, however thin the triangle.
#[test]
fn a_thin_triangle_is_planar() {
    let [base, apex] = [[-0.663, -0.534, -1.823], [-0.053, 0.832, -0.512]];
    for thickness in [1e-3, 1e-6, 1e-9, 1e-12] {
        let middle: [f64; 3] = std::array::from_fn(|k| 0.3 * base[k] + 0.7 * apex[k]);
        let aside = [middle[0] + thickness, middle[1], middle[2] - thickness];
        let thin = polygon(&[base, apex, aside]).unwrap();
        assert!(thin.area() < 3.0 * thickness, "{}", thin.area());
    }
}

/// The arms of a U end on one line; rounding leaves the ends on either side of each other's line,
/// in some positions.
#[test]
fn collinear_edges_apart_do_not_cross() {
    const U: [[f64; 2]; 8] = [
        [0.0, 0.0],
        [8.0, 0.0],
        [8.0, 8.0],
        [6.0, 8.0],
        [6.0, 3.0],
        [2.0, 3.0],
        [2.0, 8.0],
        [0.0, 8.0],
    ];
    let mut source = ChaCha8Rng::seed_from_u64(8);
    let mut vector = || DVec3::from_array([0; 3].map(|_: i32| source.random_range(-1.0..1.0)));
    for _ in 0..500 {
        let (origin, a, b) = (vector(), vector(), vector());
        let corners = U.map(|[i, j]| origin + i * a + j * b);
        let u = Patch::try_new(corners.to_vec());
        assert!(u.is_ok(), "{u:?}");
    }
}

/// Edges that cross or overlap are still found.
#[test]
fn edges_that_meet_are_refused() {
    let bow = polygon(&[
        [0.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 2.0, 0.0],
    ]);
    assert!(
        matches!(bow, Err(GeometryError::NotSimple { .. })),
        "{bow:?}"
    );
    let folded = polygon(&[
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
