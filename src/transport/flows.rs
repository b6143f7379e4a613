//! Passes over a symmetric matrix that is held by columns above its diagonal.
//!
//! ```text
//!   differences:  y_i = Σ_j J_ij (x_i − x_j)        gathered:  y_i = Σ_{j≠i} J_ij x_j
//! ```
//!
//! In the first what leaves one patch arrives at the other, so that a constant x gives 0 exactly, however far J is known.
//! The columns come in runs that depend on their number alone, each with sums of its own that are added up in
//! order: the answer does not depend on the number of threads.

#![allow(
    clippy::inline_always,
    reason = "vector code is made where it is called"
)]

use crate::numeric::vectorised;
use rayon::prelude::*;
use std::ops::{Add, Mul, Neg, Range, Sub};

/// `f64`, or numbers of 106 bits.
pub(super) trait Number:
    Copy
    + Send
    + Sync
    + From<f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
{
}

impl<T> Number for T where
    T: Copy
        + Send
        + Sync
        + From<f64>
        + Add<Output = T>
        + Sub<Output = T>
        + Mul<Output = T>
        + Neg<Output = T>
{
}

/// A symmetric matrix without its diagonal: entry (i, j), i < j, at `j(j − 1)/2 + i`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Flows<'e> {
    pub(super) count: usize,
    pub(super) values: &'e [f64],
}

/// Runs of columns, with about as many entries each.
const RUNS: usize = 16;

/// Sums that a column's entries are dealt out to.
const LANES: usize = 8;

/// Where column j starts.
pub(super) const fn start(j: usize) -> usize {
    j * j.saturating_sub(1) / 2
}

impl<'e> Flows<'e> {
    /// `Σ_j J_ij (x_i − x_j)`.
    pub(super) fn differences<T: Number>(&self, x: &[T]) -> Vec<T> {
        self.pass(x, |flow, at, x| {
            let difference = flow * (at - x);
            [difference, -difference]
        })
    }

    /// `Σ_{j≠i} J_ij x_j`.
    pub(super) fn gathered<T: Number>(&self, x: &[T]) -> Vec<T> {
        self.pass(x, |flow, at, x| [flow * x, flow * at])
    }

    /// `Σ_{j≠i} J_ij |x_i − x_j|`.
    pub(super) fn absolute_differences(&self, x: &[f64]) -> Vec<f64> {
        self.pass(x, |flow: f64, at, x| [flow * (at - x).abs(); 2])
    }

    /// Sums over the rows of what `term(J_ij, x_j, x_i)` gives to j and to i.
    fn pass<T: Number>(&self, x: &[T], term: impl Fn(T, T, T) -> [T; 2] + Sync + Copy) -> Vec<T> {
        let runs: Vec<Vec<T>> = (0..RUNS)
            .into_par_iter()
            .map(|run| {
                let columns = self.columns(run);
                let mut sums = vec![T::from(0.0); columns.end];
                for j in columns {
                    let column = &self.values[start(j)..start(j + 1)];
                    let mut own = T::from(0.0);
                    let (x, others) = (&x[..=j], &mut sums[..j]);
                    vectorised(|| own = along(column, x, others, term));
                    sums[j] = sums[j] + own;
                }
                sums
            })
            .collect();
        let mut sums = vec![T::from(0.0); self.count];
        for run in runs {
            for (sum, part) in sums.iter_mut().zip(run) {
                *sum = *sum + part;
            }
        }
        sums
    }

    /// The columns of a run.
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "between 0 and the count"
    )]
    fn columns(&self, run: usize) -> Range<usize> {
        let end = |run: usize| (self.count as f64 * (run as f64 / RUNS as f64).sqrt()) as usize;
        let last = if run + 1 == RUNS {
            self.count
        } else {
            end(run + 1)
        };
        end(run)..last
    }
}

/// One column: adds to the sums of the others, returns that of its own.
#[inline(always)]
fn along<T: Number>(
    column: &[f64],
    x: &[T],
    others: &mut [T],
    term: impl Fn(T, T, T) -> [T; 2] + Copy,
) -> T {
    let at = x[column.len()];
    let x = &x[..column.len()];
    let others = &mut others[..column.len()];
    let mut lanes = [T::from(0.0); LANES];
    let whole = column.len() / LANES * LANES;
    let blocks = column.chunks_exact(LANES).zip(x.chunks_exact(LANES));
    for ((flows, x), others) in blocks.zip(others.chunks_exact_mut(LANES)) {
        for lane in 0..LANES {
            let [own, other] = term(T::from(flows[lane]), at, x[lane]);
            lanes[lane] = lanes[lane] + own;
            others[lane] = others[lane] + other;
        }
    }
    for k in whole..column.len() {
        let [own, other] = term(T::from(column[k]), at, x[k]);
        lanes[k - whole] = lanes[k - whole] + own;
        others[k] = others[k] + other;
    }
    lanes.into_iter().fold(T::from(0.0), |sum, lane| sum + lane)
}
