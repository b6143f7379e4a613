//! Figures of lines, in SVG.
//!
//! Each line has a colour, a dash pattern and a marker of its own: any one of the three tells it
//! from the others. The page is 480 × 330 units, with a row above for each of several lines.
//! Letters are 14 units high, some 7 pt in a column 84 mm wide. It is drawn ten times finer, as the
//! drawing library rounds to whole units.
//!
//! **Not here**: computing.

use super::scale::Scale;
use crate::report::ReportError;
use plotters::coord::Shift;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Lines over two axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// The lines, at most six; a single one needs no name.
    pub lines: Vec<Line>,
}

/// An axis.
#[derive(Debug, Clone, PartialEq, Eq)]
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

/// The page, and how much finer it is drawn.
const PAGE: (u32, u32) = (480, 330);
pub(super) const FINER: u32 = 10;
/// A letter's height is 14; the library's size is 1.24 times that.
pub(super) const LETTERS: u32 = 174;
/// The margin around the figure, and the width of the vertical axis with its labels.
pub(super) const MARGIN: u32 = 12;
const LEFT: u32 = 70;
/// Height of a row of the legend, and length of the sample of a line in it.
pub(super) const ROW: u32 = 20;
pub(super) const SAMPLE: i32 = 400;
const SOLID: i32 = i32::MAX;

/// The look of a line: colour (of Okabe and Ito, distinct with any kind of sight), dash and gap,
/// and corners of the marker.
struct Look {
    colour: RGBColor,
    dash: [i32; 2],
    marker: &'static [(i32, i32)],
}

const LOOKS: [Look; 6] = [
    Look {
        colour: RGBColor(0, 0, 0),
        dash: [SOLID, 0],
        marker: &[(-32, -32), (32, -32), (32, 32), (-32, 32)],
    },
    Look {
        colour: RGBColor(0, 114, 178),
        dash: [120, 60],
        marker: &[(0, -46), (42, 30), (-42, 30)],
    },
    Look {
        colour: RGBColor(213, 94, 0),
        dash: [30, 50],
        marker: &[(0, -46), (46, 0), (0, 46), (-46, 0)],
    },
    Look {
        colour: RGBColor(0, 158, 115),
        dash: [220, 60],
        marker: &[(0, 46), (42, -30), (-42, -30)],
    },
    Look {
        colour: RGBColor(204, 121, 167),
        dash: [70, 30],
        marker: &[(-46, -14), (46, -14), (46, 14), (-46, 14)],
    },
    Look {
        colour: RGBColor(230, 159, 0),
        dash: [60, 110],
        marker: &[(-14, -46), (14, -46), (14, 46), (-14, 46)],
    },
];

/// Markers on a line, about.
const MARKERS: usize = 8;

impl Figure {
    /// The figure as an SVG file.
    ///
    /// # Errors
    /// [`ReportError::NotFinite`] if a number is not finite, or has no logarithm where one is
    /// needed; [`ReportError::Figure`] if there is nothing to draw, or too many lines.
    pub fn to_svg(&self) -> Result<String, ReportError> {
        let refused = |reason: String| ReportError::Figure { reason };
        if self.lines.len() > LOOKS.len() {
            let count = self.lines.len();
            return Err(refused(format!(
                "{count} lines are more than can be told apart, {}",
                LOOKS.len()
            )));
        }
        let lines = self.placed()?;
        let all = || lines.iter().flatten();
        let [x, y] = [0, 1].map(|axis| {
            let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY];
            for point in all() {
                (low, high) = (low.min(point[axis]), high.max(point[axis]));
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
        let page = (PAGE.0, PAGE.1 + self.legend_height());
        let size = (page.0 * FINER, page.1 * FINER);
        let mut text = String::new();
        {
            let root = SVGBackend::with_string(&mut text, size).into_drawing_area();
            self.draw(&root, &lines, &scales)
                .and_then(|()| root.present().map_err(|error| error.to_string()))
                .map_err(refused)?;
        }
        let drawn = format!("width=\"{}\" height=\"{}\"", size.0, size.1);
        let shown = format!("width=\"{}\" height=\"{}\"", page.0, page.1);
        Ok(text.replacen(&drawn, &shown, 1))
    }

    /// The points on their axes: logarithms where these are spaced evenly.
    fn placed(&self) -> Result<Vec<Vec<[f64; 2]>>, ReportError> {
        let placed = |line: &Line, point: &[f64; 2]| {
            let place = |axis: &Axis, value: f64| {
                if axis.is_logarithmic {
                    value.log10()
                } else {
                    value
                }
            };
            let place = [place(&self.x, point[0]), place(&self.y, point[1])];
            if place.iter().all(|number| number.is_finite()) {
                Ok(place)
            } else {
                let key = format!("a point of \"{}\"", line.name);
                Err(ReportError::NotFinite { key })
            }
        };
        let lines = self.lines.iter();
        lines
            .map(|line| {
                line.points
                    .iter()
                    .map(|point| placed(line, point))
                    .collect()
            })
            .collect()
    }

    fn draw<DB: DrawingBackend>(
        &self,
        root: &DrawingArea<DB, Shift>,
        lines: &[Vec<[f64; 2]>],
        [x, y]: &[Scale; 2],
    ) -> Result<(), String> {
        let text = |error: DrawingAreaErrorKind<DB::ErrorType>| error.to_string();
        root.fill(&WHITE).map_err(text)?;
        let (legend, rest) = root.split_vertically(self.legend_height() * FINER);
        let mut chart = ChartBuilder::on(&rest)
            .margin(MARGIN * FINER)
            .margin_right(2 * MARGIN * FINER)
            .x_label_area_size(46 * FINER)
            .y_label_area_size(LEFT * FINER)
            .build_cartesian_2d(x.clone(), y.clone())
            .map_err(text)?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(RGBColor(225, 225, 225).stroke_width(5))
            .axis_style(BLACK.stroke_width(8))
            .set_all_tick_mark_size(4 * FINER)
            .label_style(("sans-serif", LETTERS))
            .x_desc(self.x.label.as_str())
            .y_desc(self.y.label.as_str())
            .x_labels(x.ticks())
            .y_labels(y.ticks())
            .draw()
            .map_err(text)?;
        for (index, points) in lines.iter().enumerate() {
            let look = &LOOKS[index];
            let path: Vec<(f64, f64)> = points.iter().map(|point| (point[0], point[1])).collect();
            let every = (path.len() / MARKERS).max(1);
            // begun apart, so that lines that lie on each other show both markers
            let first = (index * every / lines.len()).min(every - 1);
            let marked: Vec<(f64, f64)> = path.iter().copied().skip(first).step_by(every).collect();
            let [dash, gap] = look.dash;
            let line = DashedPathElement::new(path, dash, gap, look.style());
            chart.draw_series([line]).map_err(text)?;
            if lines.len() > 1 {
                for at in marked {
                    let marker = look.marker_at(chart.backend_coord(&at));
                    root.draw(&marker).map_err(text)?;
                }
            }
        }
        self.draw_legend(&legend).map_err(text)
    }

    /// A row for each of several lines, above the axes, where it hides nothing.
    fn legend_height(&self) -> u32 {
        match u32::try_from(self.lines.len()) {
            Ok(rows) if rows > 1 => MARGIN / 2 + ROW * rows,
            _ => 0,
        }
    }

    fn draw_legend<DB: DrawingBackend>(
        &self,
        area: &DrawingArea<DB, Shift>,
    ) -> Result<(), DrawingAreaErrorKind<DB::ErrorType>> {
        if self.legend_height() == 0 {
            return Ok(());
        }
        let unit = |units: u32| i32::try_from(units * FINER).unwrap_or(0);
        let left = unit(MARGIN + LEFT);
        let mut height = unit(MARGIN / 2) + unit(ROW) / 2;
        for (line, look) in self.lines.iter().zip(&LOOKS) {
            let [dash, gap] = look.dash;
            let ends = [(left, height), (left + SAMPLE, height)];
            area.draw(&DashedPathElement::new(
                ends,
                dash.min(SAMPLE),
                gap,
                look.style(),
            ))?;
            area.draw(&look.marker_at((left + SAMPLE / 2, height)))?;
            let font = ("sans-serif", LETTERS).into_font();
            let style = font
                .into_text_style(area)
                .pos(Pos::new(HPos::Left, VPos::Center));
            let place = (left + SAMPLE + unit(8), height);
            area.draw(&Text::new(line.name.as_str(), place, style))?;
            height += unit(ROW);
        }
        Ok(())
    }
}

impl Look {
    fn style(&self) -> ShapeStyle {
        self.colour.stroke_width(13)
    }

    /// The marker about a place of the page.
    fn marker_at(&self, (x, y): (i32, i32)) -> Polygon<(i32, i32)> {
        let corners = self.marker.iter().map(|(dx, dy)| (x + dx, y + dy));
        Polygon::new(corners.collect::<Vec<_>>(), self.colour.filled())
    }
}
