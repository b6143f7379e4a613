//! Polygons that were once refused for the rounding of their own checks.

use glam::DVec3;
use infoscene::form_factor::{Polygon, Route};
use infoscene::geometry::{GeometryError, Patch};
use infoscene::study::Truth;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

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

/// The arms of a U end on one line; rounding leaves the ends on either side of each other's line, in some positions.
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

/// A patch lost beside a huge one is no panic: an error, or an answer in range.
#[test]
fn sizes_far_apart_do_not_panic() {
    let square = |side: f64, z: f64| {
        let corners = [[0.0, 0.0], [side, 0.0], [side, side], [0.0, side]];
        let corners = corners.map(|[x, y]| DVec3::new(x, y + 0.1 * x, z));
        Polygon::new(&Patch::try_new(corners.to_vec()).unwrap())
    };
    for (first, second) in [
        (square(1e-150, 0.0), square(1e150, -1e150)),
        (square(1e150, 1e150), square(1e-152, 0.0)),
    ] {
        if let Ok(answer) = first.exchange_area(&second, 1e-12) {
            let range = 0.0..f64::MAX;
            assert!(range.contains(&answer.exchange.value), "{answer:?}");
            assert!(range.contains(&answer.exchange.error_bound), "{answer:?}");
        }
    }
}

/// Planes 5e-7 apart in angle, and two corners 5e-15 behind one of them: rounding says that they lie in it, and the strip
/// that a clip would take off is 1e-8 wide. The contour's bound knows, and the chooser goes on to more digits.
#[test]
#[ignore = "seconds: cargo test --release --test library hides -- --ignored"]
fn a_clip_that_rounding_hides_is_in_the_bound() {
    let first = [
        [3.7645452320575714, 3.489126145839691, -3.036815106868744],
        [5.635898619890213, 5.105310499668121, -3.602350652217865],
        [6.0774626433849335, 5.463396489620209, -2.963161289691925],
        [5.141785949468613, 4.655304312705994, -2.6803935170173645],
        [5.87772598862648, 5.252114295959473, -1.6150779128074646],
        [4.942049294710159, 4.444022119045258, -1.332310140132904],
    ];
    let second = [
        [5.496619720013598, 4.930729072542363, -1.7574766017479533],
        [5.6358986198918615, 5.105310499669486, -3.6023506522161597],
        [3.76454523205922, 3.4891261458410554, -3.0368151068670386],
    ];
    let pair = [patch(&first).unwrap(), patch(&second).unwrap()];
    let exact = Truth::of(&pair).unwrap().value();
    let [first, second] = pair.each_ref().map(Polygon::new);
    for tolerance in [1e-3, 1e-6, 1e-12] {
        let found = first.exchange_area(&second, tolerance).unwrap().exchange;
        let error = (found.value - exact).abs();
        assert!(
            error <= found.error_bound + f64::EPSILON * exact,
            "{error:e}, {found:?}"
        );
    }
    let contour = first
        .exchange_area_by(Route::Contour, &second, 0.0)
        .unwrap()
        .exchange;
    assert!((contour.value - exact).abs() > 1e-9 * exact, "{contour:?}");
    assert!(
        (contour.value - exact).abs() <= contour.error_bound,
        "{contour:?}"
    );
}
