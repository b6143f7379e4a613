//! Measures of pairs as they come are those of the matrix, whatever the number of
//! threads.

use crate::support::references::value;
use infoscene::chain::{ChainError, ReversibleChain, open_visibility_chain, visibility_chain};
use infoscene::exchange::{Congruence, ExchangeError, ScenePairs};
use infoscene::form_factor::DEFAULT_TOLERANCE;
use infoscene::information::{
    OpenScene, SceneInformation, entropy_rate, mutual_information, positional_entropy,
    scene_information,
};
use infoscene::numeric::{Grade, tolerance, x_log2_ratio};
use infoscene::scene::{NamedPatch, Occlusion, Scene};

fn pairs(scene: &Scene, occlusion: Occlusion) -> ScenePairs<'static> {
    ScenePairs::try_new(scene, DEFAULT_TOLERANCE, Congruence::Shared, occlusion).unwrap()
}

fn measured(scene: &Scene, surroundings: OpenScene) -> Result<SceneInformation, ChainError> {
    scene_information(&pairs(scene, Occlusion::Refuse), surroundings)
}

fn cube(cells: usize) -> Scene {
    Scene::built_in(&format!("cube:{cells}")).unwrap()
}

/// The inside of a cube without its last patches.
fn opened(cells: usize, without: usize) -> Scene {
    let patches: Vec<NamedPatch> = cube(cells).patches().to_vec();
    Scene::try_new(patches[..patches.len() - without].to_vec()).unwrap()
}

/// `I_i = w_i Σ_j P_ij log2(P_ij/w_j)`, term by term as eq. (3) is printed.
fn contribution(chain: &ReversibleChain, i: usize) -> f64 {
    let terms = (0..chain.states()).map(|j| {
        let transition = chain.transition_probability(i, j);
        x_log2_ratio(transition, chain.stationary_probability(j))
    });
    chain.stationary_probability(i) * terms.sum::<f64>()
}

fn assert_equal(measured: &SceneInformation, chain: &ReversibleChain) {
    let close = |one: f64, other: f64| (one - other).abs() <= tolerance::IDENTITY;
    assert!(close(
        measured.mutual_information.value,
        mutual_information(chain)
    ));
    assert!(close(
        measured.positional_entropy,
        positional_entropy(chain)
    ));
    assert!(close(measured.entropy_rate, entropy_rate(chain)));
    let all = measured
        .contributions
        .iter()
        .chain(&measured.outside_contribution);
    for (i, part) in all.enumerate() {
        assert!(close(*part, contribution(chain, i)), "{i}: {part}");
    }
}

/// Eqs. (1) to (3), and each patch's part of (3).
#[test]
fn streamed_measures_are_those_of_the_matrix() {
    for cells in [1, 2, 3, 6] {
        let scene = cube(cells);
        let chain = visibility_chain(&scene).unwrap();
        let found = measured(&scene, OpenScene::Refuse).unwrap();
        assert_equal(&found, &chain);
        assert!(found.outside_contribution.is_none());
    }
}

/// J_i,out = A_i (1 − Σ_j F_ij): the chain with one more state.
#[test]
fn streamed_measures_of_an_open_scene_are_those_of_its_matrix() {
    let two = Scene::built_in("two-squares").unwrap();
    for scene in [two, opened(1, 1), opened(3, 1), opened(3, 9), opened(2, 10)] {
        let chain = open_visibility_chain(&scene).unwrap();
        let found = measured(&scene, OpenScene::AddOutsideState).unwrap();
        assert_equal(&found, &chain);
        assert_eq!(found.mutual_information.grade, Grade::Estimate);
        assert!(found.outside_contribution.unwrap() > 0.0);
        // the weights of patches are their areas
        for (weight, patch) in chain.weights().iter().zip(scene.patches()) {
            let ratio = weight / patch.shape().area();
            assert!((ratio - 1.0).abs() <= tolerance::CLOSURE, "{ratio}");
        }
    }
}

/// A closed scene is the same with `--open` and without.
#[test]
fn a_closed_scene_has_no_outside() {
    let scene = cube(2);
    let [closed, open] = [OpenScene::Refuse, OpenScene::AddOutsideState]
        .map(|surroundings| measured(&scene, surroundings).unwrap());
    assert_eq!(closed, open);
}

/// `|I − exact| ≤ error` against 29 digits, and the error is small.
#[test]
fn information_errors_are_bounds() {
    for cells in [1, 2, 3, 4, 6] {
        let found = measured(&cube(cells), OpenScene::Refuse).unwrap();
        let exact = value("cube_grids.csv", &format!("cube_regular_{cells}"));
        assert_eq!(found.mutual_information.grade, Grade::Bound);
        let off = (found.mutual_information.value - exact).abs();
        assert!(
            off <= found.mutual_information.error && off <= 1e-13,
            "{cells}: {off} {}",
            found.mutual_information.error
        );
        assert!(
            found.mutual_information.error <= 1e-10,
            "{cells}: {}",
            found.mutual_information.error
        );
    }
}

/// One thread and five give the same bits, of pairs that share and of pairs that do not.
#[test]
fn threads_do_not_change_a_bit() {
    for congruence in [Congruence::Shared, Congruence::Ignored] {
        let measure = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
            pool.build().unwrap().install(|| {
                let pairs =
                    ScenePairs::try_new(&opened(6, 17), 1e-6, congruence, Occlusion::Refuse)
                        .unwrap();
                let held = pairs.exchange_areas().unwrap();
                (
                    scene_information(&pairs, OpenScene::AddOutsideState).unwrap(),
                    held,
                )
            })
        };
        let one = measure(1);
        assert_eq!(one, measure(2));
        assert_eq!(one, measure(5));
    }
}

/// Negative control: the sum depends on the order of its terms, so that equal bits are not a matter
/// of course.
#[test]
fn the_order_of_terms_matters() {
    let pairs =
        ScenePairs::try_new(&cube(6), 1e-6, Congruence::Ignored, Occlusion::Refuse).unwrap();
    let held = pairs.exchange_areas().unwrap();
    let forth = |i: usize| (0..216).map(|j| held.get(i, j).exchange.value).sum::<f64>();
    let back = |i: usize| {
        (0..216)
            .rev()
            .map(|j| held.get(i, j).exchange.value)
            .sum::<f64>()
    };
    assert!((0..216).any(|i| forth(i).to_bits() != back(i).to_bits()));
}

/// A scene whose patches hide each other, taken without occlusion, has rows above one: refused even
/// if open.
#[test]
fn a_row_above_one_is_refused() {
    let mut patches = cube(1).patches().to_vec();
    patches.extend(Scene::facing_squares(0.5).unwrap().patches()[1..].to_vec());
    let pairs = pairs(&Scene::try_new(patches).unwrap(), Occlusion::Ignore);
    let refusal = scene_information(&pairs, OpenScene::AddOutsideState).unwrap_err();
    assert!(
        matches!(
            refusal,
            ChainError::Exchange(ExchangeError::RowAboveOne { row: 0, .. })
        ),
        "{refusal}"
    );
}
