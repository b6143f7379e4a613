//! The reference files: their rows, and the comparison of a number with a row.
//!
//! A number agrees with printed digits when it differs by at most one unit of the
//! last of them.

use crate::precision::Real;
use std::collections::BTreeMap;

/// One row: the values by their column names.
pub type Row = BTreeMap<String, String>;

/// The reference files, all of which are recomputed.
pub const FILES: [&str; 4] = ["form_factors", "splits", "section_4_2", "cube_grids"];

/// The rows of a reference file, in order.
pub fn rows(file: &str) -> Vec<Row> {
    let path = format!("{}/data/reference/{file}.csv", env!("CARGO_MANIFEST_DIR"));
    let mut reader = csv::Reader::from_path(&path).unwrap();
    reader.deserialize().map(Result::unwrap).collect()
}

/// The row of a file with the given id.
pub fn row(file: &str, id: &str) -> Row {
    let found = rows(file).into_iter().find(|row| row["id"] == id);
    found.unwrap_or_else(|| panic!("{file}.csv has no row {id}"))
}

/// The number of digits of a printed number that count.
#[derive(Clone, Copy)]
pub enum Digits {
    /// All that are printed, but at least 28: a printed 0.5 stands for 0.5000….
    Printed,
    /// The first of a number that is printed with more than are right.
    First(i32),
    /// All that are printed of a number printed with few.
    Few,
}

/// One unit of the last digit that counts.
fn unit(printed: &str, digits: Digits) -> Real {
    let (whole, decimals) = printed.split_once('.').unwrap();
    let count = |text: &str| i32::try_from(text.len()).unwrap();
    let significant = count(printed.trim_start_matches(['0', '.'])) - i32::from(whole != "0");
    // The decimal place of the first significant digit.
    let first = count(decimals) - significant + 1;
    let counted = match digits {
        Digits::Printed => significant.max(28),
        Digits::First(most) => significant.min(most),
        Digits::Few => significant,
    };
    Real::decimal(&format!("1e{}", 1 - first - counted))
}

/// Panics unless `value` agrees with the digits of the printed number of a row.
pub fn assert_digits(id: &str, printed: &str, digits: Digits, value: &Real) {
    let error = (value - Real::decimal(printed)).abs();
    println!("{id}: {value} is off by {error}");
    assert!(
        error <= unit(printed, digits),
        "{id}: recomputed {value}, printed {printed}"
    );
}

#[test]
fn one_unit_of_the_last_digit_is_accepted_and_two_are_not() {
    let (printed, digits) = ("0.0123", Digits::First(3));
    assert_digits("below", printed, digits, &Real::decimal("0.0122001"));
    assert_digits("above", printed, digits, &Real::decimal("0.0123999"));
    for off in ["0.0121", "0.0125"] {
        let off = Real::decimal(off);
        let outcome = std::panic::catch_unwind(|| assert_digits("off", printed, digits, &off));
        assert!(outcome.is_err());
    }
    for (printed, digits, expected) in [
        ("0.5", Digits::Printed, "1e-28"),
        ("0.05", Digits::Printed, "1e-29"),
        ("414213.25", Digits::First(7), "1e-1"),
        ("1.0006600069357112", Digits::First(13), "1e-12"),
        ("6.051", Digits::Few, "1e-3"),
    ] {
        let error = unit(printed, digits) / Real::decimal(expected) - Real::int(1);
        assert!(error.abs() < Real::decimal("1e-80"), "{printed}");
    }
}
