//! Tables for people and records for scripts.
//!
//! A [`Report`] carries both: a table with the digits that are certain, and records with every digit.
//! It is rendered as terminal table, Markdown, LaTeX, CSV or JSON. A [`Figure`] is lines, drawn in
//! SVG. The pages of `data/report` are templates filled with computed numbers. A record with a
//! number that is NaN or infinite is refused in every format, and the number is named
//! ([`ReportError::NotFinite`]).
//!
//! **Not here**: computing, but for the numbers of [`findings_page`]; all others come finished.

mod campaign;
mod claims_page;
mod figure;
mod findings;
mod finite;
mod form_factors;
mod gradient_cuts;
mod gradient_studies;
mod grid;
mod latex;
mod measure;
mod npy;
mod number;
mod page;
mod radiosity;
mod records;
mod refinements;
mod reproduction;
mod sampled;
mod sampled_studies;
mod scale;
mod studies;
mod table;

#[cfg(feature = "proptest")]
pub use campaign::fuzz_report;
pub use campaign::study_report;
pub use claims_page::{claims_page, first_verdicts};
pub use figure::{Axis, Figure, Line};
pub use findings::findings_page;
pub use form_factors::{FormFactorRecord, PatchRecord, write_form_factors};
pub use gradient_cuts::{cut_report, cuts_figure, cuts_report};
pub use gradient_studies::{directions_report, limits_report, profiles_report};
pub use grid::{GridAnswer, GridEnclosures, grid_report};
pub use measure::{measure_report, plan_notes};
pub use npy::{write_npy_head, write_npy_row};
pub use number::{certain_digits, enclosed_digits, power_of_ten, scientific};
pub use page::PageError;
pub use radiosity::radiosity_report;
pub use records::{Format, Report, ReportError, json_text};
pub use refinements::{refinements_figure, refinements_report};
pub use reproduction::{curve_figure, curve_report, reproduction_report};
pub use sampled::sample_report;
pub use sampled_studies::{figure_5_report, sampling_report};
pub use studies::{accuracy_report, stability_report};
pub use table::Table;
