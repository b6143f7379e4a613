//! Formats: documents, tables, numbers, figures, pages.
//!
//! Open `document` first: it carries an answer as a table and as records, and writes any format.
//! `finite` refuses NaN and infinity in it, `table` and `latex` lay out text, `number` prints no
//! more digits than are certain, `figure` (with `scale`), `heat` and `view` draw on a `sheet`,
//! which is SVG or `pdf`, `map` and `net` draw SVG, `matrix` writes matrices for other programs,
//! and `page` fills the templates of `data/report`.

pub(crate) mod document;
pub(crate) mod figure;
pub(crate) mod finite;
pub(crate) mod heat;
pub(crate) mod latex;
pub(crate) mod map;
pub(crate) mod matrix;
pub(crate) mod net;
pub(crate) mod number;
pub(crate) mod page;
mod pdf;
pub(crate) mod scale;
pub(crate) mod sheet;
pub(crate) mod table;
mod units;
pub(crate) mod view;
