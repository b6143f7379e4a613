//! Sheets: one drawing, written as SVG or as PDF.
//!
//! A drawing says how large it is and draws itself onto any area of the drawing library, ten times
//! finer than the page, as that library rounds to whole units. Both formats so show the same.
//!
//! **Not here**: the drawings.

use super::pdf::{self, PdfPage};
use super::units::FINER;
use crate::report::ReportError;
use plotters::coord::Shift;
use plotters::prelude::*;

/// An area that a drawing is drawn onto.
pub(crate) type Area<DB> = DrawingArea<DB, Shift>;

/// A drawing that is ready, with everything in it finite.
pub(crate) trait Drawing {
    /// Width and height of the page, in units.
    fn size(&self) -> (u32, u32);

    /// Draws it; the area is ten times as large as the page.
    fn draw<DB: DrawingBackend>(&self, area: &Area<DB>) -> Result<(), String>;

    /// The drawing as an SVG file.
    fn svg(&self) -> Result<String, ReportError> {
        let page = self.size();
        let size = (page.0 * FINER, page.1 * FINER);
        let mut text = String::new();
        {
            let root = SVGBackend::with_string(&mut text, size).into_drawing_area();
            let presented = || root.present().map_err(|error| error.to_string());
            let drawn = self.draw(&root).and_then(|()| presented());
            drawn.map_err(|reason| ReportError::Figure { reason })?;
        }
        let drawn = format!("width=\"{}\" height=\"{}\"", size.0, size.1);
        let shown = format!("width=\"{}\" height=\"{}\"", page.0, page.1);
        Ok(text.replacen(&drawn, &shown, 1))
    }

    /// The drawing as a PDF file of one page.
    fn pdf(&self) -> Result<Vec<u8>, ReportError> {
        let page = self.size();
        let mut content = pdf::content(page);
        let mut missing = None;
        {
            let backend = PdfPage::new(&mut content, &mut missing, page);
            let drawn = self.draw(&backend.into_drawing_area());
            drawn.map_err(|reason| ReportError::Figure { reason })?;
        }
        match missing {
            Some(letter) => Err(ReportError::Figure {
                reason: format!("the fonts of a PDF file have no letter \"{letter}\""),
            }),
            None => Ok(pdf::file(content, page)),
        }
    }
}
