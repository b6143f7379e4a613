//! The gain's building block is non-negative, exact at proportional shares, and keeps its digits.

use crate::support::strategies::shares;
use infoscene::information::divergence;
use infoscene::numeric::{HighPrecision, Scalar, divergence_kernel, tolerance};
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

    /// Nearly proportional: x_k of 1e-15 and more, gains down to 1e-30, still to full relative precision.
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
