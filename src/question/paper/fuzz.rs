//! Random refinements thrown at Theorem 1.

use crate::exchange::Progress;
use crate::question::QuestionError;
use crate::study::gain::fuzz::{Campaign, Counterexample, Findings, Histograms, Sabotage, run};
use std::ops::RangeInclusive;
use std::time::Instant;

/// Numbers of states before the division that a campaign may have.
const STATES: RangeInclusive<usize> = 2..=64;

/// The question for a counterexample to Theorem 1 among random refinements.
///
/// # Examples
/// ```
/// use infoscene::exchange::Unheard;
/// use infoscene::question::Fuzz;
/// let found = Fuzz { cases: 100, ..Fuzz::default() }.ask(&Unheard)?;
/// // the theorem is proved
/// assert!(found.counterexamples.is_empty());
/// assert_eq!(found.cases, 100);
/// # Ok::<(), infoscene::question::QuestionError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fuzz {
    /// The number of refinements to try.
    pub cases: u32,
    /// The seed: the same one makes the same cases, whatever the number of threads.
    pub seed: u64,
    /// The most states before the division, from 2 to 64.
    pub states: usize,
    /// A hypothesis broken on purpose, to see a counterexample found.
    pub sabotage: Option<Sabotage>,
}

impl Default for Fuzz {
    /// A hundred thousand refinements of up to 12 states, from seed 1.
    fn default() -> Self {
        Self {
            cases: 100_000,
            seed: 1,
            states: 12,
            sabotage: None,
        }
    }
}

/// The findings of a campaign against Theorem 1, gains in bits.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct FuzzAnswer {
    /// The number of cases run.
    pub cases: u64,
    /// The seed.
    pub seed: u64,
    /// The smallest gain; none where no case was run to its end.
    pub minimum_gain: Option<f64>,
    /// The smallest gain above 0; none where no case gains anything.
    pub minimum_positive_gain: Option<f64>,
    /// The largest error of a recomputed gain, in units of the error that is promised.
    pub worst_margin: f64,
    /// The number of gains recomputed at 256 bits.
    pub recomputed: u64,
    /// Counterexamples, simplified.
    pub counterexamples: Vec<Counterexample>,
    /// Cases per second, rounded.
    pub cases_per_second: f64,
    /// Counts of the kinds of cases.
    pub histograms: Histograms,
}

impl FuzzAnswer {
    /// Constructs the answer from the findings of a campaign that took so many seconds.
    #[must_use]
    pub fn new(seed: u64, findings: Findings, seconds: f64) -> Self {
        #[expect(clippy::cast_precision_loss, reason = "fewer than 2^53 cases")]
        let cases = findings.cases as f64;
        Self {
            cases: findings.cases,
            seed,
            minimum_gain: findings.minimum_gain,
            minimum_positive_gain: findings.minimum_positive_gain,
            worst_margin: findings.worst_margin,
            recomputed: findings.recomputed,
            counterexamples: findings.counterexamples,
            cases_per_second: (cases / seconds).round(),
            histograms: findings.histograms,
        }
    }
}

impl Fuzz {
    /// Runs the campaign; progress advances by the cases that are finished.
    ///
    /// # Errors
    /// [`QuestionError::StatesOutOfRange`].
    pub fn ask(&self, progress: &dyn Progress) -> Result<FuzzAnswer, QuestionError> {
        if !STATES.contains(&self.states) {
            return Err(QuestionError::StatesOutOfRange {
                states: self.states,
                least: *STATES.start(),
                most: *STATES.end(),
            });
        }
        let campaign = Campaign {
            cases: self.cases,
            seed: self.seed,
            states: self.states,
            sabotage: self.sabotage,
        };
        let start = Instant::now();
        let findings = run(campaign, progress);
        let seconds = start.elapsed().as_secs_f64();
        Ok(FuzzAnswer::new(self.seed, findings, seconds))
    }
}
