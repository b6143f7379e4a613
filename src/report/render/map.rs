//! Maps of a quantity over a polygon, with lines on it, in SVG.
//!
//! Values are shaded in twenty steps of grey, dark for low ones, so that borders of the steps are
//! contours. Lines have the colour and the dash of their kind. The page is 480 units wide and as
//! high as the polygon needs, with rows for the kinds of lines and the range of values above.
//!
//! **Not here**: computing.

use super::units::{FINER, LETTERS, MARGIN, ROW, SAMPLE};
use crate::report::ReportError;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// A quantity over a polygon, and lines.
#[derive(Debug, Clone, PartialEq)]
pub struct Map {
    /// The name of the quantity.
    pub quantity: String,
    /// The corners of the polygon.
    pub outline: Vec<[f64; 2]>,
    /// The lower left corner of the first cell.
    pub corner: [f64; 2],
    /// The side of a cell.
    pub cell: f64,
    /// The values of the cells, row by row from below; none outside of the polygon.
    pub values: Vec<Vec<Option<f64>>>,
    /// The lines.
    pub lines: Vec<MappedLine>,
}

/// A line on a map.
#[derive(Debug, Clone, PartialEq)]
pub struct MappedLine {
    /// The kind: `umbra`, `lit`, `sharp` or another.
    pub kind: &'static str,
    /// The ends.
    pub ends: [[f64; 2]; 2],
}

/// Width of the page.
const WIDTH: u32 = 480;
/// The longest side of the polygon on the page.
const SIDE: f64 = 4560.0;
/// The length by which a rectangle reaches over its seams.
const SEAM: i32 = 10;
/// Steps of grey, from dark to white.
const STEPS: f64 = 20.0;
const DARKEST: f64 = 60.0;

/// Colour (of Okabe and Ito), dash and gap of a kind of line.
fn look(kind: &str) -> (RGBColor, [i32; 2]) {
    match kind {
        "umbra" => (RGBColor(0, 114, 178), [i32::MAX, 0]),
        "lit" => (RGBColor(230, 159, 0), [i32::MAX, 0]),
        "sharp" => (RGBColor(213, 94, 0), [i32::MAX, 0]),
        _ => (RGBColor(0, 158, 115), [80, 50]),
    }
}

impl Map {
    /// The map as an SVG file.
    ///
    /// # Errors
    /// [`ReportError::NotFinite`] if a value is not finite; [`ReportError::Figure`] if the polygon
    /// has no extent.
    pub fn to_svg(&self) -> Result<String, ReportError> {
        let refused = |reason: String| ReportError::Figure { reason };
        let values = || self.values.iter().flatten().flatten();
        let places = || {
            let ends = self.lines.iter().flat_map(|line| line.ends);
            self.outline.iter().copied().chain(ends).flatten()
        };
        if !values().copied().chain(places()).all(f64::is_finite) {
            let key = self.quantity.clone();
            return Err(ReportError::NotFinite { key });
        }
        let range = |k: usize| {
            let corners = || self.outline.iter().map(|corner| corner[k]);
            [
                corners().fold(f64::INFINITY, f64::min),
                corners().fold(f64::NEG_INFINITY, f64::max),
            ]
        };
        let [x, y] = [range(0), range(1)];
        let extent = (x[1] - x[0]).max(y[1] - y[0]);
        if !(extent > 0.0 && extent.is_finite()) {
            return Err(refused("the polygon has no extent".to_owned()));
        }
        let scale = SIDE / extent;
        let legend = MARGIN + ROW * (1 + u32::try_from(self.kinds().len()).unwrap_or(0));
        let top = f64::from(legend * FINER);
        let place = |[px, py]: [f64; 2]| {
            let left = f64::from(MARGIN * FINER) + (px - x[0]) * scale;
            (rounded(left), rounded(top + (y[1] - py) * scale))
        };
        let height = legend + MARGIN + ceiled((y[1] - y[0]) * scale) / FINER;
        let size = (WIDTH * FINER, height * FINER);
        let mut text = String::new();
        {
            let root = SVGBackend::with_string(&mut text, size).into_drawing_area();
            let drawn = self.draw(&root, &place);
            drawn
                .and_then(|()| root.present())
                .map_err(|error| refused(error.to_string()))?;
        }
        let drawn = format!("width=\"{}\" height=\"{}\"", size.0, size.1);
        let shown = format!("width=\"{WIDTH}\" height=\"{height}\"");
        Ok(text.replacen(&drawn, &shown, 1))
    }

    /// The kinds of lines, each once.
    fn kinds(&self) -> Vec<&'static str> {
        let mut kinds: Vec<&str> = self.lines.iter().map(|line| line.kind).collect();
        kinds.sort_unstable();
        kinds.dedup();
        kinds
    }

    fn draw<DB: DrawingBackend>(
        &self,
        root: &DrawingArea<DB, plotters::coord::Shift>,
        place: &dyn Fn([f64; 2]) -> (i32, i32),
    ) -> Result<(), DrawingAreaErrorKind<DB::ErrorType>> {
        root.fill(&WHITE)?;
        let values = || self.values.iter().flatten().flatten().copied();
        let low = values().fold(f64::INFINITY, f64::min);
        let high = values().fold(f64::NEG_INFINITY, f64::max);
        let step = |value: f64| {
            let share = if high > low {
                (value - low) / (high - low)
            } else {
                1.0
            };
            (share * STEPS).floor().min(STEPS - 1.0)
        };
        let corners = || self.outline.iter().map(|corner| place(*corner));
        let end = (
            corners().map(|corner| corner.0).max().unwrap_or(0),
            corners().map(|corner| corner.1).min().unwrap_or(0),
        );
        for (row, values) in self.values.iter().enumerate() {
            let steps: Vec<Option<f64>> = values.iter().map(|value| value.map(step)).collect();
            let mut from = 0;
            // neighbours of one shade are one rectangle
            for run in steps.chunk_by(|a, b| a == b) {
                let to = from + run.len();
                if let Some(shade) = run[0] {
                    let at = |column: usize, row: usize| {
                        let [left, bottom] = [column, row].map(crate::numeric::real);
                        let [x, y] = self.corner;
                        place([x + left * self.cell, y + bottom * self.cell])
                    };
                    // over the seams to the right and above, which later ones cover
                    let ((left, top), (right, bottom)) = (at(from, row + 1), at(to, row));
                    let upper = (left, (top - SEAM).max(end.1));
                    let lower = ((right + SEAM).min(end.0), bottom);
                    root.draw(&Rectangle::new([upper, lower], grey(shade).filled()))?;
                }
                from = to;
            }
        }
        let outline = self.outline.iter().chain(self.outline.first());
        let outline: Vec<(i32, i32)> = outline.map(|corner| place(*corner)).collect();
        root.draw(&PathElement::new(outline, BLACK.stroke_width(8)))?;
        for line in &self.lines {
            let (colour, [dash, gap]) = look(line.kind);
            let ends = line.ends.map(place);
            root.draw(&DashedPathElement::new(
                ends,
                dash,
                gap,
                colour.stroke_width(16),
            ))?;
        }
        self.draw_legend(root, [low, high])
    }

    fn draw_legend<DB: DrawingBackend>(
        &self,
        root: &DrawingArea<DB, plotters::coord::Shift>,
        [low, high]: [f64; 2],
    ) -> Result<(), DrawingAreaErrorKind<DB::ErrorType>> {
        let unit = |units: u32| i32::try_from(units * FINER).unwrap_or(0);
        let style = || {
            let font = ("sans-serif", LETTERS).into_font();
            let place = Pos::new(HPos::Left, VPos::Center);
            font.into_text_style(root).pos(place)
        };
        let left = unit(MARGIN);
        let mut height = unit(MARGIN / 2) + unit(ROW) / 2;
        let range = format!(
            "{} from {low:.4} (dark) to {high:.4} (white)",
            self.quantity
        );
        root.draw(&Text::new(range, (left, height), style()))?;
        for kind in self.kinds() {
            height += unit(ROW);
            let (colour, [dash, gap]) = look(kind);
            let ends = [(left, height), (left + SAMPLE, height)];
            let dash = dash.min(SAMPLE);
            root.draw(&DashedPathElement::new(
                ends,
                dash,
                gap,
                colour.stroke_width(16),
            ))?;
            let name = format!("line of discontinuity: {kind}");
            let place = (left + SAMPLE + unit(8), height);
            root.draw(&Text::new(name, place, style()))?;
        }
        Ok(())
    }
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "60 to 255"
)]
fn grey(step: f64) -> RGBColor {
    let level = (DARKEST + (255.0 - DARKEST) * step / (STEPS - 1.0)).round() as u8;
    RGBColor(level, level, level)
}

#[expect(clippy::cast_possible_truncation, reason = "the page's units are few")]
fn rounded(place: f64) -> i32 {
    place.round() as i32
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the page's units are few"
)]
fn ceiled(length: f64) -> u32 {
    length.max(0.0).ceil() as u32
}
