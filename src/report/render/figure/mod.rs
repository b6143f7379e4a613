//! Figures of lines, in SVG.
//!
//! Each line has a colour, a dash pattern and a marker of its own: any one of the three tells it
//! from the others. The page is 480 × 330 units, with a row above for each of several lines.
//! Letters are 14 units high, some 7 pt in a column 84 mm wide. It is drawn ten times finer, as the
//! drawing library rounds to whole units.
//!
//! **Not here**: computing.

mod drawn;

use super::scale::Scale;
use super::sheet::Drawing;
use crate::report::ReportError;
use drawn::{LOOKS, Ready};

/// Lines over two axes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Figure {
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// The lines, at most six; a single one needs no name.
    pub lines: Vec<Line>,
    /// Points that no line joins, such as printed ones; at most six with the lines.
    pub dots: Vec<Line>,
    /// Bands within which values lie, drawn below the lines.
    pub bands: Vec<Band>,
    /// Numbers marked across the figure, such as a printed one.
    pub marks: Vec<Mark>,
}

/// A band about a line: points of abscissa, least and greatest ordinate.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// The index of the line, whose colour it has.
    pub line: usize,
    /// The points, in order.
    pub points: Vec<[f64; 3]>,
}

/// A number that is marked by a line across the figure, with its name beside it.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// Is it an abscissa, not an ordinate?
    pub is_abscissa: bool,
    /// The number.
    pub at: f64,
    /// The name.
    pub name: String,
}

/// An axis.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Axis {
    /// The quantity, with its unit.
    pub label: String,
    /// Whether the logarithm of the quantity is evenly spaced, not the quantity.
    pub is_logarithmic: bool,
}

/// A line with its name in the legend.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// The name.
    pub name: String,
    /// The points, in order.
    pub points: Vec<[f64; 2]>,
}

impl Axis {
    /// An axis of the quantity itself.
    #[must_use]
    pub fn even(label: &str) -> Self {
        Self {
            label: label.to_owned(),
            is_logarithmic: false,
        }
    }

    /// An axis of the logarithm of the quantity.
    #[must_use]
    pub fn logarithmic(label: &str) -> Self {
        Self {
            label: label.to_owned(),
            is_logarithmic: true,
        }
    }

    /// The place of a value: its logarithm where these are spaced evenly.
    fn place(&self, value: f64) -> f64 {
        if self.is_logarithmic {
            value.log10()
        } else {
            value
        }
    }
}

impl Figure {
    /// The figure as an SVG file.
    ///
    /// # Errors
    /// [`ReportError::NotFinite`] if a number is not finite, or has no logarithm where one is
    /// needed; [`ReportError::Figure`] if there is nothing to draw, or too many lines.
    pub fn to_svg(&self) -> Result<String, ReportError> {
        self.ready()?.svg()
    }

    /// The figure as a PDF file.
    ///
    /// # Errors
    /// As [`to_svg`](Self::to_svg), and for a letter that the file's fonts lack.
    pub fn to_pdf(&self) -> Result<Vec<u8>, ReportError> {
        self.ready()?.pdf()
    }

    /// The figure with its points on their axes.
    fn ready(&self) -> Result<Ready<'_>, ReportError> {
        let refused = |reason: String| ReportError::Figure { reason };
        let count = self.lines.len() + self.dots.len();
        if count > LOOKS.len() {
            return Err(refused(format!(
                "{count} lines are more than can be told apart, {}",
                LOOKS.len()
            )));
        }
        let lines = self.placed()?;
        let all = || lines.iter().flatten();
        let [x, y] = [0, 1].map(|axis| {
            let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY];
            for place in all().map(|point| point[axis]).chain(self.reach(axis)) {
                (low, high) = (low.min(place), high.max(place));
            }
            (low, high)
        });
        if x.0 >= x.1 {
            return Err(refused("a line needs two points".to_owned()));
        }
        let scale = |axis: &Axis, ends, is_tight| {
            let scale = Scale::new(axis.is_logarithmic, ends, is_tight);
            scale.ok_or_else(|| {
                refused(format!(
                    "no ticks can be set on the axis \"{}\"",
                    axis.label
                ))
            })
        };
        let scales = [scale(&self.x, x, true)?, scale(&self.y, y, false)?];
        Ok(Ready {
            figure: self,
            lines,
            scales,
        })
    }

    /// The points on their axes: logarithms where these are spaced evenly.
    fn placed(&self) -> Result<Vec<Vec<[f64; 2]>>, ReportError> {
        let placed = |line: &Line, point: &[f64; 2]| {
            let place = [self.x.place(point[0]), self.y.place(point[1])];
            if place.iter().all(|number| number.is_finite()) {
                Ok(place)
            } else {
                let key = format!("a point of \"{}\"", line.name);
                Err(ReportError::NotFinite { key })
            }
        };
        let lines = self.lines.iter().chain(&self.dots);
        lines
            .map(|line| {
                line.points
                    .iter()
                    .map(|point| placed(line, point))
                    .collect()
            })
            .collect()
    }

    /// The places on an axis that bands and marks reach to.
    fn reach(&self, axis: usize) -> impl Iterator<Item = f64> {
        let bands = self.bands.iter().flat_map(|band| &band.points);
        let bands = bands.flat_map(move |point| match axis {
            0 => vec![self.x.place(point[0])],
            _ => vec![self.y.place(point[1]), self.y.place(point[2])],
        });
        let marks = self
            .marks
            .iter()
            .filter(move |mark| mark.is_abscissa == (axis == 0));
        let scale = if axis == 0 { &self.x } else { &self.y };
        bands.chain(marks.map(|mark| scale.place(mark.at)))
    }
}
