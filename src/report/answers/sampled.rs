//! The information of a scene, sampled.

use crate::information::LineSample;
use crate::numeric::Grade;
use crate::question::SampledInformation;
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
    sampled: SampledInformation,
}

/// Rows of a table with the estimates from random lines.
pub(crate) fn sampled_rows(sampled: &SampledInformation) -> Vec<(&'static str, String)> {
    // a digit more than is certain, to see the estimates apart
    let digits = |value: f64| certain_digits(value, 0.1 * sampled.standard_error);
    let estimate = |value: f64| format!("({})", digits(value));
    let interval = match sampled.confidence_interval {
        Some(ends) => {
            let [from, to] = ends.map(digits);
            format!("{from} to {to}")
        }
        None => "none: too many pairs are not met yet".to_owned(),
    };
    let mut rows = vec![
        (
            "lines, seed",
            format!("{} {}, {}", sampled.lines, sampled.kind, sampled.seed),
        ),
        ("chords", sampled.samples.to_string()),
        ("pairs met", sampled.occupied_cells.to_string()),
        (
            "chords alone with their pair",
            format!("{:.2} %", 100.0 * sampled.unseen),
        ),
        (
            "sampled: plug-in, bits",
            estimate(sampled.mutual_information),
        ),
        (
            "the same, weights counted, too",
            estimate(sampled.counted_weights),
        ),
        (
            "less bias (Miller and Madow)",
            estimate(sampled.miller_madow),
        ),
        (
            "corrected (Chao, Wang and Jost)",
            estimate(sampled.corrected),
        ),
        (
            "standard error of each, bits",
            scientific(sampled.standard_error),
        ),
        ("interval of 95 %, bits", interval),
    ];
    if let Some(bias) = sampled.expected_bias {
        rows.push(("bias expected of the plug-in, bits", format!("{bias:.3e}")));
    }
    rows
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
        sampled: SampledInformation::new(sample, seed, exact),
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
    rows.extend(sampled_rows(&record.sampled));
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

fn note(sampled: &SampledInformation) -> String {
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
