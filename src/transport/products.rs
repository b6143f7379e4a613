//! Products with a symmetric matrix that is read below its diagonal, block by block.
//!
//! In the pass of differences, what leaves one patch arrives at the other, so that a constant x
//! gives 0 exactly, however far J is known. The rows come in blocks that depend on their number
//! alone, each with sums of its own that are added up in order: the answer does not depend on the
//! number of threads, nor on that of the ranks that have the blocks.
//!
//! Compensated sums of n terms t are within `n² ε² Σ|t|` (Neumaier 1974) and what the terms
//! themselves lose; one with 106 bits loses 8 ε².

use crate::exchange::{Deal, ExchangeError, LowerBlocks, agreed};
use crate::numeric::{DoubleDouble, entries_of, try_parallel_map, vectorised};
use std::ops::Range;

/// Blocks whose sums a rank holds at a time.
const BLOCKS: usize = 16;

/// Entries that are taken at a time.
const LANES: usize = 8;
type Lanes = [f64; LANES];

/// The products with a matrix.
#[derive(Clone, Copy)]
pub(super) struct Products<'m>(pub(super) &'m dyn LowerBlocks);

impl Products<'_> {
    pub(super) fn differences(&self, x: &[f64]) -> Result<Vec<f64>, ExchangeError> {
        let [sums] = self.pass([x], add, |flow, [at], [x], [own], [others]| {
            for k in 0..LANES {
                let term = flow[k] * (at - x[k]);
                own[k] += term;
                others[k] -= term;
            }
        })?;
        Ok(sums)
    }

    pub(super) fn absolute_differences(&self, x: &[f64]) -> Result<Vec<f64>, ExchangeError> {
        let [sums] = self.pass([x], add, |flow, [at], [x], [own], [others]| {
            for k in 0..LANES {
                let term = flow[k] * (at - x[k]).abs();
                own[k] += term;
                others[k] += term;
            }
        })?;
        Ok(sums)
    }

    pub(super) fn gathered(&self, x: &[f64]) -> Result<Vec<DoubleDouble>, ExchangeError> {
        let sums = self.pass(
            [x],
            add_compensated,
            |flow, [at], [x], [own, lost], [others, others_lost]| {
                for k in 0..LANES {
                    compensate(&mut own[k], &mut lost[k], flow[k] * x[k]);
                    compensate(&mut others[k], &mut others_lost[k], flow[k] * at);
                }
            },
        )?;
        Ok(paired(&sums))
    }

    pub(super) fn precise_differences(
        &self,
        x: &[DoubleDouble],
    ) -> Result<Vec<DoubleDouble>, ExchangeError> {
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
        )?;
        Ok(paired(&sums))
    }
}

impl Products<'_> {
    /// Sums over the rows of what `kernel` adds for J_ij, x_j and x_i to the sum of j and to that
    /// of i.
    fn pass<const Q: usize, const P: usize, K>(
        &self,
        x: [&[f64]; Q],
        add: impl Fn([f64; P], [f64; P]) -> [f64; P] + Sync + Copy,
        kernel: K,
    ) -> Result<[Vec<f64>; P], ExchangeError>
    where
        K: Fn(Lanes, [f64; Q], [Lanes; Q], &mut [Lanes; P], &mut [Lanes; P]) + Sync + Copy,
    {
        let order = self.0.order();
        let blocks = self.0.blocks();
        let deal = Deal::new(self.0.ranks(), order);
        let mut sums = [(); P].map(|()| vec![0.0; order]);
        for first in (0..blocks.len()).step_by(BLOCKS * deal.ranks().count()) {
            let end = (first + BLOCKS * deal.ranks().count()).min(blocks.len());
            let own: Vec<usize> = deal.own_parts(first..end).collect();
            let found = try_parallel_map(own.len(), &|place| {
                let block = own[place];
                self.of_block((block, &blocks[block]), x, add, kernel)
            });
            let found = agreed(deal.ranks(), found)?;
            let found: Vec<Vec<&[f64]>> = found
                .iter()
                .map(|sums| sums.iter().map(Vec::as_slice).collect())
                .collect();
            let shape = |block: usize| vec![0..blocks[block].end; P];
            deal.deliver(first..end, 1, &shape, &found, &mut |brought| {
                let numbers: [&[f64]; P] = std::array::from_fn(|p| brought[p].1);
                for (k, i) in brought[0].0.clone().enumerate() {
                    let sum = add(sums.each_ref().map(|s| s[i]), numbers.map(|n| n[k]));
                    for (sums, sum) in sums.iter_mut().zip(sum) {
                        sums[i] = sum;
                    }
                }
            });
        }
        if deal.ranks().count() == 1 {
            return Ok(sums);
        }
        let own = sums.iter().flat_map(|sums| &sums[deal.own_places()]);
        Ok(deal.complete_each(own.copied().collect()))
    }

    /// The sums that one block brings to its rows and to those before them.
    fn of_block<const Q: usize, const P: usize>(
        &self,
        (block, rows): (usize, &Range<usize>),
        x: [&[f64]; Q],
        add: impl Fn([f64; P], [f64; P]) -> [f64; P],
        kernel: impl Fn(Lanes, [f64; Q], [Lanes; Q], &mut [Lanes; P], &mut [Lanes; P]) + Copy,
    ) -> Result<[Vec<f64>; P], ExchangeError> {
        let entries = self.0.block(block, rows.clone())?;
        debug_assert_eq!(entries.len(), entries_of(rows), "the whole block");
        let mut entries = &*entries;
        let mut sums = [(); P].map(|()| vec![0.0; rows.end]);
        for j in rows.clone() {
            let (row, rest) = entries.split_at(j);
            entries = rest;
            let mut own = [[0.0; LANES]; P];
            let (taken, others) = (&mut own, sums.each_mut().map(|sums| &mut sums[..j]));
            // what is moved in is local to the loop, which the compiler wants to see for vectors
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
        Ok(sums)
    }
}

/// One row left of the diagonal: adds to the sums of the others, returns those of its own.
#[inline(always)]
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
