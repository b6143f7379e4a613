//! Nets: a refined scene unfolded into a page, in SVG and PDF.
//!
//! All walls have one scale. A quantity is shaded from dark violet over green to yellow, in a scale
//! of even steps of lightness that any kind of sight tells apart; lights are white, with their
//! diagonals. The page is 640 units wide at most and as high as the net needs, with a legend above.
//! It is drawn ten times finer, as the drawing library rounds to whole units.
//!
//! **Not here**: computing.

mod labels;
mod legend;

use self::labels::{Label, Labels};
use self::legend::{HEIGHT, LINKED, Legend, draw_light};
use super::sheet::{Area, Drawing};
use super::units::{FINER, LETTERS, MARGIN, ROW};
use crate::question::{MeshNet, NetWall};
use crate::report::ReportError;
use glam::DVec2;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// A quantity over the walls of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Net {
    /// The name of the quantity.
    pub quantity: String,
    /// The walls and the cells.
    pub mesh: MeshNet,
    /// Are the leaves outlined?
    pub has_outlines: bool,
}

/// The longest sides of a net on the page, and the least width of a page.
const WIDEST: f64 = 6160.0;
const HIGHEST: f64 = 6160.0;
const NARROWEST: f64 = 4560.0;
/// The length by which cells reach over their seams.
const SEAM: f64 = 6.0;
/// A bound on how far the corners of sharp cells reach.
const SHARPEST: f64 = 0.6;
type Refusal<DB> = DrawingAreaErrorKind<<DB as DrawingBackend>::ErrorType>;

/// The scale and the place of a net on its page.
struct Place {
    scale: f64,
    left: f64,
    top: f64,
    corner: [f64; 2],
    size: (u32, u32),
}

impl Net {
    /// The net as an SVG file.
    ///
    /// # Errors
    /// [`ReportError::NotFinite`] if a number is not finite; [`ReportError::Figure`] if there is
    /// nothing to draw.
    pub fn to_svg(&self) -> Result<String, ReportError> {
        self.page()?.svg()
    }

    /// The net as a PDF file of one page.
    ///
    /// # Errors
    /// As [`to_svg`](Self::to_svg).
    pub fn to_pdf(&self) -> Result<Vec<u8>, ReportError> {
        self.page()?.pdf()
    }

    /// The net, checked and laid out.
    fn page(&self) -> Result<NetPage<'_>, ReportError> {
        let cells = || self.mesh.cells.iter();
        let values = || cells().filter_map(|cell| cell.value);
        let places = || cells().flat_map(|cell| cell.corners.iter().flatten());
        if !values().chain(places().copied()).all(f64::is_finite) {
            let key = self.quantity.clone();
            return Err(ReportError::NotFinite { key });
        }
        let place = self.place().ok_or_else(|| ReportError::Figure {
            reason: "it has no extent".to_owned(),
        })?;
        let range = [
            values().fold(f64::INFINITY, f64::min),
            values().fold(f64::NEG_INFINITY, f64::max),
        ];
        Ok(NetPage {
            net: self,
            legend: Legend {
                quantity: &self.quantity,
                range,
                has_light: cells().any(|cell| cell.value.is_none()),
                has_links: self.mesh.receiver.is_some(),
            },
            labels: place.labels(&self.mesh.walls),
            place,
        })
    }

    /// The scale at which the net fits onto a page; none if it has no extent.
    fn place(&self) -> Option<Place> {
        let corners = || self.mesh.cells.iter().flat_map(|cell| &cell.corners);
        let low = |k: usize| corners().map(|c| c[k]).fold(f64::INFINITY, f64::min);
        let high = |k: usize| corners().map(|c| c[k]).fold(f64::NEG_INFINITY, f64::max);
        let extent = [0, 1].map(|k| high(k) - low(k));
        if !extent
            .into_iter()
            .all(|length| length > 0.0 && length.is_finite())
        {
            return None;
        }
        let scale = (WIDEST / extent[0]).min(HIGHEST / extent[1]);
        let [across, up] = extent.map(|length| scale * length);
        let margin = f64::from(MARGIN * FINER);
        let width = across.max(NARROWEST);
        let top = f64::from(HEIGHT * FINER);
        Some(Place {
            scale,
            left: margin + 0.5 * (width - across),
            top,
            corner: [low(0), high(1)],
            size: (ceiled(width + 2.0 * margin), ceiled(top + up + margin)),
        })
    }
}

/// A net that is laid out on its page.
struct NetPage<'n> {
    net: &'n Net,
    place: Place,
    legend: Legend<'n>,
    labels: Labels,
}

impl Drawing for NetPage<'_> {
    fn size(&self) -> (u32, u32) {
        let below = u32::try_from(self.labels.below.len()).unwrap_or(0) * ROW;
        let (width, height) = self.place.size;
        (width / FINER, height / FINER + below)
    }

    fn draw<DB: DrawingBackend>(&self, area: &Area<DB>) -> Result<(), String> {
        self.drawn(area).map_err(|error| error.to_string())
    }
}

impl NetPage<'_> {
    fn drawn<DB: DrawingBackend>(&self, root: &Area<DB>) -> Result<(), Refusal<DB>> {
        let (mesh, place) = (&self.net.mesh, &self.place);
        root.fill(&WHITE)?;
        for cell in &mesh.cells {
            if let Some(value) = cell.value {
                let corners = grown(&place.places(&cell.corners));
                root.draw(&Polygon::new(corners, self.legend.colour(value).filled()))?;
            }
        }
        // over what reaches into them
        for light in mesh.cells.iter().filter(|cell| cell.value.is_none()) {
            let corners = rounded(&place.places(&light.corners));
            draw_light(root, &corners)?;
        }
        if self.net.has_outlines {
            for leaf in &mesh.leaves {
                root.draw(&place.outline(leaf, BLACK.mix(0.4).stroke_width(4)))?;
            }
        }
        for source in &mesh.sources {
            root.draw(&place.outline(source, LINKED.stroke_width(12)))?;
        }
        if let Some(receiver) = &mesh.receiver {
            let corners = rounded(&place.places(receiver));
            root.draw(&Polygon::new(corners, LINKED.filled()))?;
        }
        for wall in &mesh.walls {
            for edge in &wall.border {
                let ends = rounded(&place.places(edge));
                root.draw(&PathElement::new(ends, BLACK.stroke_width(12)))?;
            }
        }
        draw_labels(root, &self.labels, place.size.1)?;
        self.legend.draw(root)
    }
}

impl Place {
    fn places(&self, corners: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let [left, high] = self.corner;
        let place = |[x, y]: &[f64; 2]| {
            let (right, down) = (self.scale * (x - left), self.scale * (high - y));
            [self.left + right, self.top + down]
        };
        corners.iter().map(place).collect()
    }

    fn outline(&self, corners: &[[f64; 2]], style: ShapeStyle) -> PathElement<(i32, i32)> {
        let mut places = rounded(&self.places(corners));
        places.extend(places.first().copied());
        PathElement::new(places, style)
    }

    fn labels(&self, walls: &[NetWall]) -> Labels {
        let walls = walls.iter().map(|wall| {
            let edges = wall.border.iter().map(|edge| {
                let ends = self.places(edge);
                [ends[0], ends[1]]
            });
            (wall.name.as_str(), edges.collect())
        });
        Labels::new(walls, f64::from(self.size.0))
    }
}

/// Writes the labels inside of walls on white boards, and the lines below the net.
fn draw_labels<DB: DrawingBackend>(
    root: &Area<DB>,
    labels: &Labels,
    bottom: u32,
) -> Result<(), Refusal<DB>> {
    let style = |side: HPos| {
        let font = ("sans-serif", LETTERS).into_font();
        font.into_text_style(root).pos(Pos::new(side, VPos::Center))
    };
    for Label { text, middle, half } in &labels.inside {
        let end = |sign: f64| [middle[0] + sign * half[0], middle[1] + sign * half[1]];
        let board = rounded(&[end(-1.0), end(1.0), *middle]);
        root.draw(&Rectangle::new(
            [board[0], board[1]],
            WHITE.mix(0.8).filled(),
        ))?;
        root.draw(&Text::new(text.as_str(), board[2], style(HPos::Center)))?;
    }
    let unit = |units: u32| i32::try_from(units * FINER).unwrap_or(0);
    let mut height = i32::try_from(bottom).unwrap_or(0) + unit(ROW) / 2;
    for line in &labels.below {
        root.draw(&Text::new(
            line.as_str(),
            (unit(MARGIN), height),
            style(HPos::Left),
        ))?;
        height += unit(ROW);
    }
    Ok(())
}

/// The corners of a convex cell with its edges moved outwards over their seams.
fn grown(corners: &[[f64; 2]]) -> Vec<(i32, i32)> {
    let mut corners: Vec<DVec2> = corners.iter().map(|corner| DVec2::from(*corner)).collect();
    corners.dedup_by(|one, other| one.distance(*other) < 0.5);
    let count = corners.len();
    let edge = |k: usize| corners[(k + 1) % count] - corners[k % count];
    let doubled: f64 = (0..count)
        .map(|k| corners[k].perp_dot(corners[(k + 1) % count]))
        .sum();
    let outwards = |k: usize| -edge(k).perp().normalize_or_zero() * doubled.signum();
    let moved = (0..count).map(|k| {
        let (before, after) = (outwards(k + count - 1), outwards(k));
        let miter = (before + after) / (1.0 + before.dot(after)).max(SHARPEST);
        (corners[k] + SEAM * miter).to_array()
    });
    rounded(&moved.collect::<Vec<_>>())
}

#[expect(clippy::cast_possible_truncation, reason = "the page's units are few")]
fn rounded(places: &[[f64; 2]]) -> Vec<(i32, i32)> {
    let whole = |[x, y]: &[f64; 2]| (x.round() as i32, y.round() as i32);
    places.iter().map(whole).collect()
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the page's units are few, and rounded to whole ones"
)]
fn ceiled(length: f64) -> u32 {
    (length / f64::from(FINER)).max(0.0).ceil() as u32 * FINER
}
