//! Loops in the widest vectors that the processor at hand has.
//!
//! **How vector code is written.** [`vectorised`] compiles a closure once for each kind of
//! processor; whatever is inlined into the closure is compiled with it, and whatever is called from
//! it is not. Hence every function on the way down is `#[inline(always)]`, and so is the closure
//! itself; work on several lanes is a loop with a fixed count, not a closure handed to `map`. Data
//! go in as slices bound to locals and captured by `move`; a result goes out through a reference to
//! a local ([`vector_value`]), since a returned array would be taken apart.

use std::sync::LazyLock;

static VECTOR_UNIT: LazyLock<pulp::Arch> = LazyLock::new(pulp::Arch::new);

/// Runs `work`, compiled for what this processor can do. Only the order of speed changes: no
/// operation is fused or reordered, so the answer has the same bits everywhere.
#[inline(always)]
pub(crate) fn vectorised<T>(work: impl FnOnce() -> T) -> T {
    VECTOR_UNIT.dispatch(work)
}

/// Evaluates an expression in vector code, with a first argument to hold the result until then.
macro_rules! vector_value {
    ($initial:expr, $value:expr) => {{
        let mut value = $initial;
        let out = &mut value;
        $crate::numeric::vectorised(
            #[inline(always)]
            move || *out = $value,
        );
        value
    }};
}
pub(crate) use vector_value;

/// Doubles in a vector of today's widest processors.
pub(crate) const LANES: usize = 8;

/// A vector of doubles, or what narrower ones take in turns.
pub(crate) type Lanes = [f64; LANES];

/// The sum of all lanes, halves first.
#[must_use]
pub(crate) fn across(lanes: Lanes) -> f64 {
    let [a, b, c, d, e, f, g, h] = lanes;
    ((a + e) + (c + g)) + ((b + f) + (d + h))
}
