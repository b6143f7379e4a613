//! Passes that are shared out among ranks have the same answers, to the last bit.

use crate::support::breadth::some_of;
use crate::support::ranks::among;
use infoscene::exchange::{Congruence, PassSummary, ScenePairs, failure};
use infoscene::scene::{Occlusion, Scene};

fn pairs(scene: &Scene) -> ScenePairs<'_> {
    ScenePairs::try_new(scene, 1e-12, Congruence::Shared, Occlusion::Exact).unwrap()
}

fn sums(pairs: &ScenePairs<'_>) -> (Vec<[u64; 2]>, PassSummary) {
    let term = |i: usize, j: usize, exchange: &infoscene::form_factor::ExchangeArea| {
        [exchange.value, exchange.value / (1.0 + (i * j) as f64)]
    };
    let (sums, summary) = pairs.row_sums(term).unwrap();
    let bits = sums.iter().map(|sums| sums.map(f64::to_bits)).collect();
    (bits, summary)
}

/// Sums of rows, and the counts of pairs with them, on one to five ranks: of a cube of many tiles,
/// and of a room in which blocks stand in the way, whose classes are taken by pairs of any rank.
#[test]
fn row_sums_do_not_depend_on_the_number_of_ranks() {
    for (name, subdivide) in [("cube:10", 0), ("cornell-box-blocks", 1)] {
        let scene = Scene::built_in(name).unwrap();
        let (scene, _) = scene.subdivided(subdivide).unwrap();
        let expected = sums(&pairs(&scene));
        for count in some_of([3, 1, 5, 2]) {
            let found = among(count, |ranks| {
                let pairs = pairs(&scene).among(ranks);
                sums(&pairs)
            });
            for found in found {
                assert!(found == expected, "{name} on {count} ranks: {:?}", found.1);
            }
        }
    }
}

/// The first rank that fails is named to all.
#[test]
fn all_learn_of_a_failure() {
    let told = among(3, |ranks| {
        let reason = (ranks.number() > 0).then(|| format!("disk {} full", ranks.number()));
        failure(ranks, reason.as_deref()).unwrap().to_string()
    });
    assert_eq!(told, ["rank 1: disk 1 full"; 3]);
    let none = among(2, |ranks| failure(ranks, None));
    assert_eq!(none, [None, None]);
}
