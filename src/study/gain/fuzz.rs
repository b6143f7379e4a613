//! Theorem 1 under fire: random refinements until one breaks a promise.
//!
//! Each case is a random refinement ([`strategies::refinement_draw`]); it must be buildable, gain
//! `≥ 0`, and its gain must be the difference of the two mutual informations to
//! [`tolerance::IDENTITY`]. A sample is recomputed at 256 bits: there the gain must be right to
//! [`tolerance::GAIN`] of itself, or, where an entry is below 1e-290 of the sum, to
//! [`tolerance::TINY_GAIN`] bit. A failing case is shrunk to few states and simple numbers.
//!
//! The cases depend on the seed alone, not on the number of threads.

use crate::chain::random::families::{ChainFamily, DivisionFamily, RefinementDraw};
use crate::chain::random::strategies;
use crate::chain::{Refinement, ReversibleChain};
use crate::exchange::Progress;
use crate::information::{mutual_information, refinement_gain};
use crate::numeric::{Scalar, tolerance, x_log2_ratio};
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

/// A hypothesis broken on purpose, to see that a counterexample is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sabotage {
    /// Hypothesis (a): what leaves a sub-state ignores where it came from.
    Reciprocity,
    /// Hypothesis (b): the sub-states are mixed with independent ones and no longer add up.
    Covering,
    /// No hypothesis: the gain itself is off by 1e-9 of it.
    Gain,
}

/// Counts of the kinds of cases.
#[derive(Debug, Clone, PartialEq, Eq, Default, serde::Serialize)]
pub struct Histograms {
    /// Cases by the number of states before the division: 0, 1, 2, ….
    pub states: Vec<u64>,
    /// Cases by the share of zero entries of the refined chain, in tenths.
    pub zero_tenths: Vec<u64>,
    /// Cases by `⌊log10 ΔI⌋`: the first for exactly 0, then below −60, −60 to −51, …, −10 to −1, 0
    /// and above.
    pub gain_decades: Vec<u64>,
    /// Cases by family of chains, in the order of [`ChainFamily::ALL`].
    pub chain_families: Vec<u64>,
    /// Cases by family of divisions, in the order of [`DivisionFamily::ALL`].
    pub division_families: Vec<u64>,
}

/// A refinement that broke a promise.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Counterexample {
    /// The broken promise.
    pub reason: String,
    /// Joint matrix of the refined chain, in rows.
    pub joint: Vec<Vec<f64>>,
    /// The coarse state that each state of the refined chain is a part of.
    pub parents: Vec<usize>,
    /// Rust source that makes the refinement.
    pub source: String,
}

/// The findings of a campaign.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Findings {
    /// Cases run.
    pub cases: u64,
    /// The smallest gain, in bits; none without a case.
    pub minimum_gain: Option<f64>,
    /// The smallest gain above 0, in bits; none if no case gains anything.
    pub minimum_positive_gain: Option<f64>,
    /// The largest error of a sampled gain, in units of what is promised: below 1 the promise
    /// holds.
    pub worst_margin: f64,
    /// Gains recomputed at 256 bits.
    pub recomputed: u64,
    /// Counts of the kinds of cases.
    pub histograms: Histograms,
    /// Shrunk counterexamples, one per block of cases that had any.
    pub counterexamples: Vec<Counterexample>,
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

/// `w_k P_kl` of the refined chain with one hypothesis broken, rows summing to w.
fn broken_flow(refinement: &Refinement, sabotage: Option<Sabotage>) -> Option<Vec<Vec<f64>>> {
    let sabotage = sabotage.filter(|sabotage| *sabotage != Sabotage::Gain)?;
    let refined = refinement.refined();
    let parts = refinement.parts();
    let divided = |k: usize| parts[refinement.parents()[k]].len() > 1;
    let w = |k: usize| refined.stationary_probability(k);
    let transition = |k: usize, l: usize| match sabotage {
        Sabotage::Reciprocity if divided(k) => w(l),
        Sabotage::Covering if divided(k) || divided(l) => {
            0.5 * (refined.transition_probability(k, l) + w(l))
        }
        _ => refined.transition_probability(k, l),
    };
    let n = refined.states();
    Some(
        (0..n)
            .map(|k| (0..n).map(|l| w(k) * transition(k, l)).collect())
            .collect(),
    )
}

/// Eq. (8) of a flow `w_k P_kl` that need not be reciprocal, w its row sums, in bits.
fn plain_information(flow: &[Vec<f64>]) -> f64 {
    let w: Vec<f64> = flow.iter().map(|row| row.iter().sum()).collect();
    let terms = flow.iter().zip(&w).flat_map(|(row, from)| {
        row.iter()
            .zip(&w)
            .filter(|(_, to)| **to > 0.0)
            .map(move |(flow, to)| {
                if *from > 0.0 {
                    from * x_log2_ratio(flow / from, *to)
                } else {
                    0.0
                }
            })
    });
    terms.sum()
}

impl Counterexample {
    fn none() -> Self {
        let (reason, source) = (String::new(), String::new());
        Self {
            reason,
            joint: Vec::new(),
            parents: Vec::new(),
            source,
        }
    }

    fn new(reason: String, draw: &RefinementDraw, sabotage: Option<Sabotage>) -> Self {
        let Ok(refinement) = draw.refinement() else {
            return Self {
                reason,
                source: format!("{draw:?}"),
                ..Self::none()
            };
        };
        let parents = refinement.parents().to_vec();
        match broken_flow(&refinement, sabotage) {
            None => Self {
                reason,
                joint: rows(refinement.refined()),
                parents,
                source: format!("{refinement:?}"),
            },
            Some(flow) => {
                let source = format!(
                    "// broken on purpose: w_k P_kl of a chain that is no refinement of the coarse \
                     one\n\
                     let flow = {flow:?};\nlet coarse = {:?};\nlet parents = {parents:?};",
                    rows(refinement.coarse())
                );
                Self {
                    reason,
                    joint: flow,
                    parents,
                    source,
                }
            }
        }
    }
}

fn rows(chain: &ReversibleChain) -> Vec<Vec<f64>> {
    chain
        .joint()
        .row_iter()
        .map(|row| row.iter().copied().collect())
        .collect()
}

impl Findings {
    fn count(&mut self, draw: &RefinementDraw, refinement: &Refinement, gain: f64) {
        self.cases += 1;
        self.minimum_gain = least(self.minimum_gain, Some(gain));
        let positive = Some(gain).filter(|gain| *gain > 0.0);
        self.minimum_positive_gain = least(self.minimum_positive_gain, positive);
        let joint = refinement.refined().joint();
        let zeros = joint.iter().filter(|entry| **entry <= 0.0).count();
        let histograms = &mut self.histograms;
        increment(&mut histograms.states, refinement.coarse().states());
        increment(&mut histograms.zero_tenths, 10 * zeros / joint.len());
        increment(&mut histograms.gain_decades, decade(gain));
        let chain = ChainFamily::ALL
            .iter()
            .position(|family| *family == draw.chain);
        let division = DivisionFamily::ALL
            .iter()
            .position(|family| *family == draw.division);
        increment(&mut histograms.chain_families, chain.unwrap_or(0));
        increment(&mut histograms.division_families, division.unwrap_or(0));
    }

    fn and(mut self, other: Self) -> Self {
        self.cases += other.cases;
        self.minimum_gain = least(self.minimum_gain, other.minimum_gain);
        let positive = other.minimum_positive_gain;
        self.minimum_positive_gain = least(self.minimum_positive_gain, positive);
        self.worst_margin = self.worst_margin.max(other.worst_margin);
        self.recomputed += other.recomputed;
        let (own, others) = (&mut self.histograms, other.histograms);
        for (own, others) in [
            (&mut own.states, others.states),
            (&mut own.zero_tenths, others.zero_tenths),
            (&mut own.gain_decades, others.gain_decades),
            (&mut own.chain_families, others.chain_families),
            (&mut own.division_families, others.division_families),
        ] {
            own.resize(own.len().max(others.len()), 0);
            own.iter_mut()
                .zip(others)
                .for_each(|(own, other)| *own += other);
        }
        self.counterexamples.extend(other.counterexamples);
        self
    }
}

/// The smaller of two numbers, or the only one.
fn least(one: Option<f64>, other: Option<f64>) -> Option<f64> {
    one.into_iter().chain(other).reduce(f64::min)
}

fn increment(counts: &mut Vec<u64>, index: usize) {
    if counts.len() <= index {
        counts.resize(index + 1, 0);
    }
    counts[index] += 1;
}

/// 0 for a gain of 0, 1 below 1e-60, then one step for ten powers of ten, 8 from 1 on.
fn decade(gain: f64) -> usize {
    if gain <= 0.0 {
        return 0;
    }
    let steps = ((gain.log10() + 60.0) / 10.0).floor().clamp(-1.0, 6.0);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "from 1 to 8"
    )]
    let index = (steps + 2.0) as usize;
    index
}
