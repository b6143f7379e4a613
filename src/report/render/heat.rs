//! Grids of numbers that are coloured by size, in SVG and PDF.
//!
//! The colour runs from white to dark blue, so that the order is seen in grey, too, and each cell
//! has its number.
//!
//! **Not here**: computing.

use super::sheet::{Area, Drawing};
use super::units::{FINER, LETTERS, MARGIN};
use crate::numeric::real;
use crate::report::ReportError;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Numbers in rows and columns, each with a name.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Heat {
    /// The name of what the numbers measure.
    pub(crate) quantity: String,
    /// The number that has the darkest colour; 0 has none.
    pub(crate) largest: f64,
    /// Names of the columns.
    pub(crate) columns: Vec<String>,
    /// Names of the rows, and their numbers where they have one.
    pub(crate) rows: Vec<(String, Vec<Option<f64>>)>,
}

/// Least width of a column, height of a row, and of a letter of a name about, in units.
const COLUMN: u32 = 92;
const ROW: u32 = 19;
const LETTER: u32 = 6;
/// The head: the quantity, and the names of the columns.
const HEAD: u32 = 50;
/// The size of letters.
const SMALL: u32 = LETTERS - 44;
const DARKEST: [f64; 3] = [8.0, 48.0, 107.0];

impl Heat {
    /// The grid, checked.
    ///
    /// # Errors
    /// [`ReportError::NotFinite`] for a number that is not finite; [`ReportError::Figure`] without
    /// any row.
    pub(crate) fn checked(self) -> Result<Self, ReportError> {
        if self.rows.is_empty() || self.columns.is_empty() {
            let reason = format!("there is no row of {}", self.quantity);
            return Err(ReportError::Figure { reason });
        }
        let is_finite = |number: &Option<f64>| number.is_none_or(f64::is_finite);
        let wrong = self.rows.iter().find(|row| !row.1.iter().all(is_finite));
        match wrong {
            Some((name, _)) => Err(ReportError::NotFinite { key: name.clone() }),
            None => Ok(self),
        }
    }

    fn left(&self) -> u32 {
        MARGIN + longest(self.rows.iter().map(|(name, _)| name)) + MARGIN
    }

    /// The width of a column, in which its name has room.
    fn column(&self) -> u32 {
        longest(self.columns.iter()).max(COLUMN)
    }

    /// A colour between white and the darkest, and that of letters on it.
    fn colours(&self, value: f64) -> (RGBColor, RGBColor) {
        let share = (value / self.largest).clamp(0.0, 1.0);
        let mixed = DARKEST.map(|part| {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "from 0 to 255"
            )]
            let part = (255.0 + share * (part - 255.0)).round() as u8;
            part
        });
        let letters = if share > 0.5 { WHITE } else { BLACK };
        (RGBColor(mixed[0], mixed[1], mixed[2]), letters)
    }
}

impl Drawing for Heat {
    fn size(&self) -> (u32, u32) {
        let count = |length: usize| u32::try_from(length).unwrap_or(0);
        let width = self.left() + self.column() * count(self.columns.len()) + MARGIN;
        let height = HEAD + ROW * count(self.rows.len()) + MARGIN;
        (width.max(360), height)
    }

    fn draw<DB: DrawingBackend>(&self, area: &Area<DB>) -> Result<(), String> {
        let refused = |error: DrawingAreaErrorKind<DB::ErrorType>| error.to_string();
        area.fill(&WHITE).map_err(refused)?;
        let unit = |units: u32| i32::try_from(units * FINER).unwrap_or(0);
        let say = |text: &str, at: (i32, i32), across: HPos, colour: RGBColor| {
            let font = ("sans-serif", SMALL).into_font().color(&colour);
            let style = font
                .into_text_style(area)
                .pos(Pos::new(across, VPos::Center));
            area.draw(&Text::new(text.to_owned(), at, style))
                .map_err(refused)
        };
        say(&self.quantity, (unit(MARGIN), unit(14)), HPos::Left, BLACK)?;
        let left = unit(self.left());
        let middle = |column: usize| {
            let place = real(column) + 0.5;
            #[expect(clippy::cast_possible_truncation, reason = "the page's units are few")]
            let place = (place * f64::from(unit(self.column()))) as i32;
            left + place
        };
        for (column, name) in self.columns.iter().enumerate() {
            say(name, (middle(column), unit(HEAD - 11)), HPos::Center, BLACK)?;
        }
        let mut top = unit(HEAD);
        for (name, numbers) in &self.rows {
            let centre = top + unit(ROW) / 2;
            say(name, (left - unit(8), centre), HPos::Right, BLACK)?;
            for (column, number) in numbers.iter().enumerate() {
                let Some(number) = number else {
                    continue;
                };
                let (ground, letters) = self.colours(*number);
                let half = unit(self.column()) / 2;
                let corners = [
                    (middle(column) - half + 5, top + 5),
                    (middle(column) + half - 5, top + unit(ROW) - 5),
                ];
                area.draw(&Rectangle::new(corners, ground.filled()))
                    .map_err(refused)?;
                // a sum with 0 is without the sign of −0
                let text = format!("{:.0}", number + 0.0);
                say(&text, (middle(column), centre), HPos::Center, letters)?;
            }
            top += unit(ROW);
        }
        Ok(())
    }
}

/// About the width of the longest of some names.
fn longest<'n>(names: impl Iterator<Item = &'n String>) -> u32 {
    let letters = names.map(|name| name.chars().count()).max();
    LETTER * u32::try_from(letters.unwrap_or(0)).unwrap_or(0)
}
