//! Mutual information, gains, best cuts and the whole reproduction.
#![expect(clippy::unwrap_used, reason = "a bench may panic")]

use criterion::{Criterion, criterion_group, criterion_main};
use infoscene::chain::{ReversibleChain, visibility_chain};
use infoscene::claims::{Context, judge, judge_all, registry};
use infoscene::discretize::{BestGrid, BoxGrid, GradientCut, PatchSplit, UNIT_CUBE};
use infoscene::exchange::{Congruence, ScenePairs};
use infoscene::form_factor::DEFAULT_TOLERANCE;
use infoscene::geometry::SplitAxis;
use infoscene::information::{
    OpenScene, divergence, entropy_rate, mutual_information, positional_entropy, scene_information,
};
use infoscene::scene::{Occlusion, Scene};
use std::hint::black_box;

fn measures(criterion: &mut Criterion) {
    let chain = visibility_chain(&Scene::built_in("cube:6").unwrap()).unwrap();
    // 29 digits: data/reference/cube_grids.csv
    let exact = 1.264_541_832_652_463_3;
    assert!((mutual_information(&chain) / exact - 1.0).abs() < 1e-13);
    criterion.bench_function("mutual information, 216 states", |bencher| {
        bencher.iter(|| mutual_information(black_box(&chain)));
    });
    criterion.bench_function("mutual information, 216 states, cells shared", |bencher| {
        bencher.iter(|| {
            BoxGrid::regular(UNIT_CUBE, black_box(6))
                .unwrap()
                .mutual_information()
                .unwrap()
        });
    });

    assert!((divergence(&[1.0, 0.0], &[1.0, 1.0]) - 1.0).abs() < 1e-15);
    let fluxes = black_box([0.1, 0.4, 0.2]);
    criterion.bench_function("divergence of three parts", |bencher| {
        bencher.iter(|| divergence(black_box(&fluxes), &[1.0, 2.0, 3.0]));
    });
    let near = black_box([1.0, 2.0 + 1e-12, 3.0]);
    criterion.bench_function("divergence of three nearly proportional parts", |bencher| {
        bencher.iter(|| divergence(black_box(&near), &[1.0, 2.0, 3.0]));
    });
}

/// 2000 states, a joint matrix of 32 MB, in multiples of reading it and taking one logarithm per
/// entry.
fn large_chain(criterion: &mut Criterion) {
    let n = 2000;
    // w_i P_ij = 1 + 1/(i+j+1): a known chain, symmetric, far from independent in one corner only
    #[expect(clippy::cast_precision_loss, reason = "small indices")]
    let joint = nalgebra::DMatrix::from_fn(n, n, |i, j| 1.0 + 1.0 / (i + j + 1) as f64);
    let chain = ReversibleChain::try_new(joint).unwrap();
    let difference = positional_entropy(&chain) - entropy_rate(&chain);
    assert!((mutual_information(&chain) - difference).abs() < 1e-12);
    let mut group = criterion.benchmark_group("2000 states");
    group.sample_size(20);
    group.bench_function("read, one logarithm per entry", |bencher| {
        bencher.iter(|| {
            black_box(&chain)
                .joint()
                .iter()
                .map(|entry| entry.ln())
                .sum::<f64>()
        });
    });
    group.bench_function("mutual information", |bencher| {
        bencher.iter(|| mutual_information(black_box(&chain)));
    });
    group.finish();
}

fn cuts(criterion: &mut Criterion) {
    let squares = Scene::built_in("two-squares").unwrap();
    let split = PatchSplit::try_new(&squares, 0, &[1], SplitAxis::U).unwrap();
    // 25 digits: data/reference/splits.csv
    let position = split.best(2).unwrap().positions[0];
    assert!((position - 0.399_201_026_045_385_2).abs() < 1e-14);
    criterion.bench_function("best cut of two squares", |bencher| {
        bencher.iter(|| split.best(black_box(2)));
    });
    let cut = GradientCut::try_new(1e6, 1.0).unwrap();
    criterion.bench_function("cut across a gradient, n = 1e6", |bencher| {
        bencher.iter(|| black_box(&cut).mutual_information_cut());
    });
}

fn grids(criterion: &mut Criterion) {
    let regular = || {
        BoxGrid::regular(black_box(UNIT_CUBE), 64)
            .unwrap()
            .information()
    };
    // a quarter as fine, by other code
    let cube = Scene::built_in("cube:16").unwrap();
    let pairs = ScenePairs::try_new(
        &cube,
        DEFAULT_TOLERANCE,
        Congruence::Shared,
        Occlusion::Refuse,
    )
    .unwrap();
    let exact = scene_information(&pairs, OpenScene::Refuse)
        .unwrap()
        .mutual_information;
    let found = BoxGrid::regular(UNIT_CUBE, 16)
        .unwrap()
        .information()
        .unwrap()
        .mutual_information;
    let difference = found.value - exact.value;
    assert!(difference.abs() <= found.error + exact.error);
    assert!(regular().unwrap().mutual_information.error < 1e-13);
    let mut group = criterion.benchmark_group("grids");
    group.sample_size(20);
    group.bench_function("regular, 64 cells an edge", |bencher| bencher.iter(regular));
    // 20 digits: data/reference/cube_grids.csv
    let line = BestGrid::find(UNIT_CUBE, 6).unwrap().grid.lines()[0];
    assert!((line - 0.098_485_808_008_412_18).abs() < 1e-14);
    group.bench_function("best, 8 cells an edge", |bencher| {
        bencher.iter(|| BestGrid::find(black_box(UNIT_CUBE), 8));
    });
    group.finish();
}

fn reproduction(criterion: &mut Criterion) {
    let claims = registry().unwrap();
    let context = Context::default();
    for claim in &claims {
        let judgement = judge(claim, &context).unwrap();
        assert_eq!(judgement.verdict, judgement.recorded(), "{}", claim.id);
    }
    let mut group = criterion.benchmark_group("claims");
    group.sample_size(10);
    group.bench_function("all of them", |bencher| {
        bencher.iter(|| judge_all(&claims, &Context::default(), |_, _| ()));
    });
    group.finish();
}

criterion_group!(benches, measures, large_chain, cuts, grids, reproduction);
criterion_main!(benches);
