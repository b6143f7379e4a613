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
use super::finding::{Evidence, Finding, Measure};
use crate::numeric::Interval;
use crate::numeric::interval::Endpoint;

/// What a claim comes to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// An enclosure lies inside what is printed, or a proof stands.
    Confirmed,
    /// An estimate agrees within its stated error.
    Supported,
    /// An enclosure is disjoint from what is printed, and the paper states the configuration.
    Refuted,
    /// Anything else that was computed.
    Undecided,
    /// Not computed.
    NotChecked,
}

impl Verdict {
    /// All verdicts.
    pub const ALL: [Self; 5] = [
        Self::Confirmed,
        Self::Supported,
        Self::Refuted,
        Self::Undecided,
        Self::NotChecked,
    ];

    /// The word used in tables and in JSON.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Confirmed => "confirmed",
            Self::Supported => "supported",
            Self::Refuted => "refuted",
            Self::Undecided => "undecided",
            Self::NotChecked => "not_checked",
        }
    }

    /// The verdict where a theorem alone decides.
    pub(super) const fn of_proof(is_refuted: bool) -> Self {
        if is_refuted {
            Self::Refuted
        } else {
            Self::Confirmed
        }
    }

    /// The verdict on a claim, by the rule above.
    #[must_use]
    pub fn of(claim: &Claim, finding: &Finding) -> Self {
        let agrees = match (&claim.printed, finding.holds, finding.measure) {
            (Some(printed), None, measure) => match (&finding.enclosure, measure) {
                (Some(enclosure), _) => enclosed_agreement(printed, enclosure),
                (None, Measure::Value { value, error }) => agreement(printed, value, error),
                (None, Measure::Residual { .. }) => Agreement::Overlap,
            },
            (_, Some(true), _) => Agreement::Inside,
            (_, Some(false), _) => Agreement::Outside,
            _ => Agreement::Overlap,
        };
        let is_rigorous = finding.evidence >= Evidence::Enclosure;
        match agrees {
            Agreement::Inside if is_rigorous => Self::Confirmed,
            Agreement::Inside => Self::Supported,
            Agreement::Outside if is_rigorous && claim.complete => Self::Refuted,
            _ => Self::Undecided,
        }
    }
}

enum Agreement {
    Inside,
    Overlap,
    Outside,
}

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

/// The same between the exact decimal interval and an enclosure.
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
