//! What a computation found out about a claim, and how strong the evidence is.

use super::{ClaimError, Inputs};
use crate::numeric::{Interval, Scalar};

/// A function that computes a claim.
pub type Computation = fn(&Inputs) -> Result<Finding, ClaimError>;

/// The grade of evidence, weakest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Evidence {
    /// Random or scanned cases.
    Sample,
    /// A computed value whose error is stated but not proved.
    Estimate,
    /// A value with an error bound derived on paper.
    Bound,
    /// A value enclosed by outward rounding.
    Enclosure,
    /// A machine-checked proof.
    Proof,
}

impl Evidence {
    /// The lower-case word.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Sample => "sample",
            Self::Estimate => "estimate",
            Self::Bound => "bound",
            Self::Enclosure => "enclosure",
            Self::Proof => "proof",
        }
    }
}

/// The number behind a finding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Measure {
    /// A quantity and its stated absolute error.
    Value {
        /// The quantity.
        value: f64,
        /// Its stated error.
        error: f64,
    },
    /// What is left of an identity, against what rounding may leave.
    Residual {
        /// Largest deviation found, ≥ 0.
        value: f64,
        /// What rounding may leave.
        tolerance: f64,
    },
}

impl Measure {
    /// The number itself.
    #[must_use]
    pub const fn number(self) -> f64 {
        match self {
            Self::Value { value, .. } | Self::Residual { value, .. } => value,
        }
    }
}

/// What a computation found.
#[derive(Debug, Clone)]
pub struct Finding {
    /// The number.
    pub measure: Measure,
    /// Contains the exact number, if it is enclosed.
    pub enclosure: Option<Interval>,
    /// Does the statement hold? `None` where the claim is a printed number to compare with.
    pub holds: Option<bool>,
    /// How strong the evidence is.
    pub evidence: Evidence,
    /// What a reader should know, empty if nothing.
    pub note: String,
    /// The figure's curve, if the claim has one: abscissa and ordinate.
    pub curve: Vec<[f64; 2]>,
}

impl Finding {
    /// A number to compare with the printed one.
    #[must_use]
    pub const fn value(value: f64, error: f64) -> Self {
        Self::new(Measure::Value { value, error }, None)
    }

    /// A statement that holds or not, with the number that decides it.
    #[must_use]
    pub const fn statement(holds: bool, value: f64, error: f64) -> Self {
        Self::new(Measure::Value { value, error }, Some(holds))
    }

    /// An enclosed number to compare with the printed one.
    #[must_use]
    pub fn enclosed(enclosure: Interval) -> Self {
        Self::value(enclosure.to_f64(), stated_error(&enclosure)).within(enclosure)
    }

    /// A statement that an enclosed number decides: it `holds` for all numbers of the interval, `fails` for all, or
    /// is left open.
    #[must_use]
    pub fn decided(holds: bool, fails: bool, enclosure: Interval) -> Self {
        let measure = Measure::Value {
            value: enclosure.to_f64(),
            error: stated_error(&enclosure),
        };
        let holds = (holds != fails).then_some(holds);
        Self::new(measure, holds).within(enclosure)
    }

    fn within(mut self, enclosure: Interval) -> Self {
        self.evidence = Evidence::Enclosure;
        self.enclosure = Some(enclosure);
        self
    }

    /// An identity, with what is left of it.
    #[must_use]
    pub fn residual(value: f64, tolerance: f64) -> Self {
        Self::new(
            Measure::Residual { value, tolerance },
            Some(value <= tolerance),
        )
    }

    const fn new(measure: Measure, holds: Option<bool>) -> Self {
        let evidence = Evidence::Estimate;
        Self {
            measure,
            enclosure: None,
            holds,
            evidence,
            note: String::new(),
            curve: Vec::new(),
        }
    }

    /// The same, from random or scanned cases only.
    #[must_use]
    pub fn sampled(mut self) -> Self {
        self.evidence = Evidence::Sample;
        self
    }

    /// The same, with a note.
    #[must_use]
    pub fn noting(mut self, note: impl Into<String>) -> Self {
        self.note = note.into();
        self
    }

    /// The same, with the figure's curve.
    #[must_use]
    pub fn with_curve(mut self, curve: Vec<[f64; 2]>) -> Self {
        self.curve = curve;
        self
    }
}

/// How far the exact number can lie from the double nearest to the middle of its enclosure.
fn stated_error(enclosure: &Interval) -> f64 {
    let middle = enclosure.constant(enclosure.to_f64());
    let (lower, upper) = (enclosure.clone() - &middle).to_doubles();
    upper.max(-lower)
}
