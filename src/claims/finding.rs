//! The finding of a computation: a number, whether the statement holds, and the evidence.

use super::reach::OneSided;
use crate::numeric::{Grade, Interval, Scalar};

/// The number behind a finding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Quantity {
    /// A quantity and its stated absolute error.
    Value {
        /// The quantity.
        value: f64,
        /// The stated error.
        error: f64,
    },
    /// The residual of an identity, and the residual that rounding may leave.
    Residual {
        /// Largest deviation found, ≥ 0.
        value: f64,
        /// The residual that rounding may leave.
        tolerance: f64,
    },
}

impl Quantity {
    /// The number itself.
    #[must_use]
    pub const fn number(self) -> f64 {
        match self {
            Self::Value { value, .. } | Self::Residual { value, .. } => value,
        }
    }
}

/// The finding of a computation.
#[derive(Debug, Clone)]
pub struct Finding {
    /// The number.
    pub quantity: Quantity,
    /// Contains the exact number, if it is enclosed.
    pub enclosure: Option<Interval>,
    /// Whether the statement holds; `None` where the claim is a printed number to compare with.
    pub holds: Option<bool>,
    /// The grade of the evidence.
    pub grade: Grade,
    /// The only side to which the computation can decide; none for both.
    pub one_sided: Option<OneSided>,
    /// A note for the reader, empty if there is none.
    pub note: String,
    /// The figure's curve, if the claim has one: abscissa and ordinate.
    pub curve: Vec<[f64; 2]>,
}

impl Finding {
    /// A number to compare with the printed one.
    #[must_use]
    pub const fn value(value: f64, error: f64) -> Self {
        Self::new(Quantity::Value { value, error }, None)
    }

    /// A statement that holds or not, with the number that decides it.
    #[must_use]
    pub const fn statement(holds: bool, value: f64, error: f64) -> Self {
        Self::new(Quantity::Value { value, error }, Some(holds))
    }

    /// An enclosed number to compare with the printed one.
    #[must_use]
    pub fn enclosed(enclosure: Interval) -> Self {
        Self::value(enclosure.to_f64(), stated_error(&enclosure)).within(enclosure)
    }

    /// A statement that an enclosed number decides: it `holds` for all numbers of the interval,
    /// `fails` for all, or is left open.
    #[must_use]
    pub fn decided(holds: bool, fails: bool, enclosure: Interval) -> Self {
        let quantity = Quantity::Value {
            value: enclosure.to_f64(),
            error: stated_error(&enclosure),
        };
        let holds = (holds != fails).then_some(holds);
        Self::new(quantity, holds).within(enclosure)
    }

    /// A statement that an enclosed number can confirm and not refute, as a counterexample does, or
    /// an inequality of which one case is computed.
    #[must_use]
    pub fn confirmed_if(holds: bool, enclosure: Interval) -> Self {
        let finding = Self::decided(holds, false, enclosure);
        Self {
            one_sided: Some(OneSided::Confirm),
            ..finding
        }
    }

    /// A statement that an enclosed number can refute and not confirm, as an equality of numbers.
    #[must_use]
    pub fn refuted_if(fails: bool, enclosure: Interval) -> Self {
        let finding = Self::decided(false, fails, enclosure);
        Self {
            one_sided: Some(OneSided::Refute),
            ..finding
        }
    }

    fn within(mut self, enclosure: Interval) -> Self {
        self.grade = Grade::Enclosure;
        self.enclosure = Some(enclosure);
        self
    }

    /// An identity, with its residual.
    #[must_use]
    pub fn residual(value: f64, tolerance: f64) -> Self {
        Self::new(
            Quantity::Residual { value, tolerance },
            Some(value <= tolerance),
        )
    }

    const fn new(quantity: Quantity, holds: Option<bool>) -> Self {
        Self {
            quantity,
            enclosure: None,
            holds,
            grade: Grade::Estimate,
            one_sided: None,
            note: String::new(),
            curve: Vec::new(),
        }
    }

    /// Grades the finding as from random or scanned cases only.
    #[must_use]
    pub fn sampled(mut self) -> Self {
        self.grade = Grade::Sample;
        self
    }

    /// Adds a note.
    #[must_use]
    pub fn noting(mut self, note: impl Into<String>) -> Self {
        self.note = note.into();
        self
    }

    /// Adds the figure's curve.
    #[must_use]
    pub fn with_curve(mut self, curve: Vec<[f64; 2]>) -> Self {
        self.curve = curve;
        self
    }
}

/// The largest distance of the exact number from the double nearest to the middle of its enclosure.
fn stated_error(enclosure: &Interval) -> f64 {
    let middle = enclosure.constant(enclosure.to_f64());
    let (lower, upper) = (enclosure.clone() - &middle).to_doubles();
    upper.max(-lower)
}
