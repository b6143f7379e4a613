//! Light on meshes that are refined.

mod balance;
mod bound;
mod distribution;
mod divisions;
mod gathers;
mod importance;
mod information;
mod link_factors;
mod lit_rooms;
mod oracles;

use infoscene::hierarchy::{Factors, Goal, Lighting, OracleName, Refinement};
use infoscene::scene::{Occlusion, Scene};

/// A scene in its own light, reflectances times a factor.
fn lit(scene: &Scene, factor: f64) -> Refinement<'_> {
    let materials = || {
        scene
            .patches()
            .iter()
            .map(|patch| patch.material().grey().unwrap())
    };
    let reflectances = materials().map(|material| factor * material.reflectance());
    let emittances = materials().map(|material| material.emittance());
    let lighting = Lighting::try_new(reflectances.collect(), emittances.collect()).unwrap();
    Refinement::try_new(scene, lighting, Occlusion::Exact, Factors::OfPoints).unwrap()
}

/// A room refined to so many elements.
fn refined<'s>(mut room: Refinement<'s>, oracle: OracleName, elements: usize) -> Refinement<'s> {
    let goal = Goal::Elements(elements);
    room.refine(&*oracle.oracle(None).unwrap(), goal, &mut |_| ())
        .unwrap();
    room
}
