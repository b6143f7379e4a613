//! A figure as it is drawn: axes, bands, marks, lines and legend in one style.

use super::{Band, Figure, Mark};
use crate::report::render::scale::Scale;
use crate::report::render::sheet::{Area, Drawing};
use crate::report::render::units::{FINER, LETTERS, MARGIN, ROW, SAMPLE};
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// The page.
const PAGE: (u32, u32) = (480, 330);
/// The width of the vertical axis with its labels.
const LEFT: u32 = 70;
const SOLID: i32 = i32::MAX;

/// The look of a line: colour (of Okabe and Ito, distinct with any kind of sight), dash and gap,
/// and corners of the marker.
pub(super) struct Look {
    colour: RGBColor,
    dash: [i32; 2],
    marker: &'static [(i32, i32)],
}

pub(super) const LOOKS: [Look; 6] = [
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

/// The share of its line's colour that a band has, and the colour of marks.
const BAND: f64 = 0.22;
const MARK: RGBColor = RGBColor(110, 110, 110);

/// A figure with its points on their axes.
pub(super) struct Ready<'a> {
    pub(super) figure: &'a Figure,
    pub(super) lines: Vec<Vec<[f64; 2]>>,
    pub(super) scales: [Scale; 2],
}

impl Drawing for Ready<'_> {
    fn size(&self) -> (u32, u32) {
        (PAGE.0, PAGE.1 + self.figure.legend_height())
    }

    fn draw<DB: DrawingBackend>(&self, root: &Area<DB>) -> Result<(), String> {
        let (figure, [x, y]) = (self.figure, &self.scales);
        let text = |error: DrawingAreaErrorKind<DB::ErrorType>| error.to_string();
        root.fill(&WHITE).map_err(text)?;
        let (legend, rest) = root.split_vertically(figure.legend_height() * FINER);
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
            .x_desc(figure.x.label.as_str())
            .y_desc(figure.y.label.as_str())
            .x_labels(x.ticks())
            .y_labels(y.ticks())
            .draw()
            .map_err(text)?;
        for band in &figure.bands {
            let corners = figure.outline(band);
            let colour = LOOKS[band.line.min(LOOKS.len() - 1)].colour.mix(BAND);
            chart
                .draw_series([Polygon::new(corners, colour.filled())])
                .map_err(text)?;
        }
        for mark in &figure.marks {
            let ends = mark.ends(figure, [x, y]);
            let line = DashedPathElement::new(ends.to_vec(), 40, 40, MARK.stroke_width(8));
            chart.draw_series([line]).map_err(text)?;
            let at = chart.backend_coord(&ends[0]);
            root.draw(&mark.label(root, at)).map_err(text)?;
        }
        for (index, points) in self.lines.iter().enumerate() {
            let look = &LOOKS[index];
            let path: Vec<(f64, f64)> = points.iter().map(|point| (point[0], point[1])).collect();
            let every = (path.len() / MARKERS).max(1);
            // begun apart, so that lines that lie on each other show both markers
            let first = (index * every / self.lines.len()).min(every - 1);
            let marked: Vec<(f64, f64)> = path.iter().copied().skip(first).step_by(every).collect();
            let [dash, gap] = look.dash;
            let is_joined = index < figure.lines.len();
            let marked = if is_joined { marked } else { path.clone() };
            if is_joined {
                let line = DashedPathElement::new(path, dash, gap, look.style());
                chart.draw_series([line]).map_err(text)?;
            }
            if self.lines.len() > 1 {
                for at in marked {
                    let marker = look.marker_at(chart.backend_coord(&at));
                    root.draw(&marker).map_err(text)?;
                }
            }
        }
        figure.draw_legend(&legend).map_err(text)
    }
}

impl Figure {
    /// The corners of a band, there and back.
    fn outline(&self, band: &Band) -> Vec<(f64, f64)> {
        let side = |k: usize| {
            let points = band.points.iter();
            points.map(move |point| (self.x.place(point[0]), self.y.place(point[k])))
        };
        let back: Vec<_> = side(2).collect();
        side(1).chain(back.into_iter().rev()).collect()
    }

    /// A row for each of several lines, above the axes, where it hides nothing.
    fn legend_height(&self) -> u32 {
        match u32::try_from(self.lines.len() + self.dots.len()) {
            Ok(rows) if rows > 1 => MARGIN / 2 + ROW * rows,
            _ => 0,
        }
    }

    fn draw_legend<DB: DrawingBackend>(
        &self,
        area: &Area<DB>,
    ) -> Result<(), DrawingAreaErrorKind<DB::ErrorType>> {
        if self.legend_height() == 0 {
            return Ok(());
        }
        let unit = |units: u32| i32::try_from(units * FINER).unwrap_or(0);
        let left = unit(MARGIN + LEFT);
        let mut height = unit(MARGIN / 2) + unit(ROW) / 2;
        for (index, (line, look)) in self.lines.iter().chain(&self.dots).zip(&LOOKS).enumerate() {
            let [dash, gap] = look.dash;
            let ends = [(left, height), (left + SAMPLE, height)];
            if index < self.lines.len() {
                let dash = dash.min(SAMPLE);
                area.draw(&DashedPathElement::new(ends, dash, gap, look.style()))?;
            }
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

impl Mark {
    /// The ends of its line on the axes; its name stands at the first.
    fn ends(&self, figure: &Figure, [x, y]: [&Scale; 2]) -> [(f64, f64); 2] {
        if self.is_abscissa {
            let (place, ends) = (figure.x.place(self.at), y.range());
            [(place, ends.start), (place, ends.end)]
        } else {
            let (place, ends) = (figure.y.place(self.at), x.range());
            [(ends.start, place), (ends.end, place)]
        }
    }

    /// The name of the figure, within the axes.
    fn label<'a, DB: DrawingBackend>(
        &'a self,
        area: &Area<DB>,
        (x, y): (i32, i32),
    ) -> Text<'a, (i32, i32), &'a str> {
        let font = ("sans-serif", LETTERS - 24).into_font().color(&MARK);
        let style = font.into_text_style(area);
        // where a curve seldom is: above the foot of a line upwards, on the side with more room
        let (width, _) = area.dim_in_pixel();
        let is_right = f64::from(x) > 0.6 * f64::from(width);
        let (place, across) = match (self.is_abscissa, is_right) {
            (false, _) => ((x + 60, y - 50), HPos::Left),
            (true, false) => ((x + 50, y - 350), HPos::Left),
            (true, true) => ((x - 50, y - 350), HPos::Right),
        };
        let position = Pos::new(across, VPos::Bottom);
        Text::new(self.name.as_str(), place, style.pos(position))
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
