//! Open scenes, empty counts and impossible pairs are refused, and no estimate is NaN.

use super::scene;
use crate::support::rooms::level;
use infoscene::chain::ChainError;
use infoscene::exchange::ExchangeError;
use infoscene::information::{LineKind, LineSample, PairCounts};
use infoscene::scene::Scene;

fn refusal(scene: &Scene, kind: LineKind) -> ExchangeError {
    match LineSample::draw(scene, kind, 2000, 1) {
        Err(ChainError::Exchange(refusal)) => refusal,
        other => panic!("{other:?}"),
    }
}

#[test]
fn open_scenes_are_refused() {
    let mut patches = scene("cube:2", 0).patches().to_vec();
    patches.remove(3);
    let hole = Scene::try_new(patches).unwrap();
    let shelf = level("shelf", [0.2, 0.8], [0.2, 0.8], 0.5, true);
    let shelf = scene("cube:1", 0).with_obstructions(vec![shelf]);
    for scene in [&hole, &shelf, &scene("two-squares", 0)] {
        for kind in [LineKind::Local, LineKind::Global] {
            let refused = refusal(scene, kind);
            assert!(
                matches!(refused, ExchangeError::LinesEscape { lost, lines: 2000 } if lost > 20),
                "{refused}"
            );
        }
    }
}

/// A needle fills 1e-6 of its sphere: global lines give up, local ones do not care.
#[test]
fn needles_are_for_local_lines() {
    let needle = scene("box:1,1,1000000", 0);
    let refused = LineSample::draw(&needle, LineKind::Global, 2, 1).unwrap_err();
    assert!(refused.to_string().contains("local"), "{refused}");
    let sample = LineSample::draw(&needle, LineKind::Local, 2000, 1).unwrap();
    assert!(sample.counts.plug_in() > 0.0);
}

#[test]
fn impossible_counts_are_refused() {
    let refused = |weights: &[f64], counts: &[([usize; 2], u64)]| {
        PairCounts::try_new(weights, counts.iter().copied()).unwrap_err()
    };
    let one = [([0, 1], 1)];
    assert!(matches!(
        refused(&[1.0, f64::NAN], &one),
        ChainError::InvalidWeight { state: 1, .. }
    ));
    assert!(matches!(
        refused(&[-1.0, 1.0], &one),
        ChainError::InvalidWeight { state: 0, .. }
    ));
    assert!(matches!(
        refused(&[0.0, 0.0], &one),
        ChainError::NoMass { .. }
    ));
    assert!(matches!(refused(&[], &one), ChainError::NoMass { .. }));
    assert_eq!(refused(&[1.0, 1.0], &[]), ChainError::NoSamples);
    assert_eq!(refused(&[1.0, 1.0], &[([0, 1], 0)]), ChainError::NoSamples);
    assert_eq!(
        refused(&[1.0, 1.0], &[([2, 0], 1)]),
        ChainError::NoSuchState { state: 2, last: 1 }
    );
    assert_eq!(
        refused(&[1.0, 0.0], &one),
        ChainError::ImpossiblePair { row: 0, column: 1 }
    );
}

/// One sample, one cell, all alone, counts beyond 2^53: numbers all the same.
#[test]
fn no_estimate_is_nan() {
    let weights = [1.0, 1e-200, 1e100];
    for counts in [
        vec![([1, 1], 1)],
        vec![([0, 2], 1), ([2, 2], 1)],
        vec![([0, 2], 1 << 60), ([2, 2], 3)],
        vec![([0, 2], 2), ([2, 2], 2)],
    ] {
        let counts = PairCounts::try_new(&weights, counts).unwrap();
        for number in [
            counts.plug_in(),
            counts.plug_in_of_counted_weights(),
            counts.miller_madow(),
            counts.corrected(),
            counts.standard_error(),
            counts.unseen(),
        ] {
            assert!(number.is_finite(), "{counts:?}: {number}");
        }
    }
}
