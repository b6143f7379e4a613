//! The gain's building block is non-negative, exact at proportional shares, and keeps its digits.

use crate::support::high_precision::HighPrecision;
use crate::support::strategies::shares;
use infoscene::chain::{Refinement, ReversibleChain};
use infoscene::information::{divergence, subdivision_bound};
use infoscene::numeric::{Scalar, divergence_kernel, tolerance};
use nalgebra::dmatrix;
use proptest::prelude::*;

/// `Σ J_k log2( J_k Σw / (w_k ΣJ) )` at 256 bits, from the definition.
fn exact(fluxes: &[f64], weights: &[f64]) -> HighPrecision {
    let sum = |values: &[f64]| {
        values.iter().fold(HighPrecision::new(0.0), |sum, x| {
            sum + &HighPrecision::new(*x)
        })
    };
    let (flux, weight) = (sum(fluxes), sum(weights));
    let terms = fluxes
        .iter()
        .zip(weights)
        .filter(|(flux, _)| **flux > 0.0)
        .map(|(j, w)| {
            let (j, w) = (HighPrecision::new(*j), HighPrecision::new(*w));
            (j.clone() * &weight / &(w * &flux)).ln() * &j
        });
    terms.fold(HighPrecision::new(0.0), |sum, term| sum + &term) / &HighPrecision::new(2.0).ln()
}

proptest! {
    /// `D ≥ 0`, and equal to the definition at 256 bits.
    #[test]
    fn divergence_is_non_negative_and_accurate(
        fluxes in shares(2..7),
        weights in proptest::collection::vec(1e-3..1.0f64, 7),
    ) {
        let weights = &weights[..fluxes.len()];
        let value = divergence(&fluxes, weights);
        prop_assert!(value >= 0.0);
        let exact = exact(&fluxes, weights).to_f64();
        prop_assert!((value - exact).abs() <= tolerance::GAIN * exact, "{value:e} {exact:e}");
    }

    /// Nearly proportional: x_k of 1e-15 and more, gains down to 1e-30, still to full relative
    /// precision.
    #[test]
    fn divergence_of_nearly_proportional_fluxes_keeps_its_digits(
        weights in proptest::collection::vec(0.1..1.0f64, 2..6),
        steps in proptest::collection::vec(-3..4i64, 6),
        factor in 0.1..10.0f64,
    ) {
        let fluxes: Vec<f64> = weights.iter().zip(steps).map(|(weight, step)| {
            let flux = weight * factor;
            f64::from_bits(flux.to_bits().wrapping_add_signed(step))
        }).collect();
        let (value, exact) = (divergence(&fluxes, &weights), exact(&fluxes, &weights).to_f64());
        prop_assert!((value - exact).abs() <= tolerance::GAIN * exact.abs(), "{value:e} {exact:e}");
    }

    /// Fluxes that are the weights times a power of two gain exactly nothing; any other do gain.
    #[test]
    fn divergence_vanishes_only_at_proportional_fluxes(
        weights in proptest::collection::vec(0.1..1.0f64, 2..6),
        power in -60..60i32,
    ) {
        let mut fluxes: Vec<f64> = weights.iter().map(|weight| weight * 2f64.powi(power)).collect();
        prop_assert_eq!(divergence(&fluxes, &weights), 0.0);
        fluxes[0] = fluxes[0].next_up();
        prop_assert!(divergence(&fluxes, &weights) > 0.0);
    }
}

proptest! {
    /// Eq. (6): m equal parts gain at most `2 w P log2 m`, and less as soon as two of them have
    /// flux.
    #[test]
    fn equal_parts_gain_at_most_their_bound(fluxes in shares(2..9)) {
        let weights = vec![1.0; fluxes.len()];
        let flux: f64 = fluxes.iter().sum();
        let bound = subdivision_bound(flux, u32::try_from(fluxes.len()).unwrap());
        let gain = 2.0 * divergence(&fluxes, &weights);
        prop_assert!(gain <= bound * (1.0 + tolerance::GAIN), "{gain} {bound}");
        let second = {
            let mut sorted = fluxes.clone();
            sorted.sort_by(f64::total_cmp);
            sorted[sorted.len() - 2] / flux
        };
        if second > 1e-9 {
            prop_assert!(gain < bound, "{gain} {bound}");
        }
    }
}

/// Eq. (6) is an equality where one part keeps all the flux, which it can as long as m P ≤ 1: its
/// own P is then m P. Beyond that it is out of reach: a chain in which a part would need P > 1 is
/// refused.
#[test]
fn the_bound_is_attained_as_long_as_m_p_is_at_most_one() {
    for parts in 2..=9u32 {
        let mut fluxes = vec![0.0; parts as usize];
        fluxes[0] = 0.7;
        let gain = 2.0 * divergence(&fluxes, &vec![1.0; parts as usize]);
        assert!(
            (gain / subdivision_bound(0.7, parts) - 1.0).abs() <= tolerance::GAIN,
            "{parts}"
        );
    }
    // P = 3/4 in two equal parts: one of them would have to send 3/4 of a weight of 1/2
    let chain = ReversibleChain::try_new(dmatrix![0.25, 0.75; 0.75, 0.0]).unwrap();
    let (outward, within) = (dmatrix![0.0, 0.75; 0.0, 0.0], dmatrix![0.0, 0.0; 0.0, 0.25]);
    let refinement = Refinement::of_state(&chain, 0, &outward, &within).unwrap();
    let weights = refinement.refined().weights();
    assert!(
        weights[0] > weights[2],
        "the parts cannot be equal: {weights:?}"
    );
}

/// `φ(x) = (1+x) ln(1+x) − x` against 256 bits, from −1 to 1e6 and down to |x| = 1e-150.
#[test]
fn divergence_kernel_keeps_its_digits() {
    let magnitudes = (0..4000).map(|k| 10f64.powf(-150.0 + f64::from(k) * 156.0 / 4000.0));
    let arguments = magnitudes
        .flat_map(|x| [x, -x])
        .filter(|x| *x >= -1.0)
        .chain([-1.0]);
    let mut worst: f64 = 0.0;
    for x in arguments {
        let exact = Scalar::divergence_kernel(&HighPrecision::new(x));
        let error = ((HighPrecision::new(divergence_kernel(x)) - &exact) / &exact)
            .abs()
            .to_f64();
        worst = worst.max(error);
    }
    assert!(
        worst <= tolerance::DIVERGENCE_KERNEL,
        "{:e} is {} ε",
        worst,
        worst / f64::EPSILON
    );
    assert!(
        worst >= tolerance::DIVERGENCE_KERNEL / 24.0,
        "the budget is far too wide: {worst:e}"
    );
}
