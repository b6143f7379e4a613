//! Passes over a symmetric matrix that is held, row by row below its diagonal.
//!
//! In the pass of differences, what leaves one patch arrives at the other, so that a constant x
//! gives 0 exactly, however far J is known. The rows come in blocks that depend on their number
//! alone, each with sums of its own that are added up in order: the answer does not depend on the
//! number of threads.
//!
//! Compensated sums of n terms t are within `n² ε² Σ|t|` (Neumaier 1974) and what the terms
//! themselves lose; one with 106 bits loses 8 ε².

use super::ExchangeOperator;
use crate::numeric::{DoubleDouble, Scaled, Symmetric, parallel_map, vectorised};
use std::borrow::Cow;
use std::ops::Range;

/// Exchange areas that are held, all pairs of them.
#[derive(Debug, Clone)]
pub struct DenseExchange<'e>(Cow<'e, Symmetric<f64>>);

/// Blocks of rows.
const BLOCKS: usize = 16;

/// Entries that are taken at a time.
const LANES: usize = 8;
type Lanes = [f64; LANES];

impl<'e> From<&'e Symmetric<f64>> for DenseExchange<'e> {
    fn from(values: &'e Symmetric<f64>) -> Self {
        Self(Cow::Borrowed(values))
    }
}

impl From<Symmetric<f64>> for DenseExchange<'_> {
    fn from(values: Symmetric<f64>) -> Self {
        Self(Cow::Owned(values))
    }
}

impl ExchangeOperator for DenseExchange<'_> {
    fn order(&self) -> usize {
        self.0.order()
    }

    fn differences(&self, x: &[f64]) -> Vec<f64> {
        let [sums] = self.pass([x], add, |flow, [at], [x], [own], [others]| {
            for k in 0..LANES {
                let term = flow[k] * (at - x[k]);
                own[k] += term;
                others[k] -= term;
            }
        });
        sums
    }

    fn absolute_differences(&self, x: &[f64]) -> Vec<f64> {
        let [sums] = self.pass([x], add, |flow, [at], [x], [own], [others]| {
            for k in 0..LANES {
                let term = flow[k] * (at - x[k]).abs();
                own[k] += term;
                others[k] += term;
            }
        });
        sums
    }

    fn gathered(&self, x: &[f64]) -> Vec<DoubleDouble> {
        let sums = self.pass(
            [x],
            add_compensated,
            |flow, [at], [x], [own, lost], [others, others_lost]| {
                for k in 0..LANES {
                    compensate(&mut own[k], &mut lost[k], flow[k] * x[k]);
                    compensate(&mut others[k], &mut others_lost[k], flow[k] * at);
                }
            },
        );
        paired(&sums)
    }

    fn precise_differences(&self, x: &[DoubleDouble]) -> Vec<DoubleDouble> {
        let high: Vec<f64> = x.iter().map(|x| x.high()).collect();
        let low: Vec<f64> = x.iter().map(|x| x.low()).collect();
        let sums = self.pass(
            [&high, &low],
            add_compensated,
            |flow, [at, at_low], [x, x_low], [own, lost], [others, others_lost]| {
                for k in 0..LANES {
                    let apart = at - x[k];
                    let back = apart - at;
                    let rest = (at - (apart - back)) - (x[k] + back) + (at_low - x_low[k]);
                    let term = flow[k] * apart;
                    let term_low = flow[k].mul_add(apart, -term) + flow[k] * rest;
                    compensate(&mut own[k], &mut lost[k], term);
                    compensate(&mut others[k], &mut others_lost[k], -term);
                    lost[k] += term_low;
                    others_lost[k] -= term_low;
                }
            },
        );
        paired(&sums)
    }
}

impl DenseExchange<'_> {
    /// The exchange area of two different rows.
    pub(super) fn get(&self, i: usize, j: usize) -> f64 {
        *self.0.get(i, j)
    }

    /// The largest entry, or `least` if that is larger.
    pub(super) fn largest(&self, least: f64) -> f64 {
        self.0.entries().iter().copied().fold(least, f64::max)
    }

    /// Multiplies all entries by `2^power`.
    pub(super) fn scale(&mut self, power: i32) {
        for value in self.0.to_mut().entries_mut() {
            *value = Scaled::new(*value).times_power(power);
        }
    }

    /// Sums over the rows of what `kernel` adds for J_ij, x_j and x_i to the sum of j and to that
    /// of i.
    fn pass<const Q: usize, const P: usize>(
        &self,
        x: [&[f64]; Q],
        add: impl Fn([f64; P], [f64; P]) -> [f64; P] + Sync,
        kernel: impl Fn(Lanes, [f64; Q], [Lanes; Q], &mut [Lanes; P], &mut [Lanes; P]) + Sync + Copy,
    ) -> [Vec<f64>; P] {
        let blocks: Vec<Range<usize>> = self.0.blocks(BLOCKS).collect();
        let blocks = parallel_map(blocks.len(), &|block| {
            let rows = blocks[block].clone();
            let mut sums = [(); P].map(|()| vec![0.0; rows.end]);
            for j in rows {
                let row = self.0.row(j);
                let mut own = [[0.0; LANES]; P];
                let (taken, others) = (&mut own, sums.each_mut().map(|sums| &mut sums[..j]));
                // what is moved in is local to the loop, which the compiler wants to see for
                // vectors
                vectorised(
                    #[inline(always)]
                    move || *taken = along(row, x, others, kernel),
                );
                let mut sum = [0.0; P];
                for lane in 0..LANES {
                    sum = add(sum, own.map(|own| own[lane]));
                }
                for (sums, sum) in sums.iter_mut().zip(sum) {
                    sums[j] = sum;
                }
            }
            sums
        });
        let mut sums = [(); P].map(|()| vec![0.0; self.order()]);
        for block in &blocks {
            for i in 0..block[0].len() {
                let sum = add(
                    sums.each_ref().map(|s| s[i]),
                    block.each_ref().map(|s| s[i]),
                );
                for (sums, sum) in sums.iter_mut().zip(sum) {
                    sums[i] = sum;
                }
            }
        }
        sums
    }
}

/// One row left of the diagonal: adds to the sums of the others, returns those of its own.
#[inline(always)]
#[allow(
    clippy::inline_always,
    reason = "vector code is made where it is called"
)]
fn along<const Q: usize, const P: usize>(
    row: &[f64],
    x: [&[f64]; Q],
    mut others: [&mut [f64]; P],
    kernel: impl Fn(Lanes, [f64; Q], [Lanes; Q], &mut [Lanes; P], &mut [Lanes; P]),
) -> [Lanes; P] {
    let n = row.len();
    let at = x.map(|x| x[n]);
    let mut own = [[0.0; LANES]; P];
    let whole = n / LANES * LANES;
    for k in (0..whole).step_by(LANES) {
        let mut sums = others.each_ref().map(|others| lanes(&others[k..k + LANES]));
        let x = x.map(|x| lanes(&x[k..k + LANES]));
        kernel(lanes(&row[k..k + LANES]), at, x, &mut own, &mut sums);
        for (others, sums) in others.iter_mut().zip(&sums) {
            others[k..k + LANES].copy_from_slice(sums);
        }
    }
    if whole < n {
        // no flow in the lanes beyond
        let mut sums = others.each_ref().map(|others| lanes(&others[whole..]));
        let x = x.map(|x| lanes(&x[whole..n]));
        kernel(lanes(&row[whole..]), at, x, &mut own, &mut sums);
        for (others, sums) in others.iter_mut().zip(&sums) {
            others[whole..].copy_from_slice(&sums[..n - whole]);
        }
    }
    own
}

/// Up to eight numbers, and zeros.
#[inline(always)]
#[allow(
    clippy::inline_always,
    reason = "vector code is made where it is called"
)]
fn lanes(values: &[f64]) -> Lanes {
    if let Some(lanes) = values.first_chunk() {
        return *lanes;
    }
    let mut lanes = [0.0; LANES];
    lanes[..values.len()].copy_from_slice(values);
    lanes
}

/// Adds a term to a sum, and what is lost by it to the other.
#[inline(always)]
#[allow(
    clippy::inline_always,
    reason = "vector code is made where it is called"
)]
fn compensate(sum: &mut f64, lost: &mut f64, term: f64) {
    let next = *sum + term;
    let added = next - *sum;
    *lost += (*sum - (next - added)) + (term - added);
    *sum = next;
}

fn add([a]: [f64; 1], [b]: [f64; 1]) -> [f64; 1] {
    [a + b]
}

fn add_compensated([mut sum, mut lost]: [f64; 2], [term, more]: [f64; 2]) -> [f64; 2] {
    compensate(&mut sum, &mut lost, term);
    [sum, lost + more]
}

fn paired([sums, lost]: &[Vec<f64>; 2]) -> Vec<DoubleDouble> {
    let both = sums.iter().zip(lost);
    both.map(|(sum, lost)| DoubleDouble::sum(*sum, *lost))
        .collect()
}
