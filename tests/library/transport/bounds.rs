//! The bounds that travel with a solution are never below its errors.

use super::{closed_scenes, uneven};
use infoscene::exchange::{Congruence, ScenePairs};
use infoscene::numeric::Symmetric;
use infoscene::scene::{Material, Occlusion, Scene};
use infoscene::transport::{DenseExchange, ExchangeRows, RadiositySystem};

/// Form factors asked for 1e-3 … 1e-9 only: their errors move the radiosities by no more than the
/// bound says, in closed scenes and open ones.
#[test]
fn form_factor_errors_stay_within_their_bound() {
    let mut scenes = closed_scenes();
    scenes.push(("three squares", Scene::built_in("three-squares").unwrap()));
    let mut moved = 0;
    for (name, scene) in scenes {
        let n = scene.patches().len();
        let materials: Vec<Material> = (0..n)
            .map(|patch| {
                let reflectance = match patch % 4 {
                    1 => 0.0,
                    2 => 1.0,
                    _ => 0.9 * uneven(patch, 1),
                };
                Material::try_new(reflectance, 0.0).unwrap()
            })
            .collect();
        let emittances: Vec<f64> = (0..n).map(|patch| uneven(patch, 8)).collect();
        let solved = |tolerance: f64| {
            let pairs =
                ScenePairs::try_new(&scene, tolerance, Congruence::Ignored, Occlusion::Refuse)
                    .unwrap();
            let exchange = pairs.exchange_areas().unwrap();
            let room = RadiositySystem::of(&exchange, &materials).unwrap();
            room.radiosity(&emittances).unwrap()
        };
        let exact = solved(1e-14);
        let exactly = exact.form_factor_errors.unwrap();
        for tolerance in [1e-3, 1e-6, 1e-9] {
            let rough = solved(tolerance);
            let bounds = rough.form_factor_errors.unwrap();
            for i in 0..n {
                let error = (rough.values[i] - exact.values[i]).abs();
                let rounding = 2.0 * f64::EPSILON * exact.values[i];
                let bound = bounds[i] + exactly[i] + rounding;
                assert!(
                    error <= bound,
                    "{name}, {tolerance:e}, patch {i}: {error:e} > {bound:e}"
                );
                moved += usize::from(error > rounding);
            }
        }
    }
    // the bound is asked something
    assert!(moved > 50, "{moved} radiosities moved");
}

/// A worse form factor has a worse bound; an exact matrix has none.
#[test]
fn bounds_follow_the_form_factors() {
    let scene = Scene::built_in("cornell-box").unwrap();
    let materials: Vec<Material> = scene
        .patches()
        .iter()
        .map(|patch| patch.material().grey().unwrap())
        .collect();
    let emittances: Vec<f64> = materials.iter().map(Material::emittance).collect();
    let largest = |tolerance: f64| {
        let pairs =
            ScenePairs::try_new(&scene, tolerance, Congruence::Shared, Occlusion::Refuse).unwrap();
        let exchange = pairs.exchange_areas().unwrap();
        let room = RadiositySystem::of(&exchange, &materials).unwrap();
        let errors = room
            .radiosity(&emittances)
            .unwrap()
            .form_factor_errors
            .unwrap();
        errors.into_iter().fold(0.0, f64::max)
    };
    assert!(largest(1e-4) > 100.0 * largest(1e-12));
    let exact = Scene::built_in("cube:1")
        .unwrap()
        .exchange_areas()
        .unwrap()
        .into_values();
    let room = RadiositySystem::of_matrix(&exact, vec![0.5; 6]).unwrap();
    let found = room.radiosity(&[1.0, 0.0, 0.0, 0.0, 0.0, 0.0]).unwrap();
    assert_eq!(found.form_factor_errors, None);
}

/// Two squares in the open: `B_2 = R_2 F B_1`, so that an error δ of the exchange area moves it by
/// `R_2 B_1 δ/A` at least.
#[test]
fn the_bound_is_no_lower_than_what_one_error_does() {
    let scene = Scene::built_in("two-squares").unwrap();
    let pairs = ScenePairs::try_new(&scene, 1e-12, Congruence::Shared, Occlusion::Refuse).unwrap();
    let exchange = pairs.exchange_areas().unwrap();
    let half = Material::try_new(0.5, 0.0).unwrap();
    let room = RadiositySystem::of(&exchange, &[half; 2]).unwrap();
    let found = room.radiosity(&[1.0, 0.0]).unwrap();
    let moved = 0.5 * found.values[0] * exchange.get(0, 1).exchange.error;
    let bound = found.form_factor_errors.unwrap()[1];
    assert!(
        moved > 0.0 && (moved..2.0 * moved).contains(&bound),
        "{moved:e} {bound:e}"
    );
}

/// A row of the open that sees itself, as summed patches may: `B = E/(1 − R J_ii)` with A = 1, and
/// an error of J_ii moves it within the bound.
#[test]
fn errors_of_a_rows_own_exchange_enter_the_bound() {
    let solved = |own: f64, bound: f64| {
        let rows = ExchangeRows {
            own: vec![own],
            own_bounds: vec![bound],
            open_areas: vec![Some(1.0)],
        };
        let none = || DenseExchange::from(Symmetric::filled(1, 0.0));
        let room = RadiositySystem::try_new(none(), Some(none()), rows, vec![0.8]).unwrap();
        room.radiosity(&[1.0]).unwrap()
    };
    let found = solved(0.5, 1e-3);
    assert!((found.values[0] - 1.0 / 0.6).abs() < 1e-15);
    let moved = solved(0.501, 0.0).values[0] - found.values[0];
    let bound = found.form_factor_errors.unwrap()[0];
    assert!(
        moved > 1e-3 && (moved..1.1 * moved).contains(&bound),
        "{moved} {bound}"
    );
}
