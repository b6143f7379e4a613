//! The form factors of a closed scene sum to one, row by row.

use infoscene::chain::{ChainError, visibility_chain};
use infoscene::exchange::ExchangeError;
use infoscene::numeric::tolerance;
use infoscene::scene::{NamedPatch, Scene};

/// `Σ_j F_ij = 1` for the cube, from 1 to 6 cells a side.
#[test]
fn form_factors_of_a_closed_scene_sum_to_one() {
    for cells in 1..=6 {
        let scene = Scene::built_in(&format!("cube:{cells}")).unwrap();
        let chain = visibility_chain(&scene).unwrap();
        for (weight, patch) in chain.weights().iter().zip(scene.patches()) {
            let sum = weight / patch.shape().area();
            assert!(
                (sum - 1.0).abs() <= tolerance::CLOSURE,
                "{cells}: {} sums to {sum}",
                patch.name()
            );
        }
    }
}

/// Negative control: without one patch the scene is open, and the row that misses most is named.
#[test]
fn an_open_scene_is_refused_with_its_worst_row() {
    let cube = Scene::built_in("cube:1").unwrap();
    let five: Vec<NamedPatch> = cube.patches()[..5].to_vec();
    let refusal = visibility_chain(&Scene::try_new(five).unwrap()).unwrap_err();
    let ChainError::Exchange(ExchangeError::OpenScene { row, name, sum, .. }) = refusal else {
        panic!("{refusal}")
    };
    // the lacking face is opposite to face 4 and adjacent to the others, and sees 0.2000 of each
    assert!(
        row < 5 && (sum - 0.8).abs() < 1e-3,
        "row {row} sums to {sum}"
    );
    assert_eq!(name, cube.patches()[row].name());
}
