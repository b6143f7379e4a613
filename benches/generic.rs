//! The generic formulas over `f64` against copies of them by hand, without trait or type parameter.
//!
//! The copies live here only: the same operations in the same order on plain doubles. Equal
//! results, bit by bit, are checked before anything is timed.
#![expect(clippy::unwrap_used, reason = "a bench may panic")]

use criterion::{Criterion, criterion_group, criterion_main};
use infoscene::discretize::GradientCut;
use infoscene::form_factor::rectangles::perpendicular::Plate;
use infoscene::form_factor::rectangles::{parallel, perpendicular};
use infoscene::geometry::Span;
use infoscene::information::relative_entropy;
use infoscene::numeric::{divergence_kernel, tolerance};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::{LN_2, PI};
use std::hint::black_box;

/// A span by hand: lower end, upper end, length.
#[derive(Clone, Copy)]
struct Side {
    lower: f64,
    upper: f64,
    length: f64,
}

/// Sum and sum of magnitudes by hand.
#[derive(Clone, Copy)]
struct Sum {
    value: f64,
    magnitude: f64,
}

impl Sum {
    /// The signed sum over eight corners, halves first.
    fn over_corners(corners: [(bool, Self); 8]) -> Self {
        let across = |[a, b, c, d, e, f, g, h]: [f64; 8]| ((a + e) + (c + g)) + ((b + f) + (d + h));
        Self {
            value: across(corners.map(|(plus, term)| if plus { term.value } else { -term.value })),
            magnitude: across(corners.map(|(_, term)| term.magnitude)),
        }
    }
}

fn log_ratio(difference: f64, r2_a: f64, r2_b: f64) -> f64 {
    if difference < 0.0 {
        -(-difference / r2_b).ln_1p()
    } else {
        (difference / r2_a).ln_1p()
    }
}

fn parallel_by_hand(first: [Side; 2], second: [Side; 2], z: f64) -> Option<Sum> {
    if !(z.is_finite() && z > 0.0) {
        return None;
    }
    let sides = [
        first[0].length,
        first[1].length,
        second[0].length,
        second[1].length,
    ];
    let mut shortest = 1;
    for k in 0..4 {
        if sides[k] < sides[shortest] {
            shortest = k;
        }
    }
    let (x, y, xi, eta) = match shortest {
        0 => (first[1], first[0], second[1], second[0]),
        1 => (first[0], first[1], second[0], second[1]),
        2 => (second[1], second[0], first[1], first[0]),
        _ => (second[0], second[1], first[0], first[1]),
    };
    let across = [
        (x.lower - xi.lower, false),
        (x.lower - xi.upper, true),
        (x.upper - xi.lower, true),
        (x.upper - xi.upper, false),
    ];
    let ends = [(eta.lower, true), (eta.upper, false)];
    let sum = Sum::over_corners([0, 1, 2, 3, 4, 5, 6, 7].map(|k| {
        let ((u, plus_u), (eta, plus_eta)) = (across[k / 2], ends[k % 2]);
        (plus_u == plus_eta, parallel_corner(u, y, eta, z))
    }));
    let two_pi = PI * 2.0;
    Some(Sum {
        value: sum.value / two_pi,
        magnitude: sum.magnitude / two_pi,
    })
}

fn parallel_corner(u: f64, y: Side, eta: f64, z: f64) -> Sum {
    let delta = y.length;
    let (v0, v1) = (y.lower - eta, y.upper - eta);
    let (u2, z2) = (u * u, z * z);
    let (v2_0, v2_1) = (v0 * v0, v1 * v1);
    let p2 = u2 + z2;
    let squares = delta * (v1 + v0);
    let fifth = -(log_ratio(squares, p2 + v2_0, p2 + v2_1) * (z2 * 0.5));
    let p = p2.sqrt();
    let (q0, q1) = ((v2_0 + z2).sqrt(), (v2_1 + z2).sqrt());
    let inverse = 1.0 / (q0 + q1);
    let q_step = squares * inverse;
    let (near, far) = if q0 < q1 { (q0, q1) } else { (q1, q0) };
    let step = delta * p;
    let first = v1.atan2(p) * step;
    let second = step.atan2(p2 + v0 * v1) * (p * v0);
    let angle = u.atan2(far) * u;
    let third = angle * q_step;
    let fourth = -((u * q_step).atan2(near * far + u2) * (near * u));
    let terms = first.abs() + second.abs() + (third.abs() + fourth.abs()) + fifth.abs();
    let excess = delta * (v1.abs() + v0.abs()) - squares.abs();
    Sum {
        value: (first + second) + ((third + fourth) + fifth),
        magnitude: terms + excess * inverse * (angle * 0.25 + z2 * inverse * 0.5),
    }
}

/// `[depth, width]` of both plates.
fn perpendicular_by_hand(first: [Side; 2], second: [Side; 2]) -> Sum {
    let lengths = [
        first[0].length,
        second[0].length,
        first[1].length,
        second[1].length,
    ];
    let mut shortest = 0;
    for k in 0..4 {
        if lengths[k] < lengths[shortest] {
            shortest = k;
        }
    }
    let (thin, other) = if shortest % 2 == 0 {
        (first, second)
    } else {
        (second, first)
    };
    let ends = |side: Side| [(side.upper, true), (side.lower, false)];
    let corners = [0, 1, 2, 3, 4, 5, 6, 7];
    let sum = if shortest < 2 {
        let across = [
            (thin[1].lower - other[1].lower, false),
            (thin[1].lower - other[1].upper, true),
            (thin[1].upper - other[1].lower, true),
            (thin[1].upper - other[1].upper, false),
        ];
        Sum::over_corners(corners.map(|k| {
            let ((z, plus_z), (v, plus_v)) = (ends(other[0])[k / 4], across[k % 4]);
            (plus_z == plus_v, depth_corner(thin[0], z, v))
        }))
    } else {
        Sum::over_corners(corners.map(|k| {
            let ((x, plus_x), (z, plus_z)) = (ends(thin[0])[k / 4], ends(other[0])[k / 2 % 2]);
            let (eta, plus_eta) = ends(other[1])[1 - k % 2];
            let (v0, v1) = (thin[1].lower - eta, thin[1].upper - eta);
            let plus = (plus_x == plus_z) != plus_eta;
            (plus, width_corner(x, z, thin[1].length, v0, v1))
        }))
    };
    let two_pi = PI * 2.0;
    Sum {
        value: -sum.value / two_pi,
        magnitude: sum.magnitude / two_pi,
    }
}

fn depth_corner(x: Side, z: f64, v: f64) -> Sum {
    let (z2, v2) = (z * z, v * v);
    let (s2_0, s2_1) = (x.lower * x.lower + z2, x.upper * x.upper + z2);
    let (r2_0, r2_1) = (s2_0 + v2, s2_1 + v2);
    let squares = x.length * (x.upper + x.lower);
    let coefficient = squares * 0.25;
    let (log, base) = if r2_0 == 0.0 {
        (0.0, r2_1)
    } else {
        (log_ratio(squares, r2_0, r2_1), r2_0)
    };
    let third = -(log * ((s2_1 - v2) * 0.25));
    let fourth = -(base.ln() * coefficient);
    let (s0, s1) = (s2_0.sqrt(), s2_1.sqrt());
    let s_step = squares / (s1 + s0);
    let first = v.atan2(s1) * v * s_step;
    let second = -((v * s_step).atan2(s0 * s1 + v2) * (s0 * v));
    let logs = log.abs() * (r2_1 * 0.25) + fourth.abs();
    Sum {
        value: (first + second) + (third + fourth),
        magnitude: first.abs() + second.abs() + (logs + coefficient * 0.25),
    }
}

fn width_corner(x: f64, z: f64, delta: f64, v0: f64, v1: f64) -> Sum {
    let s2 = x * x + z * z;
    let (v2_0, v2_1) = (v0 * v0, v1 * v1);
    let (r2_0, r2_1) = (s2 + v2_0, s2 + v2_1);
    let squares = delta * (v1 + v0);
    let log = if r2_0 == 0.0 || r2_1 == 0.0 {
        0.0
    } else {
        log_ratio(squares, r2_0, r2_1)
    };
    let base = if r2_0 == 0.0 { r2_1 } else { r2_0 }.ln();
    let third = -(log * ((s2 - v2_1) * 0.25));
    let fourth = base * (squares * 0.25);
    let s = s2.sqrt();
    let step = delta * s;
    let first = v1.atan2(s) * step;
    let second = step.atan2(s2 + v0 * v1) * (s * v0);
    let size = delta * (v1.abs() + v0.abs()) * 0.25;
    Sum {
        value: (first + second) + (third + fourth),
        magnitude: first.abs()
            + second.abs()
            + (log.abs() * (r2_1 * 0.25) + size * (base.abs() + 0.25)),
    }
}

/// `D(J ‖ w)` in bits.
fn relative_entropy_by_hand(flux: f64, weight: f64, parts: &[[f64; 2]]) -> f64 {
    let mut nats = 0.0;
    for [part, share] in parts {
        let x = part * weight / (share * flux) - 1.0;
        nats += divergence_kernel(x) * share;
    }
    nats * flux / (2f64.ln() * weight)
}

/// The gain of a cut at `e^−τ`, exponents n and m.
fn gradient_gain_by_hand(n: f64, m: f64, tau: f64) -> f64 {
    let survival = |k: f64| (-(k * tau)).exp();
    let loss = |k: f64| -(-(k * tau)).exp_m1();
    let p = n + 1.0;
    let (flux, rest) = (survival(p), loss(p));
    let shrink = -(survival(p) * (loss(m) / loss(m + p)));
    let growth = m * tau;
    let nats = if growth < 1.0 {
        survival(p + m) * divergence_kernel(growth.exp_m1())
            + loss(p + m) * divergence_kernel(shrink)
    } else {
        flux * growth + rest * shrink.ln_1p()
    };
    nats / 2f64.ln()
}

/// Four spans: of a pair of rectangles.
type Pair = [[Span; 2]; 2];

/// Pairs with sides of any length and ends that coincide in every third.
fn pairs(count: usize) -> Vec<Pair> {
    let mut random = ChaCha8Rng::seed_from_u64(7);
    let mut span = || {
        let lower: f64 = match random.random_range(0..3) {
            0 => 0.0,
            1 => 1.0,
            _ => random.random_range(0.0..2.0),
        };
        let length = if random.random_range(0..3) == 0 {
            1.0
        } else {
            10f64.powf(random.random_range(-3.0..0.5))
        };
        Span::try_new(lower, lower + length).unwrap()
    };
    (0..count)
        .map(|_| [[span(), span()], [span(), span()]])
        .collect()
}

fn by_hand(pair: &[Span; 2]) -> [Side; 2] {
    pair.map(|span| Side {
        lower: *span.lower(),
        upper: *span.upper(),
        length: *span.length(),
    })
}

/// The copies by hand use the standard library's functions, the crate its own: the last places
/// differ.
fn assert_close(generic: f64, hand: f64, allowed: f64) {
    assert!(
        (generic - hand).abs() <= allowed,
        "{generic:e} is not {hand:e} within {allowed:e}"
    );
}

fn generic_against_hand(criterion: &mut Criterion) {
    let plate = |[depth, width]: [Span; 2]| Plate::try_new(depth, width).unwrap();
    for [first, second] in pairs(20_000) {
        let hand = parallel_by_hand(by_hand(&first), by_hand(&second), 0.7).unwrap();
        let generic = parallel::exchange_area(&first, &second, &0.7).unwrap();
        let allowed = 2.0 * tolerance::RECTANGLE_TERMS * f64::EPSILON * hand.magnitude;
        assert_close(generic.value, hand.value, allowed);
        assert_close(generic.magnitude, hand.magnitude, allowed);
        let hand = perpendicular_by_hand(by_hand(&first), by_hand(&second));
        let generic = perpendicular::exchange_area(&plate(first), &plate(second));
        let allowed = 2.0 * tolerance::RECTANGLE_TERMS * f64::EPSILON * hand.magnitude;
        assert_close(generic.value, hand.value, allowed);
        assert_close(generic.magnitude, hand.magnitude, allowed);
        let [part, rest] = [first[0], second[1]].map(|span| *span.length());
        let parts = [[part, 0.25], [rest, 0.75]];
        let hand = relative_entropy_by_hand(part + rest, 1.0, &parts);
        let generic = relative_entropy(&(part + rest), &1.0, &parts);
        assert_close(generic, hand, tolerance::GAIN * hand.abs());
        let cut = GradientCut::try_new(part, rest).unwrap();
        let hand = gradient_gain_by_hand(part, rest, part);
        assert_close(cut.gain_at(&part), hand, tolerance::GAIN * hand.abs());
    }
    assert_close(LN_2, 2f64.ln(), f64::EPSILON);

    // a hundred different ones, so that no branch is always taken
    let inputs = pairs(100);
    let sides: Vec<[[Side; 2]; 2]> = inputs
        .iter()
        .map(|pair| pair.each_ref().map(by_hand))
        .collect();
    let plates: Vec<[Plate; 2]> = inputs.iter().map(|pair| pair.map(plate)).collect();
    let lengths: Vec<[f64; 2]> = inputs
        .iter()
        .map(|[first, second]| [*first[0].length(), *second[1].length()])
        .collect();
    let cuts: Vec<GradientCut> = lengths
        .iter()
        .map(|[n, m]| GradientCut::try_new(*n, *m).unwrap())
        .collect();

    let mut group = criterion.benchmark_group("parallel");
    group.bench_function("generic", |bencher| {
        bencher.iter(|| {
            let area = |[first, second]: &Pair| parallel::exchange_area(first, second, &0.7);
            black_box(&inputs)
                .iter()
                .map(|pair| area(pair).unwrap())
                .fold(0.0, |sum, area| sum + area.value + area.magnitude)
        });
    });
    group.bench_function("by hand", |bencher| {
        bencher.iter(|| {
            let area = |[first, second]: &[[Side; 2]; 2]| parallel_by_hand(*first, *second, 0.7);
            black_box(&sides)
                .iter()
                .map(|pair| area(pair).unwrap())
                .fold(0.0, |sum, area| sum + area.value + area.magnitude)
        });
    });
    group.finish();
    let mut group = criterion.benchmark_group("perpendicular");
    group.bench_function("generic", |bencher| {
        bencher.iter(|| {
            let area = |[first, second]: &[Plate; 2]| perpendicular::exchange_area(first, second);
            black_box(&plates)
                .iter()
                .map(area)
                .fold(0.0, |sum, area| sum + area.value + area.magnitude)
        });
    });
    group.bench_function("by hand", |bencher| {
        bencher.iter(|| {
            let area = |[first, second]: &[[Side; 2]; 2]| perpendicular_by_hand(*first, *second);
            black_box(&sides)
                .iter()
                .map(area)
                .fold(0.0, |sum, area| sum + area.value + area.magnitude)
        });
    });
    group.finish();
    let parts = |[part, rest]: &[f64; 2]| (part + rest, [[*part, 0.25], [*rest, 0.75]]);
    let mut group = criterion.benchmark_group("relative entropy");
    group.bench_function("generic", |bencher| {
        bencher.iter(|| {
            black_box(&lengths)
                .iter()
                .map(parts)
                .fold(0.0, |sum, (flux, parts)| {
                    sum + relative_entropy(&flux, &1.0, &parts)
                })
        });
    });
    group.bench_function("by hand", |bencher| {
        bencher.iter(|| {
            black_box(&lengths)
                .iter()
                .map(parts)
                .fold(0.0, |sum, (flux, parts)| {
                    sum + relative_entropy_by_hand(flux, 1.0, &parts)
                })
        });
    });
    group.finish();
    let mut group = criterion.benchmark_group("gain of a gradient cut");
    group.bench_function("generic", |bencher| {
        bencher.iter(|| {
            black_box(&cuts)
                .iter()
                .zip(&lengths)
                .fold(0.0, |sum, (cut, [n, _])| sum + cut.gain_at(n))
        });
    });
    group.bench_function("by hand", |bencher| {
        bencher.iter(|| {
            black_box(&lengths)
                .iter()
                .fold(0.0, |sum, [n, m]| sum + gradient_gain_by_hand(*n, *m, *n))
        });
    });
    group.finish();
}

criterion_group!(benches, generic_against_hand);
criterion_main!(benches);
