//! The table of the best cuts of a patch.

use crate::numeric::interval::DecimalBounds;
use crate::question::SplitAnswer;
use crate::report::{Report, ReportError, Table, certain_digits, scientific};

/// Renders the best cuts of a patch.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn split_report(answer: &SplitAnswer) -> Result<Report, ReportError> {
    let bits = |value: f64| certain_digits(value, answer.gain_error * value.abs());
    let positions = answer.positions.iter();
    let positions: Vec<String> = positions
        .map(|position| certain_digits(*position, answer.position_error))
        .collect();
    let channel = answer
        .channel
        .map(|channel| ("channel", channel.name().to_owned()));
    let rows = [
        ("patch", answer.patch.to_string()),
        ("axis", answer.axis.to_owned()),
        ("position", positions.join(", ")),
        ("gain, bits", bits(answer.gain)),
        ("gain of equal parts, bits", bits(answer.gain_at_middle)),
        (
            "most that equal parts can gain, bits",
            bits(answer.maximum_gain),
        ),
        ("derivative left, bits", scientific(answer.residual)),
    ];
    let between = |bounds: &DecimalBounds| format!("between {} and {}", bounds.lower, bounds.upper);
    let notes = answer.enclosures.iter().flat_map(|enclosures| {
        [
            ("position", between(&enclosures.position)),
            ("gain, bits", between(&enclosures.gain)),
            ("certificate", enclosures.certificate.clone()),
        ]
        .map(|(name, text)| (name.to_owned(), text))
    });
    let table = Table {
        columns: vec!["quantity", "value"],
        rows: channel
            .into_iter()
            .chain(rows)
            .map(|(name, value)| vec![name.to_owned(), value])
            .collect(),
        notes: notes.collect(),
        ..Table::default()
    };
    Report::one(table, answer)
}
