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
//! within its last place, and some are given to more than seven digits, 32 bits were what the
//! program had: then two units of such a float count, too, as coordinates come from several
//! operations.
//!
//! **Not covered**: whether the coordinates are rounded at all. A cube with corners 0 and 1 has no
//! decimals and is exact; the scene knows ([`Scene::with_last_place`](crate::scene::Scene)).

/// Fewer significant digits are written by hand.
const FEWEST_DIGITS: i64 = 6;

/// Digits that a 32-bit float has at most for sure.
const FLOAT_DIGITS: i64 = 7;

/// The relative distance of two 32-bit floats, twice: an error of two units in the last place.
const FLOAT_ERROR: f64 = 2.0 * f32::EPSILON as f64;

/// The places of all coordinates read so far.
#[derive(Debug, Clone, Default)]
pub(crate) struct LastPlaces {
    /// Most decimals, zeros at the end left out; negative where integers end in zeros.
    decimals: Option<i64>,
    /// Most significant digits, and the most and next to most common last places among them.
    digits: i64,
    /// The highest last place of numbers with so many digits, and with one fewer.
    places: [Option<i64>; 2],
    largest: f64,
    is_wider: bool,
    has_more: bool,
}

impl LastPlaces {
    /// Takes note of a coordinate, the text and its value.
    pub(crate) fn note(&mut self, text: &str, value: f64) {
        let Some(written) = Written::of(text) else {
            return;
        };
        self.largest = self.largest.max(value.abs());
        let half = half_unit(written.place);
        #[expect(clippy::cast_possible_truncation, reason = "the nearest float is meant")]
        let nearest = f64::from(value as f32);
        self.is_wider |= (value - nearest).abs() > half;
        self.has_more |= written.digits > FLOAT_DIGITS;
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

    /// Half a unit in the last place: coordinates may be off by so much; 0 if there are none.
    pub(crate) fn half_unit(&self) -> f64 {
        let Some(decimals) = self.decimals else {
            return 0.0;
        };
        let fixed = half_unit(-decimals);
        let highest = self.places[0].max(self.places[1]);
        let significant = highest.filter(|_| self.digits >= FEWEST_DIGITS);
        let float = !self.is_wider && self.has_more;
        let float = if float { FLOAT_ERROR * self.largest } else { 0.0 };
        fixed.max(significant.map_or(0.0, half_unit)).max(float)
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
        let needed = if first == length { place } else { place.checked_add(count(zeros)?)? };
        Some(Self {
            digits: length - first,
            place,
            needed,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::LastPlaces;

    /// Half units found by hand, of files as programs and people write them.
    #[test]
    fn the_last_place_is_that_of_the_longest_numbers() {
        for (coordinates, expected) in [
            ("3.059 2.577 0.000 -3.221 12.345 100.000", 5e-4),
            // the same without zeros at the end
            ("3.059 2.577 0 -3.2 12.34 100", 5e-4),
            // three decimals, written as six
            ("3.059000 2.577000 0.000000", 5e-4),
            ("3059 2577 0 -3221", 0.5),
            // six and nine significant digits
            ("12.3457 0.892223 1 0.5", 5e-5),
            ("432100.125 0.123456789 5811234.38 5811234.25", 5e-3),
            ("0 1 0.5 1e-11", 5e-12),
            ("1.5E+3 2.25e1", 5e-2),
            ("0 0 0.0", 0.0),
            // sixteen and seventeen digits: exact, as far as f64 goes
            ("0.1234567890123456 1.2345678901234567 1", 5e-16),
            // 32-bit floats written as 64 bits: two units of the largest
            ("0.100000001490116 0.300000011920929 8", 4.0 * 8.0 * 5.960_464_477_539_063e-8),
        ] {
            let mut places = LastPlaces::default();
            for text in coordinates.split(' ') {
                places.note(text, text.parse().unwrap_or(f64::NAN));
            }
            let found = places.half_unit();
            assert!(
                (found - expected).abs() <= 1e-12 * expected,
                "{coordinates}: {found:e}, not {expected:e}"
            );
        }
    }
}
