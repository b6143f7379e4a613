//! The findings of a campaign, and the sum of two of them.

use super::counterexample::Counterexample;
use crate::chain::Refinement;
use crate::chain::random::families::{ChainFamily, DivisionFamily, RefinementDraw};

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

impl Findings {
    pub(super) fn count(&mut self, draw: &RefinementDraw, refinement: &Refinement, gain: f64) {
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

    pub(super) fn and(mut self, other: Self) -> Self {
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
