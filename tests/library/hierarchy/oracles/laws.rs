//! Laws that priorities obey.

use crate::hierarchy::lit_rooms::{
    ROOMS, furnace, lighting, priorities, reference, refined, refined_by, start,
};
use glam::DVec3;
use infoscene::geometry::Patch;
use infoscene::hierarchy::{Lighting, OracleCost, OracleName, Refinement};
use infoscene::scene::{NamedPatch, Scene};

const WITHOUT_REFERENCE: usize = OracleName::ALL.len() - 1;

/// In uniform light nothing is gained by a finer mesh, but from which side light comes is better
/// known: form factors of the patches of a closed room sum to 1 at every point.
#[test]
fn a_furnace_has_no_error_but_more_information() {
    let scene = Scene::built_in("cube:1").unwrap();
    let room = start(&scene, &furnace(&scene));
    let largest = |name| priorities(&room, name).into_iter().fold(0.0, f64::max);
    // gradients of links are kept in 24 bits, form factors of pairs to 1e-6, the light to 1e-4
    for (name, rounding) in [
        (OracleName::Gradient, 1e-6),
        (OracleName::Received, 1e-12),
        (OracleName::Residual, 1e-12),
        (OracleName::Gather, 1e-5),
    ] {
        assert!(largest(name) < rounding, "{name}: {}", largest(name));
    }
    for name in [
        OracleName::Kernel,
        OracleName::Information,
        OracleName::Chain,
        OracleName::Losses,
    ] {
        assert!(largest(name) > 0.01, "{name}: {}", largest(name));
    }
}

/// Theorem 1, and its corollary for losses; no priority is negative or NaN.
#[test]
fn priorities_are_at_least_zero() {
    for name in ROOMS {
        let scene = Scene::built_in(name).unwrap();
        let room = refined(&scene, &lighting(&scene), OracleName::Gradient, 60);
        for name in &OracleName::ALL[..WITHOUT_REFERENCE] {
            let all = priorities(&room, *name);
            assert!(all.iter().all(|priority| *priority >= 0.0), "{name}");
            assert!(all.iter().any(|priority| *priority > 0.0), "{name}");
        }
    }
}

/// `|Σ_j B_j ∇F_j| ≤ Σ_j B_j |∇F_j|` as norms over the element.
#[test]
fn the_kernel_bounds_the_gradient() {
    let scene = Scene::built_in("lit-cube").unwrap();
    let room = refined(&scene, &lighting(&scene), OracleName::Gradient, 200);
    let kernel = priorities(&room, OracleName::Kernel);
    let gradient = priorities(&room, OracleName::Gradient);
    // sums of some hundred terms in another order
    let holds = |(k, g): (&f64, &f64)| *k >= g * (1.0 - 1e-12);
    assert!(kernel.iter().zip(&gradient).all(holds));
}

/// The meshes of a room eight times as bright and four times as large are the same: powers of two
/// change no digit.
#[test]
fn meshes_do_not_depend_on_units() {
    let scene = Scene::built_in("lit-cube").unwrap();
    let materials = lighting(&scene);
    let larger = scene.patches().iter().map(|patch| {
        let corners = patch.shape().corners().iter().map(|c| 4.0 * *c);
        NamedPatch::new(
            patch.name().to_owned(),
            Patch::try_new(corners.collect()).unwrap(),
        )
    });
    let larger = Scene::try_new(larger.collect()).unwrap();
    let patches = 0..materials.patches();
    let brighter = Lighting::try_new(
        patches.clone().map(|k| materials.reflectance(k)).collect(),
        patches.map(|k| 8.0 * materials.emittance(k)).collect(),
    )
    .unwrap();
    let centres = |room: &Refinement<'_>| -> Vec<DVec3> {
        let elements = room.tree().elements().iter();
        elements.map(|element| element.centre()).collect()
    };
    for name in &OracleName::ALL[..WITHOUT_REFERENCE] {
        let meshes = [(&scene, &materials, 1.0), (&larger, &brighter, 0.25)];
        let [small, large] = meshes.map(|(scene, materials, unit)| {
            let room = refined(scene, materials, *name, 60);
            let centres = centres(&room).into_iter();
            centres.map(|centre| unit * centre).collect::<Vec<_>>()
        });
        assert_eq!(small, large, "{name}");
    }
}

/// ‖B − B_h‖² is at least ‖B − P B‖², the sum of the squared priorities.
#[test]
fn true_errors_add_up_to_that_of_the_best_means() {
    let scene = Scene::built_in("lit-cube").unwrap();
    let materials = lighting(&scene);
    let reference = reference(&scene, &materials, 1000);
    let oracle = OracleName::True.oracle(Some(&reference)).unwrap();
    let mut errors = Vec::new();
    for elements in [40, 160] {
        let room = refined_by(&*oracle, start(&scene, &materials), elements);
        let best = reference.projection_error_of(room.tree());
        let error = reference.error_of(room.tree(), room.solution());
        // both are sums over the same points
        assert!(best <= error * (1.0 + 1e-12));
        let leaves: Vec<usize> = room.tree().leaves().collect();
        let priorities = oracle.priorities(&room.view(), &leaves).unwrap();
        errors.push((best, priorities.iter().map(|p| p * p).sum::<f64>().sqrt()));
    }
    let [(coarse, coarse_norm), (fine, fine_norm)] = errors[..] else {
        unreachable!()
    };
    assert!((coarse / coarse_norm / (fine / fine_norm) - 1.0).abs() < 1e-12);
}

/// What links know costs nothing; others ask for points of each link.
#[test]
fn oracles_are_charged_for_what_they_ask() {
    let scene = Scene::built_in("cube:1").unwrap();
    let cost = |name| {
        let room = start(&scene, &furnace(&scene));
        priorities(&room, name);
        room.oracle_cost()
    };
    let links = 6 * 5;
    let free = [
        OracleName::Gradient,
        OracleName::Kernel,
        OracleName::Power,
        OracleName::Neighbours,
        OracleName::Area,
    ];
    for name in free {
        assert_eq!(cost(name), OracleCost::default(), "{name}");
    }
    for (name, points, pairs) in [
        (OracleName::Residual, 4, 0),
        (OracleName::Information, 4, 0),
        (OracleName::Received, 4, 0),
        (OracleName::Losses, 16, 0),
        (OracleName::Gather, 0, 4),
    ] {
        let [points, pairs] = [points, pairs].map(|each| each * links);
        assert_eq!(cost(name), OracleCost { points, pairs }, "{name}");
    }
}
