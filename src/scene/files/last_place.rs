//! The last place of the coordinates of a file, as they are written.
//!
//! ```text
//!   3.059     three decimals: ± 0.0005          3059      none: ± 0.5
//!   12.3457   and 0.892223 beside it: six significant digits, ± 0.00005
//! ```
//!
//! Programs write a fixed number of decimals, or of significant digits, and some leave zeros at the
//! end out. So the half unit is the larger of two: that of the most decimals that any number needs,
//! and that of the largest number among those with (nearly) the most significant digits, if these
//! are six or more, as fewer are written by hand. Where every number agrees with a 32-bit float to
//! within its last place, and some are given to so many digits that few others would, 32 bits were
//! what the program had: then two units of such a float count, too, as coordinates come from
//! several operations.
//!
//! Where the largest number has hardly three digits before that place, nothing was rounded to it: a
//! square with corners 0 and 1, one of them raised by 0.1, was meant to be bent.
//!
//! Nor where most numbers are much shorter than the longest: somebody wrote it.
//!
//! **Not covered**: whether the coordinates are rounded at all. A cube with corners 0 and 1 has no
//! decimals and is exact; the scene knows ([`Scene::with_last_place`](crate::scene::Scene)).

use std::collections::BTreeMap;

/// Fewer significant digits are written by hand.
const FEWEST_DIGITS: i64 = 6;

/// The smallest ratio of the largest coordinate to half a unit of what is rounded.
const COARSEST: f64 = 150.0;

/// One in so many numbers at least is as long as the longest where a program wrote them.
const FEWEST_LONG: u32 = 3;

/// A last place this much finer than the distance of 32-bit floats tells them from other numbers,
/// by chance once in so many times.
const TELLING: f64 = 1.0 / 8.0;

/// Numbers that tell, all of which agree, leave little to chance.
const FEWEST_TELLING: u32 = 4;

/// The relative distance of two 32-bit floats, twice: an error of two units in the last place.
const FLOAT_ERROR: f64 = 2.0 * f32::EPSILON as f64;

/// The error of coordinates that were 32-bit floats, the largest of which has this size.
pub(crate) fn error_of_floats(largest: f64) -> f64 {
    FLOAT_ERROR * largest
}

/// The places of all coordinates read so far.
#[derive(Debug, Clone, Default)]
pub(crate) struct LastPlaces {
    /// Most decimals, zeros at the end left out; negative where integers end in zeros.
    decimals: Option<i64>,
    /// Most significant digits, and the most and next to most common last places among them.
    digits: i64,
    /// The highest last place of numbers with so many digits, and with one fewer.
    places: [Option<i64>; 2],
    /// Numbers by the decimals and by the significant digits that are written, and of all.
    by_decimals: BTreeMap<i64, u32>,
    by_digits: BTreeMap<i64, u32>,
    count: u32,
    largest: f64,
    /// Whether a number is no 32-bit float.
    is_wider: bool,
    /// Numbers that would have told.
    telling: u32,
}

impl LastPlaces {
    /// Takes note of a coordinate, the text and its value.
    pub(crate) fn note(&mut self, text: &str, value: f64) {
        let Some(written) = Written::of(text) else {
            return;
        };
        self.largest = self.largest.max(value.abs());
        let half = half_unit(written.place);
        #[expect(
            clippy::cast_possible_truncation,
            reason = "the nearest float is meant"
        )]
        let nearest = f64::from(value as f32);
        self.is_wider |= (value - nearest).abs() > half;
        let tells = half < TELLING * f64::from(f32::EPSILON) * value.abs();
        self.telling = self.telling.saturating_add(u32::from(tells));
        self.count += 1;
        *self.by_decimals.entry(-written.place).or_default() += 1;
        *self.by_digits.entry(written.digits).or_default() += 1;
        if written.digits == 0 {
            return;
        }
        self.decimals = self.decimals.max(Some(-written.needed));
        let step = written.digits - self.digits;
        if step > 0 {
            let before = self.places[0].filter(|_| step == 1);
            (self.digits, self.places) = (written.digits, [Some(written.place), before]);
        } else if step >= -1 {
            let known = &mut self.places[usize::from(step < 0)];
            *known = (*known).max(Some(written.place));
        }
    }

    /// Half a unit in the last place: coordinates may be off by so much; 0 if there are none, or if
    /// they are too coarse to be rounded.
    pub(crate) fn half_unit(&self) -> f64 {
        let Some(decimals) = self.decimals else {
            return 0.0;
        };
        let fixed = half_unit(-decimals);
        let highest = self.places[0].max(self.places[1]);
        let significant = highest.filter(|_| self.digits >= FEWEST_DIGITS);
        let float = !self.is_wider && self.telling >= FEWEST_TELLING;
        let float = if float {
            error_of_floats(self.largest)
        } else {
            0.0
        };
        let half = fixed.max(significant.map_or(0.0, half_unit)).max(float);
        let many = |counts: &BTreeMap<i64, u32>, least: i64| {
            let found: u32 = counts.range(least..).map(|(_, count)| count).sum();
            FEWEST_LONG * found >= self.count
        };
        let are_long = many(&self.by_decimals, decimals)
            || (self.digits >= FEWEST_DIGITS && many(&self.by_digits, self.digits - 1));
        if COARSEST * half > self.largest || !are_long {
            0.0
        } else {
            half
        }
    }
}

/// Half a unit of a decimal place: 0.0005 for −3.
fn half_unit(place: i64) -> f64 {
    let place = i32::try_from(place).unwrap_or(if place < 0 { i32::MIN } else { i32::MAX });
    0.5 * 10f64.powi(place.clamp(-400, 400))
}

/// The digits of a number as written.
struct Written {
    /// Significant digits; 0 for a zero.
    digits: i64,
    /// The power of ten of the last one.
    place: i64,
    /// The power of ten of the last one that is not 0.
    needed: i64,
}

impl Written {
    fn of(text: &str) -> Option<Self> {
        let (mantissa, exponent) = match text.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, exponent.parse::<i64>().ok()?),
            None => (text, 0),
        };
        let mantissa = mantissa.trim_start_matches(['+', '-']);
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let all = || whole.bytes().chain(fraction.bytes());
        if all().any(|byte| !byte.is_ascii_digit()) {
            return None;
        }
        let count = |length: usize| i64::try_from(length).ok();
        let length = count(whole.len() + fraction.len())?;
        let place = exponent.checked_sub(count(fraction.len())?)?;
        let first = count(all().take_while(|byte| *byte == b'0').count())?;
        let zeros = all().rev().take_while(|byte| *byte == b'0').count();
        let needed = if first == length {
            place
        } else {
            place.checked_add(count(zeros)?)?
        };
        Some(Self {
            digits: length - first,
            place,
            needed,
        })
    }
}
