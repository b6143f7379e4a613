//! The penumbra of a half-plane between two squares.

use crate::support::rooms::{among, level, squares};
use infoscene::discretize::{CutMeasure, HalfPlaneShadow, PatchSplit};
use infoscene::geometry::SplitAxis;
use infoscene::numeric::{Certificate, Interval, Scalar, tolerance};
use infoscene::reference;

/// Best cuts by an independent program, printed to six decimals, and the shares of the best gain
/// that the umbra and the lit line keep, printed to whole percents.
const PRINTED: [(f64, f64, f64, f64, f64); 3] = [
    (0.05, 0.517_962, 0.502_020, 99.0, 80.0),
    (0.2, 0.568_324, 0.510_320, 92.0, 50.0),
    (0.35, 0.608_664, 0.523_531, 74.0, 26.0),
];

#[test]
fn best_cuts_of_a_penumbra_are_those_of_the_prototype() {
    for (height, information, square, umbra, lit) in PRINTED {
        let shadow = HalfPlaneShadow::try_new(0.5, height).unwrap();
        for (measure, printed) in CutMeasure::ALL.into_iter().zip([information, square]) {
            let best = shadow.best_cut(measure).unwrap();
            assert!((best - printed).abs() <= 0.5e-6, "{height}: {best}");
            let certified = shadow.certified_cut(measure, 100).unwrap();
            let is_only = matches!(certified.certificate, Certificate::Unique { .. });
            assert!(is_only, "{:?}", certified.certificate);
            let off = (certified.position.clone() - &certified.position.constant(best)).abs();
            assert!(off < off.constant(1e-12), "{height}");
            let (lower, upper) = certified.position.to_doubles();
            assert!(upper - lower <= 2.0 * f64::EPSILON);
        }
        let gain = |at: f64| shadow.gain(CutMeasure::Information, &at).unwrap();
        let best = gain(shadow.best_cut(CutMeasure::Information).unwrap());
        let kept = |line: f64| 100.0 * gain(line) / best;
        for (line, printed) in [
            (shadow.umbra_line(&1.0), umbra),
            (shadow.lit_line(&1.0), lit),
        ] {
            assert!(
                (kept(line) - printed).abs() <= 0.5,
                "{height}: {}",
                kept(line)
            );
        }
    }
}

/// Two other roads: the engine of occluded pairs, and a rule over the area.
#[test]
fn a_penumbra_exchanges_what_other_roads_find() {
    for (edge, height) in [(0.5, 0.2), (0.3, 0.1), (0.6, 0.39)] {
        let shadow = HalfPlaneShadow::try_new(edge, height).unwrap();
        let half = level("half", [edge, 9.0], [-8.0, 9.0], height, true);
        let shape = half.shape().clone();
        let [floor, ceiling] = [0, 1].map(|k| squares()[k].shape().clone());
        let rule = reference::exchange_area_past(&floor, &ceiling, &[shape], 1e-12).unwrap();
        let exact = shadow.exchange_area(&1.0);
        // twice the rule's own estimate, and rounding
        let allowed = 2.0 * rule.error + 1e-13;
        assert!(
            (exact - rule.value).abs() <= allowed,
            "{edge} {height}: {exact} {rule:?}"
        );
        let scene = among(&squares(), &[half]);
        let split = PatchSplit::try_new(&scene, 0, &[1], SplitAxis::U).unwrap();
        for position in [0.1, 0.45, 0.55, 0.9] {
            let found = split.gain(&[position]).unwrap();
            let closed = shadow.gain(CutMeasure::Information, &position).unwrap();
            let allowed = tolerance::OCCLUDED_GAIN * closed;
            assert!(
                (found - closed).abs() <= allowed,
                "{position}: {found} {closed}"
            );
        }
    }
}

/// The derivative in each zone is the slope of the gain, and both are continuous at the lines.
#[test]
fn a_penumbra_joins_its_neighbours() {
    let shadow = HalfPlaneShadow::try_new(0.4, 0.15).unwrap();
    for line in [shadow.lit_line(&1.0), shadow.umbra_line(&1.0)] {
        for measure in CutMeasure::ALL {
            let gain = |at: f64| shadow.gain(measure, &at).unwrap();
            let h = 1e-4;
            let before = (gain(line) - gain(line - h)) / h;
            let after = (gain(line + h) - gain(line)) / h;
            // the second derivatives are below 100
            assert!((before - after).abs() <= 100.0 * h, "{before} {after}");
        }
    }
}

#[test]
fn half_planes_whose_lines_leave_the_floor_are_refused() {
    for (edge, height) in [
        (0.5, 0.5),
        (0.2, 0.3),
        (0.5, 0.0),
        (f64::NAN, 0.1),
        (1.2, 0.1),
    ] {
        assert!(HalfPlaneShadow::try_new(edge, height).is_err());
    }
    let shadow = HalfPlaneShadow::try_new(0.5, 0.2).unwrap();
    let on_a_line = Interval::precise(0.6, 80).hull(&Interval::precise(0.65, 80));
    assert!(shadow.gain(CutMeasure::Information, &on_a_line).is_err());
    assert!(shadow.gain(CutMeasure::Information, &1.0).is_err());
}
