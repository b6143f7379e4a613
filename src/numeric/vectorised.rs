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
pub fn vectorised(work: impl FnOnce()) {
    VECTOR_UNIT.dispatch(work);
}
