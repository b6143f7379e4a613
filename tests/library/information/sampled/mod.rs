//! Mutual information from sampled lines: estimates, their bias, their errors, and what is refused.

mod coverage;
mod estimates;
mod expected_bias;
mod lines;
mod refusals;
mod spread;
mod threads;

use infoscene::exchange::{Congruence, ScenePairs};
use infoscene::information::{OpenScene, scene_information};
use infoscene::scene::{Occlusion, Scene};

/// A built-in scene, quartered so many times.
fn scene(name: &str, times: u32) -> Scene {
    Scene::built_in(name).unwrap().subdivided(times).unwrap().0
}

fn pairs(scene: &Scene) -> ScenePairs<'static> {
    ScenePairs::try_new(scene, 1e-12, Congruence::Shared, Occlusion::Refuse).unwrap()
}

/// The mutual information by closed forms.
fn exact(scene: &Scene) -> f64 {
    let measured = scene_information(&pairs(scene), OpenScene::Refuse).unwrap();
    measured.mutual_information.value
}

/// The cube with walls across that leave n slabs 1 × 1 × 1/n; its faces are patches. Lines that are
/// not level cross several.
fn slabs(n: usize) -> Scene {
    let heights = || (1..n).map(|k| k as f64 / n as f64);
    let walls = heights().flat_map(|z| [(z, true), (z, false)]);
    let walls =
        walls.map(|(z, up)| crate::support::rooms::level("wall", [0.0, 1.0], [0.0, 1.0], z, up));
    let mut patches = Vec::new();
    for patch in Scene::built_in("cube:1").unwrap().patches() {
        let corners = patch.shape().corners();
        let is_side = patch.shape().normal().z == 0.0;
        let parts = if is_side { n } else { 1 };
        for part in 0..parts {
            let height = |z: f64| (part as f64 + z) / parts as f64;
            let moved = corners.iter().map(|c| [c.x, c.y, height(c.z)]);
            let moved: Vec<[f64; 3]> = moved.collect();
            patches.push(crate::support::rooms::polygon(patch.name(), &moved));
        }
    }
    Scene::try_new(patches.into_iter().chain(walls).collect()).unwrap()
}
