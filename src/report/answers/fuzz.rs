//! Table of a campaign of random refinements.

use crate::chain::random::families::{ChainFamily, DivisionFamily};
use crate::question::FuzzAnswer;
use crate::report::{Report, ReportError, Table, scientific};
use crate::study::gain::fuzz::Histograms;
use std::fmt::Debug;

/// The answer to [`Fuzz`](crate::question::Fuzz): a line for each number and kind of case, and a
/// note for each counterexample.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn fuzz_report(answer: &FuzzAnswer) -> Result<Report, ReportError> {
    let gain = |gain: Option<f64>| gain.map_or_else(|| "none".to_owned(), scientific);
    let mut rows = vec![
        vec!["cases".to_owned(), answer.cases.to_string()],
        vec![
            "cases per second".to_owned(),
            format!("{:.0}", answer.cases_per_second),
        ],
        vec![
            "counterexamples".to_owned(),
            answer.counterexamples.len().to_string(),
        ],
        vec!["smallest gain, bits".to_owned(), gain(answer.minimum_gain)],
        vec![
            "smallest gain above 0, bits".to_owned(),
            gain(answer.minimum_positive_gain),
        ],
        vec![
            "largest error over promised error".to_owned(),
            format!(
                "{:.3} ({} gains at 256 bits)",
                answer.worst_margin, answer.recomputed
            ),
        ],
    ];
    rows.extend(kinds(&answer.histograms));
    let notes = answer.counterexamples.iter();
    let notes = notes.map(|found| (found.reason.clone(), format!("\n{}", found.source)));
    let table = Table {
        columns: vec!["quantity", "value"],
        rows,
        wrapped: Some(1),
        notes: notes.collect(),
    };
    Report::one(table, answer)
}

/// The kinds of cases that came up, a line for each way to tell them apart.
fn kinds(histograms: &Histograms) -> Vec<Vec<String>> {
    let decades = [
        "0", "< -60", "-60", "-50", "-40", "-30", "-20", "-10", "≥ 0",
    ]
    .map(str::to_owned);
    let tenths: Vec<String> = (0..=10).map(|tenth| format!("{}%", 10 * tenth)).collect();
    let numbers: Vec<String> = (0..histograms.states.len())
        .map(|count| count.to_string())
        .collect();
    let counted = [
        ("states", &histograms.states, numbers),
        ("zero entries, from", &histograms.zero_tenths, tenths),
        (
            "log10 of the gain, from",
            &histograms.gain_decades,
            decades.to_vec(),
        ),
        (
            "chains",
            &histograms.chain_families,
            names(&ChainFamily::ALL),
        ),
        (
            "divisions",
            &histograms.division_families,
            names(&DivisionFamily::ALL),
        ),
    ];
    let line = |(name, counts, labels): (&str, &Vec<u64>, Vec<String>)| {
        vec![name.to_owned(), shares(counts, &labels)]
    };
    counted.map(line).to_vec()
}

fn names(families: &[impl Debug]) -> Vec<String> {
    families
        .iter()
        .map(|family| format!("{family:?}"))
        .collect()
}

/// `label share%` of every class that came up.
fn shares(counts: &[u64], labels: &[String]) -> String {
    let total: u64 = counts.iter().sum();
    let share = |count: u64| {
        #[expect(clippy::cast_precision_loss, reason = "fewer than 2^53 cases")]
        let percent = 100.0 * count as f64 / total.max(1) as f64;
        percent
    };
    let present = counts.iter().zip(labels).filter(|(count, _)| **count > 0);
    let texts = present.map(|(count, label)| format!("{label}: {:.1}%", share(*count)));
    texts.collect::<Vec<_>>().join(", ")
}
