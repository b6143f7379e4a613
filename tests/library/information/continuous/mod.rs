//! Continuous mutual information: known values, other roads to it, invariance, and what lies below
//! it.

mod cross_sections;
mod invariance;
mod known_values;
mod other_roads;
mod pair_losses;
mod refusals;

use infoscene::information::{ContinuousInformation, continuous_information};
use infoscene::scene::Scene;
use std::collections::BTreeMap;
use std::sync::Mutex;

/// Continuous mutual information of a built-in scene, computed once.
fn information(name: &str) -> ContinuousInformation {
    static KNOWN: Mutex<BTreeMap<String, ContinuousInformation>> = Mutex::new(BTreeMap::new());
    let mut known = KNOWN.lock().unwrap();
    let compute = || continuous_information(&Scene::built_in(name).unwrap()).unwrap();
    known.entry(name.to_owned()).or_insert_with(compute).clone()
}

/// Relative accuracy promised for moderate and for extreme rooms.
const MODERATE: f64 = 1e-12;
const EXTREME: f64 = 1e-10;

const SOLIDS: [&str; 5] = [
    "tetrahedron",
    "cube:1",
    "octahedron",
    "dodecahedron",
    "icosahedron",
];
