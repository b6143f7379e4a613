//! Form factors in any format, written as they are made: there may be very many of them.

use crate::exchange::PlanSummary;
use crate::question::{FormFactorRecord, PatchRecord};
use crate::report::render::finite;
use crate::report::{Format, ReportError, Table, certain_digits, plan_notes, scientific};
use serde::ser::{Error as _, SerializeSeq};
use serde::{Serialize, Serializer};
use std::cell::RefCell;
use std::io::Write;

/// Pairs that a table shows; records carry all.
const MOST_ROWS: usize = 1000;

#[derive(Serialize)]
struct Document<'p, R> {
    patches: &'p [PatchRecord],
    form_factors: R,
    resolution: f64,
    plan: &'p PlanSummary,
}

/// A form factor as a line, with the names and the sum that JSON has beside the list.
#[derive(Serialize)]
struct CsvRecord<'p> {
    from: usize,
    to: usize,
    value: f64,
    error: f64,
    route: &'static str,
    from_name: &'p str,
    to_name: &'p str,
    row_sum: Option<f64>,
    /// Only where coordinates are not exact.
    #[serde(skip_serializing_if = "Option::is_none")]
    resolution_error: Option<f64>,
}

impl<'p> CsvRecord<'p> {
    fn new(record: FormFactorRecord, patches: &'p [PatchRecord], resolution: f64) -> Self {
        let [from, to] = [record.from, record.to].map(|row| &patches[row]);
        Self {
            from: record.from,
            to: record.to,
            value: record.value,
            error: record.error,
            route: record.route,
            from_name: &from.name,
            to_name: &to.name,
            row_sum: from.row_sum,
            resolution_error: (resolution > 0.0).then_some(record.resolution_error),
        }
    }
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
/// **Arguments** `resolution`: that of the scene; tables and CSV have a column for what it can
/// change unless it is 0.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite: what was written
/// before it is no answer. [`ReportError::Write`], [`ReportError::Csv`] or [`ReportError::Json`] if
/// the text cannot be written.
pub fn write_form_factors(
    patches: &[PatchRecord],
    records: impl Iterator<Item = FormFactorRecord>,
    (resolution, plan): (f64, &PlanSummary),
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
                resolution,
                plan,
            };
            let written = serde_json::to_writer_pretty(&mut text, &document);
            written.map_err(|error| refusal.take().unwrap_or(ReportError::Json(error)))?;
            writeln!(text)?;
        }
        Format::Csv => {
            let mut writer = csv::Writer::from_writer(text);
            for record in records {
                writer.serialize(CsvRecord::new(record?, patches, resolution))?;
            }
            writer.flush()?;
        }
        Format::Table | Format::Markdown | Format::Latex => {
            let table = table(patches, records, resolution, plan)?;
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
    patches: &[PatchRecord],
    mut records: impl Iterator<Item = Result<FormFactorRecord, ReportError>>,
    resolution: f64,
    plan: &PlanSummary,
) -> Result<Table, ReportError> {
    let line = |record: FormFactorRecord| {
        let name = |index: usize| format!("{index} ({})", patches[index].name);
        let moved = (resolution > 0.0).then(|| scientific(record.resolution_error));
        let known = [
            name(record.from),
            name(record.to),
            certain_digits(record.value, record.error),
            scientific(record.error),
        ];
        let route = record.route.to_owned();
        known.into_iter().chain(moved).chain([route]).collect()
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
    let mut columns = vec!["from", "to", "form factor", "±"];
    columns.extend((resolution > 0.0).then_some("± resolution"));
    columns.push("route");
    Ok(Table {
        columns,
        rows,
        notes,
        ..Table::default()
    })
}
