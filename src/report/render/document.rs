//! Finished answers, a table and records, in any format.

use super::finite;
use crate::report::{ReportError, Table};
use serde_json::{Map, Value};

/// The format of an answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Format {
    /// A table for a terminal.
    #[default]
    Table,
    /// A Markdown table.
    Markdown,
    /// Comma-separated records, every digit.
    Csv,
    /// JSON, every digit.
    Json,
    /// A LaTeX tabular.
    Latex,
}

/// An answer: a table for people, records for scripts.
#[derive(Debug, Clone, PartialEq)]
pub struct Report {
    table: Table,
    records: Vec<Map<String, Value>>,
    list_key: Option<&'static str>,
    title: Option<(&'static str, &'static str)>,
    summary: Map<String, Value>,
}

impl Report {
    /// An answer that is one record.
    ///
    /// # Errors
    /// [`ReportError::Json`] if it is not a struct or map; [`ReportError::NotFinite`] with the key
    /// of a number that is NaN or infinite.
    pub fn one(table: Table, record: &impl serde::Serialize) -> Result<Self, ReportError> {
        Ok(Self {
            table,
            records: vec![flat(record, finite::check(record))?],
            list_key: None,
            title: None,
            summary: Map::new(),
        })
    }

    /// An answer that is a list of records, under `key` in JSON.
    ///
    /// # Errors
    /// As [`one`](Self::one).
    pub fn list<R: serde::Serialize>(
        table: Table,
        key: &'static str,
        records: &[R],
    ) -> Result<Self, ReportError> {
        let records = records
            .iter()
            .enumerate()
            .map(|(index, record)| flat(record, finite::check_entry(key, index, record)));
        let records = records.collect::<Result<_, _>>()?;
        Ok(Self {
            table,
            records,
            list_key: Some(key),
            title: None,
            summary: Map::new(),
        })
    }

    /// An answer that is one record, of which a list of records under `key` is most. The list comes
    /// first in JSON, and makes the lines of comma-separated values.
    ///
    /// # Errors
    /// As [`one`](Self::one); [`ReportError::Json`] if there is no list of records under `key`.
    pub fn list_in(
        table: Table,
        key: &'static str,
        record: &impl serde::Serialize,
    ) -> Result<Self, ReportError> {
        let mut summary = flat(record, finite::check(record))?;
        let records = match summary.shift_remove(key) {
            Some(Value::Array(list)) => list.into_iter().map(as_map).collect::<Result<_, _>>()?,
            _ => {
                let message = format!("a record must have a list under {key:?}");
                return Err(ReportError::Json(serde::ser::Error::custom(message)));
            }
        };
        Ok(Self {
            table,
            records,
            list_key: Some(key),
            title: None,
            summary,
        })
    }

    /// The table for people.
    #[must_use]
    pub const fn table(&self) -> &Table {
        &self.table
    }

    /// Adds a name under `key`, before the list of records in JSON.
    #[must_use]
    pub const fn entitled(mut self, key: &'static str, name: &'static str) -> Self {
        self.title = Some((key, name));
        self
    }

    /// Adds a record that concerns the whole list, after it in JSON.
    ///
    /// # Errors
    /// As [`one`](Self::one).
    pub fn summarised(mut self, summary: &impl serde::Serialize) -> Result<Self, ReportError> {
        self.summary = flat(summary, finite::check(summary))?;
        Ok(self)
    }

    /// The answer as text, ending in a newline.
    ///
    /// # Errors
    /// [`ReportError::Csv`], [`ReportError::Json`].
    pub fn render(&self, format: Format) -> Result<String, ReportError> {
        Ok(match format {
            Format::Table => self.table.to_terminal(),
            Format::Markdown => self.table.to_markdown(),
            Format::Latex => self.table.to_latex(),
            Format::Csv => self.to_csv()?,
            Format::Json => {
                let value = match (self.list_key, self.records.as_slice()) {
                    (None, [record]) => Value::Object(record.clone()),
                    (key, records) => {
                        let list = records.iter().cloned().map(Value::Object).collect();
                        let title = self.title.into_iter();
                        let title = title.map(|(key, name)| (key.to_owned(), Value::from(name)));
                        let key = key.unwrap_or("records").to_owned();
                        let head = title.chain([(key, Value::Array(list))]);
                        Value::Object(head.chain(self.summary.clone()).collect())
                    }
                };
                json_text(&value)?
            }
        })
    }

    fn to_csv(&self) -> Result<String, ReportError> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        let records: Vec<_> = self.records.iter().map(spread).collect();
        if let Some(record) = records.first() {
            // a list of numbers becomes one cell; curves, lists of points, stay in JSON
            let fits = |value: &Value| match value {
                Value::Array(list) => list.iter().all(Value::is_number),
                _ => true,
            };
            let keys: Vec<&String> = record
                .iter()
                .filter(|(_, value)| fits(value))
                .map(|(key, _)| key)
                .collect();
            writer.write_record(&keys)?;
            for record in &records {
                let cell = |key: &&String| match record.get(*key) {
                    None | Some(Value::Null) => String::new(),
                    Some(Value::String(text)) => text.clone(),
                    Some(Value::Array(list)) => list
                        .iter()
                        .map(Value::to_string)
                        .collect::<Vec<_>>()
                        .join(" "),
                    Some(value) => value.to_string(),
                };
                writer.write_record(keys.iter().map(cell))?;
            }
        }
        let bytes = writer
            .into_inner()
            .map_err(|error| csv::Error::from(error.into_error()))?;
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    }
}

/// A record whose quantities by channel, `channels.r.radiosity`, have keys of their own,
/// `radiosity_r`.
fn spread(record: &Map<String, Value>) -> Map<String, Value> {
    let mut spread = record.clone();
    if let Some(Value::Object(channels)) = spread.shift_remove("channels") {
        for (channel, quantities) in channels {
            for (key, value) in quantities.as_object().into_iter().flatten() {
                spread.insert(format!("{key}_{channel}"), value.clone());
            }
        }
    }
    spread
}

/// Any value as JSON text that ends in a newline.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite;
/// [`ReportError::Json`].
pub fn json_text(value: &impl serde::Serialize) -> Result<String, ReportError> {
    finite::check(value)?;
    Ok(serde_json::to_string_pretty(value)? + "\n")
}

/// A record that was checked, as a map.
fn flat(
    record: &impl serde::Serialize,
    checked: Result<(), ReportError>,
) -> Result<Map<String, Value>, ReportError> {
    checked?;
    as_map(serde_json::to_value(record)?)
}

fn as_map(value: Value) -> Result<Map<String, Value>, ReportError> {
    match value {
        Value::Object(map) => Ok(map),
        other => {
            let message = format!("a record must be a map, not {other}");
            Err(ReportError::Json(serde::ser::Error::custom(message)))
        }
    }
}
