//! Values from independent evaluations.

use super::{EXTREME, MODERATE, SOLIDS, information};
use crate::support::breadth::some_of;
use infoscene::information::continuous_information;
use infoscene::numeric::GaussLegendre;
use infoscene::scene::Scene;
use std::f64::consts::{E, LN_2, PI};

/// Values of an independent evaluation to 37 digits, rounded.
#[test]
fn known_values_are_met() {
    for (name, exact) in [
        ("cube:1", 1.610_473_346_468_777_7),
        ("tetrahedron", 2.619_457_987_927_652),
        ("box:1,1,2", 1.796_996_907_794_523),
    ] {
        let found = information(name);
        let off = (found.mutual_information.value - exact).abs();
        assert!(off <= MODERATE * exact, "{name}: {off:e}");
        assert!(
            off <= found.mutual_information.error && found.mutual_information.error < 1e-11,
            "{name}: {off:e} {:e}",
            found.mutual_information.error
        );
    }
}

/// ∫ over pieces that double from `scale`, for functions that change on that scale near 0: 24
/// points each leave 1e-20.
fn graded(function: impl Fn(f64) -> f64, end: f64, scale: f64) -> f64 {
    let gauss = GaussLegendre::with(24);
    let (mut start, mut stop, mut sum) = (0.0, (0.5 * scale).min(end), 0.0);
    while start < end {
        let (middle, half) = (0.5 * (start + stop), 0.5 * (stop - start));
        let rule = gauss.nodes.iter().zip(&gauss.weights);
        sum += half
            * rule
                .map(|(x, w)| w * function(middle + half * x))
                .sum::<f64>();
        (start, stop) = (stop, (2.0 * stop).min(end));
    }
    sum
}

/// A formula that boxes have to themselves, and that no pair of faces enters but opposite ones: `∮∮
/// (ln² r + ln r) dl·dl' = 4π ∫∫ F ln r − 2 n·n' ∫∫ dA dA'/r²` for any two polygons (Stokes).
/// Summed over all faces of a closed room and each with itself the contours cancel; perpendicular
/// faces have no last term. So `Σ_ij R_ij = −(1/4π) Σ_i ∮_i∮_i − (1/2π) Σ_opposite ∫∫ dA dA'/r²`.
fn of_a_box(edges: [f64; 3]) -> f64 {
    let mut sum = 0.0;
    let mut area = 0.0;
    for k in 0..3 {
        let [a, b, d] = [0, 1, 2].map(|i| edges[(k + i) % 3]);
        area += 2.0 * a * b;
        // an edge with itself less the same with the opposite one: ln² r + ln r at r = u and at r =
        // √(u² + b²)
        let edge = |a: f64, b: f64| {
            let difference = |u: f64| {
                let drop = 0.5 * (b / u).powi(2).ln_1p();
                -(a - u) * drop * (u.ln() + u.hypot(b).ln() + 1.0)
            };
            4.0 * graded(difference, a, 1e-20 * a.min(b))
        };
        sum -= 2.0 * (edge(a, b) + edge(b, a)) / (4.0 * PI);
        let inner = |u: f64| {
            let c = u.hypot(d);
            (a - u) * (b / c * (b / c).atan() - 0.5 * (b * b / (c * c)).ln_1p())
        };
        sum -= 2.0 * 4.0 * graded(inner, a, d) / (2.0 * PI);
    }
    (area / (PI * E)).log2() - 2.0 * sum / area / LN_2
}

#[test]
fn boxes_agree_with_a_formula_of_their_own() {
    for (edges, allowed) in some_of([
        ([1.0, 1.0, 1.0], MODERATE),
        ([1.0, 1.0, 2.0], MODERATE),
        ([1.0, 2.0, 3.0], MODERATE),
        ([1.0, 1.0, 10.0], EXTREME),
        ([1.0, 1.0, 0.1], EXTREME),
        ([1.0, 1.0, 1e3], EXTREME),
        ([1.0, 1.0, 1e-3], EXTREME),
        ([1.0, 30.0, 1e-2], EXTREME),
        ([1.0, 1.0, 1e6], EXTREME),
        ([1.0, 1.0, 1e-6], EXTREME),
        ([1.0, 1e-4, 1e4], EXTREME),
        ([1.0, 1.0, 1e8], EXTREME),
        ([1.0, 1.0, 1e-9], EXTREME),
    ]) {
        let [x, y, z] = edges;
        let found = continuous_information(&Scene::inside_of_box(x, y, z).unwrap()).unwrap();
        let expected = of_a_box(edges);
        let off = (found.mutual_information.value - expected).abs() / expected;
        println!(
            "{edges:?}: {expected} {off:e}, said {:e}",
            found.mutual_information.error
        );
        assert!(
            off < allowed && off * expected <= found.mutual_information.error,
            "{edges:?}: {off:e}"
        );
        assert!(
            found.mutual_information.error < allowed * expected,
            "{edges:?}: {:e}",
            found.mutual_information.error
        );
    }
}

/// A face of a convex room sees everything: both end angles of a chord are cosine-distributed, so
/// the closed formula `log2(A_T/(π e)) − 2 E[log2 r]` and the sum over pairs agree, and both stay
/// within the error said.
#[test]
fn errors_of_the_solids_are_small() {
    for name in SOLIDS {
        let found = information(name);
        assert!(
            found.mutual_information.error < MODERATE * found.mutual_information.value.max(1.0),
            "{name}: {:e}",
            found.mutual_information.error
        );
        let probability: f64 = found.pairs.iter().map(|pair| pair.probability).sum();
        assert!(
            (probability - 1.0).abs() < MODERATE,
            "{name}: {probability}"
        );
    }
}

/// The rounder the room, the less a point says about where it goes; in a sphere nothing (see
/// `sphere_is_zero`).
#[test]
fn rounder_solids_have_less_information() {
    let values = SOLIDS.map(|name| information(name).mutual_information.value);
    assert!(values.is_sorted_by(|a, b| a > b), "{values:?}");
}
