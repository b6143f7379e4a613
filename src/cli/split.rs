//! `infoscene split SCENE --patch I`.

use super::Answer;
use super::light::Light;
use super::output::{MOST_DECIMALS, Output, between, precision};
use super::scene::SceneArgument;
use infoscene::discretize::{DiscretizeError, PatchSplit, regular_positions};
use infoscene::exchange::{Congruence, ScenePairs};
use infoscene::form_factor::DEFAULT_TOLERANCE;
use infoscene::geometry::SplitAxis;
use infoscene::numeric::interval::DecimalBounds;
use infoscene::numeric::{Interval, compensated_sum, tolerance};
use infoscene::report::{Report, Table, certain_digits, scientific};
use infoscene::scene::Scene;
use std::error::Error;

#[derive(Debug, clap::Args)]
pub(super) struct Split {
    #[command(flatten)]
    scene: SceneArgument,
    /// The patch to cut, counted from 0.
    #[arg(long, value_name = "I")]
    patch: usize,
    /// The patches it is judged against; all others if none is named.
    #[arg(long, value_name = "J,K,…", value_delimiter = ',')]
    against: Vec<usize>,
    /// The axis across which it is cut, u towards the second corner, v towards the last: cuts run parallel to the other
    /// one. The better one if none is named.
    #[arg(long, value_enum)]
    axis: Option<AxisName>,
    /// How many parts it is cut into.
    #[arg(long, value_name = "M", default_value_t = 2, value_parser = clap::value_parser!(u32).range(2..=64))]
    parts: u32,
    /// Enclose the best cut and its gain, too, with ends of this many bits, and prove it the best of all; for two parts of rectangles along common axes.
    #[arg(long, value_name = "BITS", value_parser = precision())]
    precision: Option<u32>,
    #[command(flatten)]
    light: Light,
    #[command(flatten)]
    output: Output,
}

#[derive(Debug, Clone, Copy, clap::ValueEnum)]
enum AxisName {
    U,
    V,
}

/// The answer as a record: the keys are relied on by scripts.
#[derive(Debug, serde::Serialize)]
struct Record {
    patch: usize,
    axis: &'static str,
    position: f64,
    positions: Vec<f64>,
    gain: f64,
    gain_at_middle: f64,
    maximum_gain: f64,
    residual: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    enclosures: Option<Enclosures>,
}

/// Decimal bounds of the best cut, and what is proved about it.
#[derive(Debug, serde::Serialize)]
struct Enclosures {
    position: DecimalBounds,
    gain: DecimalBounds,
    certificate: String,
}

impl Split {
    pub(super) fn answer(&self) -> Answer {
        if self.precision.is_some() && self.parts != 2 {
            return Err("--precision encloses one cut; leave out --parts".into());
        }
        let scene = self.scene.read()?;
        let others = (0..scene.patches().len()).filter(|index| *index != self.patch);
        let against = if self.against.is_empty() {
            others.collect()
        } else {
            self.against.clone()
        };
        let axes = match self.axis {
            None => SplitAxis::ALL.to_vec(),
            Some(AxisName::U) => vec![SplitAxis::U],
            Some(AxisName::V) => vec![SplitAxis::V],
        };
        let lit = if self.light.is_visibility()? {
            None
        } else {
            Some(self.lit(&scene)?)
        };
        let mut best: Option<(Record, bool)> = None;
        for axis in axes {
            let found = self.along(&scene, &against, axis, lit.as_ref())?;
            // of equal axes the first
            let margin = 1.0 + tolerance::EQUAL_MAXIMA;
            if best
                .as_ref()
                .is_none_or(|(best, _)| found.0.gain > best.gain * margin)
            {
                best = Some(found);
            }
        }
        let Some((record, is_closed_form)) = best else {
            return Err("no axis to cut across".into());
        };
        let (position_error, gain_error) = if is_closed_form {
            (tolerance::POSITION, tolerance::GAIN)
        } else {
            (tolerance::POLYGON_POSITION, tolerance::POLYGON_GAIN)
        };
        let bits = |value: f64| certain_digits(value, gain_error * value.abs());
        let positions: Vec<String> = record
            .positions
            .iter()
            .map(|t| certain_digits(*t, position_error))
            .collect();
        let rows = [
            ("patch", record.patch.to_string()),
            ("axis", record.axis.to_owned()),
            ("position", positions.join(", ")),
            ("gain, bits", bits(record.gain)),
            ("gain of equal parts, bits", bits(record.gain_at_middle)),
            (
                "most that equal parts can gain, bits",
                bits(record.maximum_gain),
            ),
            ("derivative left, bits", scientific(record.residual)),
        ];
        let rows = rows
            .map(|(name, value)| vec![name.to_owned(), value])
            .to_vec();
        let notes = record.enclosures.iter().flat_map(|enclosures| {
            [
                ("position", between(&enclosures.position)),
                ("gain, bits", between(&enclosures.gain)),
                ("certificate", enclosures.certificate.clone()),
            ]
            .map(|(name, text)| (name.to_owned(), text))
        });
        let notes = notes.collect();
        let table = Table {
            columns: vec!["quantity", "value"],
            rows,
            notes,
            ..Table::default()
        };
        self.output.write(&Report::one(table, &record)?)
    }

    /// The brightness of each patch, and Σw.
    fn lit(&self, scene: &Scene) -> Result<(Vec<f64>, f64), Box<dyn Error>> {
        let (tolerance, occlusion) = (DEFAULT_TOLERANCE, self.scene.occlusion());
        let pairs = ScenePairs::try_new(scene, tolerance, Congruence::Shared, occlusion)?;
        let exchange = pairs.exchange_areas()?;
        let found = self.light.brightness(scene, &exchange)?;
        let rows = found.values.iter().zip(&found.received);
        let weights = rows
            .zip(exchange.areas())
            .map(|((value, received), area)| value * received * area);
        let total = compensated_sum(weights);
        let patches = 0..scene.patches().len();
        let brightness = patches.map(|patch| found.values[scene.group_of(patch)]);
        Ok((brightness.collect(), total))
    }

    /// The best cuts across an axis, and whether they come from closed forms.
    fn along(
        &self,
        scene: &Scene,
        against: &[usize],
        axis: SplitAxis,
        lit: Option<&(Vec<f64>, f64)>,
    ) -> Result<(Record, bool), DiscretizeError> {
        let occlusion = self.scene.occlusion();
        let mut split = PatchSplit::with_occlusion(scene, self.patch, against, axis, occlusion)?;
        if let Some((brightness, total)) = lit {
            split = split.under(self.patch, brightness, *total)?;
        }
        let best = split.best(self.parts)?;
        let enclosures = match self.precision {
            Some(bits) => {
                let best = split.certified_best(bits)?;
                let bounds = |enclosure: &Interval| enclosure.to_decimal(MOST_DECIMALS);
                let both = bounds(&best.position).zip(bounds(&best.value));
                both.map(|(position, gain)| Enclosures {
                    position,
                    gain,
                    certificate: best.certificate.to_string(),
                })
            }
            None => None,
        };
        let record = Record {
            patch: self.patch,
            axis: axis.name(),
            position: best.positions[0],
            gain: best.gain,
            gain_at_middle: split.gain(&regular_positions(self.parts))?,
            maximum_gain: split.maximum_gain(self.parts)?,
            residual: best.residual,
            positions: best.positions,
            enclosures,
        };
        Ok((record, split.is_closed_form()))
    }
}
