//! The files of independent values in `data/reference`.

use glam::DVec3;
use infoscene::geometry::Patch;
use std::path::PathBuf;

/// One row: an id and its columns.
pub struct Row {
    pub id: String,
    columns: Vec<(String, String)>,
}

impl Row {
    /// The text of a column.
    pub fn text(&self, column: &str) -> &str {
        let found = self.columns.iter().find(|(name, _)| name == column);
        &found
            .unwrap_or_else(|| panic!("row {} has no column {column}", self.id))
            .1
    }

    /// The number in a column.
    pub fn number(&self, column: &str) -> f64 {
        self.text(column)
            .parse()
            .unwrap_or_else(|error| panic!("{} {column}: {error}", self.id))
    }

    /// The polygons in the column `inputs`.
    pub fn polygons(&self) -> Vec<Patch> {
        polygons(self.text("inputs"))
    }
}

/// The polygons in a text `P=[["x", "y", "z"], …];Q=…`.
pub fn polygons(text: &str) -> Vec<Patch> {
    let parse = |text: &str| {
        let corners: Vec<[String; 3]> = serde_json::from_str(text).unwrap();
        corners
            .iter()
            .map(|c| DVec3::from_array(c.each_ref().map(|x| x.parse().unwrap())))
            .collect()
    };
    text.split(';')
        .map(|text| Patch::try_new(parse(&text[2..])).unwrap())
        .collect()
}

/// All rows of a file in `data/reference`.
pub fn rows(file: &str) -> Vec<Row> {
    let path: PathBuf = [env!("CARGO_MANIFEST_DIR"), "data", "reference", file]
        .iter()
        .collect();
    let mut reader = csv::Reader::from_path(&path).unwrap();
    let headers = reader.headers().unwrap().clone();
    let records = reader.records().map(|record| {
        let record = record.unwrap();
        let columns = headers
            .iter()
            .zip(&record)
            .map(|(h, c)| (h.to_owned(), c.to_owned()));
        Row {
            id: record[0].to_owned(),
            columns: columns.collect(),
        }
    });
    records.collect()
}

/// The value of one row.
pub fn value(file: &str, id: &str) -> f64 {
    let row = rows(file).into_iter().find(|row| row.id == id);
    row.unwrap_or_else(|| panic!("{file} has no row {id}"))
        .number("value")
}
