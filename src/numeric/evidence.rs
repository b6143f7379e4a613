//! Grades of evidence, and numbers that carry one.
//!
//! ```text
//!   sample < estimate < bound < enclosure < proof
//! ```
//!
//! One rule names them everywhere. A number that people read is a [`Bounded`]. A type held by the
//! million has the fields `value` and `error` alone; its grade is the constant `GRADE`, and
//! `bounded` joins the three. A list of errors is `errors`; where several lists stand in one type,
//! each has its own list of bounds beside it: `own` and `own_bounds`. An `error` is absolute and of
//! the number beside it; names for something else stay: `standard_error` (one standard deviation),
//! `relative_error` (a quotient), and `uncertainty` (relative, of a value that judges another).
//!
//! **Not covered**: enclosures themselves, which are [`Interval`](super::Interval)s.

/// The grade of evidence behind a number or a statement, weakest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Grade {
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

impl Grade {
    /// The grades, weakest first.
    pub const ALL: [Self; 5] = [
        Self::Sample,
        Self::Estimate,
        Self::Bound,
        Self::Enclosure,
        Self::Proof,
    ];

    /// The word used in tables and in JSON.
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

    /// The meaning of the grade, in half a sentence.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Sample => "random or scanned cases",
            Self::Estimate => "a number whose error is stated and measured, not proved",
            Self::Bound => "a number whose error is bounded on paper",
            Self::Enclosure => "a number enclosed by outward rounding",
            Self::Proof => "a machine-checked proof",
        }
    }
}

/// A number with its absolute error and the grade of that error.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Bounded {
    /// The number.
    pub value: f64,
    /// The absolute error of the value, ≥ 0; the grade tells its meaning.
    pub error: f64,
    /// The grade of the error.
    pub grade: Grade,
}

impl Bounded {
    /// Constructs a number whose error is stated but not proved.
    #[must_use]
    pub const fn estimate(value: f64, error: f64) -> Self {
        Self::of_grade(value, error, Grade::Estimate)
    }

    /// Constructs a number whose error is bounded on paper.
    #[must_use]
    pub const fn bound(value: f64, error: f64) -> Self {
        Self::of_grade(value, error, Grade::Bound)
    }

    /// Constructs a number from random cases, with its standard error.
    #[must_use]
    pub const fn sample(value: f64, error: f64) -> Self {
        Self::of_grade(value, error, Grade::Sample)
    }

    /// Constructs a number whose error has this grade.
    #[must_use]
    pub const fn of_grade(value: f64, error: f64, grade: Grade) -> Self {
        Self {
            value,
            error,
            grade,
        }
    }
}
