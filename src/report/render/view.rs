//! Small views of scenes in perspective, in SVG and PDF.
//!
//! Patches are seen from in front, above and aside; those whose fronts face away are left out, so
//! that one looks into a room. The farthest is drawn first.
//!
//! **Not covered**: patches that pass through each other.

use super::sheet::{Area, Drawing};
use super::units::FINER;
use crate::geometry::mean;
use crate::question::ReportedScene;
use crate::report::ReportError;
use glam::{DVec2, DVec3};
use plotters::prelude::*;

/// Width and height of a view, in units, and its margin.
const PAGE: (u32, u32) = (180, 150);
const AIR: f64 = 8.0;
/// The direction to the eye, and its distance in sizes of the scene.
const ASIDE: DVec3 = DVec3::new(1.9, 1.15, 1.25);
const DISTANCE: f64 = 3.2;
/// The direction of the light that shades patches.
const LIGHT: DVec3 = DVec3::new(0.35, 0.5, 0.79);
/// The ground colours of patches and of the patch that is cut.
const PLAIN: [f64; 3] = [232.0, 235.0, 239.0];
const CUT: [f64; 3] = [158.0, 202.0, 225.0];
const EDGE: RGBColor = RGBColor(70, 70, 75);
const LINE: RGBColor = RGBColor(213, 94, 0);

/// A patch as seen: its outline on the page, ten times finer, and its colour.
struct Seen {
    outline: Vec<(i32, i32)>,
    depth: f64,
    colour: RGBColor,
}

/// A scene as seen.
pub(crate) struct View {
    patches: Vec<Seen>,
    lines: Vec<[(i32, i32); 2]>,
}

/// An eye that looks at a point.
struct Eye {
    place: DVec3,
    ahead: DVec3,
    right: DVec3,
    up: DVec3,
}

impl Eye {
    fn at(centre: DVec3, size: f64) -> Self {
        let place = centre + DISTANCE * size * ASIDE.normalize();
        let ahead = (centre - place).normalize();
        let right = ahead.cross(DVec3::Z).normalize();
        let up = right.cross(ahead);
        Self {
            place,
            ahead,
            right,
            up,
        }
    }

    fn project(&self, point: DVec3) -> DVec2 {
        let away = point - self.place;
        DVec2::new(away.dot(self.right), -away.dot(self.up)) / away.dot(self.ahead)
    }
}

impl View {
    /// The view of a scene.
    ///
    /// # Errors
    /// [`ReportError::Figure`] if nothing of it is seen.
    pub(crate) fn of(scene: &ReportedScene) -> Result<Self, ReportError> {
        let nothing = || ReportError::Figure {
            reason: format!("nothing is seen of {}", scene.name),
        };
        let points = || {
            scene
                .patches
                .iter()
                .flatten()
                .map(|corner| DVec3::from_array(*corner))
        };
        let low = points().reduce(DVec3::min).ok_or_else(nothing)?;
        let high = points().reduce(DVec3::max).ok_or_else(nothing)?;
        let eye = Eye::at(0.5 * (low + high), (high - low).length());
        let seen: Vec<_> = scene
            .patches
            .iter()
            .enumerate()
            .filter_map(|(index, corners)| {
                let corners: Vec<DVec3> = corners.iter().map(|c| DVec3::from_array(*c)).collect();
                let normal = area_vector(&corners).normalize_or_zero();
                let centre = mean(&corners);
                let is_front = normal.dot(eye.place - centre) > 0.0;
                let flat: Vec<DVec2> = corners.iter().map(|corner| eye.project(*corner)).collect();
                let ground = if scene.cut_patch == Some(index) {
                    CUT
                } else {
                    PLAIN
                };
                let depth = (centre - eye.place).length();
                is_front.then(|| (flat, depth, shaded(ground, normal)))
            })
            .collect();
        let flat = || seen.iter().flat_map(|patch| patch.0.iter().copied());
        let [from, to] = [flat().reduce(DVec2::min), flat().reduce(DVec2::max)];
        let (from, to) = from.zip(to).ok_or_else(nothing)?;
        let [width, height] = [PAGE.0, PAGE.1].map(f64::from);
        let extent = to - from;
        let scale = ((width - 2.0 * AIR) / extent.x).min((height - 2.0 * AIR) / extent.y);
        let place = |point: DVec2| {
            let middle = 0.5 * DVec2::new(width, height);
            let at = f64::from(FINER) * (middle + scale * (point - 0.5 * (from + to)));
            #[expect(clippy::cast_possible_truncation, reason = "the page's units are few")]
            let at = (at.x.round() as i32, at.y.round() as i32);
            at
        };
        let mut patches: Vec<Seen> = seen
            .iter()
            .map(|(flat, depth, colour)| Seen {
                outline: flat.iter().copied().map(place).collect(),
                depth: *depth,
                colour: *colour,
            })
            .collect();
        patches.sort_by(|a, b| b.depth.total_cmp(&a.depth));
        let ends = |line: &[[f64; 3]; 2]| line.map(|end| place(eye.project(end.into())));
        let lines = scene.lines.iter().map(ends).collect();
        Ok(Self { patches, lines })
    }
}

/// Twice the area of a polygon along its normal.
fn area_vector(corners: &[DVec3]) -> DVec3 {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(a, b)| a.cross(*b)).sum()
}

/// A ground colour, darker where it faces away from the light.
fn shaded(ground: [f64; 3], normal: DVec3) -> RGBColor {
    let share = 0.78 + 0.22 * normal.dot(LIGHT).abs();
    let [r, g, b] = ground.map(|part| {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "from 0 to 255"
        )]
        let part = (share * part) as u8;
        part
    });
    RGBColor(r, g, b)
}

impl Drawing for View {
    fn size(&self) -> (u32, u32) {
        PAGE
    }

    fn draw<DB: DrawingBackend>(&self, area: &Area<DB>) -> Result<(), String> {
        let refused = |error: DrawingAreaErrorKind<DB::ErrorType>| error.to_string();
        for patch in &self.patches {
            let filled = Polygon::new(patch.outline.clone(), patch.colour.filled());
            area.draw(&filled).map_err(refused)?;
            let closed = patch.outline.iter().chain(patch.outline.first()).copied();
            let edge = PathElement::new(closed.collect::<Vec<_>>(), EDGE.stroke_width(7));
            area.draw(&edge).map_err(refused)?;
        }
        for line in &self.lines {
            let drawn = PathElement::new(line.to_vec(), LINE.stroke_width(18));
            area.draw(&drawn).map_err(refused)?;
        }
        Ok(())
    }
}
