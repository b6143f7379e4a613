//! A surface of a scene that stands between others, by its index.

use std::fmt;

/// A surface that stands in the way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Obstacle {
    /// The patch with this index.
    Patch(usize),
    /// The obstruction with this index.
    Obstruction(usize),
}

impl fmt::Display for Obstacle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Patch(index) => write!(f, "patch {index}"),
            Self::Obstruction(index) => write!(f, "obstruction {index}"),
        }
    }
}
