//! Rectangle closed forms, in multiples of the textbook's sixteen terms timed beside them.
#![expect(clippy::unwrap_used, reason = "a bench may panic")]

mod textbook;

use criterion::{Criterion, criterion_group, criterion_main};
use infoscene::form_factor::rectangles::perpendicular::Plate;
use infoscene::form_factor::rectangles::{parallel, perpendicular};
use infoscene::geometry::Span;
use std::hint::black_box;
use textbook::textbook_parallel;

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
