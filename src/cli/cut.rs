//! `infoscene cut --exponent N…`.

use super::Answer;
use super::output::{Output, check_place, precision, write_file};
use infoscene::discretize::{CutComparison, DiscretizeError, GradientCut};
use infoscene::report::{cut_report, cuts_figure, cuts_report};
use std::path::PathBuf;
use std::str::FromStr;

#[derive(Debug, clap::Args)]
pub(super) struct Cut {
    /// Radiosity grows as this power of l, 1e-6 to 1e12: a number, several with commas, `1..4` (by one), `1..1e6:25`
    /// (so many, evenly spaced in the logarithm).
    #[arg(
        long,
        value_name = "N,…",
        required = true,
        value_delimiter = ',',
        allow_negative_numbers = true
    )]
    exponent: Vec<Exponents>,
    /// Irradiance grows as this power of l: 1 is what the paper prints, `n` (the radiosity's) what its hypotheses imply;
    /// also several.
    #[arg(
        long,
        value_name = "M,…",
        default_value = "1",
        value_delimiter = ',',
        allow_negative_numbers = true
    )]
    irradiance_exponent: Vec<IrradianceExponents>,
    /// Enclose the cuts, too, with ends of this many bits.
    #[arg(long, value_name = "BITS", value_parser = precision())]
    precision: Option<u32>,
    /// Draw the cuts against N, into an SVG file.
    #[arg(long, value_name = "PATH")]
    figure: Option<PathBuf>,
    #[command(flatten)]
    output: Output,
}

/// One number, or a range of them.
#[derive(Debug, Clone, PartialEq)]
struct Exponents(Vec<f64>);

/// More in one range than anybody reads.
const MOST_IN_RANGE: usize = 1000;

impl FromStr for Exponents {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |text: &str| {
            let parsed = text.trim().parse::<f64>();
            parsed.map_err(|_| format!("\"{text}\" is no number"))
        };
        let Some((from, rest)) = text.split_once("..") else {
            return Ok(Self(vec![number(text)?]));
        };
        let (to, count) = match rest.split_once(':') {
            Some((to, count)) => (to, Some(count)),
            None => (rest, None),
        };
        let (from, to) = (number(from)?, number(to)?);
        if !(from > 0.0 && from <= to && to.is_finite()) {
            return Err(format!("{from} to {to} is no range of numbers > 0"));
        }
        let too_many = || format!("more than {MOST_IN_RANGE} numbers");
        let Some(count) = count else {
            let mut numbers = vec![from];
            let mut step = 1.0;
            while from + step <= to {
                numbers.push(from + step);
                step += 1.0;
                if numbers.len() > MOST_IN_RANGE {
                    return Err(too_many());
                }
            }
            return Ok(Self(numbers));
        };
        let count: u16 = count
            .parse()
            .map_err(|_| format!("\"{count}\" is no count"))?;
        if count < 2 || usize::from(count) > MOST_IN_RANGE {
            return Err(format!("a count from 2 to {MOST_IN_RANGE} is needed"));
        }
        let last = count - 1;
        let share = |k: u16| f64::from(k) / f64::from(last);
        let between = (1..last).map(|k| (from.ln() + (to / from).ln() * share(k)).exp());
        Ok(Self(
            [from].into_iter().chain(between).chain([to]).collect(),
        ))
    }
}

/// Fixed exponents, or that of the radiosity.
#[derive(Debug, Clone, PartialEq)]
enum IrradianceExponents {
    Fixed(Vec<f64>),
    Same,
}

impl FromStr for IrradianceExponents {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text.trim() == "n" {
            Ok(Self::Same)
        } else {
            let numbers = Exponents::from_str(text);
            numbers
                .map(|Exponents(numbers)| Self::Fixed(numbers))
                .map_err(|error| format!("{error}, nor the letter n"))
        }
    }
}

/// What the irradiance does: its exponent, `None` for that of the radiosity.
#[derive(Debug, Clone, Copy)]
struct Reading(Option<f64>);

impl Reading {
    fn name(self) -> String {
        match self.0 {
            None => "lⁿ".to_owned(),
            Some(m) if (m - 1.0).abs() <= 0.0 => "l".to_owned(),
            Some(m) => format!("l^{m}"),
        }
    }
}

#[derive(Debug, thiserror::Error)]
#[error("{0} pairs of exponents are more than {MOST_PAIRS}")]
struct TooManyPairs(usize);

/// More pairs than anybody reads.
const MOST_PAIRS: usize = 10_000;

impl Cut {
    pub(super) fn answer(&self) -> Answer {
        self.output.check()?;
        if let Some(path) = &self.figure {
            check_place(path)?;
        }
        let exponents: Vec<f64> = self
            .exponent
            .iter()
            .flat_map(|list| list.0.clone())
            .collect();
        let readings: Vec<Reading> = self.irradiance_exponent.iter().flat_map(readings).collect();
        let pairs = exponents.len() * readings.len();
        if pairs > MOST_PAIRS {
            return Err(TooManyPairs(pairs).into());
        }
        let cuts = |n: f64, reading: Reading| {
            let patch = GradientCut::try_new(n, reading.0.unwrap_or(n))?;
            CutComparison::try_new(patch, self.precision)
        };
        let all = exponents
            .iter()
            .flat_map(|n| readings.iter().map(|reading| cuts(*n, *reading)));
        let all: Vec<CutComparison> = all.collect::<Result<_, DiscretizeError>>()?;
        let report = match all.as_slice() {
            [one] => cut_report(one)?,
            _ => cuts_report(&all)?,
        };
        if let Some(path) = &self.figure {
            let mut rising = exponents;
            rising.sort_by(f64::total_cmp);
            let of_reading = |reading: &Reading| {
                let cuts = rising.iter().map(|n| cuts(*n, *reading));
                Ok((reading.name(), cuts.collect::<Result<_, _>>()?))
            };
            let drawn = readings.iter().map(of_reading);
            let drawn = drawn.collect::<Result<Vec<_>, DiscretizeError>>()?;
            write_file(path, cuts_figure(&drawn).to_svg()?.as_bytes())?;
        }
        self.output.write(&report)
    }
}

fn readings(list: &IrradianceExponents) -> Vec<Reading> {
    match list {
        IrradianceExponents::Same => vec![Reading(None)],
        IrradianceExponents::Fixed(numbers) => numbers.iter().map(|m| Reading(Some(*m))).collect(),
    }
}
