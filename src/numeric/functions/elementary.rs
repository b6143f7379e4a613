//! Logarithm and angle of doubles, without branches.
//!
//! ```text
//!   x = 2^k m, m in [√½, √2), f = m − 1, s = f/(2+f):   ln x = k ln 2 + 2 atanh s
//!   angle: t = min/max of |y|, |x|, turned by π/4 beyond tan(π/8), then an odd polynomial
//!   θ/sin θ: a polynomial in 1 − cos θ, whose Taylor coefficients are 2^k k!²/(2k+1)!
//! ```
//!
//! Only `+ − × ÷ √` and bit shifts, in a fixed order: the same bits on every machine, and a loop
//! over them is compiled to vector instructions. The error bounds are measured:
//! `elementary_functions_keep_their_bound` sees 0.6 of them at most against 192 bits.
//!
//! **Not covered**: correct rounding; two infinite coordinates.
//!
//! Sources: the split of `ln` and its seven coefficients are those of FreeBSD's `e_log.c` (Sun
//! Microsystems, 1993); the eleven of `atan` are a minimax fit of `(atan(√z)/√z − 1)/z` on
//! `[0, tan²(π/8)]` by Remez exchange in 60 digits, relative error 1.3e-18 of the angle; the ten of
//! `atanh` one of `(2 atanh(√z)/√z − 2)/z` on `[0, 1/9]`, relative error 3.4e-18 of the logarithm;
//! the fourteen of θ/sin θ a fit of the same kind on `[0, ½]`, relative error 4.9e-18.

/// Error bound of [`ln`], relative.
pub const LN_ERROR: f64 = 1.0 * f64::EPSILON;
/// Error bound of [`angle`], relative.
pub const ANGLE_ERROR: f64 = 2.0 * f64::EPSILON;

/// Error bound of [`angle_over_sine`], relative, beside that of its argument.
pub const ANGLE_OVER_SINE_ERROR: f64 = 1.0 * f64::EPSILON;

/// Error bound of [`ln_ratio`], relative: half an ε for the sum, the quotient and the last addition
/// each; the first two count 1.08 times, by the condition of atanh up to ⅓, and what is added last
/// is below a twentieth of the sum.
pub const LN_RATIO_ERROR: f64 = 2.0 * f64::EPSILON;

const LN_2_HIGH: f64 = 6.931_471_803_691_238e-1;
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;
const LN: [f64; 7] = [
    6.666_666_666_666_735e-1,
    3.999_999_999_940_942e-1,
    2.857_142_874_366_239e-1,
    2.222_219_843_214_978_4e-1,
    1.818_357_216_161_805e-1,
    1.531_383_769_920_937_3e-1,
    1.479_819_860_511_658_6e-1,
];
const ATANH: [f64; 10] = [
    0.666_666_666_666_663_1,
    0.400_000_000_001_572_5,
    0.285_714_285_478_531_2,
    0.222_222_239_697_710_7,
    0.181_817_439_237_247_24,
    0.153_865_599_448_860_5,
    0.133_009_733_435_302_37,
    0.121_060_878_617_832_64,
    0.083_400_957_037_399_72,
    0.170_185_840_452_153_07,
];
const ATAN: [f64; 11] = [
    -0.333_333_333_333_332,
    0.199_999_999_999_540_82,
    -0.142_857_142_802_485_35,
    0.111_111_107_861_387_66,
    -0.090_908_978_364_706_32,
    0.076_920_616_374_365_66,
    -0.066_631_203_869_747_75,
    0.058_480_089_355_472_234,
    -0.050_398_455_881_370_3,
    0.038_078_322_729_337_01,
    -0.017_922_281_106_444_338,
];
const ANGLE_OVER_SINE: [f64; 15] = [
    1.0,
    0.333_333_333_333_331_54,
    0.133_333_333_333_656_63,
    0.057_142_857_122_482_69,
    0.025_396_826_044_493_136,
    0.011_543_999_367_338_47,
    0.005_328_153_039_965_033,
    0.002_485_185_071_763_731_7,
    0.001_177_098_298_001_345_5,
    0.000_525_421_045_352_337_6,
    0.000_348_048_193_470_754_1,
    -4.595_944_459_553_318e-5,
    0.000_298_836_941_579_087_67,
    -0.000_176_597_809_849_465_1,
    0.000_104_928_865_531_632_82,
];

/// Natural logarithm, with the special values of the standard library's.
///
/// **Accuracy** within [`LN_ERROR`].
#[inline(always)]
#[must_use]
pub fn ln(x: f64) -> f64 {
    log_of(x, 0.0)
}

/// Error bound of [`log2`], relative: that of the logarithm of m, half an ε for ln 2, for the
/// quotient and for the sum each.
pub const LOG2_ERROR: f64 = 2.5 * f64::EPSILON;

/// Binary logarithm `k + ln m/ln 2` of 2^k m, exact at powers of two, with the special values of
/// the standard library's.
///
/// **Accuracy** within [`LOG2_ERROR`].
#[inline(always)]
#[must_use]
pub fn log2(x: f64) -> f64 {
    let Split { k, f } = split_of_any(x);
    let [log] = logarithms_of([Split { k: 0.0, f }], [0.0]);
    with_special_values(x, k + log / std::f64::consts::LN_2)
}

/// Error bound of [`rough_ln`], absolute.
pub const ROUGH_LN_ERROR: f64 = 1e-4;

/// `ln x` to four digits, for `x > 0` that is normal: for plans, and for bounds with its error
/// added.
///
/// With x = 2^k m and `m = (3 + t)/2`, `ln m = ln(3/2) + ln(1 + t/3)`, whose Chebyshev series has
/// the terms `±2 q^n/n T_n(t)`, q = 3 − √8; those from the fifth on are left out, 2 Σ q^n/n =
/// 7.2e-5.
#[inline(always)]
#[must_use]
pub fn rough_ln(x: f64) -> f64 {
    let bits = x.to_bits();
    let k = f64::from_bits(0x4330_0000_0000_0000 | bits >> 52) - (4_503_599_627_370_496.0 + 1023.0);
    let m = f64::from_bits(bits & 0x000f_ffff_ffff_ffff | 0x3ff0_0000_0000_0000);
    let t = 2.0 * m - 3.0;
    let series = 0.333_044_7 + t * (-0.055_408_4 + t * (0.013_468_4 - t * 0.003_466_2));
    k * std::f64::consts::LN_2 + (0.405_457 + t * series)
}

/// Natural logarithms of numbers that are positive, finite and normal, step by step for all of
/// them, so that none waits for another; of other numbers anything.
///
/// **Accuracy** within [`LN_ERROR`].
#[inline(always)]
#[must_use]
pub fn logarithms<const N: usize>(x: [f64; N]) -> [f64; N] {
    let mut splits = [Split::default(); N];
    for i in 0..N {
        splits[i] = split(x[i]);
    }
    logarithms_of(splits, [0.0; N])
}

/// Error bound of [`rough_exp2`], relative.
pub const ROUGH_EXP2_ERROR: f64 = 1.1e-4;

/// `2^x` to four digits, for x from −1000 to 1000: for bounds, times one more than its error.
///
/// A cubic through four Chebyshev nodes on `[−½, ½]`.
#[inline(always)]
#[must_use]
pub fn rough_exp2(x: f64) -> f64 {
    // rounds to an integer, which is in its low bits
    const ROUND: f64 = 6_755_399_441_055_744.0;
    let shifted = x + ROUND;
    let t = x - (shifted - ROUND);
    let cubic = 0.999_925 + t * (0.693_137 + t * (0.242_639 + t * 0.055_838));
    f64::from_bits(cubic.to_bits().wrapping_add(shifted.to_bits() << 52))
}

/// `ln x` plus something small.
#[inline(always)]
fn log_of(x: f64, small: f64) -> f64 {
    let [log] = logarithms_of([split_of_any(x)], [small]);
    with_special_values(x, log)
}

/// The split of a number that may be subnormal.
#[inline(always)]
fn split_of_any(x: f64) -> Split {
    const TWO_TO_54: f64 = 18_014_398_509_481_984.0;
    let subnormal = x < f64::MIN_POSITIVE;
    let Split { k, f } = split(if subnormal { x * TWO_TO_54 } else { x });
    let k = if subnormal { k - 54.0 } else { k };
    Split { k, f }
}

/// The logarithm of a positive number, or the standard library's value for any other.
#[inline(always)]
fn with_special_values(x: f64, log: f64) -> f64 {
    let below = if x < 0.0 { f64::NAN } else { f64::NEG_INFINITY };
    let log = if x > 0.0 { log } else { below };
    // infinity and NaN stay as they are
    if x < f64::INFINITY { log } else { x }
}

/// `2^k (1 + f)`, f in [√½ − 1, √2 − 1).
#[derive(Debug, Clone, Copy, Default)]
struct Split {
    k: f64,
    f: f64,
}

#[inline(always)]
fn split(x: f64) -> Split {
    // the bits of √½ taken off, so that the exponent turns over there and not at 1
    const SQRT_HALF: u64 = 0x3fe6_a09e_667f_3bcd;
    let bits = x.to_bits().wrapping_sub(SQRT_HALF);
    // |k| < 2¹¹ as a double, by way of 2⁵² + 2¹¹ + k, which holds it in its low bits
    let shifted = (bits >> 52).wrapping_add(2048) & 0xfff;
    let k = f64::from_bits(0x4330_0000_0000_0000 | shifted) - 4_503_599_627_372_544.0;
    let m = f64::from_bits((bits & 0x000f_ffff_ffff_ffff).wrapping_add(SQRT_HALF));
    // exact
    Split { k, f: m - 1.0 }
}

/// The logarithms, each plus something small.
#[inline(always)]
fn logarithms_of<const N: usize>(splits: [Split; N], small: [f64; N]) -> [f64; N] {
    let (mut s, mut z, mut w) = ([0.0; N], [0.0; N], [0.0; N]);
    for i in 0..N {
        // within 1.5 ε/2 of itself
        s[i] = splits[i].f / (2.0 + splits[i].f);
    }
    for i in 0..N {
        z[i] = s[i] * s[i];
        w[i] = z[i] * z[i];
    }
    let (mut odd, mut even) = ([LN[5]; N], [LN[6]; N]);
    for n in [4, 2] {
        for i in 0..N {
            even[i] = LN[n] + w[i] * even[i];
            odd[i] = LN[n - 1] + w[i] * odd[i];
        }
    }
    let mut logs = [0.0; N];
    for i in 0..N {
        let Split { k, f } = splits[i];
        let series = w[i] * odd[i] + z[i] * (LN[0] + w[i] * even[i]);
        let half_square = 0.5 * f * f;
        let low = k * LN_2_LOW + small[i];
        logs[i] = k * LN_2_HIGH - ((half_square - (s[i] * (half_square + series) + low)) - f);
    }
    logs
}

/// `ln(1 + x)` for `x > −1`, to its own relative precision.
///
/// **Accuracy** within [`LN_ERROR`]: what `1 + x` loses is added to its logarithm.
#[inline(always)]
#[must_use]
pub fn ln_1p(x: f64) -> f64 {
    let sum = 1.0 + x;
    let lost = if x < 1.0 {
        x - (sum - 1.0)
    } else {
        1.0 - (sum - x)
    };
    log_of(
        sum,
        if sum > 0.0 && sum < f64::INFINITY {
            lost / sum
        } else {
            0.0
        },
    )
}

/// `ln(to/from)` from what the two differ by, for `0 < from ≤ to`: with `y = 2^k from` in
/// `(to/2, to]`, `k ln 2 + 2 atanh((to − y)/(to + y))`, where `to − y` is exact, and is the
/// difference itself if k = 0.
///
/// **Arguments** `difference`: `to − from`, to its own precision; `from` and `to` normal, `to`
/// below `from` by rounding at most.
/// **Returns** NaN for other arguments.
/// **Accuracy** within [`LN_RATIO_ERROR`].
#[inline(always)]
#[must_use]
pub fn ln_ratio(difference: f64, from: f64, to: f64) -> f64 {
    const C: [f64; 10] = ATANH;
    const SIGNIFICAND: u64 = 0x000f_ffff_ffff_ffff;
    let to = if to < from { from } else { to };
    let apart = to.to_bits().wrapping_sub(from.to_bits());
    let k = f64::from_bits(0x4330_0000_0000_0000 | apart >> 52) - 4_503_599_627_370_496.0;
    let y = f64::from_bits(to.to_bits().wrapping_sub(apart & SIGNIFICAND));
    let rise = if apart <= SIGNIFICAND {
        difference
    } else {
        to - y
    };
    let s = rise / (to + y);
    let z = s * s;
    let w = z * z;
    let even = C[0] + w * (C[2] + w * (C[4] + w * (C[6] + w * C[8])));
    let odd = C[1] + w * (C[3] + w * (C[5] + w * (C[7] + w * C[9])));
    let log = k * LN_2_HIGH + ((s + s) + (k * LN_2_LOW + s * z * (even + z * odd)));
    let is_covered = from >= f64::MIN_POSITIVE && to < f64::INFINITY;
    if is_covered { log } else { f64::NAN }
}

/// The angle of the point `(x, y)` from the positive x axis, in `[−π, π]`.
///
/// **Arguments** not both infinite; the angle of the origin is 0, or π where `x` is −0.
/// **Accuracy** within [`ANGLE_ERROR`]; 1e-12 where both are subnormal, which
/// [`Scalar::atan2`](crate::numeric::Scalar::atan2) scales first.
#[inline(always)]
#[must_use]
pub fn angle(y: f64, x: f64) -> f64 {
    let [angle] = angles([[y, x]]);
    angle
}

/// The angles of several points `[y, x]`, step by step for all of them, so that none waits for
/// another.
#[inline(always)]
#[must_use]
pub fn angles<const N: usize>(points: [[f64; 2]; N]) -> [f64; N] {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
    const TAN_PI_8: f64 = 0.414_213_562_373_095_03;
    const C: [f64; 11] = ATAN;
    // loops, not closures, so that nothing is left to be inlined
    let (mut steep, mut turned) = ([false; N], [false; N]);
    let (mut t, mut z, mut w) = ([0.0; N], [0.0; N], [0.0; N]);
    for i in 0..N {
        let [y, x] = points[i];
        let (up, across) = (y.abs(), x.abs());
        steep[i] = up > across;
        let (short, long) = if steep[i] { (across, up) } else { (up, across) };
        // turned by π/4, the quotient is at most tan(π/8) again; it is small there beside π/4
        turned[i] = short > TAN_PI_8 * long;
        let numerator = if turned[i] { short - long } else { short };
        let denominator = if turned[i] { short + long } else { long };
        t[i] = numerator / if denominator > 0.0 { denominator } else { 1.0 };
    }
    for i in 0..N {
        z[i] = t[i] * t[i];
        w[i] = z[i] * z[i];
    }
    let (mut even, mut odd) = ([C[10]; N], [C[9]; N]);
    for k in [8, 6, 4, 2] {
        for i in 0..N {
            even[i] = C[k] + w[i] * even[i];
            odd[i] = C[k - 1] + w[i] * odd[i];
        }
    }
    let mut angles = [0.0; N];
    for i in 0..N {
        let small = t[i] + t[i] * z[i] * (C[0] + w[i] * even[i] + z[i] * odd[i]);
        let octant = if turned[i] { FRAC_PI_4 + small } else { small };
        let quadrant = if steep[i] { FRAC_PI_2 - octant } else { octant };
        let [y, x] = points[i];
        let half = if x.is_sign_negative() {
            PI - quadrant
        } else {
            quadrant
        };
        angles[i] = half.copysign(y);
    }
    angles
}

/// `θ/sin θ` from `cos θ`, for angles up to 60°: `cos θ` from ½ to 1, or above by rounding.
///
/// **Accuracy** within [`ANGLE_OVER_SINE_ERROR`]; an argument off by δ changes it by 0.44 δ at
/// most.
#[inline(always)]
#[must_use]
pub fn angle_over_sine(cosine: f64) -> f64 {
    let z = 1.0 - cosine;
    let w = z * z;
    let [odd, even] = angle_over_sine_series(w);
    ANGLE_OVER_SINE[0] + (z * odd + w * even)
}

/// `(θ/sin θ − 1)/(1 − cos θ)` from `1 − cos θ`, for angles up to 60°: ⅓ at 0, where the quotient
/// has no digits.
///
/// **Accuracy** some ε, and as much as the argument is off.
#[inline(always)]
#[must_use]
pub fn angle_over_sine_rise(z: f64) -> f64 {
    let [odd, even] = angle_over_sine_series(z * z);
    odd + z * even
}

/// The sums of every other term of the series of `(θ/sin θ − 1)/z` in `w = z²`, z = 1 − cos θ.
#[inline(always)]
fn angle_over_sine_series(w: f64) -> [f64; 2] {
    const C: [f64; 15] = ANGLE_OVER_SINE;
    [
        C[1] + w * (C[3] + w * (C[5] + w * (C[7] + w * (C[9] + w * (C[11] + w * C[13]))))),
        C[2] + w * (C[4] + w * (C[6] + w * (C[8] + w * (C[10] + w * (C[12] + w * C[14]))))),
    ]
}
