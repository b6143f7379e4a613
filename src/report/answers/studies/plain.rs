//! Tables of a fuzzing campaign and of a study of one number per row.

use crate::report::{Report, ReportError, Table, scientific};
use crate::study::Row;

/// The rows of a study, under `rows` in JSON.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn study_report(
    study: &'static str,
    error: &'static str,
    rows: &[Row],
) -> Result<Report, ReportError> {
    let line = |row: &Row| {
        vec![
            row.case.clone(),
            row.method.clone(),
            scientific(row.value),
            scientific(row.relative_error),
            scientific(row.seconds),
        ]
    };
    let table = Table {
        columns: vec!["case", "method", "value", error, "seconds"],
        rows: rows.iter().map(line).collect(),
        ..Table::default()
    };
    Ok(Report::list(table, "rows", rows)?.entitled("study", study))
}

#[cfg(feature = "proptest")]
mod fuzzing {
    use super::{Report, ReportError, Table, scientific};
    use crate::chain::random::families::{ChainFamily, DivisionFamily};
    use crate::numeric::real;
    use crate::study::gain::fuzz::{Campaign, Counterexample, Findings, Histograms};
    use std::fmt::Debug;

    /// The answer as a record: the keys are relied on by scripts.
    #[derive(Debug, serde::Serialize)]
    struct Record<'f> {
        cases: u64,
        seed: u64,
        /// The smallest gain; null where no case was run to its end.
        minimum_gain: Option<f64>,
        /// The smallest gain above 0; null where no case gains anything.
        minimum_positive_gain: Option<f64>,
        worst_margin: f64,
        recomputed: u64,
        counterexamples: &'f [Counterexample],
        cases_per_second: f64,
        histograms: &'f Histograms,
    }

    /// What a campaign found in `seconds`.
    ///
    /// # Errors
    /// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
    pub fn fuzz_report(
        campaign: Campaign,
        findings: &Findings,
        seconds: f64,
    ) -> Result<Report, ReportError> {
        let cases = real(findings.cases);
        let record = Record {
            cases: findings.cases,
            seed: campaign.seed,
            minimum_gain: findings.minimum_gain,
            minimum_positive_gain: findings.minimum_positive_gain,
            worst_margin: findings.worst_margin,
            recomputed: findings.recomputed,
            counterexamples: &findings.counterexamples,
            cases_per_second: (cases / seconds).round(),
            histograms: &findings.histograms,
        };
        let gain = |gain: Option<f64>| gain.map_or_else(|| "none".to_owned(), scientific);
        let mut rows = vec![
            vec!["cases".to_owned(), findings.cases.to_string()],
            vec![
                "cases per second".to_owned(),
                format!("{:.0}", record.cases_per_second),
            ],
            vec![
                "counterexamples".to_owned(),
                findings.counterexamples.len().to_string(),
            ],
            vec!["smallest gain, bits".to_owned(), gain(record.minimum_gain)],
            vec![
                "smallest gain above 0, bits".to_owned(),
                gain(record.minimum_positive_gain),
            ],
            vec![
                "largest error over promised error".to_owned(),
                format!(
                    "{:.3} ({} gains at 256 bits)",
                    findings.worst_margin, findings.recomputed
                ),
            ],
        ];
        let histograms = &findings.histograms;
        let decades = [
            "0", "< -60", "-60", "-50", "-40", "-30", "-20", "-10", "≥ 0",
        ]
        .map(str::to_owned);
        let tenths: Vec<String> = (0..=10).map(|tenth| format!("{}%", 10 * tenth)).collect();
        let numbers: Vec<String> = (0..histograms.states.len())
            .map(|count| count.to_string())
            .collect();
        for (name, counts, labels) in [
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
        ] {
            rows.push(vec![name.to_owned(), shares(counts, &labels)]);
        }
        let notes = findings.counterexamples.iter();
        let notes = notes.map(|found| (found.reason.clone(), format!("\n{}", found.source)));
        let table = Table {
            columns: vec!["quantity", "value"],
            rows,
            wrapped: Some(1),
            notes: notes.collect(),
        };
        Report::one(table, &record)
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
        let share = |count: u64| 100.0 * real(count) / real(total.max(1));
        let present = counts.iter().zip(labels).filter(|(count, _)| **count > 0);
        let texts = present.map(|(count, label)| format!("{label}: {:.1}%", share(*count)));
        texts.collect::<Vec<_>>().join(", ")
    }
}

#[cfg(feature = "proptest")]
pub use fuzzing::fuzz_report;
