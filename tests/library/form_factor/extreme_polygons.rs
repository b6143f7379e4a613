//! Polygons that are hard to clip, or of sizes far apart.

use crate::support::rooms::patch;
use glam::DVec3;
use infoscene::form_factor::{Polygon, Route};
use infoscene::geometry::Patch;
use infoscene::reference::Truth;

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
            assert!(range.contains(&answer.exchange.error), "{answer:?}");
        }
    }
}

/// Planes 5e-7 apart in angle, and two corners 5e-15 behind one of them: rounding says that they
/// lie in it, and the strip that a clip would take off is 1e-8 wide. The contour's bound knows, and
/// the chooser goes on to more digits.
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
    let pair = [patch(&first), patch(&second)];
    let exact = Truth::of(&pair).unwrap().value();
    let [first, second] = pair.each_ref().map(Polygon::new);
    for tolerance in [1e-3, 1e-6, 1e-12] {
        let found = first.exchange_area(&second, tolerance).unwrap().exchange;
        let error = (found.value - exact).abs();
        assert!(
            error <= found.error + f64::EPSILON * exact,
            "{error:e}, {found:?}"
        );
    }
    let contour = first
        .exchange_area_by(Route::Contour, &second, 0.0)
        .unwrap()
        .exchange;
    assert!((contour.value - exact).abs() > 1e-9 * exact, "{contour:?}");
    assert!(
        (contour.value - exact).abs() <= contour.error,
        "{contour:?}"
    );
}
