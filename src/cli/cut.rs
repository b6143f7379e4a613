//! `infoscene cut --exponent N…`.

use super::Answer;
use super::output::{Output, check_place, precision, write_file};
use infoscene::exchange::Unheard;
use infoscene::question::{Cuts, IrradianceExponent};
use infoscene::report::{cut_report, cuts_figure, cuts_report};
use std::path::PathBuf;
use std::str::FromStr;

#[derive(Debug, clap::Args)]
pub(super) struct Cut {
    /// Radiosity grows as this power of l, 1e-6 to 1e12: a number, several with commas, `1..4` (by
    /// one), `1..1e6:25` (so many, evenly spaced in the logarithm).
    #[arg(
        long,
        value_name = "N,…",
        required = true,
        value_delimiter = ',',
        allow_negative_numbers = true
    )]
    exponent: Vec<Exponents>,
    /// Irradiance grows as this power of l: 1 is what the paper prints, `n` (the radiosity's) what
    /// its hypotheses imply; also several.
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

/// Exponents of the irradiance.
#[derive(Debug, Clone, PartialEq)]
struct IrradianceExponents(Vec<IrradianceExponent>);

impl FromStr for IrradianceExponents {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text.trim() == "n" {
            return Ok(Self(vec![IrradianceExponent::OfRadiosity]));
        }
        let numbers = Exponents::from_str(text);
        let Exponents(numbers) = numbers.map_err(|error| format!("{error}, nor the letter n"))?;
        let fixed = numbers.into_iter().map(IrradianceExponent::Fixed);
        Ok(Self(fixed.collect()))
    }
}

impl Cut {
    pub(super) fn answer(&self) -> Answer {
        self.output.check()?;
        if let Some(path) = &self.figure {
            check_place(path)?;
        }
        let answer = self.question().ask(&Unheard)?;
        let report = match answer.cuts.as_slice() {
            [one] => cut_report(one)?,
            _ => cuts_report(&answer)?,
        };
        if let Some(path) = &self.figure {
            write_file(path, cuts_figure(&answer).to_svg()?.as_bytes())?;
        }
        self.output.write(&report)
    }

    fn question(&self) -> Cuts {
        let exponents = self.exponent.iter().flat_map(|list| list.0.clone());
        let irradiance = self.irradiance_exponent.iter();
        Cuts {
            exponents: exponents.collect(),
            irradiance: irradiance.flat_map(|list| list.0.clone()).collect(),
            precision: self.precision,
        }
    }
}
