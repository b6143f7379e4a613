//! Formats: documents, tables, numbers, figures, pages.

pub(crate) mod document;
pub(crate) mod figure;
pub(crate) mod finite;
pub(crate) mod latex;
pub(crate) mod npy;
pub(crate) mod number;
pub(crate) mod page;
pub(crate) mod scale;
pub(crate) mod table;
