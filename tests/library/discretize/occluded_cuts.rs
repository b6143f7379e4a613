//! Cuts of a patch that others shade.

use crate::support::rooms::{among, level, squares};
use infoscene::discretize::{DiscretizeError, PatchSplit};
use infoscene::geometry::SplitAxis;
use infoscene::numeric::tolerance;
use infoscene::scene::Occlusion;

/// Parallel unit squares at distance 1, and the half-plane x > 1/2 between them: cuts by an
/// independent evaluation, printed to six decimals.
#[test]
fn a_cut_behind_a_half_plane_is_that_of_the_reference() {
    for (height, position) in [(0.05, 0.517_962), (0.2, 0.568_324), (0.35, 0.608_664)] {
        let half = level("half", [0.5, 9.0], [-8.0, 9.0], height, true);
        let scene = among(&squares(), &[half]);
        let split = PatchSplit::try_new(&scene, 0, &[1], SplitAxis::U).unwrap();
        assert!(split.is_occluded() && !split.is_closed_form());
        let best = split.best(2).unwrap();
        let off = (best.positions[0] - position).abs();
        assert!(
            off <= 0.5e-6 + tolerance::OCCLUDED_POSITION,
            "{height}: {best:?}"
        );
        // a maximum, as far as an error of 1e-13 of the exchange areas shows one
        for beside in [-1e-3, 1e-3] {
            assert!(split.gain(&[best.positions[0] + beside]).unwrap() < best.gain);
        }
        let refused = split.certified_best(60).unwrap_err();
        assert!(matches!(refused, DiscretizeError::NotEnclosed));
    }
}

/// The derivative of the gain is the limit of its differences.
#[test]
fn the_derivative_of_an_occluded_gain_is_its_slope() {
    let plate = level("plate", [0.3, 0.62], [0.25, 0.55], 0.3, true);
    let scene = among(&squares(), &[plate]);
    let split = PatchSplit::try_new(&scene, 0, &[1], SplitAxis::U).unwrap();
    for position in [0.2, 0.45, 0.8] {
        let h = 1.0 / 1024.0;
        let gain = |at: f64| split.gain(&[at]).unwrap();
        let slope = |h: f64| (gain(position + h) - gain(position - h)) / (2.0 * h);
        let slope = (4.0 * slope(0.5 * h) - slope(h)) / 3.0;
        let found = split.gain_derivative(&[position], 0).unwrap();
        // both err by h⁴ and by 1e-13/h of the exchange areas
        assert!((found - slope).abs() <= 1e-8, "{position}: {found} {slope}");
    }
}

/// One pair is blocked: what is ignored is at most its exchange area.
#[test]
fn what_is_ignored_at_a_cut_is_counted() {
    let plate = level("plate", [0.3, 0.62], [0.25, 0.55], 0.3, true);
    let scene = among(&squares(), &[plate]);
    let split = |occlusion| PatchSplit::with_occlusion(&scene, 0, &[1], SplitAxis::U, occlusion);
    let bare = split(Occlusion::Ignore).unwrap();
    let ignored = bare.ignored_occlusion().unwrap();
    assert_eq!(ignored.pairs, 1);
    // Howell, C-11: parallel unit squares at distance 1
    assert!((ignored.exchange_area - 0.199_824_895_698_387).abs() < 1e-14);
    assert!(bare.is_closed_form() && !bare.is_occluded());
    assert!(split(Occlusion::Refuse).is_err());
}
