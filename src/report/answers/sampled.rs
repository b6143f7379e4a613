//! The table of a scene's information from random lines.

use crate::question::{SampleAnswer, SampledInformation};
use crate::report::{Report, ReportError, Table, certain_digits, scientific};

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

/// Renders the estimates of a scene's information from random lines.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn sample_report(answer: &SampleAnswer) -> Result<Report, ReportError> {
    let rows = lines_of(answer).into_iter();
    let table = Table {
        columns: vec!["quantity", "value"],
        rows: rows
            .map(|(quantity, value)| vec![quantity.to_owned(), value])
            .collect(),
        notes: vec![("sampled".to_owned(), note(&answer.sampled))],
        ..Table::default()
    };
    Report::one(table, answer)
}

fn lines_of(answer: &SampleAnswer) -> Vec<(&'static str, String)> {
    let mut rows = vec![("patches", answer.patches.to_string())];
    rows.extend(sampled_rows(&answer.sampled));
    if let Some(exact) = answer.sampled.exact_mutual_information {
        rows.push(("exact, bits", format!("{exact:.9}")));
    }
    let continuous = answer
        .continuous_mutual_information
        .zip(answer.continuous_standard_error);
    if let Some((value, error)) = continuous {
        let digits = certain_digits(value, error);
        rows.push(("continuous mutual information, bits", format!("({digits})")));
        rows.push(("its standard error, bits", scientific(error)));
    }
    rows
}

fn note(sampled: &SampledInformation) -> String {
    let bias = "the plug-in estimate lies above the exact value by some (pairs)/(2 N ln 2), all \
                estimates by part of what pairs not met yet would add";
    if sampled.confidence_interval.is_some() {
        bias.to_owned()
    } else {
        format!(
            "{bias}: take more lines, until the {} bit taken off for these are below the standard \
             error",
            scientific(sampled.taken_for_unseen)
        )
    }
}
