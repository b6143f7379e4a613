//! Mutual information from sampled lines: estimates, their bias, their errors, and what is refused.
#![allow(
    clippy::unwrap_used,
    clippy::float_cmp,
    clippy::cast_precision_loss,
    reason = "a test may panic, compares what is exact, and counts little"
)]

mod coverage;
mod estimates;
mod expected_bias;
mod lines;
mod refusals;
mod spread;
mod threads;

#[path = "../support/mod.rs"]
mod support;

use infoscene::information::{Surroundings, scene_information};
use infoscene::scene::{Congruence, Scene, ScenePairs};

/// A built-in scene, quartered so many times.
fn scene(name: &str, times: u32) -> Scene {
    Scene::built_in(name).unwrap().subdivided(times).unwrap().0
}

fn pairs(scene: &Scene) -> ScenePairs {
    ScenePairs::try_new(scene, 1e-12, Congruence::Shared).unwrap()
}

/// The mutual information by closed forms.
fn exact(scene: &Scene) -> f64 {
    let measured = scene_information(&pairs(scene), Surroundings::None).unwrap();
    measured.mutual_information
}

/// The cube with a wall across that leaves two boxes 1 × 1 × ½; its faces are patches. Every line through the cube
/// that is not level crosses it.
fn two_boxes() -> Scene {
    let walls = [(0.5, true), (0.5, false)];
    let walls = walls.map(|(z, up)| support::rooms::level("wall", [0.0, 1.0], [0.0, 1.0], z, up));
    let mut patches = Vec::new();
    for patch in Scene::built_in("cube:1").unwrap().patches() {
        let corners = patch.shape().corners();
        let is_wall = patch.shape().normal().z == 0.0;
        let halves = if is_wall { vec![0.0, 0.5] } else { vec![0.0] };
        let scale = if is_wall { 0.5 } else { 1.0 };
        for low in halves {
            let moved = corners.iter().map(|c| [c.x, c.y, low + scale * c.z]);
            patches.push(support::rooms::polygon(
                patch.name(),
                &moved.collect::<Vec<_>>(),
            ));
        }
    }
    Scene::try_new(patches.into_iter().chain(walls).collect()).unwrap()
}
