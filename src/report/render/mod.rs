//! Formats: documents, tables, numbers, figures, pages.
//!
//! Open `document` first: it carries an answer as a table and as records, and writes any format.
//! `finite` refuses NaN and infinity in it, `table` and `latex` lay out text, `number` prints no
//! more digits than are certain, `figure` (with `scale`) and `map` draw SVG, `matrix` writes matrices
//! for other programs, and `page` fills the templates of `data/report`.

pub(crate) mod document;
pub(crate) mod figure;
pub(crate) mod finite;
pub(crate) mod latex;
pub(crate) mod map;
pub(crate) mod matrix;
pub(crate) mod number;
pub(crate) mod page;
pub(crate) mod scale;
pub(crate) mod table;
