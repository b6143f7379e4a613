//! Theorem 1 under fire: random refinements until one breaks a promise.
//!
//! Each case is a random refinement ([`strategies::refinement_draw`]); it must be buildable, gain
//! `≥ 0`, and its gain must be the difference of the two mutual informations to
//! [`tolerance::IDENTITY`]. A sample is recomputed at 256 bits: there the gain must be right to
//! [`tolerance::GAIN`] of itself, or, where an entry is below 1e-290 of the sum, to
//! [`tolerance::TINY_GAIN`] bit. A failing case is shrunk to few states and simple numbers.
//!
//! The cases depend on the seed alone, not on the number of threads.

mod counterexample;
mod findings;
mod sabotage;

pub use counterexample::Counterexample;
pub use findings::{Findings, Histograms};
pub use sabotage::Sabotage;

use self::sabotage::{broken_flow, plain_information};
use crate::chain::Refinement;
use crate::chain::random::families::RefinementDraw;
use crate::chain::random::strategies;
use crate::exchange::Progress;
use crate::information::{mutual_information, refinement_gain};
use crate::numeric::{Scalar, tolerance};
use crate::reference::exact_gain;
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestError, TestRng, TestRunner};
use rayon::prelude::*;
use std::cell::{Cell, RefCell};
use std::sync::atomic::{AtomicU32, Ordering};

/// The length and the size of a campaign.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Campaign {
    /// Cases to run.
    pub cases: u32,
    /// Seed.
    pub seed: u64,
    /// Most states before the division, ≥ 2.
    pub states: usize,
    /// The promise broken on purpose.
    pub sabotage: Option<Sabotage>,
}

/// Cases per block; a block has its own random numbers.
const BLOCK: u32 = 500;
/// Attempts to make a counterexample simpler.
const SHRINKING: u32 = 50_000;
/// Bits of the enclosures that judge a sample of the gains.
const JUDGE: u32 = 256;

/// One case in this many is recomputed at 256 bits.
const SAMPLED: u64 = 500;

/// Runs a campaign on all threads; `progress` is called with the number of cases of each finished
/// block.
///
/// It ends at the first block with a counterexample: blocks behind it are left out, whoever ran
/// them.
#[must_use]
pub fn run(campaign: Campaign, progress: &dyn Progress) -> Findings {
    let first_failing = AtomicU32::new(u32::MAX);
    let blocks = campaign.cases.div_ceil(BLOCK);
    let found = (0..blocks).into_par_iter().map(|block| {
        if block > first_failing.load(Ordering::Relaxed) {
            return None;
        }
        let findings = run_block(campaign, block, BLOCK.min(campaign.cases - block * BLOCK));
        if !findings.counterexamples.is_empty() {
            first_failing.fetch_min(block, Ordering::Relaxed);
        }
        progress.advance(usize::try_from(findings.cases).unwrap_or(usize::MAX));
        Some(findings)
    });
    let found: Vec<Option<Findings>> = found.collect();
    let upto = usize::try_from(first_failing.into_inner()).unwrap_or(usize::MAX);
    found
        .into_iter()
        .take(upto.saturating_add(1))
        .flatten()
        .fold(Findings::default(), Findings::and)
}

fn run_block(campaign: Campaign, block: u32, cases: u32) -> Findings {
    let mut seed = [0; 32];
    seed[..8].copy_from_slice(&campaign.seed.to_le_bytes());
    seed[8..12].copy_from_slice(&block.to_le_bytes());
    let config = Config {
        cases,
        failure_persistence: None,
        max_shrink_iters: SHRINKING,
        ..Config::default()
    };
    let source = TestRng::from_seed(RngAlgorithm::ChaCha, &seed);
    let findings = RefCell::new(Findings::default());
    let has_failed = Cell::new(false);
    let outcome = TestRunner::new_with_rng(config, source).run(
        &strategies::refinement_draw(campaign.states),
        |draw| {
            let mut findings = findings.borrow_mut();
            // what follows a failure is shrinking: it does not count, and leaves nothing unchecked
            let mut shrinking = Findings::default();
            let (own, sampling) = if has_failed.get() {
                (&mut shrinking, 1)
            } else {
                (&mut *findings, SAMPLED)
            };
            examine(&draw, campaign.sabotage, sampling, own).map_err(|reason| {
                has_failed.set(true);
                TestCaseError::fail(reason)
            })
        },
    );
    let mut findings = findings.into_inner();
    match outcome {
        Ok(()) => {}
        Err(TestError::Fail(reason, draw)) => {
            findings.counterexamples.push(Counterexample::new(
                reason.to_string(),
                &draw,
                campaign.sabotage,
            ));
        }
        Err(TestError::Abort(reason)) => {
            let reason = format!("the campaign gave up: {reason}");
            findings.counterexamples.push(Counterexample {
                reason,
                ..Counterexample::none()
            });
        }
    }
    findings
}

/// One case: what it breaks, if anything; one in `sampling` is recomputed at 256 bits.
fn examine(
    draw: &RefinementDraw,
    sabotage: Option<Sabotage>,
    sampling: u64,
    findings: &mut Findings,
) -> Result<(), String> {
    let refinement = draw
        .refinement()
        .map_err(|error| format!("not a refinement: {error}"))?;
    let spoiled = if sabotage == Some(Sabotage::Gain) {
        1.0 + 1e-9
    } else {
        1.0
    };
    let gain = spoiled * refinement_gain(&refinement);
    findings.count(draw, &refinement, gain);
    let coarse = mutual_information(refinement.coarse());
    let flow = broken_flow(&refinement, sabotage);
    let refined = match &flow {
        None => mutual_information(refinement.refined()),
        Some(flow) => plain_information(flow),
    };
    let difference = refined - coarse;
    if !(gain.is_finite() && gain >= 0.0) {
        return Err(format!("the gain is {gain:e}"));
    }
    if difference.is_nan() || difference < -tolerance::IDENTITY {
        return Err(format!("mutual information falls by {:e} bit", -difference));
    }
    if flow.is_some() {
        return Ok(()); // the gain is that of the sound refinement
    }
    if (difference - gain).abs() > tolerance::IDENTITY + (spoiled - 1.0) * gain {
        return Err(format!("the gain is {gain:e}, I' - I is {difference:e}"));
    }
    if findings.cases.is_multiple_of(sampling) {
        let exact = exact_gain(&refinement, JUDGE);
        // at least; what 256 bits do not resolve is not held against the gain
        let (error, _) = (exact.constant(gain) - &exact).abs().to_doubles();
        let promised = tolerance::GAIN * exact.to_f64() + tiny(&refinement) + exact.width();
        findings.recomputed += 1;
        findings.worst_margin = findings.worst_margin.max(error / promised);
        if error > promised {
            return Err(format!("the gain {gain:e} is off by {error:e} bit"));
        }
    }
    Ok(())
}

/// The absolute error that entries below 1e-290 of the sum leave, else 0.
fn tiny(refinement: &Refinement) -> f64 {
    let refined = refinement.refined();
    let least = 1e-290 * refined.total();
    let is_tiny = refined
        .joint()
        .iter()
        .any(|entry| *entry > 0.0 && *entry < least);
    if is_tiny { tolerance::TINY_GAIN } else { 0.0 }
}
