//! A pair as the routes see it: what of each polygon is in front of the other's plane, and measures of both.

use super::gauss_points;
use super::horizon::{Off, Side, side_of};
use super::shape::Shape;
use super::{Answer, ExchangeArea, FormFactorError, Polygon, Route};
use glam::DVec3;
use std::f64::consts::PI;

/// Gauss points per direction from which on other routes are cheaper.
pub(super) const MOST: usize = 17;

/// What of a pair is in front of the other's plane, with measures that the choice rests on.
pub(super) struct View<'a> {
    pub polygons: [&'a Polygon; 2],
    pub shapes: [&'a Shape; 2],
    pub heights: [&'a [f64]; 2],
    /// A lower bound on the distance between the two; not positive if they may touch.
    pub gap: f64,
    /// An upper bound on all distances.
    pub reach: f64,
    /// What corners may be off.
    pub off: Off,
    /// What that changes at most, per length: by flux through ribbons; for polygons apart, relative to the value, by other
    /// heights, and by other areas and distances.
    ribbons: f64,
    by_height: f64,
    by_place: f64,
    /// An idea of the value.
    pub estimate: f64,
    pub tolerance: f64,
}

/// What `route` makes of a pair; nothing is asked of it if one polygon is behind the other's plane, or in it.
pub(super) fn seen(
    polygons: [&Polygon; 2],
    tolerance: f64,
    route: impl FnOnce(&View) -> Result<Answer, FormFactorError>,
) -> Result<Answer, FormFactorError> {
    let [first, second] = polygons;
    let (above_second, first_off) = side_of(first, second);
    let (above_first, second_off) = side_of(second, first);
    let off = first_off.max(second_off);
    let sides = [&above_second, &above_first];
    let [Some(first_heights), Some(second_heights)] = sides.map(Side::heights) else {
        let within = sides.iter().all(|side| matches!(side, Side::Within));
        return Ok(Answer {
            exchange: ExchangeArea {
                value: 0.0,
                error_bound: 2.0 * off.height * (first.perimeter() + second.perimeter()),
            },
            route: if within {
                Route::Coplanar
            } else {
                Route::BackFacing
            },
        });
    };
    let shapes = [
        above_second.shape(&first.shape),
        above_first.shape(&second.shape),
    ];
    let view = View::new(
        polygons,
        shapes,
        [first_heights, second_heights],
        off,
        tolerance,
    );
    route(&view)
}

impl<'a> View<'a> {
    fn new(
        polygons: [&'a Polygon; 2],
        shapes: [&'a Shape; 2],
        heights: [&'a [f64]; 2],
        off: Off,
        tolerance: f64,
    ) -> Self {
        let [first, second] = shapes;
        let between = second.centre - first.centre;
        let distance = between.length();
        let corners = first
            .corners
            .iter()
            .flat_map(|x| second.corners.iter().map(|y| (*x - *y).length_squared()));
        let reach = corners.fold(0.0, f64::max).sqrt() * (1.0 + 4.0 * f64::EPSILON);
        // planes that have one polygon on one side and the other on the other: across the centres' line, and their own
        let farthest = |shape: &Shape, direction: DVec3| {
            let along = shape
                .corners
                .iter()
                .map(|c| (*c - first.centre).dot(direction));
            along.fold(f64::NEG_INFINITY, f64::max)
        };
        let least = |heights: &[f64]| heights.iter().copied().fold(f64::INFINITY, f64::min);
        let direction = between / distance;
        let apart = -farthest(second, -direction) - farthest(first, direction);
        let gap = apart.max(least(heights[0])).max(least(heights[1])) - 8.0 * f64::EPSILON * reach;
        #[allow(clippy::cast_precision_loss, reason = "a number of corners")]
        let means = heights.map(|heights| heights.iter().sum::<f64>() / heights.len() as f64);
        let gap = if gap > 0.0 { gap } else { 0.0 };
        let spread = if gap > 0.0 {
            (reach / gap).powi(4)
        } else {
            f64::INFINITY
        };
        // heights h weighted by the kernel K: Σ K/Σ h K is at most 1/h_min, and at most (K_max/K_min)/h_mean
        let sensitivities = [0, 1].map(|k| (1.0 / least(heights[k])).min(spread / means[k]));
        let received = |shape: &Shape| (shape.area / (PI * gap * gap)).min(1.0);
        let ribbons = first.perimeter * received(second) + second.perimeter * received(first);
        // corners that are off by δ change heights, areas and r⁴, too: relative to the value
        let by_place = 4.0 / gap + first.perimeter / first.area + second.perimeter / second.area;
        // between the far formula and that of two patches near to each other
        let square = distance * distance + first.area.max(second.area) / PI;
        let cosines = means[0] * means[1] / (distance * distance).max(means[0] * means[1]);
        let estimate = first.area * second.area * cosines / (PI * square);
        Self {
            polygons,
            shapes,
            heights,
            gap,
            reach,
            off,
            ribbons: 2.0 * ribbons,
            by_height: 2.0 * (sensitivities[0] + sensitivities[1]),
            by_place: 2.0 * by_place,
            estimate,
            tolerance,
        }
    }

    /// What corners that are off may change. The kernel takes its heights from the corners', which are exact where a clip put
    /// them on the plane; for all others a corner out of place is at another height, too.
    pub(super) fn slack(&self, off: Off, value: f64, route: Route) -> f64 {
        let Off { height, place } = off;
        let heights = if route == Route::Kernel {
            height
        } else {
            height + place
        };
        let relative = heights * self.by_height + (height + place) * self.by_place;
        ((height + place) * self.ribbons).min(relative * value.abs())
    }

    /// The absolute error that truncation may have.
    pub(super) fn wanted(&self) -> f64 {
        0.3 * self.tolerance.max(4.0 * f64::EPSILON) * self.estimate
    }

    /// Gauss points per direction on one of the shapes.
    pub(super) fn points(&self, k: usize) -> usize {
        let (largest, wanted) = (self.largest(), self.wanted());
        (2..MOST)
            .find(|n| self.truncation(k, *n, largest) <= wanted)
            .unwrap_or(MOST)
    }

    /// A bound on the error of a rule on one of the shapes.
    pub(super) fn truncation(&self, k: usize, points: usize, largest: f64) -> f64 {
        gauss_points::error(points, self.gap / self.shapes[k].half_length) * largest
    }

    /// `area × area × h_max g_max / (π gap⁴)`.
    pub(super) fn largest(&self) -> f64 {
        let highest = self.heights.map(|h| h.iter().copied().fold(0.0, f64::max));
        let areas = self.shapes[0].area * self.shapes[1].area;
        areas * highest[0] / self.gap * (highest[1] / self.gap) / (PI * self.gap * self.gap)
    }
}

/// A bound on `θ/sin θ` for the angle θ that an edge subtends at a distance: beyond a right angle only that θ is at most π.
pub(super) fn widening(length: f64, distance: f64) -> f64 {
    let half = 0.5 * length / distance;
    if half <= 1.0 {
        half.atan() * (1.0 + half * half) / half
    } else {
        PI
    }
}
