//! Figures of lines, in SVG.
//!
//! Each line has a colour, a dash pattern and a marker of its own: any one of the three tells it from the others. The page is
//! 480 × 320 units with letters of 14, some 7 pt in a column 84 mm wide; it is drawn ten times finer, as the drawing library
//! rounds to whole units.
//!
//! **Not here**: computing.

use super::ReportError;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::element::DashedPathElement;
use plotters::prelude::*;

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
    /// What it measures, with the unit.
    pub label: String,
    /// Is it the logarithm that is evenly spaced?
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
const PAGE: (u32, u32) = (480, 320);
const FINER: u32 = 10;
const LETTERS: u32 = 14 * FINER;
/// Length of the sample of a line in the legend.
const SAMPLE: i32 = 340;
const SOLID: i32 = i32::MAX;

/// What tells a line: colour (of Okabe and Ito, told apart with any kind of sight), dash and gap, corners of the marker.
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
    /// [`ReportError::NotFinite`] if a number is not, or has no logarithm where one is needed; [`ReportError::Figure`] if there
    /// is nothing to draw, or too many lines.
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
        let scales = [Scale::of(&self.x, x), Scale::of(&self.y, y)];
        let size = (PAGE.0 * FINER, PAGE.1 * FINER);
        let mut text = String::new();
        {
            let root = SVGBackend::with_string(&mut text, size).into_drawing_area();
            self.draw(&root, &lines, &scales)
                .and_then(|()| root.present().map_err(|error| error.to_string()))
                .map_err(refused)?;
        }
        let drawn = format!("width=\"{}\" height=\"{}\"", size.0, size.1);
        let page = format!("width=\"{}\" height=\"{}\"", PAGE.0, PAGE.1);
        Ok(text.replacen(&drawn, &page, 1))
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
        root: &DrawingArea<DB, plotters::coord::Shift>,
        lines: &[Vec<[f64; 2]>],
        [x, y]: &[Scale; 2],
    ) -> Result<(), String> {
        let text = |error: DrawingAreaErrorKind<DB::ErrorType>| error.to_string();
        root.fill(&WHITE).map_err(text)?;
        let mut chart = ChartBuilder::on(root)
            .margin(12 * FINER)
            .margin_right(20 * FINER)
            .x_label_area_size(40 * FINER)
            .y_label_area_size(62 * FINER)
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
            .x_labels(x.ticks.len())
            .y_labels(y.ticks.len())
            .draw()
            .map_err(text)?;
        for (index, (points, line)) in lines.iter().zip(&self.lines).enumerate() {
            let look = &LOOKS[index];
            let style = look.colour.stroke_width(13);
            let [dash, gap] = look.dash;
            let path: Vec<(f64, f64)> = points.iter().map(|point| (point[0], point[1])).collect();
            let every = (path.len() / MARKERS).max(1);
            // begun apart, so that lines that lie on each other show both markers
            let first = (index * every / lines.len().max(1)).min(every - 1);
            let marked: Vec<(f64, f64)> = path.iter().copied().skip(first).step_by(every).collect();
            let entry = if dash == SOLID {
                chart.draw_series(LineSeries::new(path, style))
            } else {
                chart.draw_series(DashedLineSeries::new(path, dash, gap, style))
            };
            let entry = entry.map_err(text)?;
            if lines.len() > 1 {
                let sample = move |(x, y): (i32, i32)| {
                    let ends = [(0, 0), (SAMPLE, 0)];
                    let middle = look.marker.iter().map(|(dx, dy)| (dx + SAMPLE / 2, *dy));
                    let dash = dash.min(SAMPLE);
                    EmptyElement::at((x, y))
                        + DashedPathElement::new(ends, dash, gap, style)
                        + Polygon::new(middle.collect::<Vec<_>>(), look.colour.filled())
                };
                entry.label(line.name.as_str()).legend(sample);
            }
            let markers = marked.into_iter().map(|at| {
                EmptyElement::at(at) + Polygon::new(look.marker.to_vec(), look.colour.filled())
            });
            chart.draw_series(markers).map_err(text)?;
        }
        if lines.len() > 1 {
            chart
                .configure_series_labels()
                .position(emptiest_corner(lines, x, y))
                .margin(8 * FINER)
                .legend_area_size(SAMPLE + 6 * 10)
                .background_style(WHITE.mix(0.85))
                .border_style(RGBColor(150, 150, 150).stroke_width(5))
                .label_font(("sans-serif", LETTERS))
                .draw()
                .map_err(text)?;
        }
        Ok(())
    }
}

/// The corner of the drawing with the fewest points.
fn emptiest_corner(lines: &[Vec<[f64; 2]>], x: &Scale, y: &Scale) -> SeriesLabelPosition {
    let share = |scale: &Scale, place: f64| (place - scale.low) / (scale.high - scale.low);
    let corners = [
        (SeriesLabelPosition::UpperLeft, [false, true]),
        (SeriesLabelPosition::LowerRight, [true, false]),
        (SeriesLabelPosition::UpperRight, [true, true]),
        (SeriesLabelPosition::LowerLeft, [false, false]),
    ];
    let within = |point: &&[f64; 2], [right, upper]: [bool; 2]| {
        let [across, up] = [share(x, point[0]), share(y, point[1])];
        (if right { 1.0 - across } else { across }) < 0.6
            && (if upper { 1.0 - up } else { up }) < 0.4
    };
    let count = |corner: [bool; 2]| lines.iter().flatten().filter(|p| within(p, corner)).count();
    let emptiest = corners.into_iter().min_by_key(|(_, corner)| count(*corner));
    emptiest.map_or(SeriesLabelPosition::UpperLeft, |(position, _)| position)
}

/// An axis from end to end, with its ticks: place and name.
#[derive(Debug, Clone)]
struct Scale {
    low: f64,
    high: f64,
    ticks: Vec<(f64, String)>,
}

impl Scale {
    fn of(axis: &Axis, (low, high): (f64, f64)) -> Self {
        if axis.is_logarithmic {
            Self::logarithmic(low, high)
        } else {
            Self::even(low, high)
        }
    }

    /// Four to nine ticks 1, 2 or 5 times a power of ten apart, from the one below to the one above.
    fn even(low: f64, high: f64) -> Self {
        let width = if high > low {
            high - low
        } else {
            low.abs().max(1.0)
        };
        let power = 10f64.powf((width / 4.0).log10().floor());
        let step = [5.0, 2.0, 1.0]
            .into_iter()
            .find(|k| k * power <= width / 3.99);
        let step = step.unwrap_or(1.0) * power;
        let (first, last) = (
            (low / step).floor(),
            (high / step).ceil().max((low / step).floor() + 1.0),
        );
        let decimals = (-step.log10().floor()).max(0.0);
        let mut ticks = Vec::new();
        let mut count = first;
        while count <= last {
            ticks.push((count * step, decimal(count * step, decimals)));
            count += 1.0;
        }
        Self {
            low: first * step,
            high: last * step,
            ticks,
        }
    }

    /// Powers of ten, with 2 and 5 between them on a short axis.
    fn logarithmic(low: f64, high: f64) -> Self {
        let decades = high - low;
        let (factors, every): (&[f64], f64) = if decades <= 3.0 {
            (&[1.0, 2.0, 5.0], 1.0)
        } else {
            (&[1.0], (decades / 7.0).ceil())
        };
        let mut ticks = Vec::new();
        let mut power = (low / every).floor() * every;
        while power <= high {
            for factor in factors {
                let place = power + factor.log10();
                if place >= low - 1e-9 && place <= high + 1e-9 {
                    ticks.push((place, magnitude(*factor, power)));
                }
            }
            power += every;
        }
        Self { low, high, ticks }
    }
}

impl Ranged for Scale {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    #[allow(clippy::cast_possible_truncation, reason = "the page's units are few")]
    fn map(&self, place: &f64, (start, end): (i32, i32)) -> i32 {
        let share = (place - self.low) / (self.high - self.low);
        start + (share * f64::from(end - start)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _hint: Hint) -> Vec<f64> {
        self.ticks.iter().map(|(place, _)| *place).collect()
    }

    fn range(&self) -> std::ops::Range<f64> {
        self.low..self.high
    }
}

impl ValueFormatter<f64> for Scale {
    fn format(place: &f64) -> String {
        place.to_string()
    }

    fn format_ext(&self, place: &f64) -> String {
        let apart = |tick: &&(f64, String)| (tick.0 - place).abs();
        let nearest = self
            .ticks
            .iter()
            .min_by(|a, b| apart(a).total_cmp(&apart(b)));
        nearest.map_or_else(String::new, |(_, name)| name.clone())
    }
}

/// A number with so many decimals, without a sign if they are all 0.
fn decimal(value: f64, decimals: f64) -> String {
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a count of decimals"
    )]
    let decimals = decimals as usize;
    let text = format!("{value:.decimals$}");
    let is_zero = text.chars().all(|c| matches!(c, '-' | '0' | '.'));
    if is_zero { text.replace('-', "") } else { text }
}

/// `factor · 10^power`.
fn magnitude(factor: f64, power: f64) -> String {
    if (-3.0..=4.0).contains(&power) {
        decimal(factor * 10f64.powf(power), (-power).max(0.0))
    } else {
        format!("{factor}e{power}")
    }
}
