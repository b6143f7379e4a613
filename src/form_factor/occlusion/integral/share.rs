//! Integrals along pieces of edges, each with what it may be off by.
//!
//! **Not covered**: displaced corners, which are counted once for a pair.

/// An integral with what it may be off by.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Share {
    pub value: f64,
    pub truncation: f64,
    pub rounding: f64,
}

impl Share {
    pub(crate) fn add(&mut self, other: Self) {
        self.value += other.value;
        self.truncation += other.truncation;
        self.rounding += other.rounding + 0.5 * f64::EPSILON * self.value.abs();
    }
}
