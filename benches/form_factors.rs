//! Rectangle closed forms, in multiples of the textbook's sixteen terms timed beside them.
#![allow(
    missing_docs,
    reason = "criterion's macros write undocumented functions"
)]
#![allow(clippy::unwrap_used, reason = "a bench may panic")]

use criterion::{Criterion, criterion_group, criterion_main};
use infoscene::form_factor::perpendicular::Plate;
use infoscene::form_factor::{parallel, perpendicular};
use infoscene::geometry::Span;
use std::hint::black_box;

/// The sum of Howell's C-13 as it is usually typed in, without a thought for cancellation.
fn textbook_parallel(x: [f64; 2], y: [f64; 2], xi: [f64; 2], eta: [f64; 2], z: f64) -> f64 {
    let mut sum = 0.0;
    for (i, x) in x.into_iter().enumerate() {
        for (j, y) in y.into_iter().enumerate() {
            for (k, xi) in xi.into_iter().enumerate() {
                for (l, eta) in eta.into_iter().enumerate() {
                    let (u, v) = (x - xi, y - eta);
                    let (p, q) = (u.hypot(z), v.hypot(z));
                    let sign = if (i + j + k + l) % 2 == 0 { 1.0 } else { -1.0 };
                    sum += sign
                        * (v * p * (v / p).atan() + u * q * (u / q).atan()
                            - 0.5 * z * z * (u * u + v * v + z * z).ln());
                }
            }
        }
    }
    sum / std::f64::consts::TAU
}

fn rectangles(criterion: &mut Criterion) {
    let span = |lower, upper| Span::try_new(lower, upper).unwrap();
    let (unit, other) = (span(0.0, 1.0), span(0.25, 2.0));
    let plate = |depth, width| Plate::try_new(depth, width).unwrap();

    // unit squares at distance 1 and with a common edge: 60-digit values
    let facing = parallel::exchange_area(&[unit, unit], &[unit, unit], &1.0)
        .unwrap()
        .value;
    assert!((facing - 0.199_824_895_698_387_38).abs() < 1e-15);
    let naive = textbook_parallel([0.0, 1.0], [0.0, 1.0], [0.0, 1.0], [0.0, 1.0], 1.0);
    assert!((naive - facing).abs() < 1e-14);
    let corner = perpendicular::exchange_area(&plate(unit, unit), &plate(unit, unit)).value;
    assert!((corner - 0.200_043_776_075_403_15).abs() < 1e-15);

    let mut group = criterion.benchmark_group("rectangles");
    group.bench_function("textbook, 16 terms", |bencher| {
        bencher.iter(|| {
            let unit = black_box([0.0, 1.0]);
            textbook_parallel(unit, unit, black_box([0.25, 2.0]), unit, black_box(1.0))
        });
    });
    group.bench_function("parallel, with bound", |bencher| {
        bencher.iter(|| {
            parallel::exchange_area(black_box(&[unit, unit]), black_box(&[other, unit]), &1.0)
        });
    });
    group.bench_function("perpendicular, with bound", |bencher| {
        bencher.iter(|| {
            let (first, second) = (plate(unit, unit), plate(other, unit));
            perpendicular::exchange_area(black_box(&first), black_box(&second))
        });
    });
    group.finish();
}

criterion_group!(benches, rectangles);
criterion_main!(benches);
