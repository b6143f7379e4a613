//! The functions that every form factor is made of keep their bounds.

use infoscene::numeric::functions::elementary::{
    ANGLE_ERROR, ANGLE_OVER_SINE_ERROR, LN_ERROR, LN_RATIO_ERROR, LOG2_ERROR, ROUGH_EXP2_ERROR,
    ROUGH_LN_ERROR, angle, angle_over_sine, angles, ln, ln_ratio, log2, logarithms, rough_exp2,
    rough_ln,
};
use infoscene::numeric::{DoubleDouble, GaussLegendre, Interval, SQUARED_EPSILON, Scalar};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

const BITS: u32 = 192;
const SAMPLES: usize = 20_000;

fn precise(x: f64) -> Interval {
    Interval::precise(x, BITS)
}

/// `|value − exact|`, from 192 bits.
fn error(value: f64, exact: &Interval) -> f64 {
    (precise(value) - exact).abs().to_f64()
}

fn double_double_error(value: DoubleDouble, exact: &Interval) -> f64 {
    let low = (value - DoubleDouble::from(value.high())).high();
    (precise(value.high()) + &precise(low) - exact)
        .abs()
        .to_f64()
}

/// Over all binades, and near 1, where the logarithm is small.
fn positive(random: &mut ChaCha8Rng, reach: f64) -> f64 {
    let exponent = random.random_range(-reach..reach);
    if random.random_bool(0.3) {
        1.0 + random.random_range(-1.0..1.0) * random.random_range(-40.0..-1.0f64).exp2()
    } else {
        exponent.exp2()
    }
}

#[test]
fn elementary_functions_keep_their_bound() {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let (mut worst_ln, mut worst_log2, mut worst_angle) = (0.0f64, 0.0f64, 0.0f64);
    let ln_2 = precise(2.0).ln();
    let (mut worst_rough, mut worst_power) = (0.0f64, 0.0f64);
    for _ in 0..SAMPLES {
        let x = positive(&mut random, 1000.0);
        let exact = precise(x).ln();
        let allowed = LN_ERROR * exact.abs().to_f64();
        worst_ln = worst_ln.max(error(ln(x), &exact) / allowed.max(f64::MIN_POSITIVE));
        let binary = exact.clone() / &ln_2;
        let allowed = (LOG2_ERROR * binary.abs().to_f64()).max(f64::MIN_POSITIVE);
        worst_log2 = worst_log2.max(error(log2(x), &binary) / allowed);
        worst_rough = worst_rough.max(error(rough_ln(x), &exact) / ROUGH_LN_ERROR);
        assert_eq!(logarithms([x, 2.0]), [ln(x), ln(2.0)]);
        let power = x.log2();
        let exact = (precise(power) * &ln_2).exp();
        let allowed = ROUGH_EXP2_ERROR * exact.to_f64();
        worst_power = worst_power.max(error(rough_exp2(power), &exact) / allowed);
        let y = positive(&mut random, 30.0);
        let x = positive(&mut random, 30.0) * if random.random_bool(0.5) { 1.0 } else { -1.0 };
        let exact = precise(y).atan2(&precise(x));
        worst_angle = worst_angle.max(error(angle(y, x), &exact) / (ANGLE_ERROR * exact.to_f64()));
    }
    assert!(worst_ln <= 1.0, "ln: {worst_ln} of its bound");
    assert!(worst_angle <= 1.0, "angle: {worst_angle} of its bound");
    assert!(
        (0.1..=1.0).contains(&worst_log2),
        "log2: {worst_log2} of its bound"
    );
    assert!(
        (0.1..=1.0).contains(&worst_rough),
        "rough ln: {worst_rough} of its bound"
    );
    assert!(
        (0.1..=1.0).contains(&worst_power),
        "rough power: {worst_power} of its bound"
    );
    assert!(rough_exp2(f64::NAN).is_nan());
    println!("{worst_ln} {worst_angle}");
    assert!(
        worst_ln > 0.1 && worst_angle > 0.1,
        "the bounds say little: {worst_ln}, {worst_angle}"
    );
    // the ends of the range, as the standard library has them
    for x in [
        0.0,
        -0.0,
        -1.0,
        f64::INFINITY,
        f64::NAN,
        f64::MAX,
        5e-324,
        1e-310,
    ] {
        for (ours, std, bound) in [(ln(x), x.ln(), LN_ERROR), (log2(x), x.log2(), LOG2_ERROR)] {
            let equal = ours == std || (ours.is_nan() && std.is_nan());
            assert!(
                equal || ((ours - std) / std).abs() <= 2.0 * bound,
                "{x}: {ours}, {std}"
            );
        }
    }
    // exact where the answer is
    for exponent in -1074..1024 {
        assert_eq!(log2(f64::from(exponent).exp2()), f64::from(exponent));
    }
    assert!(ln(1.0).abs() <= 0.0 && angle(0.0, 2.0).abs() <= 0.0);
    for (y, x, quarters) in [
        (1.0, 1.0, 1.0),
        (1.0, 0.0, 2.0),
        (1.0, -1.0, 3.0),
        (0.0, -1.0, 4.0),
        (0.0, 0.0, 0.0),
        (-1.0, 0.0, -2.0),
    ] {
        assert!((angle(y, x) - quarters * std::f64::consts::FRAC_PI_4).abs() <= 0.0);
    }
}

/// Against the logarithm of the quotient, from neighbours to many binades apart; and several angles
/// at once are those of one.
#[test]
fn logarithms_of_ratios_keep_their_bound() {
    let mut random = ChaCha8Rng::seed_from_u64(4);
    let mut worst = [0.0f64; 2];
    for _ in 0..SAMPLES {
        let from = positive(&mut random, 400.0);
        let growth = if random.random_bool(0.7) {
            random.random_range(-52.0..1.0f64).exp2()
        } else {
            random.random_range(0.0..600.0f64).exp2()
        };
        let to = from * (1.0 + growth);
        // exact below a factor of two, beyond which it is not taken
        let (binade, value) = (usize::from(to >= 2.0 * from), ln_ratio(to - from, from, to));
        let exact = (precise(to) / &precise(from)).ln();
        let allowed = LN_RATIO_ERROR * exact.to_f64();
        worst[binade] = worst[binade].max(error(value, &exact) / allowed.max(f64::MIN_POSITIVE));
    }
    println!("{worst:?}");
    assert!(
        worst.iter().all(|worst| (0.1..=1.0).contains(worst)),
        "{worst:?} of their bound"
    );
    assert!(ln_ratio(0.0, 3.0, 3.0).abs() <= 0.0);
    // a difference far below the numbers' own rounding, with either sign
    let tiny = f64::EPSILON / 1024.0;
    assert!((ln_ratio(tiny, 1.0, 1.0) - tiny).abs() <= LN_RATIO_ERROR * tiny);
    let below = 1.0 - 0.5 * f64::EPSILON;
    assert!((ln_ratio(tiny, 1.0, below) - tiny).abs() <= f64::EPSILON * tiny);
    for [from, to] in [
        [0.0, 1.0],
        [5e-324, 1.0],
        [1e-310, 1e-309],
        [1.0, f64::INFINITY],
        [f64::NAN, 1.0],
        [1.0, f64::NAN],
        [-1.0, 1.0],
    ] {
        assert!(ln_ratio(to - from, from, to).is_nan(), "{from} {to}");
    }
    let points = [[0.5, 1.0], [3.0, -1.0], [-2.0, 0.1]];
    for (several, [y, x]) in angles(points).into_iter().zip(points) {
        assert_eq!(several.to_bits(), angle(y, x).to_bits());
    }
}

/// Against `2 atan(√((1 − c)/(1 + c)))/√(1 − c²)`, for cosines down to ½ and a little below.
#[test]
fn the_angle_over_its_sine_keeps_its_bound() {
    let mut random = ChaCha8Rng::seed_from_u64(3);
    let one = precise(1.0);
    let mut worst = 0.0f64;
    for _ in 0..SAMPLES {
        let below_one = if random.random_bool(0.3) {
            random.random_range(-50.0..-1.0f64).exp2()
        } else {
            random.random_range(1e-9..0.5 + 1e-12)
        };
        let cosine = 1.0 - below_one;
        let (up, down) = (
            one.clone() + &precise(cosine),
            one.clone() - &precise(cosine),
        );
        let half = down.sqrt().atan2(&up.sqrt());
        let exact = (half.clone() + &half) / &(up * &down).sqrt();
        let allowed = ANGLE_OVER_SINE_ERROR * exact.to_f64();
        worst = worst.max(error(angle_over_sine(cosine), &exact) / allowed);
    }
    assert!((0.1..=1.0).contains(&worst), "{worst} of its bound");
    assert!((angle_over_sine(1.0) - 1.0).abs() <= 0.0);
}

#[test]
fn double_doubles_keep_their_bound() {
    let mut random = ChaCha8Rng::seed_from_u64(2);
    let mut worst = [0.0f64; 9];
    for _ in 0..SAMPLES / 4 {
        let mut number = || {
            let high = positive(&mut random, 60.0);
            let low = high * random.random_range(-0.5..0.5) * f64::EPSILON;
            let sign = if random.random_bool(0.5) { 1.0 } else { -1.0 };
            (DoubleDouble::sum(high, low), sign)
        };
        let (a, _) = number();
        let (b, sign) = number();
        let signed = if sign < 0.0 { -b } else { b };
        let lift = |x: DoubleDouble| {
            let low = (x - DoubleDouble::from(x.high())).high();
            precise(x.high()) + &precise(low)
        };
        let (p, q) = (lift(a), lift(signed));
        let small = signed / (DoubleDouble::from(1.0) + b);
        let moderate = small * DoubleDouble::from(8.0);
        let pairs = [
            (a * signed, p.clone() * &q),
            (a / signed, p.clone() / &q),
            (a.sqrt(), p.sqrt()),
            (a.ln(), p.ln()),
            (a.atan2(&signed), p.atan2(&q)),
            (small.ln_1p(), lift(small).ln_1p()),
            (moderate.exp_m1(), lift(moderate).exp_m1()),
            (small.divergence_kernel(), lift(small).divergence_kernel()),
            (small.x_ln_x(), lift(small).x_ln_x()),
        ];
        for (worst, (value, exact)) in worst.iter_mut().zip(pairs) {
            let size = exact.abs().to_f64();
            if size > 1e-200 {
                let relative = double_double_error(value, &exact) / size;
                *worst = worst.max(relative / SQUARED_EPSILON);
            }
        }
        // a sum cancels: its error is relative to the sum itself, exact inputs given
        let sum = double_double_error(a + signed, &(p.clone() + &q));
        let size = (p + &q).abs().to_f64();
        assert!(sum <= 4.0 * SQUARED_EPSILON * size, "{a:?} + {signed:?}");
    }
    let bounds = [4.0, 16.0, 16.0, 64.0, 64.0, 64.0, 64.0, 64.0, 64.0];
    println!("{worst:?}");
    for (worst, bound) in worst.into_iter().zip(bounds) {
        assert!(worst <= bound, "{worst} ε², the bound is {bound}");
    }
}

/// A rule of n points integrates powers up to 2n − 1 exactly: ∫ x^k = 2/(k + 1) for even k.
#[test]
fn gauss_rules_are_exact_for_their_powers() {
    for points in [1, 2, 3, 7, 16, 33, 64] {
        let rule = GaussLegendre::with(points);
        for power in [0, (points - 1) & !1, 2 * points - 2] {
            let mut sum = DoubleDouble::from(0.0);
            for [x, w] in &rule.precise {
                let mut term = *w;
                for _ in 0..power {
                    term = term * *x;
                }
                sum = sum + term;
            }
            #[expect(clippy::cast_precision_loss, reason = "small")]
            let exact = DoubleDouble::from(2.0) / DoubleDouble::from(power as f64 + 1.0);
            let error = ((sum - exact) / exact).to_f64().abs();
            // n nodes with the error of a Newton step near a root: a few ε² each, n of them
            assert!(
                error <= 1000.0 * SQUARED_EPSILON,
                "{points} points, power {power}: {error:e}"
            );
        }
    }
}

/// The angle of numbers of one to four bits, which no octant's edge may round wrongly.
#[test]
fn angles_of_the_smallest_numbers_keep_their_bound() {
    for (i, j) in (-16..=16i32).flat_map(|i| (-16..=16i32).map(move |j| (i, j))) {
        let [y, x] = [i, j].map(|units| f64::from(units) * f64::from_bits(1));
        // at the jump the enclosure holds both π and −π
        if i == 0 {
            continue;
        }
        let off = error(Scalar::atan2(&y, &x), &precise(y).atan2(&precise(x)));
        assert!(off <= ANGLE_ERROR, "{i} {j}: {off:e}");
    }
}
