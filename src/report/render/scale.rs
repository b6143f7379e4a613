//! An axis of a figure from end to end, with ticks at round numbers.

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

/// Ends and ticks (place and name) of an axis; on a logarithmic one a place is a power of ten.
#[derive(Debug, Clone)]
pub(crate) struct Scale {
    low: f64,
    high: f64,
    ticks: Vec<(f64, String)>,
}

impl Scale {
    /// The scale between two places. A tight one ends there, unless a tick is near; any other ends
    /// at ticks.
    ///
    /// `None` if the ends are too near to each other, or too far apart, for `f64`.
    pub(crate) fn new(
        is_logarithmic: bool,
        (low, high): (f64, f64),
        is_tight: bool,
    ) -> Option<Self> {
        if is_logarithmic {
            return Self::logarithmic(low, high);
        }
        let scale = Self::even(low, high)?;
        if !is_tight {
            return Some(scale);
        }
        let near = NEAR * (high - low);
        let ticks = scale.ticks.into_iter();
        let ticks: Vec<_> = ticks
            .filter(|(place, _)| *place > low - near && *place < high + near)
            .collect();
        let [first, last] = [ticks.first()?.0, ticks.last()?.0];
        Some(Self {
            low: low.min(first),
            high: high.max(last),
            ticks,
        })
    }

    /// The number of ticks.
    pub(crate) const fn ticks(&self) -> usize {
        self.ticks.len()
    }

    /// Five to ten ticks 1, 2 or 5 times a power of ten apart, from the one below to the one above.
    fn even(low: f64, high: f64) -> Option<Self> {
        let width = if high > low {
            high - low
        } else {
            low.abs().max(1.0)
        };
        let power = 10f64.powf((width / 4.0).log10().floor());
        let factor = [5.0, 2.0, 1.0]
            .into_iter()
            .find(|k| k * power <= width / 3.99);
        let step = factor.unwrap_or(1.0) * power;
        let first = (low / step).floor();
        let last = (high / step).ceil().max(first + 1.0);
        let is_fine = step > 0.0 && last - first < 20.0 && first.abs().max(last.abs()) < 1e12;
        if !is_fine {
            return None;
        }
        let decimals = (-step.log10().floor()).max(0.0);
        let mut ticks = Vec::new();
        let mut count = first;
        while count <= last {
            ticks.push((count * step, decimal(count * step, decimals)));
            count += 1.0;
        }
        let [low, high] = [first * step, last * step];
        Some(Self { low, high, ticks })
    }

    /// Powers of ten, with 2 and 5 between them on a short axis, and all digits on one of less than
    /// a decade.
    fn logarithmic(low: f64, high: f64) -> Option<Self> {
        let decades = high - low;
        let (factors, every): (&[f64], f64) = if decades <= 0.75 {
            (&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0], 1.0)
        } else if decades <= 3.0 {
            (&[1.0, 2.0, 5.0], 1.0)
        } else {
            (&[1.0], (decades / 7.0).ceil())
        };
        let mut ticks = Vec::new();
        let mut power = (low / every).floor() * every;
        while power <= high {
            for factor in factors {
                let place = power + factor.log10();
                if place >= low - ROUNDING && place <= high + ROUNDING {
                    ticks.push((place, magnitude(*factor, power)));
                }
            }
            power += every;
        }
        (decades > 0.0).then_some(Self { low, high, ticks })
    }
}

/// The distance from the end of an axis at which a tick becomes its end, as a share of the axis.
const NEAR: f64 = 0.03;

/// The largest distance that rounding may leave between a tick and the end of a logarithmic axis.
const ROUNDING: f64 = 1e-9;

impl Ranged for Scale {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    #[expect(clippy::cast_possible_truncation, reason = "the page's units are few")]
    fn map(&self, place: &f64, (start, end): (i32, i32)) -> i32 {
        let share = (place - self.low) / (self.high - self.low);
        start + (share * f64::from(end - start)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _hint: Hint) -> Vec<f64> {
        self.ticks.iter().map(|(place, _)| *place).collect()
    }

    fn range(&self) -> std::ops::Range<f64> {
        self.low..self.high
    }
}

impl ValueFormatter<f64> for Scale {
    fn format(place: &f64) -> String {
        place.to_string()
    }

    fn format_ext(&self, place: &f64) -> String {
        let apart = |tick: &&(f64, String)| (tick.0 - place).abs();
        let nearest = self
            .ticks
            .iter()
            .min_by(|a, b| apart(a).total_cmp(&apart(b)));
        nearest.map_or_else(String::new, |(_, name)| name.clone())
    }
}

/// A number with so many decimals, without a sign if they are all 0.
fn decimal(value: f64, decimals: f64) -> String {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a count of decimals"
    )]
    let decimals = decimals as usize;
    let text = format!("{value:.decimals$}");
    let is_zero = text.chars().all(|c| matches!(c, '-' | '0' | '.'));
    if is_zero { text.replace('-', "") } else { text }
}

/// `factor · 10^power`.
fn magnitude(factor: f64, power: f64) -> String {
    if (-3.0..=4.0).contains(&power) {
        decimal(factor * 10f64.powf(power), (-power).max(0.0))
    } else {
        format!("{factor}e{power}")
    }
}
