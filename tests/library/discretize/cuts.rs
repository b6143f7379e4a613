//! Laws that every best cut obeys.

use infoscene::discretize::{ContactShadow, GradientCut, PatchSplit, regular_positions};
use infoscene::geometry::SplitAxis;
use infoscene::scene::Scene;

fn two_squares(axis: SplitAxis) -> PatchSplit {
    PatchSplit::try_new(&Scene::built_in("two-squares").unwrap(), 0, &[1], axis).unwrap()
}

/// The derivative in closed form against a central difference of the gain.
#[test]
fn gain_derivatives_are_derivatives_of_the_gain() {
    let step = 1e-5; // the difference is off by its square times a third derivative below 10
    for axis in SplitAxis::ALL {
        let split = two_squares(axis);
        for cuts in [vec![0.3], vec![0.2, 0.7], vec![0.1, 0.4, 0.9]] {
            for k in 0..cuts.len() {
                let at = |shift: f64| {
                    let mut moved = cuts.clone();
                    moved[k] += shift;
                    split.gain(&moved).unwrap()
                };
                let difference = (at(step) - at(-step)) / (2.0 * step);
                let derivative = split.gain_derivative(&cuts, k).unwrap();
                assert!(
                    (derivative - difference).abs() < 1e-9,
                    "{axis:?} {cuts:?} {k}"
                );
            }
        }
    }
}

/// More parts gain more, never beyond `2 w P log2 m`, and the best cuts gain at least what equal
/// parts do.
#[test]
fn more_parts_gain_more() {
    for axis in SplitAxis::ALL {
        let split = two_squares(axis);
        let mut previous = 0.0;
        for parts in 2..=9 {
            let gain = split.best(parts).unwrap().gain;
            assert!(gain > previous && gain <= split.maximum_gain(parts).unwrap());
            assert!(gain >= split.gain(&regular_positions(parts)).unwrap());
            previous = gain;
        }
    }
}

/// 64 parts of two squares are found, in order.
#[test]
fn many_parts_come_to_rest() {
    for axis in SplitAxis::ALL {
        let best = two_squares(axis).best(64).unwrap();
        assert!(best.positions.is_sorted() && best.positions.len() == 63);
        assert!(best.residual < 1e-12, "{:e}", best.residual);
    }
}

/// A patch that sees nothing cannot gain; a patch is not cut against itself.
#[test]
fn useless_cuts_are_refused() {
    let scene = Scene::built_in("cube:2").unwrap();
    let coplanar = PatchSplit::try_new(&scene, 0, &[1], SplitAxis::U).unwrap_err();
    assert!(
        coplanar.to_string().contains("exchanges nothing"),
        "{coplanar}"
    );
    let itself = PatchSplit::try_new(&scene, 0, &[0], SplitAxis::U).unwrap_err();
    assert!(itself.to_string().contains("against itself"), "{itself}");
    assert!(two_squares(SplitAxis::U).best(1).is_err());
    assert!(two_squares(SplitAxis::U).gain(&[0.7, 0.3]).is_err());
}

/// The stationarity of §4.2: the gain is lower a thousandth to either side of the cut.
#[test]
fn gradient_cuts_are_maxima() {
    for n in [0.5, 1.0, 3.0, 50.0, 1e4] {
        for m in [1.0, n] {
            let cut = GradientCut::try_new(n, m).unwrap();
            let best = cut.mutual_information_cut().unwrap();
            let tau = -best.position.ln();
            assert!(
                best.value > cut.gain_at(&(tau * 0.99)).max(cut.gain_at(&(tau * 1.01))),
                "{n} {m}"
            );
        }
    }
}

/// Exponents outside the tested range are refused.
#[test]
fn exponents_are_checked() {
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e13] {
        assert!(GradientCut::try_new(bad, 1.0).is_err(), "{bad}");
        assert!(GradientCut::try_new(1.0, bad).is_err(), "{bad}");
    }
}

/// Without occlusion the contact shadow's gain would be that of two squares; with a lit part it is
/// larger at the line than where the shadow is cut off by a cut deeper in the dark (appendix B.1).
#[test]
fn contact_shadow_prefers_its_line_to_the_dark() {
    for line in [0.2, 0.5, 0.8] {
        let shadow = ContactShadow::try_new(line).unwrap();
        let at_line = shadow.gain(&line).unwrap();
        for cut in [line + 0.01, line + 0.1, 0.99] {
            assert!(shadow.gain(&cut).unwrap() < at_line);
        }
    }
    assert!(ContactShadow::try_new(1.0).is_err());
}

/// The limit of appendix B.2: before it the line wins, beyond it a lit cut does.
#[test]
fn contact_shadow_changes_sides_at_its_limit() {
    let limit = ContactShadow::limit_of_the_discontinuity_line().unwrap();
    for (line, wins) in [(limit - 1e-3, true), (limit + 1e-3, false)] {
        let shadow = ContactShadow::try_new(line).unwrap();
        let lit = shadow.best_lit_cut().unwrap().unwrap();
        assert_eq!(
            shadow.gain(&line).unwrap() > shadow.gain(&lit).unwrap(),
            wins,
            "{line}"
        );
    }
}
