//! Continuous mutual information: known values, other roads to it, invariance, and what lies below it.
#![allow(
    clippy::unwrap_used,
    clippy::float_cmp,
    reason = "a test may panic, and compares what is exact"
)]

mod invariance;
mod known_values;
mod other_roads;
mod refinement;
mod refusals;

#[path = "../support/mod.rs"]
mod support;

use infoscene::information::continuous_information;
use infoscene::scene::Scene;

/// Continuous mutual information of a built-in scene.
fn information(name: &str) -> f64 {
    continuous_information(&Scene::built_in(name).unwrap())
        .unwrap()
        .mutual_information
}

const SOLIDS: [&str; 5] = [
    "tetrahedron",
    "cube:1",
    "octahedron",
    "dodecahedron",
    "icosahedron",
];
