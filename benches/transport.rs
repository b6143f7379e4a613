//! Radiosities of 5,046 patches: the whole solution with its bounds, and what it is made of.
#![expect(clippy::unwrap_used, reason = "a bench may panic")]

use criterion::{Criterion, criterion_group, criterion_main};
use infoscene::exchange::ExchangeAreas;
use infoscene::scene::{Material, Scene};
use infoscene::transport::RadiositySystem;
use std::hint::black_box;

/// The inside of a cube, 29 × 29 patches a face; one face emits, reflectances of three kinds.
fn room() -> (ExchangeAreas, Vec<Material>, Vec<f64>) {
    let exchange = Scene::built_in("cube:29")
        .unwrap()
        .exchange_areas()
        .unwrap();
    let count = exchange.rows();
    let reflectance = |patch: usize| [0.3, 0.7, 0.9][patch % 3];
    let materials = (0..count).map(|patch| Material::try_new(reflectance(patch), 0.0).unwrap());
    let emittances = (0..count).map(|patch| f64::from(u8::from(patch < count / 6)));
    let (materials, emittances) = (materials.collect(), emittances.collect());
    (exchange, materials, emittances)
}

/// One product with the exchange areas, entry by entry, as a memory of what the matrix costs to
/// read.
fn read_once(values: &[f64], x: &[f64]) -> f64 {
    let mut sum = 0.0;
    let mut start = 0;
    for j in 0..x.len() {
        for (value, x) in values[start..start + j].iter().zip(x) {
            sum += value * x;
        }
        start += j;
    }
    sum
}

fn radiosities(criterion: &mut Criterion) {
    let (exchange, materials, emittances) = room();
    let room = RadiositySystem::of(&exchange, &materials).unwrap();
    let found = room.radiosity(&emittances).unwrap();
    // what is emitted is absorbed
    let sum = |term: &dyn Fn(usize) -> f64| -> f64 {
        (0..materials.len())
            .map(|i| exchange.areas()[i] * term(i))
            .sum()
    };
    let emitted = sum(&|i| emittances[i]);
    let absorbed = sum(&|i| (1.0 - materials[i].reflectance()) * found.received[i]);
    assert!((absorbed / emitted - 1.0).abs() < 1e-12);
    assert!(found.relative_error < 1e-15, "{}", found.relative_error);

    let mut group = criterion.benchmark_group("5046 patches");
    group.sample_size(10);
    group.bench_function("the exchange areas read once", |bencher| {
        bencher.iter(|| {
            read_once(
                black_box(exchange.values().entries()),
                black_box(&emittances),
            )
        });
    });
    group.bench_function("row sums", |bencher| {
        bencher.iter(|| RadiositySystem::of(black_box(&exchange), &materials).unwrap());
    });
    group.bench_function("radiosities with both bounds", |bencher| {
        bencher.iter(|| room.radiosity(black_box(&emittances)).unwrap());
    });
    group.finish();
}

criterion_group!(benches, radiosities);
criterion_main!(benches);
