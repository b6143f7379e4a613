//! The rule that turns a finding into a verdict.
//!
//! ```text
//!   printed number, v ± e computed      enclosure or proof         anything weaker
//!     [v−e, v+e] inside                 confirmed                  supported
//!     disjoint, configuration stated    refuted                    undecided
//!     otherwise                         undecided                  undecided
//!   statement
//!     holds                             confirmed                  supported
//!     fails, configuration stated       refuted                    undecided
//! ```

use super::claim::{Claim, Printed};
use super::finding::{Finding, Quantity};
use super::verdict::Verdict;
use crate::numeric::Grade;
use crate::numeric::Interval;
use crate::numeric::interval::Endpoint;

impl Verdict {
    /// The verdict on a claim, by the rule above.
    #[must_use]
    pub fn of(claim: &Claim, finding: &Finding) -> Self {
        let is_rigorous = finding.grade >= Grade::Enclosure;
        match Agreement::of(claim, finding) {
            Agreement::Inside if is_rigorous => Self::Confirmed,
            Agreement::Inside => Self::Supported,
            Agreement::Outside if is_rigorous && claim.complete => Self::Refuted,
            _ => Self::Undecided,
        }
    }
}

/// The relation of a finding to the claim.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Agreement {
    /// Inside what is printed, or the statement holds.
    Inside,
    /// Neither inside nor outside for certain.
    Overlap,
    /// Outside of what is printed, or the statement fails.
    Outside,
}

impl Agreement {
    pub(super) fn of(claim: &Claim, finding: &Finding) -> Self {
        match (&claim.printed, finding.holds) {
            (Some(printed), None) => match (&finding.enclosure, finding.quantity) {
                (Some(enclosure), _) => enclosed_agreement(printed, enclosure),
                (None, Quantity::Value { value, error }) => agreement(printed, value, error),
                (None, Quantity::Residual { .. }) => Self::Overlap,
            },
            (_, Some(true)) => Self::Inside,
            (_, Some(false)) => Self::Outside,
            (None, None) => Self::Overlap,
        }
    }
}

/// Compares a value and its error with what is printed, in doubles.
fn agreement(printed: &Printed, value: f64, error: f64) -> Agreement {
    let (lower, upper) = printed.interval();
    if lower <= value - error && value + error <= upper {
        Agreement::Inside
    } else if value + error < lower || upper < value - error {
        Agreement::Outside
    } else {
        Agreement::Overlap
    }
}

/// Compares an enclosure with the exact decimal interval.
fn enclosed_agreement(printed: &Printed, enclosure: &Interval) -> Agreement {
    let Some([lower, upper]) = printed.exact_interval(enclosure.lower().bits()) else {
        return Agreement::Overlap;
    };
    if enclosure < &lower || enclosure > &upper {
        Agreement::Outside
    } else if &lower < enclosure && enclosure < &upper {
        Agreement::Inside
    } else {
        Agreement::Overlap
    }
}
