//! Derivatives by the lines against differences of enclosures.

use crate::support::breadth::some_of;
use infoscene::discretize::{BestGrid, BoxGrid, UNIT_CUBE};
use infoscene::numeric::{Bounded, Interval, Scalar};

/// Bits for second differences, which lose twice the bits of the step.
const BITS: u32 = 160;

/// Bits for first differences, which are left with 88 of them.
const FIRST_BITS: u32 = 128;

/// I at half-lines moved by powers of two of an edge.
fn information(like: &Interval, edges: [f64; 3], half: &[f64], cells: u32, by: &[f64]) -> Interval {
    let lines = half.iter().zip(by);
    let moved = lines.map(|(line, by)| like.constant(*line) + like.constant(*by));
    let moved: Vec<Interval> = moved.collect();
    let grid = BoxGrid::mirrored(edges, &moved, cells, like).unwrap();
    grid.mutual_information().unwrap()
}

/// 2⁻⁴⁰ of an edge: central differences are off by its square, 1e-24 times the next derivative.
const STEP: f64 = 1.0 / (1_u64 << 40) as f64;

fn aside(lines: usize, of: &[(usize, f64)]) -> Vec<f64> {
    let mut by = vec![0.0; lines];
    for (line, step) in of {
        by[*line] += step;
    }
    by
}

/// `(I(t + h) − I(t − h))/(2h)`
#[test]
fn gradients_are_differences() {
    for (edges, half, cells) in some_of([
        (UNIT_CUBE, vec![0.3], 3),
        (UNIT_CUBE, vec![0.07, 0.3], 5),
        ([1.0, 2.0, 3.0], vec![0.3], 4),
        ([1.0, 0.01, 7.0], vec![0.45], 3),
        ([1.0, 0.05, 0.05], vec![0.1, 0.2], 5),
    ]) {
        let like = Interval::precise(1.0, FIRST_BITS);
        let exact: Vec<f64> = (0..half.len())
            .map(|line| {
                let at = |step| {
                    information(
                        &like,
                        edges,
                        &half,
                        cells,
                        &aside(half.len(), &[(line, step)]),
                    )
                };
                ((at(STEP) - at(-STEP)) / like.constant(2.0 * STEP)).to_f64()
            })
            .collect();
        let grid = BoxGrid::mirrored(edges, &half, cells, &1.0).unwrap();
        let found = grid.gradient().unwrap();
        for (found, exact) in found.iter().zip(&exact) {
            assert!(
                (found - exact).abs() <= 1e-11,
                "{edges:?} {half:?}: {found} {exact}"
            );
        }
        assert_eq!(found.len(), half.len());
        // over intervals it encloses the same number, up to the difference's own error
        let lifted = grid.lifted(&like).unwrap().gradient().unwrap();
        for (enclosure, exact) in lifted.iter().zip(&exact) {
            assert!(enclosure.width() < 1e-30);
            assert!((enclosure.to_f64() - exact).abs() <= 1e-15 * (1.0 + exact.abs()));
        }
    }
}

/// The largest eigenvalue of the Hessian, whose entries are second differences.
#[test]
fn curvatures_are_second_differences() {
    for (edges, cells) in some_of([([1.0, 2.0, 3.0], 4), ([1.0, 0.1, 0.1], 5), (UNIT_CUBE, 3)]) {
        let best = BestGrid::find(edges, cells).unwrap();
        let half: Vec<f64> = best
            .grid
            .lines()
            .iter()
            .copied()
            .filter(|t| *t < 0.5)
            .collect();
        let n = half.len();
        let like = Interval::precise(1.0, BITS);
        let middle = information(&like, edges, &half, cells, &aside(n, &[]));
        let second = |i: usize, k: usize| {
            let at = |s, t| information(&like, edges, &half, cells, &aside(n, &[(i, s), (k, t)]));
            let (rising, falling) = (at(STEP, STEP), at(-STEP, -STEP));
            let mixed = if i == k {
                rising + falling - middle.clone() - middle.clone()
            } else {
                rising + falling - at(STEP, -STEP) - at(-STEP, STEP)
            };
            (mixed / like.constant(4.0 * STEP * STEP)).to_f64()
        };
        // the lower triangle is all that is read
        let hessian =
            nalgebra::DMatrix::from_fn(n, n, |i, k| if k > i { 0.0 } else { second(i, k) });
        let largest = hessian.symmetric_eigenvalues().max();
        let Bounded {
            value: found,
            error,
            ..
        } = best.curvature.unwrap();
        assert!(
            (found - largest).abs() <= 1e-9 * largest.abs(),
            "{edges:?} {cells}: {found} {largest}"
        );
        assert!((found - largest).abs() <= error);
        assert!(found < 0.0);
    }
}
