//! Tables for people and records for scripts.
//!
//! A [`Report`] carries both: a table with the digits that are certain, and records with every
//! digit.
//! It is rendered as terminal table, Markdown, LaTeX, CSV or JSON. A [`Figure`] is lines, drawn in
//! SVG. The pages of `data/report` are templates filled with computed numbers. A record with a
//! number that is NaN or infinite is refused in every format, and the number is named
//! ([`ReportError::NotFinite`]).
//!
//! **Not here**: computing, but for the numbers of [`findings_page`]; all others come finished.

mod answers;
mod render;

pub use answers::claims::{curve_figure, curve_report, reproduction_report};
pub use answers::claims_page::{claims_page, first_verdicts};
pub use answers::cuts::{cut_report, cuts_figure, cuts_report};
pub use answers::findings::findings_page;
pub use answers::form_factors::write_form_factors;
pub use answers::grid::{GridAnswer, GridEnclosures, grid_report};
pub use answers::measure::{measure_report, plan_notes};
pub use answers::radiosity::radiosity_report;
pub use answers::refinement::{refinements_figure, refinements_report};
pub use answers::sampled::sample_report;
pub use answers::split::split_report;
pub use answers::studies::gradient::{directions_report, limits_report, profiles_report};
#[cfg(feature = "proptest")]
pub use answers::studies::plain::fuzz_report;
pub use answers::studies::plain::study_report;
pub use answers::studies::routes::{accuracy_report, stability_report};
pub use answers::studies::sampling::{figure_5_report, sampling_report};
pub use render::document::{Format, Report, ReportError, json_text};
pub use render::figure::{Axis, Figure, Line};
pub use render::npy::{write_npy_head, write_npy_row};
pub use render::number::{certain_digits, enclosed_digits, power_of_ten, scientific};
pub use render::page::PageError;
pub use render::table::Table;
