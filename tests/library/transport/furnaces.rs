//! Furnaces: what emits as much as it absorbs glows evenly, whatever the room.

use super::{closed_scenes, radiosity, uneven};
use proptest::prelude::*;

/// `E = 1 − R` ⇒ `B = 1`, R of every patch its own; 1 − R is exact for R ≥ ½, and rounds by ε/2 of
/// itself below.
#[test]
fn furnaces_glow_evenly() {
    for (name, scene) in closed_scenes() {
        let exchange = scene.exchange_areas().unwrap();
        let n = exchange.rows();
        for (salt, most) in [0.5, 0.95, 1.0 - 1e-9, 1.0 - 1e-12].into_iter().enumerate() {
            let reflectances: Vec<f64> = (0..n)
                .map(|patch| most * (1.0 - 0.5 * uneven(patch, salt) * f64::from(salt < 2)))
                .collect();
            let emittances: Vec<f64> = reflectances.iter().map(|r| 1.0 - r).collect();
            let found = radiosity(&exchange, &reflectances, &emittances);
            // emittances that round by ε/2 of themselves move B by no more
            let bound = found.relative_error + 0.5 * f64::EPSILON;
            assert!(bound < 1e-15, "{name}, {most}: bound {bound:e}");
            for (patch, value) in found.values.iter().enumerate() {
                let error = (value - 1.0).abs();
                assert!(error <= bound, "{name}, {most}, patch {patch}: {error:e}");
            }
        }
    }
}

/// Negative control: with another emittance on one patch nothing is even.
#[test]
fn a_brighter_patch_is_seen_by_all() {
    let (_, scene) = closed_scenes().pop().unwrap();
    let exchange = scene.exchange_areas().unwrap();
    let mut emittances = vec![0.5; exchange.rows()];
    emittances[0] = 0.75;
    let found = radiosity(&exchange, &vec![0.5; exchange.rows()], &emittances);
    assert!(found.values.iter().all(|value| *value > 1.0 + 1e-3));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    /// The emittances' unit is free: powers of two come out exactly.
    #[test]
    fn radiosity_is_linear_in_powers_of_two(power in -900i32..900, salt in 0usize..97) {
        let scene = infoscene::scene::Scene::built_in("cube:1").unwrap();
        let exchange = scene.exchange_areas().unwrap();
        let reflectances: Vec<f64> = (0..6).map(|patch| uneven(patch, salt)).collect();
        let emittances: Vec<f64> = (0..6).map(|patch| uneven(patch, salt + 1)).collect();
        let factor = 2f64.powi(power);
        let scaled: Vec<f64> = emittances.iter().map(|e| e * factor).collect();
        let one = radiosity(&exchange, &reflectances, &emittances);
        let other = radiosity(&exchange, &reflectances, &scaled);
        for (one, other) in one.values.iter().zip(&other.values) {
            prop_assert_eq!(one * factor, *other);
        }
    }
}
