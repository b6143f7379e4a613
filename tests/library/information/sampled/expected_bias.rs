//! The exact bias of the plug-in estimate, against all outcomes, other sums, the literature's
//! series, and simulation.

use super::{exact, pairs, scene};
use approx::assert_relative_eq;
use infoscene::exchange::{Congruence, ScenePairs};
use infoscene::information::{
    OpenScene, PairCounts, expected_bias, expected_bias_of_scene, scene_information,
    scene_information_and_bias,
};
use infoscene::numeric::divergence_kernel;
use infoscene::scene::{Occlusion, Scene};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::LN_2;

/// Three states, pairs of different ones; and the weights that go with it.
const CELLS: [([usize; 2], f64); 3] = [([0, 1], 0.5), ([0, 2], 0.3), ([1, 2], 0.2)];
const WEIGHTS: [f64; 3] = [0.4, 0.35, 0.25];

fn information() -> f64 {
    let term = |([i, j], p): &([usize; 2], f64)| p * (p / (2.0 * WEIGHTS[*i] * WEIGHTS[*j])).log2();
    CELLS.iter().map(term).sum()
}

/// Every outcome of n samples with its multinomial probability.
fn outcomes(n: u64) -> Vec<([u64; 3], f64)> {
    let factorial = |k: u64| (1..=k).map(|i| i as f64).product::<f64>();
    let mut all = Vec::new();
    for a in 0..=n {
        for b in 0..=n - a {
            let counts = [a, b, n - a - b];
            let powers = counts
                .iter()
                .zip(CELLS)
                .map(|(k, (_, p))| p.powf(*k as f64));
            let ways = factorial(n) / counts.iter().map(|k| factorial(*k)).product::<f64>();
            all.push((counts, ways * powers.product::<f64>()));
        }
    }
    all
}

fn counts(counts: &[u64]) -> PairCounts {
    let cells = CELLS.iter().zip(counts).map(|((cell, _), n)| (*cell, *n));
    PairCounts::try_new(&WEIGHTS, cells).unwrap()
}

/// The estimate itself, averaged over all outcomes; with counted weights the bias of the weights is
/// taken off.
#[test]
fn expected_bias_is_that_of_all_outcomes() {
    for n in [1, 2, 3, 7, 20, 60] {
        let mean = |estimate: &dyn Fn(&PairCounts) -> f64| -> f64 {
            let all = outcomes(n);
            let terms = all.iter().map(|(k, p)| p * estimate(&counts(k)));
            terms.sum::<f64>() - information()
        };
        let bias = expected_bias(CELLS.map(|(_, p)| (p, 1.0)), n);
        // some thousand terms of order one
        assert_relative_eq!(mean(&PairCounts::plug_in), bias, epsilon = 1e-13);
        let of_weights = expected_bias(WEIGHTS.map(|w| (2.0 * w, 1.0)), n);
        let counted = mean(&PairCounts::plug_in_of_counted_weights);
        assert_relative_eq!(counted, bias - of_weights, epsilon = 1e-13);
    }
}

/// `E φ(k/(Np) − 1)` by the binomial distribution from the mode outwards, on both sides of where
/// the moments take over.
#[test]
fn both_ways_to_the_expected_bias_agree() {
    for samples in [2000u64, 10_000, 1_000_000, 1_000_000_000_000] {
        for mean in [
            1.0, 30.0, 900.0, 999.9, 1000.0, 1000.1, 1500.0, 5000.0, 50_000.0,
        ] {
            let (n, p) = (samples as f64, mean / samples as f64);
            if p >= 1.0 {
                continue;
            }
            let width = 12.0 * mean.sqrt() + 40.0;
            let (low, high) = (
                (mean - width).max(0.0).floor(),
                (mean + width).ceil().min(n),
            );
            let (mut weight, mut mass, mut sum) = (1.0, 0.0, 0.0);
            // upwards from the middle, then downwards
            let mut k = mean.floor();
            while k <= high {
                mass += weight;
                sum += weight * divergence_kernel(k / mean - 1.0);
                weight *= (n - k) / (k + 1.0) * (p / (1.0 - p));
                k += 1.0;
            }
            (k, weight) = (mean.floor(), 1.0);
            while k > low {
                weight *= k / (n - k + 1.0) * ((1.0 - p) / p);
                k -= 1.0;
                mass += weight;
                sum += weight * divergence_kernel(k / mean - 1.0);
            }
            let found = expected_bias([(p, 1.0)], samples);
            let expected = p * sum / mass / LN_2;
            let off = (found / expected - 1.0).abs();
            assert!(off < 1e-11, "N = {samples}, Np = {mean}: {off:e}");
        }
    }
}

/// `(K − 1)/(2N) + (Σ 1/p − 1)/(12 N²) + O(N⁻³)` nats (Harris 1975): Miller and Madow's correction
/// takes the first term off.
#[test]
fn first_two_orders_are_the_literatures() {
    let cells = CELLS.map(|(_, p)| (p, 1.0));
    let second = CELLS.iter().map(|(_, p)| 1.0 / p).sum::<f64>() - 1.0;
    for samples in [1000u64, 10_000, 100_000] {
        let n = samples as f64;
        let rest = expected_bias(cells, samples) * LN_2 - 1.0 / n;
        let off = rest * 12.0 * n * n / second - 1.0;
        // the next order, and the digits that the difference loses
        assert!(off.abs() < 20.0 / n + 1e-13 * n, "N = {samples}: {off:e}");
    }
    // what Miller and Madow leave over all outcomes falls faster than 1/N
    let left = |n: u64| -> f64 {
        let all = outcomes(n);
        let terms = all.iter().map(|(k, p)| p * counts(k).miller_madow());
        terms.sum::<f64>() - information()
    };
    let ratio = left(40) / left(80);
    assert!((3.7..4.6).contains(&ratio), "{ratio}");
}

/// 4000 samples of 50 draws; four standard errors, with a fixed seed.
#[test]
fn simulations_have_the_expected_bias() {
    let mut random = ChaCha8Rng::seed_from_u64(12);
    let estimates: Vec<f64> = (0..4000)
        .map(|_| {
            let mut met = [0; 3];
            for _ in 0..50 {
                let u: f64 = random.random();
                met[usize::from(u >= 0.5) + usize::from(u >= 0.8)] += 1;
            }
            counts(&met).plug_in()
        })
        .collect();
    let mean = estimates.iter().sum::<f64>() / 4000.0;
    let squares: f64 = estimates.iter().map(|e| (e - mean).powi(2)).sum();
    let error = (squares / 4000.0 / 3999.0).sqrt();
    let expected = information() + expected_bias(CELLS.map(|(_, p)| (p, 1.0)), 50);
    assert!(
        (mean - expected).abs() < 4.0 * error,
        "{mean} {expected} {error}"
    );
    assert!(expected - information() > 20.0 * error);
}

/// One line falls into one cell: the estimate is `log2(1/m)` on average over the cells, here 0.263
/// + 3.906 bit of bias, whatever the way.
#[test]
fn one_sample_knows_its_cell() {
    let cube = scene("cube:1", 0);
    let pairs = pairs(&cube);
    // all products are 2/36
    let expected = (36.0f64 / 2.0).log2() - exact(&cube);
    let found = expected_bias_of_scene(&pairs, 1).unwrap();
    assert_relative_eq!(found, expected, epsilon = 1e-12);
}

/// One pass over the pairs gives, to the last bit, the two numbers of one pass each; an open scene
/// is refused.
#[test]
fn one_pass_gives_the_information_and_its_bias() {
    let cube = Scene::built_in("cube:3").unwrap();
    let pairs = ScenePairs::try_new(&cube, 1e-12, Congruence::Shared, Occlusion::Refuse).unwrap();
    let (information, bias) = scene_information_and_bias(&pairs, 1000).unwrap();
    assert_eq!(
        information,
        scene_information(&pairs, OpenScene::Refuse).unwrap()
    );
    let alone = expected_bias_of_scene(&pairs, 1000).unwrap();
    assert_eq!(bias.to_bits(), alone.to_bits());
    assert!(bias > 0.0);
    let open = Scene::built_in("two-squares").unwrap();
    let open = ScenePairs::try_new(&open, 1e-12, Congruence::Shared, Occlusion::Refuse).unwrap();
    assert!(scene_information_and_bias(&open, 1000).is_err());
}
