//! Radiosity and importance: exact gates, bounds against truth, chains, walks.

mod adiabatic;
mod balance;
mod bounds;
mod furnaces;
mod operators;
mod refusals;
mod stiff;
mod walks;

use infoscene::exchange::ExchangeAreas;
use infoscene::scene::{Material, Scene};
use infoscene::transport::{RadiositySolution, RadiositySystem};

/// Closed scenes: cubes, boxes flat and long, and the Cornell box.
pub fn closed_scenes() -> Vec<(&'static str, Scene)> {
    let cube = Scene::built_in("cube:3").unwrap();
    let stretched = |x: f64, y: f64, z: f64| {
        crate::support::rooms::mapped(&cube, |corner| corner * glam::DVec3::new(x, y, z))
    };
    vec![
        ("flat box", stretched(1.0, 1.0, 0.125)),
        ("long box", stretched(8.0, 1.0, 0.5)),
        ("Cornell box", Scene::built_in("cornell-box").unwrap()),
        ("cube", cube),
    ]
}

/// Numbers between 0 and 1 that have nothing to do with each other.
pub fn uneven(patch: usize, salt: usize) -> f64 {
    ((patch * 29 + salt * 17 + 5) % 97) as f64 / 97.0
}

/// The radiosities for these reflectances and emittances.
fn radiosity(
    exchange: &ExchangeAreas,
    reflectances: &[f64],
    emittances: &[f64],
) -> RadiositySolution {
    let materials: Vec<Material> = reflectances
        .iter()
        .map(|reflectance| Material::try_new(*reflectance, 0.0).unwrap())
        .collect();
    let room = RadiositySystem::of(exchange, &materials).unwrap();
    room.radiosity(emittances).unwrap()
}
