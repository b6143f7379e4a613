//! Null-variance walks (§3.4, §3.5) are run, and others beside them.

use super::uneven;
use infoscene::scene::{Material, Scene};
use infoscene::transport::walks::Steering;
use infoscene::transport::{DenseExchange, RadiositySystem};

/// A cube of 150 patches, with R from 0 to 0.8 and a third of the patches emitting.
struct Room {
    exchange: infoscene::exchange::ExchangeAreas,
    materials: Vec<Material>,
    emittances: Vec<f64>,
}

impl Room {
    fn new() -> Self {
        let exchange = Scene::built_in("cube:5").unwrap().exchange_areas().unwrap();
        let materials =
            (0..150).map(|patch| Material::try_new(0.8 * uneven(patch, 1), 0.0).unwrap());
        let emits = |patch: usize| {
            if patch.is_multiple_of(3) {
                0.1 + uneven(patch, 2)
            } else {
                0.0
            }
        };
        Self {
            exchange,
            materials: materials.collect(),
            emittances: (0..150).map(emits).collect(),
        }
    }

    fn interreflection(&self) -> RadiositySystem<DenseExchange<'_>> {
        RadiositySystem::of(&self.exchange, &self.materials).unwrap()
    }
}

/// The error that a walk of k steps may have: three roundings a step in the weight and one in the
/// sum, each ε/2 of B at most, and as much for the radiosities as given.
fn rounding(steps: u32) -> f64 {
    4.0 * f64::from(steps + 2) * f64::EPSILON
}

/// Steered by `P_ij = R_i F_ij B_j/(B_i − E_i)` *every* walk finds B_i; steered by F they differ.
#[test]
fn gathering_walks_have_no_variance() {
    let room = Room::new();
    let light = room.interreflection();
    let radiosity = light.radiosity(&room.emittances).unwrap();
    for from in [0, 1, 40, 77, 149] {
        let exact = radiosity.values[from];
        let steered = Steering::Towards(radiosity.values.as_slice());
        let walks = light
            .gathering_walks(from, &room.emittances, steered, 400, 7)
            .unwrap();
        let allowed = rounding(walks.longest) * exact;
        assert!(walks.longest > 10, "{walks:?}");
        assert!(walks.farthest <= allowed, "patch {from}: {walks:?}");
        assert!(
            (walks.mean - exact).abs() <= allowed,
            "patch {from}: {walks:?}"
        );
        let plain = light
            .gathering_walks(from, &room.emittances, Steering::FormFactors, 4000, 7)
            .unwrap();
        // six standard errors
        assert!(
            (plain.mean - exact).abs() < 6.0 * plain.standard_error(),
            "{plain:?}, {exact}"
        );
        if room.materials[from].reflectance() > 0.1 {
            assert!(
                plain.variance > 1e-6 * exact * exact,
                "patch {from}: {plain:?}"
            );
        }
    }
}

/// Steered by `P_ij = R_j F_ij I_j/(I_i − V_i)`, V = δ_k, *every* walk finds the power `A_k B_k`;
/// by F they differ.
#[test]
fn shooting_walks_have_no_variance() {
    let room = Room::new();
    let light = room.interreflection();
    let radiosity = light.radiosity(&room.emittances).unwrap();
    for target in [1, 40, 77, 149] {
        let direct: Vec<f64> = (0..150).map(|patch| f64::from(patch == target)).collect();
        let importance = light.importance(&direct).unwrap();
        let exact = room.exchange.areas()[target] * radiosity.values[target];
        let steered = Steering::Towards(&importance);
        let walks = light
            .shooting_walks(&room.emittances, &direct, steered, 400, 8)
            .unwrap();
        // the start has one division and one product more, and areas are row sums to 1e-13
        let allowed = (rounding(walks.longest + 4) + 1e-12) * exact;
        assert!(
            walks.farthest <= rounding(walks.longest + 4) * exact,
            "{target}: {walks:?}"
        );
        assert!(
            (walks.mean - exact).abs() <= allowed,
            "{target}: {walks:?}, {exact}"
        );
        let plain = light
            .shooting_walks(&room.emittances, &direct, Steering::FormFactors, 20_000, 8)
            .unwrap();
        assert!(
            (plain.mean - exact).abs() < 6.0 * plain.standard_error(),
            "{plain:?}, {exact}"
        );
        assert!(plain.variance > 1e-3 * exact * exact, "{target}: {plain:?}");
    }
}

/// Negative control: steered by radiosities that are a hundredth off, walks differ by about as
/// much.
#[test]
fn a_guessed_solution_has_little_variance_but_some() {
    let room = Room::new();
    let light = room.interreflection();
    let radiosity = light.radiosity(&room.emittances).unwrap();
    let guess: Vec<f64> = (0..150)
        .map(|patch| radiosity.values[patch] * (0.99 + 0.02 * uneven(patch, 9)))
        .collect();
    let steered = Steering::Towards(guess.as_slice());
    let walks = light
        .gathering_walks(77, &room.emittances, steered, 2000, 3)
        .unwrap();
    let exact = radiosity.values[77];
    let spread = walks.variance.sqrt() / exact;
    assert!(spread > 1e-4 && spread < 2e-2, "{spread:e}");
    assert!((walks.mean - exact).abs() < 6.0 * walks.standard_error());
}

/// The deviation of a walk follows the error of the solution that steers it; by form factors it is
/// larger than any.
#[test]
fn variance_falls_with_the_square_of_the_solutions_error() {
    let rows = infoscene::study::light::walks::walk_variance(400).unwrap();
    for method in ["gathering", "shooting"] {
        let deviation = |what: &str| {
            let found = rows
                .iter()
                .find(|row| row.method == method && row.case.ends_with(what));
            found.unwrap().relative_error
        };
        assert!(deviation("solution 0e0 off") < 1e-14);
        for (off, name) in [(1e-8, "1e-8 off"), (1e-4, "1e-4 off"), (1e-2, "1e-2 off")] {
            let ratio = deviation(name) / off;
            assert!((0.05..2.0).contains(&ratio), "{method}, {off:e}: {ratio}");
        }
        assert!(deviation("by form factors") > deviation("5e-1 off"));
    }
}
