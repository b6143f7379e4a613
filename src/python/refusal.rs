//! A refusal on its way to Python.

use super::mends::mend;
use std::error::Error;

/// The text of a refusal, with its mend in Python's words.
pub(super) struct Refusal(pub(super) String);

impl<E: Error + 'static> From<E> for Refusal {
    fn from(error: E) -> Self {
        Self(format!("{error}{}", mend(&error)))
    }
}
