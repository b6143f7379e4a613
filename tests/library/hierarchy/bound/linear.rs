//! The bound for radiosities that are linear on each leaf.

use super::solver::room;
use super::truth::uniform;
use crate::hierarchy::lit_rooms::{ROOMS, lighting, refined};
use crate::transport::uneven;
use glam::DVec3;
use infoscene::hierarchy::{ErrorBound, HierarchyError, Lighting, OracleName, Refinement, Tree};
use infoscene::reference::BoxRadiosity;
use infoscene::scene::{Channel, Scene};

/// The values and the gradients of a solution by leaf.
fn linear(room: &Refinement<'_>) -> (Vec<f64>, Vec<DVec3>) {
    let (tree, light, solution) = (room.tree(), room.lighting(), room.solution());
    let of = |leaf| {
        let gradient = solution.gradient(tree, light, leaf);
        (solution.radiosity[leaf], gradient)
    };
    tree.leaves().map(of).unzip()
}

/// `‖B − B_h‖` over all that is no light.
fn error(tree: &Tree, exact: &BoxRadiosity, values: &[f64], gradients: &[DVec3]) -> f64 {
    let leaves: Vec<usize> = tree.leaves().collect();
    let moments = exact.leaf_moments(tree);
    let squares = moments.iter().map(|(leaf, moments)| {
        let place = leaves.iter().position(|other| other == leaf).unwrap();
        moments.squared_error(values[place], gradients[place])
    });
    squares.sum::<f64>().sqrt()
}

/// `‖B − B_h‖ ≤ bound ≤ 4 ‖B − B_h‖` for a linear solution of a cube. The control: slopes that are
/// turned about make an error that is beyond the bound of the same means as constants, and within
/// their own.
#[test]
fn a_linear_solution_is_bounded() {
    let scene = Scene::built_in("lit-cube").unwrap();
    let exact = BoxRadiosity::try_new(&scene, Channel::Green, 4).unwrap();
    let light = lighting(&scene);
    let room = refined(&scene, &light, OracleName::Gradient, 60);
    let tree = room.tree();
    let (values, gradients) = linear(&room);
    let found = ErrorBound::of_linear(&scene, tree, &light, &values, &gradients).unwrap();
    let ratio = found.absolute / error(tree, &exact, &values, &gradients);
    assert!((1.0..4.0).contains(&ratio), "{ratio}");

    let constant = ErrorBound::try_new(&scene, tree, &light, &values).unwrap();
    let turned: Vec<DVec3> = gradients.iter().map(|gradient| -3.0 * gradient).collect();
    let found = ErrorBound::of_linear(&scene, tree, &light, &values, &turned).unwrap();
    let off = error(tree, &exact, &values, &turned);
    assert!(off > constant.absolute, "{off} {}", constant.absolute);
    assert!((1.0..2.0).contains(&(found.absolute / off)));
    // leaf by leaf, too
    let leaves: Vec<usize> = tree.leaves().collect();
    for (leaf, moments) in exact.leaf_moments(tree) {
        let place = leaves.iter().position(|other| *other == leaf).unwrap();
        let off = moments.squared_error(values[place], turned[place]).sqrt();
        assert!(off <= found.bound_by_leaf[place], "leaf {leaf}");
    }
}

/// Where little is reflected, B is what the residual of B̃ shows, and nearly nothing is left to
/// bound: slopes that are right, none, turned about, or too steep have bounds next to their errors,
/// so that no term can be lost or change its sign.
#[test]
fn a_dark_room_is_bounded_by_little_more_than_its_error() {
    let scene = room("lit-cube", Some(0.1));
    let exact = BoxRadiosity::try_new(&scene, Channel::Green, 6).unwrap();
    let light = lighting(&scene);
    let room = refined(&scene, &light, OracleName::Gradient, 60);
    let tree = room.tree();
    let (values, gradients) = linear(&room);
    for (factor, most) in [(1.0, 1.3), (0.0, 1.1), (-3.0, 1.05), (5.0, 1.05)] {
        let slopes: Vec<DVec3> = gradients.iter().map(|g| factor * *g).collect();
        let found = ErrorBound::of_linear(&scene, tree, &light, &values, &slopes).unwrap();
        let ratio = found.absolute / error(tree, &exact, &values, &slopes);
        assert!((1.0..most).contains(&ratio), "{factor}: {ratio}");
    }
}

/// In a furnace B = 1, so that on squares of side h
///
/// ```text
///   ‖1 − B_h‖² = Σ h² d² + h⁴ |g|²/12        d: what means are off, g: gradients
/// ```
#[test]
fn slopes_in_a_furnace_are_bounded_by_little_more_than_their_error() {
    let (size, scene) = (0.5, Scene::built_in("cube:1").unwrap());
    let tree = uniform(&scene, size);
    for (seed, reflectance) in [(1, 0.5), (2, 0.9), (3, 0.99)] {
        let light = Lighting::try_new(vec![reflectance; 6], vec![1.0 - reflectance; 6]).unwrap();
        let (mut values, mut gradients, mut square) = (Vec::new(), Vec::new(), 0.0);
        for (place, leaf) in tree.leaves().enumerate() {
            let corners = tree.elements()[leaf].shape().corners();
            let off = 0.02 * (uneven(place, seed) - 0.5);
            let along = (corners[1] - corners[0]) / size;
            let across = (corners[2] - corners[1]) / size;
            let slopes = [4, 5].map(|k| uneven(place, seed + k) - 0.5);
            values.push(1.0 + off);
            gradients.push(slopes[0] * along + slopes[1] * across);
            let steep = slopes[0] * slopes[0] + slopes[1] * slopes[1];
            square += size.powi(2) * off * off + size.powi(4) * steep / 12.0;
        }
        let bound = ErrorBound::of_linear(&scene, &tree, &light, &values, &gradients).unwrap();
        let ratio = bound.absolute / square.sqrt();
        assert!((1.0..1.5).contains(&ratio), "R = {reflectance}: {ratio}");
    }
}

#[test]
fn gradients_that_are_none_are_refused() {
    let scene = Scene::built_in("cube:1").unwrap();
    let tree = uniform(&scene, 1.0);
    let light = Lighting::try_new(vec![0.5; 6], vec![1.0; 6]).unwrap();
    let refused = |gradients: &[DVec3]| {
        ErrorBound::of_linear(&scene, &tree, &light, &[1.0; 6], gradients).unwrap_err()
    };
    assert!(matches!(
        refused(&[DVec3::ZERO; 5]),
        HierarchyError::WrongCount {
            found: 5,
            expected: 6,
            ..
        }
    ));
    let mut gradients = [DVec3::ZERO; 6];
    gradients[3].y = f64::NAN;
    assert!(matches!(
        refused(&gradients),
        HierarchyError::WrongGradient { leaf: 3, .. }
    ));
}

/// `‖B − B_h‖ ≤ bound` for linear solutions of three rooms; the table is printed.
#[test]
#[ignore = "minutes: cargo test --release --test library bound::linear -- --ignored --nocapture"]
fn linear_solutions_are_bounded() {
    for name in ROOMS {
        for reflectance in [
            None,
            Some(0.3),
            Some(0.5),
            Some(0.9),
            Some(0.95),
            Some(0.99),
        ] {
            let scene = room(name, reflectance);
            let exact = BoxRadiosity::try_new(&scene, Channel::Green, 8).unwrap();
            let light = lighting(&scene);
            for elements in [100, 300] {
                let room = refined(&scene, &light, OracleName::Gradient, elements);
                let (values, gradients) = linear(&room);
                let tree = room.tree();
                let bound = ErrorBound::of_linear(&scene, tree, &light, &values, &gradients);
                let off = error(tree, &exact, &values, &gradients);
                let ratio = bound.unwrap().absolute / off;
                println!("{name} {elements} R={reflectance:?}: {off:.3e}, bound/error {ratio:.3}");
                assert!(ratio >= 1.0, "{name} {reflectance:?} {elements}: {ratio}");
            }
        }
    }
}
