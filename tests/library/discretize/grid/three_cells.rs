//! The bounds on boxes by which the best grid of three cells is proved.

use infoscene::discretize::ThreeCells;
use infoscene::numeric::{Dual, Interval, Maximand};

/// The Taylor form and the bound on a box hold at every point of it.
#[test]
fn boxes_contain_the_slopes_at_their_points() {
    let cube = ThreeCells { edges: [1.0; 3] };
    for (lower, width) in [(0.05, 1e-5), (0.2, 1e-3), (0.3, 4e-3), (0.45, 1e-3)] {
        let domain = Interval::try_new(lower, lower + width);
        let slopes = domain.as_ref().and_then(|domain| cube.slope_on_box(domain));
        let bound = domain.as_ref().and_then(|domain| cube.bound_on(domain));
        for share in [0.0, 0.3, 0.5, 1.0] {
            let at = Interval::precise(f64::min(lower + share * width, lower + width), 128);
            let exact = cube.slope(&Dual::variable(at.clone()));
            let (Some(slopes), Some(exact)) = (&slopes, exact) else {
                panic!("no slope at {lower}");
            };
            for (wide, point) in [(&slopes.value, &exact.value), (&slopes.slope, &exact.slope)] {
                assert!(Interval::from_doubles(wide, 128).contains(point), "{lower}");
            }
            let value = cube.value(&at).map(|value| value.to_doubles().1);
            assert!(value <= bound, "{lower}: {value:?} above {bound:?}");
        }
    }
}
