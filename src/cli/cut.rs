//! `infoscene cut --exponent N`.

use super::Answer;
use super::output::{MOST_DECIMALS, Output, between, precision};
use crate::discretize::{DiscretizeError, GradientCut};
use crate::numeric::interval::DecimalBounds;
use crate::numeric::{Interval, tolerance};
use crate::report::{Report, Table, certain_digits};

#[derive(Debug, clap::Args)]
pub(super) struct Cut {
    /// Radiosity grows as this power of l, 1e-6 to 1e12.
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    exponent: f64,
    /// Irradiance grows as this power of l: 1 is what the paper prints, N what its hypotheses imply.
    #[arg(
        long,
        value_name = "M",
        default_value_t = 1.0,
        allow_negative_numbers = true
    )]
    irradiance_exponent: f64,
    /// Enclose the cuts, too, with ends of this many bits.
    #[arg(long, value_name = "BITS", value_parser = precision())]
    precision: Option<u32>,
    #[command(flatten)]
    output: Output,
}

/// The answer as a record: the keys are relied on by scripts.
#[derive(Debug, serde::Serialize)]
struct Record {
    exponent: f64,
    irradiance_exponent: f64,
    mutual_information_cut: f64,
    mutual_information_complement: f64,
    mutual_information_gain: f64,
    mean_square_cut: f64,
    mean_square_complement: f64,
    mean_square_error: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    enclosures: Option<Enclosures>,
}

/// Decimal bounds of the same quantities.
#[derive(Debug, serde::Serialize)]
struct Enclosures {
    mutual_information_cut: DecimalBounds,
    mutual_information_complement: DecimalBounds,
    mutual_information_gain: DecimalBounds,
    mean_square_cut: DecimalBounds,
    mean_square_complement: DecimalBounds,
    mean_square_error: DecimalBounds,
}

impl Enclosures {
    fn of(cut: &GradientCut, bits: u32) -> Result<Option<Self>, DiscretizeError> {
        let information = cut.certified_mutual_information_cut(bits)?;
        let square = cut.certified_mean_square_cut(bits)?;
        let bounds = |enclosure: &Interval| enclosure.to_decimal(MOST_DECIMALS);
        // every one of them is bounded
        let enclosures = || {
            Some(Self {
                mutual_information_cut: bounds(&information.position)?,
                mutual_information_complement: bounds(&information.complement)?,
                mutual_information_gain: bounds(&information.value)?,
                mean_square_cut: bounds(&square.position)?,
                mean_square_complement: bounds(&square.complement)?,
                mean_square_error: bounds(&square.value)?,
            })
        };
        Ok(enclosures())
    }
}

impl Cut {
    pub(super) fn answer(&self) -> Answer {
        let cut = GradientCut::try_new(self.exponent, self.irradiance_exponent)?;
        let (information, square) = (cut.mutual_information_cut()?, cut.mean_square_cut()?);
        let enclosures = match self.precision {
            Some(bits) => Enclosures::of(&cut, bits)?,
            None => None,
        };
        let notes = enclosures.iter().flat_map(|enclosures| {
            [
                ("mutual information", &enclosures.mutual_information_cut),
                ("mean square", &enclosures.mean_square_cut),
            ]
            .map(|(name, bounds)| (name.to_owned(), between(bounds)))
        });
        let notes = notes.collect();
        let record = Record {
            exponent: self.exponent,
            irradiance_exponent: self.irradiance_exponent,
            mutual_information_cut: information.position,
            mutual_information_complement: information.complement,
            mutual_information_gain: information.value,
            mean_square_cut: square.position,
            mean_square_complement: square.complement,
            mean_square_error: square.value,
            enclosures,
        };
        let row = |name: &str, cut: crate::discretize::Cut| {
            vec![
                name.to_owned(),
                certain_digits(cut.position, tolerance::POSITION),
                format!("{:.11e}", cut.complement),
                format!("{:.11e}", cut.value),
            ]
        };
        let table = Table {
            columns: vec!["cut by", "position l", "1 − l", "gain (bits) or error"],
            rows: vec![
                row("mutual information", information),
                row("mean square", square),
            ],
            notes,
            ..Table::default()
        };
        self.output.write(&Report::one(table, &record)?)
    }
}
