//! Theorem 1 under fire: refinement never lowers mutual information.

use infoscene::chain::random::families::DivisionFamily;
use infoscene::chain::random::strategies::{refinement, refinement_draw, reversible_chain};
use infoscene::chain::{Refinement, ReversibleChain};
use infoscene::information::{
    divergence, entropy_rate, mutual_information, positional_entropy, refinement_gain,
};
use infoscene::numeric::{Scalar, compensated_sum, tolerance, x_log2_ratio};
use infoscene::reference::exact_gain;
use nalgebra::DMatrix;
use proptest::prelude::*;

/// The smallest positive joint entry, relative to their sum.
fn smallest_entry(chain: &ReversibleChain) -> f64 {
    let positive = chain.joint().iter().filter(|entry| **entry > 0.0);
    positive.fold(f64::INFINITY, |least, entry| least.min(*entry)) / chain.total()
}

proptest! {
    /// Theorem 1: `I′ − I = gain ≥ 0`.
    #[test]
    fn refining_never_lowers_mutual_information(refinement in refinement(12)) {
        let refinement = refinement?;
        let (coarse, refined) = (refinement.coarse(), refinement.refined());
        let difference = mutual_information(refined) - mutual_information(coarse);
        let gain = refinement_gain(&refinement);
        prop_assert!(gain >= 0.0);
        prop_assert!(
            (difference - gain).abs() <= tolerance::IDENTITY,
            "{difference:e} {gain:e}"
        );
    }

    /// Data processing, the same from the other side: putting any states together never raises it.
    #[test]
    fn coarsening_never_raises_mutual_information(
        chain in reversible_chain(10),
        cut in 1..10usize,
    ) {
        let chain = chain?;
        let parents: Vec<usize> = (0..chain.states())
            .map(|state| usize::from(state >= cut))
            .collect();
        if !parents.contains(&1) {
            return Ok(());
        }
        let together = Refinement::coarsening(chain, parents).unwrap();
        let (before, after) = (
            mutual_information(together.refined()),
            mutual_information(together.coarse()),
        );
        prop_assert!(after <= before + tolerance::IDENTITY);
        prop_assert!(refinement_gain(&together) >= 0.0);
    }

    /// `0 ≤ I ≤ H_p ≤ log2 n`.
    #[test]
    fn mutual_information_lies_between_zero_and_positional_entropy(chain in reversible_chain(12)) {
        let chain = chain?;
        let (information, entropy) = (mutual_information(&chain), positional_entropy(&chain));
        let most = f64::from(u32::try_from(chain.states()).unwrap()).log2();
        prop_assert!(information >= 0.0 && information <= entropy + tolerance::IDENTITY);
        prop_assert!(entropy <= most + tolerance::IDENTITY);
    }

    /// `I = H_p − H_s`.
    #[test]
    fn mutual_information_is_entropy_minus_entropy_rate(chain in reversible_chain(12)) {
        let chain = chain?;
        let difference = positional_entropy(&chain) - entropy_rate(&chain);
        prop_assert!((mutual_information(&chain) - difference).abs() <= tolerance::IDENTITY);
    }

    /// `Σ_i w_i P_ij = w_j`, relative.
    #[test]
    fn the_weights_are_stationary(chain in reversible_chain(12)) {
        let chain = chain?;
        for j in 0..chain.states() {
            let w = |i: usize| chain.stationary_probability(i);
            let inflow = (0..chain.states()).map(|i| w(i) * chain.transition_probability(i, j));
            let change = (compensated_sum(inflow) - w(j)).abs();
            prop_assert!(
                change <= 8.0 * f64::EPSILON * w(j) + 1e-300,
                "{j}: {change:e}"
            );
        }
    }

    /// `w_i P_ij = w_j P_ji`, relative.
    #[test]
    fn the_balance_relation_holds(chain in reversible_chain(12)) {
        let chain = chain?;
        for i in 0..chain.states() {
            for j in 0..i {
                let flow = |i: usize, j: usize| {
                    chain.stationary_probability(i) * chain.transition_probability(i, j)
                };
                let (there, back) = (flow(i, j), flow(j, i));
                // three roundings on either side; products below 1e-300 lose digits
                prop_assert!((there - back).abs() <= 4.0 * f64::EPSILON * there + 1e-300);
            }
        }
    }

    /// Chain rule: the gains of a refinement and of a further one add up to the gain of both at
    /// once, and it does not matter which state is divided first.
    #[test]
    fn gains_of_repeated_refinement_add_up(refinement in refinement(8)) {
        let refinement = refinement?;
        let divided: Vec<usize> = (0..refinement.coarse().states())
            .filter(|i| refinement.parts()[*i].len() > 1)
            .collect();
        let whole = refinement_gain(&refinement);
        for first in &divided {
            // put all parts together again but those of `first`
            let (mut names, mut parents, mut middle_parents) = (Vec::new(), Vec::new(), Vec::new());
            for (part, parent) in refinement.parents().iter().enumerate() {
                let name = (*parent, if parent == first { part } else { 0 });
                let known = names.iter().position(|other| *other == name);
                parents.push(known.unwrap_or_else(|| {
                    names.push(name);
                    middle_parents.push(*parent);
                    names.len() - 1
                }));
            }
            let second = Refinement::coarsening(refinement.refined().clone(), parents).unwrap();
            let coarse = refinement.coarse().clone();
            let first =
                Refinement::try_new(coarse, second.coarse().clone(), middle_parents).unwrap();
            let sum = refinement_gain(&first) + refinement_gain(&second);
            // the middle chain's entries are rounded: its gains carry ε of the information they
            // change
            prop_assert!(
                (sum - whole).abs() <= tolerance::IDENTITY,
                "{sum:e} {whole:e}"
            );
            let both = first.then(&second).unwrap();
            prop_assert_eq!(refinement_gain(&both), whole);
        }
    }

    /// Relabelling the states changes the measures by rounding, scaling by a power of two not at
    /// all.
    #[test]
    fn names_and_units_do_not_matter(
        refinement in refinement(10),
        turn in 1..20usize,
        power in -20..20i32,
    ) {
        let refinement = refinement?;
        let joint = refinement.refined().joint();
        let size = joint.nrows();
        let turned = |k: usize| (k + turn) % size;
        let relabelled = DMatrix::from_fn(size, size, |k, l| joint[(turned(k), turned(l))]);
        let parents = (0..size).map(|k| refinement.parents()[turned(k)]).collect();
        let other =
            Refinement::coarsening(ReversibleChain::try_new(relabelled).unwrap(), parents).unwrap();
        let gain = refinement_gain(&refinement);
        prop_assert!(
            (refinement_gain(&other) - gain).abs() <= tolerance::GAIN * gain + tolerance::TINY_GAIN
        );
        let smallest = smallest_entry(refinement.refined()) * refinement.refined().total();
        if smallest > 1e-290 {
            let scaled = ReversibleChain::try_new(joint * 2f64.powi(power)).unwrap();
            let scaled = Refinement::coarsening(scaled, refinement.parents().to_vec()).unwrap();
            // a gain near the smallest double is rounded to its few bits
            let slack = if gain > tolerance::TINY_GAIN {
                0.0
            } else {
                tolerance::TINY_GAIN
            };
            prop_assert!((refinement_gain(&scaled) - gain).abs() <= slack);
            prop_assert_eq!(
                mutual_information(scaled.refined()),
                mutual_information(refinement.refined())
            );
        }
    }

    /// The gain against 256 bits: to 1e-13 of itself where the smallest entry is ≥ 1e-290 of the
    /// sum, to 1e-280 bit below.
    #[test]
    fn gains_agree_with_256_bits(refinement in refinement(8)) {
        let refinement = refinement?;
        let enclosure = exact_gain(&refinement, 256);
        let (exact, width) = (enclosure.to_f64(), enclosure.width());
        prop_assert!(width < 1e-70);
        let gain = refinement_gain(&refinement);
        let slack = width + tolerance::TINY_GAIN;
        prop_assert!(
            (gain - exact).abs() <= tolerance::GAIN * exact + slack,
            "{gain:e} {exact:e}"
        );
    }

    /// Equality case: a division in exact proportion gains exactly 0, and moving one entry by a
    /// unit in the last place gains something.
    #[test]
    fn proportional_division_gains_nothing_and_only_that(draw in refinement_draw(8)) {
        let draw = infoscene::chain::random::families::RefinementDraw {
            division: DivisionFamily::Proportional,
            ..draw
        };
        let refinement = draw.refinement().unwrap();
        if smallest_entry(refinement.refined()) < 1e-290 {
            return Ok(()); // powers of two of such entries are no longer exact
        }
        prop_assert_eq!(refinement_gain(&refinement), 0.0);
        let parts = &refinement.parts()[0];
        let mut joint = refinement.refined().joint().clone();
        let (k, other) = (parts[0], refinement.parts()[1][0]);
        let moved = joint[(k, other)].next_up();
        // the gain is the square of ε of the entry; and a part that shares flux with one state only
        // cannot be out of proportion
        let shared = (0..joint.ncols())
            .filter(|l| joint[(k, *l)] > 0.0 && !parts.contains(l))
            .count();
        if joint[(k, other)] / refinement.refined().total() < 1e-250 || shared < 2 {
            return Ok(());
        }
        joint[(k, other)] = moved;
        joint[(other, k)] = moved;
        let moved = ReversibleChain::try_new(joint).unwrap();
        let moved = Refinement::coarsening(moved, refinement.parents().to_vec()).unwrap();
        prop_assert!(refinement_gain(&moved) > 0.0, "{:?}", moved);
    }

    /// The log-sum inequality (12): `Σ a log(a/b) ≥ (Σa) log(Σa/Σb)`, an equality for proportional
    /// numbers.
    #[test]
    fn the_log_sum_inequality_holds(
        a in crate::support::strategies::shares(2..8),
        b in proptest::collection::vec(1e-6..1.0f64, 8),
    ) {
        let b = &b[..a.len()];
        let left = compensated_sum(a.iter().zip(b).map(|(a, b)| x_log2_ratio(*a, *b)));
        let right = x_log2_ratio(a.iter().sum(), b.iter().sum());
        prop_assert!(left >= right - tolerance::IDENTITY, "{left} {right}");
        prop_assert!((left - right - divergence(&a, b)).abs() <= tolerance::IDENTITY);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases.div_ceil(6)))]

    /// The promise without slack, down to the smallest gains: 2304 bits resolve 1e-690. Where all
    /// entries are ≥ 1e-290 of the sum the gain is right to 1e-13 of itself or a few of the
    /// smallest doubles.
    #[test]
    fn the_smallest_gains_keep_their_digits(draw in refinement_draw(2)) {
        // weights down to 1e-300 make gains as small
        let chain = infoscene::chain::random::families::ChainFamily::Spread;
        let draw = infoscene::chain::random::families::RefinementDraw { chain, ..draw };
        let refinement = draw.refinement().unwrap();
        if smallest_entry(refinement.refined()) < 1e-290 {
            return Ok(());
        }
        let (gain, exact) = (
            refinement_gain(&refinement),
            exact_gain(&refinement, 2304).to_f64(),
        );
        let normal = 1e-300; // below, doubles lose their digits
        prop_assert!(
            (gain - exact).abs() <= tolerance::GAIN * exact + normal,
            "{gain:e} {exact:e}"
        );
    }

    /// "Nearly decomposable" is what it says: a second eigenvalue within 1e-12 of 1. That of
    /// `D^−½ J D^−½`, by a symmetric solver, whose error is some ε.
    #[test]
    fn decomposable_chains_have_a_second_eigenvalue_near_one(draw in refinement_draw(8)) {
        let draw = infoscene::chain::random::families::RefinementDraw {
            chain: infoscene::chain::random::families::ChainFamily::Decomposable,
            division: DivisionFamily::Proportional,
            ..draw
        };
        let refinement = draw.refinement().unwrap();
        let chain = refinement.coarse();
        let n = chain.states();
        let scaled = DMatrix::from_fn(n, n, |i, j| {
            chain.joint()[(i, j)] / (chain.weights()[i] * chain.weights()[j]).sqrt()
        });
        let mut eigenvalues: Vec<f64> = scaled.symmetric_eigenvalues().iter().copied().collect();
        eigenvalues.sort_by(f64::total_cmp);
        prop_assert!(eigenvalues[n - 2] > 1.0 - 1e-12, "{eigenvalues:?}");
    }
}
