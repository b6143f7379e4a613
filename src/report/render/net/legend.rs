//! The legend of a net: the scale of its colours, and samples of lights and links.

use crate::report::render::scale::Scale;
use crate::report::render::units::{FINER, LETTERS, MARGIN, ROW};
use plotters::coord::Shift;
use plotters::coord::ranged1d::{Ranged, ValueFormatter};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// The colour of links (of Okabe and Ito).
pub(super) const LINKED: RGBColor = RGBColor(213, 94, 0);
/// The colour of the lines by which a light is known.
const RAYS: RGBColor = RGBColor(150, 150, 150);
/// The height of the legend.
pub(super) const HEIGHT: u32 = 3 * ROW + 12;
/// The width and the height of the bar of colours, and its steps.
const BAR: (i32, i32) = (2400, 140);
const STEPS: i32 = 120;
/// Ticks whose names have room below the bar.
const MOST_TICKS: usize = 4;
/// The place on the bar up to which a tick has its name to the right.
const FIRST: i32 = 200;
const LIGHT: &str = "light";
/// The side of a sample.
const SAMPLE: i32 = 140;

/// The meaning of the colours of a net.
pub(super) struct Legend<'n> {
    pub(super) quantity: &'n str,
    /// The lowest and the highest value.
    pub(super) range: [f64; 2],
    pub(super) has_light: bool,
    pub(super) has_links: bool,
}

type Drawn<DB> = Result<(), DrawingAreaErrorKind<<DB as DrawingBackend>::ErrorType>>;

impl Legend<'_> {
    /// The colour of a value.
    pub(super) fn colour(&self, value: f64) -> RGBColor {
        ViridisRGB::get_color_normalized(self.share(value), 0.0, 1.0)
    }

    /// The place of a value from the lowest to the highest, 0 to 1; of one value only, the middle.
    fn share(&self, value: f64) -> f64 {
        let [low, high] = self.range;
        if high > low {
            (value - low) / (high - low)
        } else {
            0.5
        }
    }

    pub(super) fn draw<DB: DrawingBackend>(&self, root: &DrawingArea<DB, Shift>) -> Drawn<DB> {
        let left = unit(MARGIN);
        let text = |text: &str, place: (i32, i32), side: HPos| {
            let font = ("sans-serif", LETTERS).into_font();
            let style = font.into_text_style(root).pos(Pos::new(side, VPos::Center));
            root.draw(&Text::new(text.to_owned(), place, style))
        };
        text(
            self.quantity,
            (left, unit(MARGIN) / 2 + unit(ROW) / 2),
            HPos::Left,
        )?;
        let top = unit(MARGIN) / 2 + unit(ROW);
        self.draw_bar(root, (left, top))?;
        let mut place = (left + BAR.0 + unit(40), unit(MARGIN) / 2 + unit(ROW) / 2);
        let samples = [
            (self.has_light, LIGHT, BLACK.stroke_width(8)),
            (self.has_links, "receiver", LINKED.filled()),
            (
                self.has_links,
                "where its light is from",
                LINKED.stroke_width(12),
            ),
        ];
        for (_, name, style) in samples.into_iter().filter(|(is_there, ..)| *is_there) {
            let corner = (place.0, place.1 - SAMPLE / 2);
            let ends = [corner, (corner.0 + SAMPLE, corner.1 + SAMPLE)];
            if name == LIGHT {
                draw_light(root, &corners(ends))?;
            }
            draw_box(root, ends, style)?;
            text(name, (place.0 + SAMPLE + 80, place.1), HPos::Left)?;
            place.1 += unit(ROW);
        }
        Ok(())
    }

    /// Draws the bar of colours with its ticks below.
    fn draw_bar<DB: DrawingBackend>(
        &self,
        root: &DrawingArea<DB, Shift>,
        (left, top): (i32, i32),
    ) -> Drawn<DB> {
        let [low, high] = self.range;
        if low > high {
            // there is nothing but light
            return Ok(());
        }
        for step in 0..STEPS {
            let at = |step: i32| left + BAR.0 * step / STEPS;
            let share = (f64::from(step) + 0.5) / f64::from(STEPS);
            let colour = self.colour(low + share * (high - low));
            // over the seam to the right, which the next one covers
            let ends = [(at(step), top), (at(STEPS.min(step + 2)), top + BAR.1)];
            root.draw(&Rectangle::new(ends, colour.filled()))?;
        }
        let ends = [(left, top), (left + BAR.0, top + BAR.1)];
        draw_box(root, ends, BLACK.stroke_width(8))?;
        let Some(scale) = Scale::new(false, (low, high), true) else {
            return Ok(());
        };
        let mut ticks = scale.key_points(scale.ticks());
        ticks.retain(|tick| (low..=high).contains(tick));
        let every = ticks.len().div_ceil(MOST_TICKS).max(1);
        for tick in ticks.iter().step_by(every) {
            let name = Scale::format_ext(&scale, tick);
            self.draw_tick(root, (left, top + BAR.1), *tick, &name)?;
        }
        Ok(())
    }

    /// Draws a tick below the bar whose lower left corner is given.
    fn draw_tick<DB: DrawingBackend>(
        &self,
        root: &DrawingArea<DB, Shift>,
        (left, top): (i32, i32),
        tick: f64,
        name: &str,
    ) -> Drawn<DB> {
        #[expect(clippy::cast_possible_truncation, reason = "the bar's units are few")]
        let right = (self.share(tick) * f64::from(BAR.0)).round() as i32;
        let mark = [(left + right, top), (left + right, top + 40)];
        root.draw(&PathElement::new(mark, BLACK.stroke_width(8)))?;
        // the first one may not leave the page
        let (side, from) = if right < FIRST {
            (HPos::Left, left)
        } else {
            (HPos::Center, left + right)
        };
        let font = ("sans-serif", LETTERS).into_font();
        let style = font.into_text_style(root).pos(Pos::new(side, VPos::Top));
        root.draw(&Text::new(name.to_owned(), (from, top + 55), style))
    }
}

/// Draws a light: white, with lines from its corners to its middle.
pub(super) fn draw_light<DB: DrawingBackend>(
    root: &DrawingArea<DB, Shift>,
    corners: &[(i32, i32)],
) -> Drawn<DB> {
    root.draw(&Polygon::new(corners, WHITE.filled()))?;
    let count = i32::try_from(corners.len()).unwrap_or(i32::MAX);
    let (right, down) = corners
        .iter()
        .fold((0, 0), |sum, c| (sum.0 + c.0, sum.1 + c.1));
    let middle = (right / count, down / count);
    for corner in corners {
        root.draw(&PathElement::new([*corner, middle], RAYS.stroke_width(6)))?;
    }
    Ok(())
}

/// Draws a rectangle: filled, or its outline.
fn draw_box<DB: DrawingBackend>(
    root: &DrawingArea<DB, Shift>,
    ends: [(i32, i32); 2],
    style: ShapeStyle,
) -> Drawn<DB> {
    let mut corners = corners(ends).to_vec();
    corners.push(corners[0]);
    if style.filled {
        return root.draw(&Polygon::new(corners, style));
    }
    root.draw(&PathElement::new(corners, style))
}

fn corners([low, high]: [(i32, i32); 2]) -> [(i32, i32); 4] {
    [low, (high.0, low.1), high, (low.0, high.1)]
}

fn unit(units: u32) -> i32 {
    i32::try_from(units * FINER).unwrap_or(0)
}
