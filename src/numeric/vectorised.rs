//! Loops in the widest vectors that the processor at hand has.

use std::sync::LazyLock;

static VECTOR_UNIT: LazyLock<pulp::Arch> = LazyLock::new(pulp::Arch::new);

/// Runs `work`, compiled for what this processor can do. Only the order of speed changes: no operation is fused or
/// reordered, so the answer has the same bits everywhere.
#[inline(always)]
#[allow(
    clippy::inline_always,
    reason = "vector code is made where it is called"
)]
pub fn vectorised<T>(work: impl FnOnce() -> T) -> T {
    VECTOR_UNIT.dispatch(work)
}

/// Doubles in a vector of today's widest processors.
pub const LANES: usize = 8;

/// A vector of doubles, or what narrower ones take in turns.
pub type Lanes = [f64; LANES];

/// The sum of all lanes, halves first.
#[must_use]
pub fn across(lanes: Lanes) -> f64 {
    let [a, b, c, d, e, f, g, h] = lanes;
    ((a + e) + (c + g)) + ((b + f) + (d + h))
}
