//! Tables for people and records for scripts.
//!
//! A [`Report`] carries both: a table with the digits that are certain, and records with every
//! digit. It is rendered as terminal table, Markdown, LaTeX, CSV or JSON. A [`Figure`] shows lines,
//! a [`Map`] a polygon, a [`Net`] the walls of a scene unfolded, all in SVG. The pages of
//! `data/report` are templates filled with computed numbers. A record with a number that is NaN or
//! infinite is refused in every format, and the number is named ([`ReportError::NotFinite`]).
//!
//! [`report_files`] makes a folder of all of them, with one page to read.
//!
//! **Not here**: computing, but for the numbers of [`findings_page`]; all others come finished.

mod answers;
mod bundle;
mod error;
mod render;

pub use answers::check::check_report;
pub use answers::claims::{curve_figure, curve_report, reproduction_report};
pub use answers::cuts::{cut_report, cuts_figure, cuts_report};
pub use answers::discontinuities::{discontinuities_map, discontinuities_report, gain_figure};
pub use answers::form_factors::write_form_factors;
#[cfg(feature = "proptest")]
pub use answers::fuzz::fuzz_report;
pub use answers::grid::grid_report;
pub use answers::measure::measure_report;
pub(crate) use answers::measure::plan_notes;
pub use answers::pages::claims::{claims_page, first_verdicts};
pub use answers::pages::findings::findings_page;
pub use answers::pages::trusted::trusted_page;
pub use answers::points::write_points;
pub use answers::radiosity::radiosity_report;
pub use answers::refine::{refinement_net, refinement_report};
pub use answers::sampled::sample_report;
pub use answers::split::split_report;
pub use answers::store::{store_report, store_state_report};
pub use answers::studies::{study_figure, study_report};
pub use bundle::{
    BundleFigure, BundleFile, BundleTable, REPORT_SCHEMA, report_figures, report_files,
    report_tables,
};
pub use error::ReportError;
pub use render::document::{Format, Report, json_text};
pub use render::figure::{Axis, Band, Figure, Line, Mark};
pub use render::map::{Map, MappedLine};
pub use render::matrix::{MatrixFormat, MatrixWriter};
pub use render::net::Net;
pub(crate) use render::number::power_of_ten;
pub use render::number::{certain_digits, enclosed_digits, scientific};
pub use render::page::PageError;
pub use render::table::Table;
