//! Tables for people and records for scripts.
//!
//! A [`Report`] carries both: a table with the digits that are certain, and records with every digit. It is
//! rendered as terminal table, Markdown, LaTeX, CSV or JSON.
//!
//! **Not here**: computing; the numbers come finished.

mod campaign;
mod latex;
mod number;
mod records;
mod reproduction;
mod table;

#[cfg(feature = "proptest")]
pub use campaign::fuzz_report;
pub use campaign::study_report;
pub use number::{certain_digits, enclosed_digits, power_of_ten, scientific};
pub use records::{Format, Report, ReportError};
pub use reproduction::{curve_report, reproduction_report};
pub use table::Table;
