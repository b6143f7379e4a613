//! The radiosity and the importance chain (§3.4, §3.5).

use crate::transport::{closed_scenes, uneven};
use infoscene::chain::{
    Refinement, ReversibleChain, brightness_chain, continuous_chain, patch_integrals,
    visibility_chain,
};
use infoscene::exchange::ExchangeAreas;
use infoscene::information::{mutual_information, refinement_gain};
use infoscene::numeric::tolerance;
use infoscene::scene::{Material, Scene};
use infoscene::transport::RadiositySystem;

/// R, E and V of every patch its own.
fn materials(n: usize) -> Vec<Material> {
    (0..n)
        .map(|patch| Material::try_new(0.05 + 0.9 * uneven(patch, 1), uneven(patch, 2)).unwrap())
        .collect()
}

fn emittances(materials: &[Material]) -> Vec<f64> {
    materials.iter().map(Material::emittance).collect()
}

/// The largest relative deviation of a chain's transitions from a formula.
fn off(
    chain: &ReversibleChain,
    exchange: &ExchangeAreas,
    formula: impl Fn(usize, usize, f64) -> f64,
) -> f64 {
    let n = chain.states();
    let mut worst: f64 = 0.0;
    for i in 0..n {
        for j in 0..n {
            let form_factor = exchange.get(i, j).exchange.value / exchange.areas()[i];
            let (found, expected) = (
                chain.transition_probability(i, j),
                formula(i, j, form_factor),
            );
            if found > 0.0 || expected > 0.0 {
                worst = worst.max((found / expected - 1.0).abs());
            }
        }
    }
    worst
}

/// `P_ij = R_i F_ij B_j/(B_i − E_i)` with rows that sum to one, `w_i ∝ A_i B_i (B_i − E_i)/R_i`;
/// rows of F to 1e-13 at least.
#[test]
fn the_radiosity_chain_is_that_of_section_3_4() {
    for (name, scene) in closed_scenes() {
        let exchange = scene.exchange_areas().unwrap();
        let materials = materials(exchange.rows());
        let room = RadiositySystem::of(&exchange, &materials).unwrap();
        let radiosity = room.radiosity(&emittances(&materials)).unwrap();
        let b = &radiosity.values;
        let chain = brightness_chain(&exchange, b).unwrap();
        let gathered = |i: usize| (b[i] - materials[i].emittance()) / materials[i].reflectance();
        let worst = off(&chain, &exchange, |i, j, f| f * b[j] / gathered(i));
        assert!(worst < 1e-12, "{name}: {worst:e}");
        let weight = |i: usize| exchange.areas()[i] * b[i] * gathered(i);
        let total: f64 = (0..chain.states()).map(weight).sum();
        for i in 0..chain.states() {
            let error = chain.stationary_probability(i) * total / weight(i) - 1.0;
            assert!(error.abs() < 1e-12, "{name}, patch {i}: {error:e}");
        }
        rows_and_reciprocity(&chain, name);
        // as printed, with B_i in the numerator, rows do not sum to one
        let row = |i: usize| (0..chain.states()).map(move |j| (i, j));
        let printed = |i: usize| -> f64 {
            let terms = row(i).map(|(i, j)| exchange.get(i, j).exchange.value * b[i]);
            terms.sum::<f64>() / exchange.areas()[i] / gathered(i)
        };
        assert!(
            (0..chain.states()).any(|i| (printed(i) - 1.0).abs() > 0.05),
            "{name}"
        );
    }
}

/// `P_ij = R_j F_ij I_j/(I_i − V_i)`, `w_i ∝ A_i R_i I_i (I_i − V_i)`.
#[test]
fn the_importance_chain_is_that_of_section_3_5() {
    for (name, scene) in closed_scenes() {
        let exchange = scene.exchange_areas().unwrap();
        let materials = materials(exchange.rows());
        let room = RadiositySystem::of(&exchange, &materials).unwrap();
        let direct: Vec<f64> = (0..exchange.rows()).map(|i| uneven(i, 7)).collect();
        let importance = room.importance(&direct).unwrap();
        let values = &importance.values;
        let chain = brightness_chain(&exchange, &importance.reflected.values).unwrap();
        let r = |i: usize| materials[i].reflectance();
        let worst = off(&chain, &exchange, |i, j, f| {
            r(j) * f * values[j] / (values[i] - direct[i])
        });
        assert!(worst < 1e-12, "{name}: {worst:e}");
        let weight = |i: usize| exchange.areas()[i] * r(i) * values[i] * (values[i] - direct[i]);
        let total: f64 = (0..chain.states()).map(weight).sum();
        for i in 0..chain.states() {
            let error = chain.stationary_probability(i) * total / weight(i) - 1.0;
            assert!(error.abs() < 1e-12, "{name}, patch {i}: {error:e}");
        }
        rows_and_reciprocity(&chain, name);
    }
}

/// Row sums and `w_i P_ij = w_j P_ji`, to 1e-14 relative.
fn rows_and_reciprocity(chain: &ReversibleChain, name: &str) {
    for i in 0..chain.states() {
        let row: f64 = (0..chain.states())
            .map(|j| chain.transition_probability(i, j))
            .sum();
        assert!((row - 1.0).abs() < 1e-14, "{name}: row {i} sums to {row}");
        for j in 0..i {
            let there = chain.stationary_probability(i) * chain.transition_probability(i, j);
            let back = chain.stationary_probability(j) * chain.transition_probability(j, i);
            assert!(
                (there - back).abs() <= 1e-14 * back,
                "{name}: {there} {back}"
            );
        }
    }
}

/// `E = k (1 − R)` makes the radiosity chain the visibility chain; `V = k (1/R − 1)` the importance
/// chain.
#[test]
fn even_light_reverts_to_visibility() {
    for (name, scene) in closed_scenes() {
        let exchange = scene.exchange_areas().unwrap();
        let materials = materials(exchange.rows());
        let room = RadiositySystem::of(&exchange, &materials).unwrap();
        let even: Vec<f64> = materials
            .iter()
            .map(|m| 3.0 * (1.0 - m.reflectance()))
            .collect();
        let direct: Vec<f64> = materials
            .iter()
            .map(|m| 3.0 * (1.0 / m.reflectance() - 1.0))
            .collect();
        let visibility = visibility_chain(&scene).unwrap();
        rows_and_reciprocity(&visibility, name);
        let lit = room.radiosity(&even).unwrap().values;
        let seen = room.importance(&direct).unwrap().reflected.values;
        for brightness in [lit, seen] {
            let chain = brightness_chain(&exchange, &brightness).unwrap();
            for i in 0..chain.states() {
                for j in 0..chain.states() {
                    let (a, b) = (
                        chain.joint()[(i, j)] / chain.total(),
                        visibility.joint()[(i, j)] / visibility.total(),
                    );
                    assert!((a - b).abs() <= 1e-14 * b, "{name}: {a} {b}");
                }
            }
            let information = [&chain, &visibility].map(mutual_information);
            assert!((information[0] - information[1]).abs() < tolerance::INFORMATION * 4.0);
        }
    }
    // negative control: uneven light is another chain
    let scene = Scene::built_in("cube:2").unwrap();
    let exchange = scene.exchange_areas().unwrap();
    let brightness: Vec<f64> = (0..24).map(|i| 1.0 + uneven(i, 3)).collect();
    let chain = brightness_chain(&exchange, &brightness).unwrap();
    let visibility = visibility_chain(&scene).unwrap();
    assert!((mutual_information(&chain) - mutual_information(&visibility)).abs() > 1e-3);
}

/// Dividing patches keeps the hypotheses of Theorem 1, so that information grows: a cube's faces in
/// 9, of any brightness each.
#[test]
fn dividing_patches_refines_the_radiosity_chain() {
    let fine = Scene::built_in("cube:3").unwrap().exchange_areas().unwrap();
    let coarse = Scene::built_in("cube:1").unwrap().exchange_areas().unwrap();
    let faces = |cell: usize| cell / 9;
    let brightness: Vec<f64> = (0..6).map(|i| 0.1 + uneven(i, 1)).collect();
    let per_cell: Vec<f64> = (0..54).map(|cell| brightness[faces(cell)]).collect();
    let refined = brightness_chain(&fine, &per_cell).unwrap();
    let refinement = Refinement::coarsening(refined, (0..54).map(faces).collect()).unwrap();
    // (b): parts add up to the whole; a cube's face is the sum of its cells
    let whole = brightness_chain(&coarse, &brightness).unwrap();
    for i in 0..6 {
        for j in 0..6 {
            let (sum, entry) = (refinement.coarse().joint()[(i, j)], whole.joint()[(i, j)]);
            assert!((sum - entry).abs() <= 1e-12 * entry, "{sum} {entry}");
        }
    }
    let gain = refinement_gain(&refinement);
    assert!(gain > 0.1, "{gain}");
    // negative control: parts of another brightness do not add up, and are another chain
    let other: Vec<f64> = (0..54).map(|cell| 0.1 + uneven(cell, 1)).collect();
    let other = brightness_chain(&fine, &other).unwrap();
    let sum = |i: usize, j: usize| {
        let cells = |face: usize| 9 * face..9 * face + 9;
        let mut sum = 0.0;
        for k in cells(i) {
            for l in cells(j) {
                sum += other.joint()[(k, l)];
            }
        }
        sum / other.total()
    };
    assert!((0..6).any(|j| (sum(0, j) - whole.joint()[(0, j)] / whole.total()).abs() > 1e-3));
}

/// B, E and R constant on each patch: the integral form is the discrete one (§3.4).
#[test]
fn constant_light_makes_the_continuous_chain_discrete() {
    let scene = Scene::built_in("cube:1").unwrap();
    let exchange = scene.exchange_areas().unwrap();
    let brightness: Vec<f64> = (0..6).map(|i| 0.1 + uneven(i, 5)).collect();
    let discrete = brightness_chain(&exchange, &brightness).unwrap();
    let continuous = continuous_chain(&scene, |patch, _| brightness[patch], 1e-12).unwrap();
    assert!(continuous.error < 1e-12);
    for i in 0..6 {
        for j in 0..6 {
            let [a, b] =
                [&discrete, &continuous.chain].map(|chain| chain.joint()[(i, j)] / chain.total());
            assert!((a - b).abs() <= 1e-13, "{i}, {j}: {a} {b}");
        }
    }
}

/// RadiositySolution that varies: two facing squares, against a Gauss rule over both that knows the
/// kernel only.
#[test]
fn varying_light_agrees_with_gauss_rules() {
    let scene = Scene::facing_squares(0.75).unwrap();
    let below = |x: glam::DVec3| (1.0 + x.x * x.x) * x.y.exp();
    let above = |x: glam::DVec3| 2.0 - x.x * x.y;
    let found = continuous_chain(
        &scene,
        |patch, x| if patch == 0 { below(x) } else { above(x) },
        1e-9,
    )
    .unwrap();
    let rule = infoscene::numeric::GaussLegendre::with(20);
    let mut exact = 0.0;
    let onto_unit = rule.nodes.iter().zip(&rule.weights);
    let points: Vec<[f64; 2]> = onto_unit.map(|(x, w)| [0.5 + 0.5 * x, 0.5 * w]).collect();
    for [x, wx] in &points {
        for [y, wy] in &points {
            for [u, wu] in &points {
                for [v, wv] in &points {
                    let (from, to) = (
                        glam::DVec3::new(*x, *y, 0.0),
                        glam::DVec3::new(*u, *v, 0.75),
                    );
                    let squared = from.distance_squared(to);
                    let kernel = 0.75 * 0.75 / (std::f64::consts::PI * squared * squared);
                    exact += wx * wy * wu * wv * kernel * below(from) * above(to);
                }
            }
        }
    }
    // the stated error is relative to both entries
    let error = (found.chain.joint()[(0, 1)] / exact - 1.0).abs() / 2.0;
    assert!(
        error < found.error && found.error < 1e-6,
        "{error:e}, {:e}",
        found.error
    );
    // negative control: a mean brightness on each is another chain's
    let means = patch_integrals(
        &scene,
        |patch, x| if patch == 0 { below(x) } else { above(x) },
        4,
    )
    .unwrap();
    let form_factor = scene.exchange_areas().unwrap().get(0, 1).exchange.value;
    assert!((means[0] * means[1] * form_factor / exact - 1.0).abs() > 1e-3);
}

/// B(x) of a finer solution, E and R even: the paper's weight `∫ B (B − E)/R` is the row sum.
#[test]
fn weights_of_a_varying_solution_are_row_sums() {
    // the light of a bright face of a cube on the others, where it is smooth: between two facing
    // squares in the open
    let scene = Scene::facing_squares(1.0).unwrap();
    let (fine, parents) = scene.subdivided(4).unwrap();
    let exchange = fine.exchange_areas().unwrap();
    let materials: Vec<Material> = parents
        .iter()
        .map(|patch| Material::try_new(if *patch == 0 { 0.5 } else { 0.8 }, 0.0).unwrap())
        .collect();
    let sources: Vec<f64> = parents.iter().map(|patch| f64::from(*patch == 0)).collect();
    let room = RadiositySystem::of(&exchange, &materials).unwrap();
    let radiosity = room.radiosity(&sources).unwrap();
    let mut printed = [0.0; 2];
    for (cell, patch) in parents.iter().enumerate() {
        let (b, e, r) = (
            radiosity.values[cell],
            sources[cell],
            materials[cell].reflectance(),
        );
        printed[*patch] += exchange.areas()[cell] * b * (b - e) / r;
    }
    let cells = brightness_chain(&exchange, &radiosity.values).unwrap();
    let whole = Refinement::coarsening(cells, parents).unwrap();
    for (state, printed) in printed.into_iter().enumerate() {
        let weight = whole.coarse().weights()[state] * unit(&radiosity.values).powi(2);
        assert!((weight / printed - 1.0).abs() < 1e-12, "{weight} {printed}");
    }
}

/// The power of two that the chain's brightness is counted in.
fn unit(values: &[f64]) -> f64 {
    let largest = values.iter().copied().fold(0.0, f64::max);
    largest.log2().floor().exp2()
}

/// Negative brightness, and none, are refused.
#[test]
fn dark_and_negative_light_is_refused() {
    let scene = Scene::built_in("two-squares").unwrap();
    assert!(continuous_chain(&scene, |_, _| -1.0, 1e-6).is_err());
    assert!(continuous_chain(&scene, |_, _| f64::NAN, 1e-6).is_err());
    assert!(continuous_chain(&scene, |_, _| 0.0, 1e-6).is_err());
    let exchange = scene.exchange_areas().unwrap();
    for brightness in [&[1.0, -1.0][..], &[1.0], &[0.0, 0.0], &[1.0, f64::NAN]] {
        assert!(brightness_chain(&exchange, brightness).is_err());
    }
    let area = patch_integrals(&scene, |_, x| x.x * x.y, 3).unwrap();
    // ∫∫ x y over the floor is 1/4, over the wall x is 0
    assert!(
        (area[0] - 0.25).abs() < 1e-15 && area[1].abs() < 1e-15,
        "{area:?}"
    );
}
