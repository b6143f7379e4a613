//! Bounds over single leaves, and at points after one more gather.

use crate::hierarchy::lit_rooms::{furnace, lighting, refined};
use glam::DVec3;
use infoscene::hierarchy::{ErrorBound, HierarchyError, OracleName};
use infoscene::reference::BoxRadiosity;
use infoscene::scene::{Channel, Scene};

/// `‖B − B_h‖ ≤ bound` over each leaf of a cube, against its radiosity by a road that shares
/// nothing with it; half of the bounds are less than 12 times the error. An even share of the bound
/// of the whole, the control, is below the error of some leaf.
#[test]
fn each_leaf_has_its_bound() {
    let scene = Scene::built_in("lit-cube").unwrap();
    let exact = BoxRadiosity::try_new(&scene, Channel::Green, 4).unwrap();
    let light = lighting(&scene);
    let room = refined(&scene, &light, OracleName::Gradient, 60);
    let leaves: Vec<usize> = room.tree().leaves().collect();
    let values: Vec<f64> = leaves
        .iter()
        .map(|l| room.solution().radiosity[*l])
        .collect();
    let bound = ErrorBound::try_new(&scene, room.tree(), &light, &values).unwrap();
    let even = bound.absolute / (leaves.len() as f64).sqrt();
    let (mut ratios, mut beyond) = (Vec::new(), 0);
    for (leaf, moments) in exact.leaf_moments(room.tree()) {
        let place = leaves.iter().position(|other| *other == leaf).unwrap();
        let error = moments.squared_error(values[place], DVec3::ZERO).sqrt();
        let most = bound.bound_by_leaf[place];
        assert!(error <= most, "leaf {leaf}: {error:e} > {most:e}");
        beyond += usize::from(error > even);
        ratios.push(most / error);
    }
    ratios.sort_by(f64::total_cmp);
    let median = ratios[ratios.len() / 2];
    assert!(median < 12.0, "{median}");
    assert!(beyond > 0);
}

/// Radiosities gathered at points of a cube are off by less than their bounds; on a coarse mesh
/// half of the bounds are less than six tenths of the radiosity.
#[test]
fn points_have_bounds() {
    let scene = Scene::built_in("lit-cube").unwrap();
    let exact = BoxRadiosity::try_new(&scene, Channel::Green, 6).unwrap();
    let light = lighting(&scene);
    let room = refined(&scene, &light, OracleName::Gradient, 60);
    let leaves = room.tree().leaves();
    let values: Vec<f64> = leaves.map(|leaf| room.solution().radiosity[leaf]).collect();
    let bound = ErrorBound::try_new(&scene, room.tree(), &light, &values).unwrap();
    let mut parts = Vec::new();
    for (patch, [s, t]) in [
        (0, [0.5, 0.5]),
        (0, [0.95, 0.4]),
        (2, [0.3, 0.8]),
        (8, [0.5, 0.3]),
    ] {
        let corners = scene.patches()[patch].shape().corners();
        let point = corners[0] + s * (corners[1] - corners[0]) + t * (corners[3] - corners[0]);
        let found = bound.gathered(patch, point).unwrap();
        let truth = exact.radiosity(patch, point);
        let off = (found.value - truth.value).abs() - truth.error;
        assert!(
            off <= found.error,
            "patch {patch} at {point}: {off:e}, {found:?}"
        );
        parts.push(found.error / found.value);
    }
    parts.sort_by(f64::total_cmp);
    assert!(parts[1] < 0.6, "{parts:?}");
}

/// In a furnace B = 1 everywhere: single leaves and points know what their radiosities are off,
/// past a plate, too.
#[test]
fn a_furnace_is_bounded_leaf_by_leaf() {
    for name in ["lit-cube", "shaded-cube"] {
        let scene = Scene::built_in(name).unwrap();
        let light = furnace(&scene);
        let room = refined(&scene, &light, OracleName::Area, 24);
        let off = |leaf: usize| 0.2 * (leaf as f64).sin();
        let values: Vec<f64> = (0..room.tree().leaf_count())
            .map(|l| 1.0 + off(l))
            .collect();
        let bound = ErrorBound::try_new(&scene, room.tree(), &light, &values).unwrap();
        for (place, leaf) in room.tree().leaves().enumerate() {
            let element = &room.tree().elements()[leaf];
            let error = off(place).abs() * element.shape().area().sqrt();
            let most = bound.bound_by_leaf[place];
            assert!(
                error <= most * (1.0 + 1e-9),
                "{name} {leaf}: {error:e} > {most:e}"
            );
            // some points: each takes an adjoint solution
            if place % 8 != 3 {
                continue;
            }
            let inside =
                element.centre() + 1e-3 * (element.shape().corners()[0] - element.centre());
            let found = bound.gathered(element.patch(), inside).unwrap();
            assert!(
                (found.value - 1.0).abs() <= found.error,
                "{name} {leaf}: {found:?}"
            );
        }
    }
}

/// A point outside of the patch, off its plane, or on an edge of a leaf that it sees has no bound.
#[test]
fn points_without_a_bound_are_refused() {
    let scene = Scene::built_in("lit-cube").unwrap();
    let light = furnace(&scene);
    let room = refined(&scene, &light, OracleName::Area, 12);
    let values = vec![0.9; room.tree().leaf_count()];
    let bound = ErrorBound::try_new(&scene, room.tree(), &light, &values).unwrap();
    let corners = scene.patches()[0].shape().corners();
    let [middle, edge] = [
        0.5 * (corners[0] + corners[2]),
        0.5 * (corners[0] + corners[1]),
    ];
    let up = scene.patches()[0].shape().normal();
    for (patch, point) in [
        (0, middle + 2.0 * (corners[1] - corners[0])),
        (0, middle + 1e-3 * up),
        (0, edge),
        (99, middle),
        (0, DVec3::NAN),
    ] {
        let refused = bound.gathered(patch, point);
        let is_refused = matches!(refused, Err(HierarchyError::NoBoundAt { .. }));
        assert!(is_refused, "{patch} {point}: {refused:?}");
    }
    assert!(bound.gathered(0, middle).is_ok());
}
