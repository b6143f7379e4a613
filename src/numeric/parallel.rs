//! Maps over indices on all threads.
//!
//! The answers stand in the order of the indices, whichever thread gave them. The code that shares
//! out the work is compiled once, for all who use it: adaptors of `rayon` would be compiled again
//! for each closure, and were a tenth of the time that this library takes to compile.
//!
//! **Not here**: sums (their order is their caller's); searches for a first answer.

use rayon::prelude::*;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Computes an answer for each index below `count`.
pub(crate) fn parallel_map<T: Send + Sync>(
    count: usize,
    answer: &(dyn Fn(usize) -> T + Sync),
) -> Vec<T> {
    let slots = empty(count);
    for_each_index(count, &|index| {
        slots[index].get_or_init(|| answer(index));
    });
    slots.into_iter().filter_map(OnceLock::into_inner).collect()
}

/// Computes an answer for each index below `count`, or gives the error of the first index that has
/// one; what comes after an error is left out as far as no thread has begun it.
pub(crate) fn try_parallel_map<T: Send + Sync, E: Send + Sync>(
    count: usize,
    answer: &(dyn Fn(usize) -> Result<T, E> + Sync),
) -> Result<Vec<T>, E> {
    let slots = empty(count);
    let first_error = AtomicUsize::new(usize::MAX);
    for_each_index(count, &|index| {
        if index > first_error.load(Ordering::Relaxed) {
            return;
        }
        if slots[index].get_or_init(|| answer(index)).is_err() {
            first_error.fetch_min(index, Ordering::Relaxed);
        }
    });
    // only slots behind an error are empty
    slots.into_iter().map_while(OnceLock::into_inner).collect()
}

fn empty<T>(count: usize) -> Vec<OnceLock<T>> {
    std::iter::repeat_with(OnceLock::new).take(count).collect()
}

/// The one loop over threads.
fn for_each_index(count: usize, work: &(dyn Fn(usize) + Sync)) {
    (0..count).into_par_iter().for_each(work);
}
