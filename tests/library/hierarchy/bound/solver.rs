//! The bound for radiosities of the hierarchical solver, against the radiosity of boxes, which
//! shares nothing with it.

use crate::hierarchy::lit_rooms::{ROOMS, lighting, refined};
use infoscene::hierarchy::{ErrorBound, OracleName, Refinement};
use infoscene::reference::BoxRadiosity;
use infoscene::scene::{Channel, Material, NamedPatch, Scene};
use std::time::Instant;

/// A built-in room whose walls reflect so much, or as they do by themselves.
pub fn room(name: &str, reflectance: Option<f64>) -> Scene {
    let scene = Scene::built_in(name).unwrap();
    let Some(reflectance) = reflectance else {
        return scene;
    };
    let patch = |patch: &NamedPatch| match patch.material().grey() {
        Some(material) if material.emittance() > 0.0 => patch.clone(),
        _ => {
            let material = Material::try_new(reflectance, 0.0).unwrap();
            patch.clone().with_material(material)
        }
    };
    Scene::try_new(scene.patches().iter().map(patch).collect()).unwrap()
}

/// `‖B − B_h‖`, over all that is no light.
fn error(room: &Refinement<'_>, exact: &BoxRadiosity) -> f64 {
    let moments = exact.leaf_moments(room.tree());
    let squares = moments.iter().map(|(leaf, moments)| {
        moments.squared_error(room.solution().radiosity[*leaf], glam::DVec3::ZERO)
    });
    squares.sum::<f64>().sqrt()
}

/// What a mesh of so many elements is judged to be.
pub struct Judged {
    pub error: f64,
    /// The bound over the error.
    pub ratio: f64,
    /// How long the bound took.
    pub seconds: f64,
}

/// The bound for constants on a mesh of so many elements, against their error.
pub fn judged(scene: &Scene, elements: usize, error: impl Fn(&Refinement<'_>) -> f64) -> Judged {
    let lighting = lighting(scene);
    let room = refined(scene, &lighting, OracleName::Gradient, elements);
    let leaves = room.tree().leaves();
    let values: Vec<f64> = leaves.map(|leaf| room.solution().radiosity[leaf]).collect();
    let start = Instant::now();
    let bound = ErrorBound::try_new(scene, room.tree(), &lighting, &values).unwrap();
    let seconds = start.elapsed().as_secs_f64();
    let error = error(&room);
    Judged {
        error,
        ratio: bound.absolute / error,
        seconds,
    }
}

impl std::fmt::Display for Judged {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self {
            error,
            ratio,
            seconds,
        } = self;
        write!(f, "{error:.3e}, bound/error {ratio:.3}, {seconds:.2} s")
    }
}

/// `‖B − B_h‖ ≤ bound ≤ 4 ‖B − B_h‖` for a coarse mesh of a cube.
#[test]
fn a_coarse_mesh_of_the_solver_is_bounded() {
    let scene = room("lit-cube", None);
    let exact = BoxRadiosity::try_new(&scene, Channel::Green, 4).unwrap();
    let ratio = judged(&scene, 40, |room| error(room, &exact)).ratio;
    assert!((1.0..4.0).contains(&ratio), "{ratio}");
}

/// The same in three rooms, for meshes of 100 and 300 elements and reflectances from 0.3 to 0.99;
/// up to four times the error where at least a twentieth is absorbed.
#[test]
#[ignore = "minutes: cargo test --release --test library bound::solver -- --ignored --nocapture"]
fn meshes_of_the_solver_are_bounded() {
    for name in ROOMS {
        for reflectance in [
            None,
            Some(0.3),
            Some(0.5),
            Some(0.7),
            Some(0.9),
            Some(0.95),
            Some(0.99),
        ] {
            let scene = room(name, reflectance);
            let exact = BoxRadiosity::try_new(&scene, Channel::Green, 8).unwrap();
            for elements in [100, 300] {
                let found = judged(&scene, elements, |room| error(room, &exact));
                println!("{name} {elements} R={reflectance:?}: {found}");
                let ratio = found.ratio;
                assert!(ratio >= 1.0, "{name} {reflectance:?} {elements}: {ratio}");
                let is_near = reflectance.is_some_and(|r| r <= 0.95);
                assert!(
                    !is_near || ratio <= 4.0,
                    "{name} {reflectance:?} {elements}: {ratio}"
                );
            }
        }
    }
}

/// Effectivity and seconds for 100, 300 and 1000 elements of a cube.
#[test]
#[ignore = "a table: cargo test --release --test library cost_of_the_bound -- --ignored --nocapture"]
fn cost_of_the_bound() {
    let scene = room("lit-cube", None);
    let exact = BoxRadiosity::try_new(&scene, Channel::Green, 4).unwrap();
    for elements in [100, 300, 1000] {
        let found = judged(&scene, elements, |room| error(room, &exact));
        println!("{elements}: {found}");
        assert!(found.ratio >= 1.0, "{elements}: {}", found.ratio);
    }
}
