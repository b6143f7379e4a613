//! Rooms with their materials, refined.

use infoscene::hierarchy::{Factors, Goal, Lighting, Oracle, OracleName, Reference, Refinement};
use infoscene::scene::{Occlusion, Scene};

/// The built-in rooms of a cube and a hall with a light.
pub const ROOMS: [&str; 3] = ["lit-cube", "lit-cube-edge", "lit-hall"];

/// The materials that a scene comes with.
pub fn lighting(scene: &Scene) -> Lighting {
    let patches = scene.patches().iter();
    let materials: Vec<_> = patches.map(|p| p.material().grey().unwrap()).collect();
    Lighting::try_new(
        materials.iter().map(|m| m.reflectance()).collect(),
        materials.iter().map(|m| m.emittance()).collect(),
    )
    .unwrap()
}

/// A room of which every patch glows as much as it absorbs: B = 1 everywhere.
pub fn furnace(scene: &Scene) -> Lighting {
    let count = scene.patches().len();
    Lighting::try_new(vec![0.5; count], vec![0.5; count]).unwrap()
}

/// The patches of a scene, lit, with the form factors of points.
pub fn start<'s>(scene: &'s Scene, lighting: &Lighting) -> Refinement<'s> {
    let factors = Factors::OfPoints;
    Refinement::try_new(scene, lighting.clone(), Occlusion::Exact, factors).unwrap()
}

/// An oracle that needs no reference.
pub fn oracle(name: OracleName) -> Box<dyn Oracle> {
    name.oracle(None).unwrap()
}

/// A room refined to so many elements by an oracle that needs no reference.
pub fn refined<'s>(
    scene: &'s Scene,
    lighting: &Lighting,
    name: OracleName,
    elements: usize,
) -> Refinement<'s> {
    refined_by(&*oracle(name), start(scene, lighting), elements)
}

/// A room refined further.
pub fn refined_by<'s>(
    oracle: &dyn Oracle,
    mut room: Refinement<'s>,
    elements: usize,
) -> Refinement<'s> {
    room.refine(oracle, Goal::Elements(elements), &mut |_| ())
        .unwrap();
    room
}

/// A finer solution by the oracle of the gradient.
pub fn reference(scene: &Scene, lighting: &Lighting, elements: usize) -> Reference {
    let finer = refined(scene, lighting, OracleName::Gradient, elements);
    Reference::new(finer.tree(), finer.lighting(), finer.solution())
}

/// The priorities of the leaves that reflect light, by an oracle without a reference.
pub fn priorities(refinement: &Refinement<'_>, name: OracleName) -> Vec<f64> {
    let view = refinement.view();
    let leaves = refinement.tree().leaves();
    let leaves: Vec<usize> = leaves
        .filter(|leaf| view.reflectance(*leaf) > 0.0)
        .collect();
    oracle(name).priorities(&view, &leaves).unwrap()
}
