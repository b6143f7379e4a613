//! Form factors as records, written as they are made into text: there may be very many of them.

use super::{Format, ReportError, Table, certain_digits, plan_notes, scientific};
use crate::form_factor::Answer;
use crate::scene::PlanSummary;
use serde::ser::Error as _;
use serde::{Serialize, Serializer};
use std::cell::RefCell;
use std::io::Write;

/// Pairs that a table shows; records carry all.
const MOST_ROWS: usize = 1000;

/// A form factor as a record: the keys are relied on by scripts.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FormFactorRecord {
    /// The patch that sends.
    pub from: usize,
    /// The patch that receives.
    pub to: usize,
    /// `F`, from 0 to 1.
    pub value: f64,
    /// A bound on its absolute error.
    pub error: f64,
    /// How it was found.
    pub route: &'static str,
}

impl FormFactorRecord {
    /// The form factor from a patch of this area, with the bound on its rounding and the quotient's.
    #[must_use]
    pub fn new([from, to]: [usize; 2], [area, bound]: [f64; 2], answer: &Answer) -> Self {
        let value = answer.exchange.value / area;
        Self {
            from,
            to,
            value,
            error: answer.exchange.error_bound / area + bound / area * value,
            route: answer.route.name(),
        }
    }
}

/// A patch, or several that are summed, as a record.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PatchRecord<'p> {
    /// Its number, from 0.
    pub index: usize,
    /// Its name, or that of the first.
    pub name: &'p str,
    /// Its area, without what lies in it.
    pub area: f64,
}

#[derive(Serialize)]
struct Document<'p, R> {
    patches: &'p [PatchRecord<'p>],
    form_factors: R,
    plan: &'p PlanSummary,
}

/// Records that are made one after the other.
struct Records<I>(RefCell<Option<I>>);

impl<I: Iterator<Item = FormFactorRecord>> Serialize for Records<I> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let records = self.0.borrow_mut().take();
        let records = records.ok_or_else(|| S::Error::custom("records are made once"))?;
        serializer.collect_seq(records)
    }
}

/// Writes form factors in any format.
///
/// # Errors
/// [`ReportError`] if a number is not finite or the text cannot be written.
pub fn write_form_factors(
    patches: &[PatchRecord<'_>],
    records: impl Iterator<Item = FormFactorRecord>,
    plan: &PlanSummary,
    format: Format,
    mut text: impl Write,
) -> Result<(), ReportError> {
    match format {
        Format::Json => {
            let document = Document {
                patches,
                form_factors: Records(RefCell::new(Some(records))),
                plan,
            };
            serde_json::to_writer_pretty(&mut text, &document)?;
            writeln!(text).map_err(csv::Error::from)?;
        }
        Format::Csv => {
            let mut writer = csv::Writer::from_writer(text);
            for record in records {
                writer.serialize(record)?;
            }
            writer.flush().map_err(csv::Error::from)?;
        }
        Format::Table | Format::Markdown | Format::Latex => {
            let table = table(patches, records, plan);
            let lines = match format {
                Format::Markdown => table.to_markdown(),
                Format::Latex => table.to_latex(),
                _ => table.to_terminal(),
            };
            text.write_all(lines.as_bytes()).map_err(csv::Error::from)?;
        }
    }
    Ok(())
}

fn table(
    patches: &[PatchRecord<'_>],
    mut records: impl Iterator<Item = FormFactorRecord>,
    plan: &PlanSummary,
) -> Table {
    let line = |record: FormFactorRecord| {
        let name = |index: usize| format!("{index} ({})", patches[index].name);
        vec![
            name(record.from),
            name(record.to),
            certain_digits(record.value, record.error),
            scientific(record.error),
            record.route.to_owned(),
        ]
    };
    let rows: Vec<_> = records.by_ref().take(MOST_ROWS).map(line).collect();
    let more = records.count();
    let mut notes = plan_notes(plan);
    if more > 0 {
        let note = format!("{more}: --format csv or json lists all, --from and --to choose");
        notes.insert(0, ("pairs not shown".to_owned(), note));
    }
    Table {
        columns: vec!["from", "to", "form factor", "±", "route"],
        rows,
        notes,
        ..Table::default()
    }
}
