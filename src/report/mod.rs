//! Tables for people and records for scripts.
//!
//! A [`Report`] carries both: a table with the digits that are certain, and records with every
//! digit. It is rendered as terminal table, Markdown, LaTeX, CSV or JSON. A [`Figure`] is lines,
//! drawn in SVG. The pages of `data/report` are templates filled with computed numbers. A record
//! with a number that is NaN or infinite is refused in every format, and the number is named
//! ([`ReportError::NotFinite`]).
//!
//! **Not here**: computing, but for the numbers of [`findings_page`]; all others come finished.

mod answers;
mod error;
mod render;

pub use answers::check::check_report;
pub use answers::claims::{curve_figure, curve_report, reproduction_report};
pub use answers::claims_page::{claims_page, first_verdicts};
pub use answers::cuts::{cut_report, cuts_figure, cuts_report};
pub use answers::discontinuities::{discontinuities_map, discontinuities_report, gain_figure};
pub use answers::findings::findings_page;
pub use answers::form_factors::write_form_factors;
#[cfg(feature = "proptest")]
pub use answers::fuzz::fuzz_report;
pub use answers::grid::grid_report;
pub use answers::measure::measure_report;
pub(crate) use answers::measure::plan_notes;
pub use answers::points::write_points;
pub use answers::radiosity::radiosity_report;
pub use answers::sampled::sample_report;
pub use answers::split::split_report;
pub use answers::studies::{study_figure, study_report};
pub use answers::trusted::trusted_page;
pub use error::ReportError;
pub use render::document::{Format, Report, json_text};
pub use render::figure::{Axis, Figure, Line};
pub use render::map::{Map, MappedLine};
pub use render::matrix::{MatrixFormat, MatrixWriter};
pub(crate) use render::number::power_of_ten;
pub use render::number::{certain_digits, enclosed_digits, scientific};
pub use render::page::PageError;
pub use render::table::Table;
