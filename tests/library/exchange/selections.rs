//! Some pairs of a scene, asked for alone: the values of the whole, at the cost of the part.

use crate::support::rooms::level;
use infoscene::exchange::{Congruence, Entry, ExchangeError, ScenePairs, Selection, Tolerance};
use infoscene::scene::{Occlusion, Scene, SceneError};

fn selection(from: Option<&[usize]>, to: Option<&[usize]>) -> Selection {
    let [from, to] = [from, to].map(|rows| rows.map(<[usize]>::to_vec));
    Selection { from, to }
}

fn alone(scene: &Scene, selection: &Selection) -> Result<ScenePairs<'static>, ExchangeError> {
    let (own, occlusion) = (Congruence::Ignored, Occlusion::Refuse);
    ScenePairs::of_selection(scene, 1e-12, own, occlusion, selection)
}

/// Both evaluations have bounds: they differ by no more than the sum of these.
#[test]
fn a_selection_has_the_values_of_the_whole() {
    let scene = Scene::built_in("cube:3").unwrap();
    let all = scene.exchange_areas().unwrap();
    for (from, to, count) in [
        (Some(&[0usize][..]), Some(&[40usize][..]), 1),
        (Some(&[7]), None, 53),
        (None, Some(&[7]), 53),
        (Some(&[1, 30]), Some(&[30, 1, 50]), 4),
    ] {
        let selection = selection(from, to);
        let pairs = alone(&scene, &selection);
        let (entries, summary) = pairs.unwrap().entries(&selection).unwrap();
        assert_eq!(entries.len(), count);
        for Entry { from, to, answer } in &entries {
            let known = all.get(*from, *to).exchange;
            let off = (answer.exchange.value - known.value).abs();
            assert!(
                off <= answer.exchange.error + known.error,
                "{from} {to}: {off:e}"
            );
        }
        // with the plan of the whole the values are the same
        let (shared, occlusion) = (Congruence::Shared, Occlusion::Refuse);
        let pairs = ScenePairs::of_selection(&scene, 1e-12, shared, occlusion, &selection);
        for Entry { from, to, answer } in pairs.unwrap().entries(&selection).unwrap().0 {
            assert_eq!(answer, all.get(from, to));
        }
        // (1, 30) and (30, 1) are one pair
        let pairs = if count == 4 { 3 } else { count };
        assert_eq!(summary.plan.pairs, pairs);
    }
}

/// A row of a closed scene sums to 1, its column to `Σ_i A_i F_ij = A_j`.
#[test]
fn a_complete_row_or_column_has_its_sum() {
    let scene = Scene::built_in("cube:3").unwrap();
    for (from, to, known) in [
        (Some(&[5usize][..]), None, vec![5]),
        (None, Some(&[5usize, 6][..]), vec![5, 6]),
        (Some(&[5]), Some(&[6]), vec![]),
    ] {
        let selection = selection(from, to);
        let pairs = alone(&scene, &selection).unwrap();
        let (entries, _) = pairs.entries(&selection).unwrap();
        let sums = pairs.complete_sums(&selection, &entries);
        assert_eq!(sums.iter().map(|sum| sum.row).collect::<Vec<_>>(), known);
        for sum in sums {
            assert!(
                (sum.sum - 1.0).abs() <= sum.error && sum.error < 1e-12,
                "{sum:?}"
            );
        }
    }
}

#[test]
fn a_pair_beside_the_selection_is_refused() {
    let scene = Scene::built_in("cube:1").unwrap();
    let one = selection(Some(&[0]), Some(&[1]));
    let pairs = alone(&scene, &one).unwrap();
    assert!(pairs.row_pair(1, 0).is_ok());
    let refusal = pairs.row_pair(2, 3).unwrap_err();
    let expected = ExchangeError::NotSelected {
        first: 2,
        second: 3,
    };
    assert_eq!(refusal, expected);
    let beyond = selection(None, Some(&[6]));
    let refusal = alone(&scene, &beyond).unwrap_err();
    let expected = SceneError::NoSuchPatch { index: 6, last: 5 };
    assert_eq!(refusal, expected.into());
}

/// Two squares face each other; beside them lie two more, which overlap or not, and a third between
/// the first two or not.
#[test]
fn only_what_concerns_a_selection_is_checked() {
    let [unit, aside] = [[0.0, 1.0], [5.0, 6.0]];
    let scene = |between: bool| {
        let x = if between { unit } else { aside };
        let patches = vec![
            level("floor", unit, unit, 0.0, true),
            level("ceiling", unit, unit, 1.0, false),
            level("one", aside, unit, 0.0, true),
            level("two", [5.5, 6.5], unit, 0.0, true),
            level("shelf", x, unit, 0.5, true),
        ];
        Scene::try_new(patches).unwrap()
    };
    let ask = |scene: &Scene, from: usize, to: Option<usize>, occlusion| {
        let to = to.map(|to| vec![to]);
        let from = Some(vec![from]);
        let selection = Selection { from, to };
        ScenePairs::of_selection(scene, 1e-12, Congruence::Ignored, occlusion, &selection)
            .map(|_| ())
    };
    let (free, blocked) = (scene(false), scene(true));
    assert_eq!(ask(&free, 0, Some(1), Occlusion::Refuse), Ok(()));
    assert_eq!(ask(&blocked, 0, Some(1), Occlusion::Ignore), Ok(()));
    let hidden = ask(&blocked, 0, Some(1), Occlusion::Refuse).unwrap_err();
    assert!(
        matches!(
            hidden,
            ExchangeError::Scene(SceneError::MayBeBlocked {
                first: 0,
                second: 1,
                ..
            })
        ),
        "{hidden}"
    );
    // an overlap concerns those who see it, whether occlusion counts or not
    for (from, to) in [(2, Some(1)), (0, Some(3)), (0, None)] {
        let lying = ask(&free, from, to, Occlusion::Ignore).unwrap_err();
        assert!(
            matches!(
                lying,
                ExchangeError::Scene(SceneError::Overlap {
                    first: 2,
                    second: 3,
                    ..
                })
            ),
            "{lying}"
        );
    }
}

/// `error ≤ max(absolute, relative · F)`: the absolute one is that of the larger form factor.
#[test]
fn an_absolute_error_is_kept_and_saves_work() {
    let scene = Scene::built_in("cornell-box").unwrap();
    let all = scene.exchange_areas().unwrap();
    for absolute in [1e-3, 1e-6, 1e-9] {
        let tolerance = Tolerance {
            relative: 1e-15,
            absolute: Some(absolute),
        };
        let pairs =
            ScenePairs::try_new(&scene, tolerance, Congruence::Ignored, Occlusion::Ignore).unwrap();
        let found = pairs.exchange_areas().unwrap();
        assert_eq!(found.summary().unreached, 0);
        for (i, j) in (0..found.rows()).flat_map(|i| (0..i).map(move |j| (i, j))) {
            let smaller = found.areas()[i].min(found.areas()[j]);
            let (rough, known) = (found.get(i, j).exchange, all.get(i, j).exchange);
            assert!(rough.error <= absolute * smaller, "{i} {j}: {rough:?}");
            let off = (rough.value - known.value).abs();
            assert!(off <= rough.error + known.error, "{i} {j}: {off:e}");
        }
    }
    // a relative error alone, that no route reaches
    let hopeless = ScenePairs::try_new(&scene, 1e-30, Congruence::Ignored, Occlusion::Ignore);
    let missed = hopeless.unwrap().exchange_areas().unwrap();
    assert!(missed.summary().unreached > 0);
}
