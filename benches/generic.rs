//! The generic formulas over `f64` against copies of them by hand, without trait or type parameter.
//!
//! The copies live here only: the same operations in the same order on plain doubles. Equal results, bit by bit, are
//! checked before anything is timed.
#![allow(
    missing_docs,
    reason = "criterion's macros write undocumented functions"
)]
#![allow(clippy::unwrap_used, reason = "a bench may panic")]

use criterion::{Criterion, criterion_group, criterion_main};
use infoscene::discretize::GradientCut;
use infoscene::form_factor::perpendicular::Plate;
use infoscene::form_factor::{parallel, perpendicular};
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
    const ZERO: Self = Self {
        value: 0.0,
        magnitude: 0.0,
    };

    fn add(&mut self, term: f64) {
        self.magnitude += term.abs();
        self.value += term;
    }

    fn add_uncertain(&mut self, term: f64, magnitude: f64) {
        self.magnitude += magnitude.abs();
        self.value += term;
    }

    fn add_signed(&mut self, plus: bool, other: Self) {
        self.magnitude += other.magnitude;
        if plus {
            self.value += other.value;
        } else {
            self.value -= other.value;
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

fn log_ratio_size(log: f64, uncertainty: f64, r2_a: f64, r2_b: f64) -> f64 {
    log.abs() + uncertainty / if r2_a < r2_b { r2_b } else { r2_a }
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
    let mut sum = Sum::ZERO;
    for (u, plus_u) in [
        (x.lower - xi.lower, false),
        (x.lower - xi.upper, true),
        (x.upper - xi.lower, true),
        (x.upper - xi.upper, false),
    ] {
        for (eta, plus_eta) in [(eta.lower, true), (eta.upper, false)] {
            sum.add_signed(plus_u == plus_eta, parallel_corner(u, y, eta, z));
        }
    }
    let two_pi = PI * 2.0;
    Some(Sum {
        value: sum.value / two_pi,
        magnitude: sum.magnitude / two_pi,
    })
}

fn parallel_corner(u: f64, y: Side, eta: f64, z: f64) -> Sum {
    let delta = y.length;
    let (v0, v1) = (y.lower - eta, y.upper - eta);
    let z2 = z * z;
    let p2 = u * u + z2;
    let p = p2.sqrt();
    let (q0, q1) = ((v0 * v0 + z2).sqrt(), (v1 * v1 + z2).sqrt());
    let (r2_0, r2_1) = (p2 + v0 * v0, p2 + v1 * v1);
    let squares = delta * (v1 + v0);
    let squares_size = delta * (v1.abs() + v0.abs());
    let q_sum = q0 + q1;
    let q_step = squares / q_sum;
    let q_step_size = squares_size / q_sum;

    let mut sum = Sum::ZERO;
    sum.add(delta * p * v1.atan2(p));
    sum.add(v0 * p * (delta * p).atan2(p2 + v0 * v1));
    let angle = u.atan2(q1) * u;
    sum.add_uncertain(angle * q_step, angle * q_step_size);
    let denominator = q0 * q1 + u * u;
    let turn = (u * q_step).atan2(denominator) * u * q0;
    sum.add_uncertain(-turn, u * u * q_step_size / denominator * q0);
    let log = log_ratio(squares, r2_0, r2_1);
    let half_z2 = z2 / 2.0;
    sum.add_uncertain(
        -(log * half_z2),
        log_ratio_size(log, squares_size, r2_0, r2_1) * half_z2,
    );
    sum
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
    let mut sum = Sum::ZERO;
    if shortest < 2 {
        for (z, plus_z) in ends(other[0]) {
            for (v, plus_v) in [
                (thin[1].lower - other[1].lower, false),
                (thin[1].lower - other[1].upper, true),
                (thin[1].upper - other[1].lower, true),
                (thin[1].upper - other[1].upper, false),
            ] {
                sum.add_signed(plus_z == plus_v, depth_corner(thin[0], z, v));
            }
        }
    } else {
        for (x, plus_x) in ends(thin[0]) {
            for (z, plus_z) in ends(other[0]) {
                for (eta, plus_eta) in ends(other[1]) {
                    let plus = (plus_x == plus_z) != plus_eta;
                    let (v0, v1) = (thin[1].lower - eta, thin[1].upper - eta);
                    sum.add_signed(plus, width_corner(x, z, thin[1].length, v0, v1));
                }
            }
        }
    }
    let two_pi = PI * 2.0;
    Sum {
        value: -sum.value / two_pi,
        magnitude: sum.magnitude / two_pi,
    }
}

fn log_size(term: f64, coefficient: f64) -> f64 {
    term.abs() + coefficient.abs()
}

fn depth_corner(x: Side, z: f64, v: f64) -> Sum {
    let (z2, v2) = (z * z, v * v);
    let (s2_0, s2_1) = (x.lower * x.lower + z2, x.upper * x.upper + z2);
    let (s0, s1) = (s2_0.sqrt(), s2_1.sqrt());
    let (r2_0, r2_1) = (s2_0 + v2, s2_1 + v2);
    let squares = x.length * (x.upper + x.lower);

    let mut sum = Sum::ZERO;
    if r2_0 == 0.0 {
        let coefficient = s2_1 * 0.25;
        let log_term = r2_1.ln() * coefficient;
        sum.add_uncertain(-log_term, log_size(log_term, coefficient));
        return sum;
    }
    if v != 0.0 {
        let s_step = squares / (s1 + s0);
        sum.add(v.atan2(s1) * v * s_step);
        let denominator = s0 * s1 + v2;
        sum.add(-((v * s_step).atan2(denominator) * v * s0));
    }
    let log = log_ratio(squares, r2_0, r2_1);
    let difference = (s2_1 - v2) * 0.25;
    sum.add_uncertain(
        -(log * difference),
        log_ratio_size(log, squares, r2_0, r2_1) * ((s2_1 + v2) * 0.25),
    );
    let coefficient = squares * 0.25;
    let log_term = r2_0.ln() * coefficient;
    sum.add_uncertain(-log_term, log_size(log_term, coefficient));
    sum
}

fn width_corner(x: f64, z: f64, delta: f64, v0: f64, v1: f64) -> Sum {
    let s2 = x * x + z * z;
    let s = s2.sqrt();
    let (v2_0, v2_1) = (v0 * v0, v1 * v1);
    let (r2_0, r2_1) = (s2 + v2_0, s2 + v2_1);

    let mut sum = Sum::ZERO;
    if s != 0.0 {
        sum.add(v1.atan2(s) * s * delta);
        let angle = (delta * s).atan2(s2 + v0 * v1);
        sum.add(angle * v0 * s);
    }
    if r2_0 == 0.0 || r2_1 == 0.0 {
        for (v2, r2, plus) in [(v2_1, r2_1, true), (v2_0, r2_0, false)] {
            if r2 != 0.0 {
                let coefficient = v2 * 0.25;
                let log_term = r2.ln() * coefficient;
                let signed = if plus { log_term } else { -log_term };
                sum.add_uncertain(signed, log_size(log_term, coefficient));
            }
        }
        return sum;
    }
    let squares = delta * (v1 + v0);
    let squares_size = delta * (v1.abs() + v0.abs());
    let log = log_ratio(squares, r2_0, r2_1);
    let difference = (s2 - v2_1) * 0.25;
    sum.add_uncertain(
        -(log * difference),
        log_ratio_size(log, squares_size, r2_0, r2_1) * ((s2 + v2_1) * 0.25),
    );
    let log = r2_0.ln();
    sum.add_uncertain(
        log * squares * 0.25,
        (log.abs() + 1.0) * squares_size * 0.25,
    );
    sum
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

/// The copies by hand use the standard library's functions, the crate its own: the last places differ.
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
