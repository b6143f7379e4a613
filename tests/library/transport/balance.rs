//! The balance of light: all that is emitted is absorbed or escapes.

use super::{closed_scenes, radiosity, uneven};
use infoscene::exchange::Closure;
use infoscene::numeric::compensated_sum;
use infoscene::scene::Scene;

/// One R everywhere in a closed scene: `mean B = mean E/(1 − R)`, whatever the geometry.
#[test]
fn the_mean_radiosity_of_even_reflectance_is_geometry_free() {
    for (name, scene) in closed_scenes() {
        let exchange = scene.exchange_areas().unwrap();
        let n = exchange.rows();
        for reflectance in [0.1, 0.5, 0.95, 1.0 - 1e-9] {
            let emittances: Vec<f64> = (0..n).map(|patch| uneven(patch, 3)).collect();
            let found = radiosity(&exchange, &vec![reflectance; n], &emittances);
            let mean = |values: &[f64]| {
                compensated_sum(values.iter().zip(exchange.areas()).map(|(v, a)| v * a))
            };
            let error = mean(&found.values) * (1.0 - reflectance) / mean(&emittances) - 1.0;
            // the areas are row sums within their bounds, 1e-13
            assert!(error.abs() < 1e-12, "{name}, {reflectance}: {error:e}");
        }
    }
}

/// `Σ A E = Σ A (1 − R) H + Σ A B (1 − ΣF)`, lights and open scenes included.
#[test]
fn what_is_emitted_is_absorbed_or_escapes() {
    let mut scenes = closed_scenes();
    scenes.push(("two squares", Scene::built_in("two-squares").unwrap()));
    scenes.push(("three squares", Scene::built_in("three-squares").unwrap()));
    for (name, scene) in scenes {
        let exchange = scene.exchange_areas().unwrap();
        let n = exchange.rows();
        let closure = Closure::of_held(&exchange);
        // every fourth patch reflects nothing, another one all
        let reflectances: Vec<f64> = (0..n)
            .map(|patch| match patch % 4 {
                1 => 0.0,
                2 => 1.0,
                _ => uneven(patch, 1),
            })
            .collect();
        let emittances: Vec<f64> = (0..n).map(|patch| uneven(patch, 2)).collect();
        let found = radiosity(&exchange, &reflectances, &emittances);
        let sum = |term: &dyn Fn(usize) -> f64| {
            compensated_sum((0..n).map(|i| exchange.areas()[i] * term(i)))
        };
        let emitted = sum(&|i| emittances[i]);
        let absorbed = sum(&|i| (1.0 - reflectances[i]) * found.received[i]);
        let escaped = sum(&|i| found.values[i] * closure.escaping(i));
        let error = (absorbed + escaped) / emitted - 1.0;
        assert!(error.abs() < 1e-12, "{name}: {error:e}");
        assert!(
            found.residual < 4.0 * f64::EPSILON,
            "{name}: {}",
            found.residual
        );
    }
}

/// Two unit squares at a right angle, F = 0.2000437760754: `B_1 = E/(1 − R₁ R₂ F²)`, `B_2 = R₂ F
/// B_1`.
#[test]
fn two_patches_have_a_closed_form() {
    let exchange = Scene::built_in("two-squares")
        .unwrap()
        .exchange_areas()
        .unwrap();
    let found = radiosity(&exchange, &[0.9, 0.6], &[2.0, 0.0]);
    // Howell C-14, as in data/reference: perpendicular unit squares
    let form_factor = 0.200_043_776_075_4;
    let first = 2.0 / (1.0 - 0.9 * 0.6 * form_factor * form_factor);
    let second = 0.6 * form_factor * first;
    for (value, exact) in found.values.iter().zip([first, second]) {
        assert!((value / exact - 1.0).abs() < 1e-12, "{value} {exact}");
    }
}

/// `Σ A E I = Σ A V B`: importance is the adjoint of radiosity.
#[test]
fn importance_is_adjoint_to_radiosity() {
    for (name, scene) in closed_scenes() {
        let exchange = scene.exchange_areas().unwrap();
        let n = exchange.rows();
        let materials: Vec<_> = (0..n)
            .map(|patch| {
                let reflectance = match patch % 5 {
                    2 => 0.0,
                    3 => 1.0,
                    _ => uneven(patch, 4),
                };
                infoscene::scene::Material::try_new(reflectance, 0.0).unwrap()
            })
            .collect();
        let room = infoscene::transport::RadiositySystem::of(&exchange, &materials).unwrap();
        let emittances: Vec<f64> = (0..n).map(|patch| uneven(patch, 5)).collect();
        let direct: Vec<f64> = (0..n).map(|patch| uneven(patch, 6)).collect();
        let radiosity = room.radiosity(&emittances).unwrap();
        let importance = room.importance(&direct).unwrap();
        let sum = |a: &[f64], b: &[f64]| {
            compensated_sum((0..n).map(|i| exchange.areas()[i] * a[i] * b[i]))
        };
        let error = sum(&emittances, &importance.values) / sum(&direct, &radiosity.values) - 1.0;
        assert!(error.abs() < 1e-12, "{name}: {error:e}");
    }
}
