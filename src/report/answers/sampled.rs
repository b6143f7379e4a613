//! The information of a scene, sampled.

use crate::information::LineSample;
use crate::numeric::Grade;
use crate::report::{Report, ReportError, Table, certain_digits, scientific};
use crate::scene::Scene;

/// The answer as a record: the keys are relied on by scripts.
#[derive(Debug, serde::Serialize)]
struct Record {
    patches: usize,
    total_area: f64,
    /// Always none: that of the pairs, which are not computed.
    mutual_information: Option<f64>,
    continuous_mutual_information: Option<f64>,
    continuous_standard_error: Option<f64>,
    continuous_error_grade: Option<Grade>,
    lines: u32,
    seed: u64,
    sampled: SampledRecord,
}

impl SampledRecord {
    /// With the exact mutual information and the expected bias, where they are known.
    pub(crate) fn new(sample: &LineSample, seed: u64, exact: Option<[f64; 2]>) -> Self {
        let counts = &sample.counts;
        Self {
            lines: sample.lines,
            seed,
            kind: sample.kind.name(),
            samples: counts.samples(),
            occupied_cells: counts.occupied(),
            unseen: counts.unseen(),
            taken_for_unseen: counts.taken_for_unseen(),
            mutual_information: counts.plug_in(),
            expected_bias: exact.map(|[_, bias]| bias),
            counted_weights: counts.plug_in_of_counted_weights(),
            miller_madow: counts.miller_madow(),
            corrected: counts.corrected(),
            standard_error: counts.standard_error(),
            error_grade: Grade::Sample,
            confidence_interval: counts.confidence_interval(),
            exact_mutual_information: exact.map(|[information, _]| information),
        }
    }

    /// The rows of a table.
    pub(crate) fn rows(&self) -> Vec<(&'static str, String)> {
        // a digit more than is certain, to see the estimates apart
        let digits = |value: f64| certain_digits(value, 0.1 * self.standard_error);
        let estimate = |value: f64| format!("({})", digits(value));
        let interval = match self.confidence_interval {
            Some(ends) => {
                let [from, to] = ends.map(digits);
                format!("{from} to {to}")
            }
            None => "none: too many pairs are not met yet".to_owned(),
        };
        let mut rows = vec![
            (
                "lines, seed",
                format!("{} {}, {}", self.lines, self.kind, self.seed),
            ),
            ("chords", self.samples.to_string()),
            ("pairs met", self.occupied_cells.to_string()),
            (
                "chords alone with their pair",
                format!("{:.2} %", 100.0 * self.unseen),
            ),
            ("sampled: plug-in, bits", estimate(self.mutual_information)),
            (
                "the same, weights counted, too",
                estimate(self.counted_weights),
            ),
            ("less bias (Miller and Madow)", estimate(self.miller_madow)),
            ("corrected (Chao, Wang and Jost)", estimate(self.corrected)),
            (
                "standard error of each, bits",
                scientific(self.standard_error),
            ),
            ("interval of 95 %, bits", interval),
        ];
        if let Some(bias) = self.expected_bias {
            rows.push(("bias expected of the plug-in, bits", format!("{bias:.3e}")));
        }
        rows
    }
}

/// Estimates from counted pairs.
#[derive(Debug, serde::Serialize)]
pub(crate) struct SampledRecord {
    lines: u32,
    seed: u64,
    kind: &'static str,
    /// Chords: several for a line where a room is not convex.
    samples: u64,
    occupied_cells: usize,
    /// The part of the samples that are alone in their cell.
    unseen: f64,
    /// What the corrected estimate takes off for pairs not met.
    taken_for_unseen: f64,
    /// The plug-in estimate with the areas known.
    mutual_information: f64,
    /// How far it lies above the exact value on average, where that is known.
    expected_bias: Option<f64>,
    counted_weights: f64,
    miller_madow: f64,
    corrected: f64,
    standard_error: f64,
    error_grade: Grade,
    /// Of 95 %, around the corrected estimate; none if too much is unseen.
    confidence_interval: Option<[f64; 2]>,
    exact_mutual_information: Option<f64>,
}

/// What random lines from this seed say about a scene; beside it the exact mutual information and the expected bias of the plug-in
/// estimate, where they are known, and the continuous mutual information, if it is asked for.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn sample_report(
    scene: &Scene,
    sample: &LineSample,
    exact: Option<[f64; 2]>,
    continuous: bool,
    seed: u64,
) -> Result<Report, ReportError> {
    let chords = continuous.then_some(sample.chords);
    let record = Record {
        patches: scene.group_count(),
        total_area: scene.total_area(),
        mutual_information: None,
        continuous_mutual_information: chords.map(|chords| chords.mutual_information),
        continuous_standard_error: chords.map(|chords| chords.standard_error),
        continuous_error_grade: chords.map(|_| Grade::Sample),
        lines: sample.lines,
        seed,
        sampled: SampledRecord::new(sample, seed, exact),
    };
    let table = Table {
        columns: vec!["quantity", "value"],
        rows: lines_of(&record)
            .into_iter()
            .map(|(quantity, value)| vec![quantity.to_owned(), value])
            .collect(),
        notes: vec![("sampled".to_owned(), note(&record.sampled))],
        ..Table::default()
    };
    Report::one(table, &record)
}

fn lines_of(record: &Record) -> Vec<(&'static str, String)> {
    let mut rows = vec![("patches", record.patches.to_string())];
    rows.extend(record.sampled.rows());
    if let Some(exact) = record.sampled.exact_mutual_information {
        rows.push(("exact, bits", format!("{exact:.9}")));
    }
    let continuous = record
        .continuous_mutual_information
        .zip(record.continuous_standard_error);
    if let Some((value, error)) = continuous {
        let digits = certain_digits(value, error);
        rows.push(("continuous mutual information, bits", format!("({digits})")));
        rows.push(("its standard error, bits", scientific(error)));
    }
    rows
}

fn note(sampled: &SampledRecord) -> String {
    let bias = "the plug-in estimate lies above the exact value by some (pairs)/(2 N ln 2), all estimates by part of what pairs not met yet \
                would add";
    if sampled.confidence_interval.is_some() {
        bias.to_owned()
    } else {
        format!(
            "{bias}: take more lines, until the {} bit taken off for these are below the standard error",
            scientific(sampled.taken_for_unseen)
        )
    }
}
