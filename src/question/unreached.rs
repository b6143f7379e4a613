//! Promised tolerances that an answer misses.

use crate::exchange::{PassSummary, Tolerance};
use std::fmt;

/// A tolerance that an answer misses; its text says by how much.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Unreached {
    /// The form factors of some pairs of rows.
    Pairs {
        /// The error that is accepted.
        tolerance: Tolerance,
        /// The number of pairs whose error bound is larger.
        pairs: usize,
        /// The rows of the worst pair.
        worst: [usize; 2],
        /// The names of the rows.
        names: [String; 2],
        /// The larger form factor of the worst pair.
        form_factor: f64,
        /// The bound on its absolute error.
        error: f64,
    },
    /// The radiosities, for the form factors as computed.
    Radiosity {
        /// The relative error asked for.
        tolerance: f64,
        /// The bound on the relative error.
        relative_error: f64,
    },
}

impl Unreached {
    /// The pairs of rows with these names that miss the tolerance in a pass, if some do.
    pub(super) fn pairs<N: AsRef<str>>(
        names: &[N],
        summary: &PassSummary,
        tolerance: Tolerance,
    ) -> Option<Self> {
        let worst = summary.worst?;
        let rows = [worst.first, worst.second];
        Some(Self::Pairs {
            tolerance,
            pairs: summary.unreached,
            worst: rows,
            names: rows.map(|row| names[row].as_ref().to_owned()),
            form_factor: worst.form_factor,
            error: worst.error,
        })
    }
}

impl fmt::Display for Unreached {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Pairs {
                tolerance,
                pairs,
                worst: [first, second],
                names: [one, other],
                form_factor,
                error,
            } => write!(
                f,
                "{pairs} pairs miss the tolerance {tolerance}; the worst is {first} ({one}) and \
                 {second} ({other}), whose form factor is {form_factor:.0e} ± {error:.0e}: \
                 accept a larger relative or absolute error"
            ),
            Self::Radiosity {
                tolerance,
                relative_error,
            } => write!(
                f,
                "the radiosities may be {relative_error:.0e} off, relative, and the tolerance is \
                 {tolerance:e}"
            ),
        }
    }
}
