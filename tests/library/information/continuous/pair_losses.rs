//! Losses of pairs of patches: sums, signs, refusals.

use super::information;
use crate::support::breadth::some_of;
use crate::support::rooms::{L, mapped, prism};
use infoscene::chain::ChainError;
use infoscene::exchange::{Congruence, ScenePairs, Unheard};
use infoscene::information::{OpenScene, PairLoss, pair_losses, scene_information};
use infoscene::scene::{Occlusion, Scene, SceneError};

fn losses(scene: &Scene) -> Vec<PairLoss> {
    pair_losses(scene, &Unheard).unwrap()
}

fn discrete(scene: &Scene) -> f64 {
    let pairs = ScenePairs::try_new(scene, 1e-12, Congruence::Shared, Occlusion::Refuse).unwrap();
    scene_information(&pairs, OpenScene::Refuse)
        .unwrap()
        .mutual_information
        .value
}

/// `Σ I_ij = I`, `Σ I^c_ij = I^c` (whose pairs are of whole faces), `Σ P = 1`, each within the
/// errors said.
#[test]
fn parts_of_pairs_sum_to_both_informations() {
    for (name, times) in some_of([
        ("cube:1", 1),
        ("dodecahedron", 0),
        ("box:1,2,0.1", 1),
        ("tetrahedron", 1),
    ]) {
        let (scene, _) = Scene::built_in(name).unwrap().subdivided(times).unwrap();
        let parts = losses(&scene);
        let sum = |of: fn(&PairLoss) -> f64| parts.iter().map(of).sum::<f64>();
        let error = sum(|pair| pair.error) + 1e-13;
        assert!(error < 1e-12, "{name}: {error:e}");
        let continuous = information(name).mutual_information.value;
        for (what, sum, whole) in [
            ("P", sum(|pair| pair.probability), 1.0),
            ("I", sum(|pair| pair.mutual_information), discrete(&scene)),
            (
                "Ic",
                sum(|pair| pair.continuous_mutual_information),
                continuous,
            ),
            ("loss", sum(|pair| pair.loss), continuous - discrete(&scene)),
        ] {
            assert!((sum - whole).abs() < error, "{name} {what}: {sum} {whole}");
        }
    }
}

/// Jensen: no pair loses less than nothing; and no refinement of both patches regains more than the
/// loss.
#[test]
fn losses_bound_what_refinements_gain() {
    let scene = Scene::built_in("box:1,2,0.5").unwrap();
    let (parts, parents) = scene.subdivided(1).unwrap();
    let fine = losses(&parts);
    for pair in losses(&scene) {
        assert!(pair.loss > pair.error, "{pair:?}");
        let of_parts = fine.iter().filter(|part| {
            let mut of = [parents[part.first], parents[part.second]];
            of.sort_unstable();
            of == [pair.first, pair.second]
        });
        let (mut regained, mut left, mut error) = (-pair.mutual_information, 0.0, pair.error);
        for part in of_parts {
            regained += part.mutual_information;
            left += part.loss;
            error += part.error;
        }
        assert!(
            regained > error && regained < pair.loss,
            "{pair:?}: {regained}"
        );
        assert!(
            (regained + left - pair.loss).abs() < error,
            "{pair:?}: {regained} {left}"
        );
    }
}

/// Losses are numbers of the shape.
#[test]
fn losses_do_not_know_the_size() {
    let scene = Scene::built_in("cube:2").unwrap();
    let expected = losses(&scene);
    for scale in [1e-120, 1e120] {
        let found = losses(&mapped(&scene, |corner| scale * corner));
        assert_eq!(found.len(), expected.len());
        for (found, expected) in found.iter().zip(&expected) {
            assert!(
                (found.loss - expected.loss).abs() < found.error + expected.error,
                "{found:?} {expected:?}"
            );
        }
    }
}

#[test]
fn losses_need_a_convex_room() {
    let open = Scene::built_in("two-squares").unwrap();
    let refused = pair_losses(&prism(&L), &Unheard).unwrap_err();
    assert!(
        matches!(refused, ChainError::Scene(SceneError::NotConvex { .. })),
        "{refused}"
    );
    // an open one has the pairs it has
    assert_eq!(losses(&open).len(), 1);
}
