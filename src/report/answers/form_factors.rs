//! Form factors as records, written as they are made into text: there may be very many of them.

use crate::exchange::PlanSummary;
use crate::form_factor::Answer;
use crate::report::render::finite;
use crate::report::{Format, ReportError, Table, certain_digits, plan_notes, scientific};
use serde::ser::{Error as _, SerializeSeq};
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
            error: answer.exchange.error / area + bound / area * value,
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

/// Records that are made and checked one after the other.
struct Records<'e, I> {
    records: RefCell<Option<I>>,
    /// Why a record was refused.
    refusal: &'e RefCell<Option<ReportError>>,
}

impl<I: Iterator<Item = Result<FormFactorRecord, ReportError>>> Serialize for Records<'_, I> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let records = self.records.borrow_mut().take();
        let records = records.ok_or_else(|| S::Error::custom("records are made once"))?;
        let mut list = serializer.serialize_seq(None)?;
        for record in records {
            let record = record.map_err(|error| {
                let message = S::Error::custom(&error);
                *self.refusal.borrow_mut() = Some(error);
                message
            })?;
            list.serialize_element(&record)?;
        }
        list.end()
    }
}

/// Writes form factors in any format.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite: what was written
/// before it is no answer. [`ReportError::Write`], [`ReportError::Csv`] or [`ReportError::Json`] if
/// the text cannot be written.
pub fn write_form_factors(
    patches: &[PatchRecord<'_>],
    records: impl Iterator<Item = FormFactorRecord>,
    plan: &PlanSummary,
    format: Format,
    mut text: impl Write,
) -> Result<(), ReportError> {
    for (index, patch) in patches.iter().enumerate() {
        finite::check_entry("patches", index, patch)?;
    }
    let records = records.enumerate().map(|(index, record)| {
        finite::check_entry("form_factors", index, &record)?;
        Ok(record)
    });
    match format {
        Format::Json => {
            let refusal = RefCell::new(None);
            let document = Document {
                patches,
                form_factors: Records {
                    records: RefCell::new(Some(records)),
                    refusal: &refusal,
                },
                plan,
            };
            let written = serde_json::to_writer_pretty(&mut text, &document);
            written.map_err(|error| refusal.take().unwrap_or(ReportError::Json(error)))?;
            writeln!(text)?;
        }
        Format::Csv => {
            let mut writer = csv::Writer::from_writer(text);
            for record in records {
                writer.serialize(record?)?;
            }
            writer.flush()?;
        }
        Format::Table | Format::Markdown | Format::Latex => {
            let table = table(patches, records, plan)?;
            let lines = match format {
                Format::Markdown => table.to_markdown(),
                Format::Latex => table.to_latex(),
                _ => table.to_terminal(),
            };
            text.write_all(lines.as_bytes())?;
        }
    }
    Ok(())
}

fn table(
    patches: &[PatchRecord<'_>],
    mut records: impl Iterator<Item = Result<FormFactorRecord, ReportError>>,
    plan: &PlanSummary,
) -> Result<Table, ReportError> {
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
    let shown = records.by_ref().take(MOST_ROWS);
    let rows = shown.map(|record| record.map(line));
    let rows = rows.collect::<Result<Vec<_>, _>>()?;
    let more = records.try_fold(0, |more: usize, record| record.map(|_| more + 1))?;
    let mut notes = plan_notes(plan);
    if more > 0 {
        let note = format!("{more}: --format csv or json lists all, --from and --to choose");
        notes.insert(0, ("pairs not shown".to_owned(), note));
    }
    Ok(Table {
        columns: vec!["from", "to", "form factor", "±", "route"],
        rows,
        notes,
        ..Table::default()
    })
}
