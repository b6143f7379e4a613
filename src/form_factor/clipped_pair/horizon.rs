//! The part of each polygon in front of the other's plane.
//!
//! A height above a plane is taken in `f64` first; near zero it is taken again to 106 bits. A
//! corner counts as on the plane if its height is within the rounding of the coordinates it came
//! from. Such a corner may be off by δ; that changes what the two exchange by at most
//!
//! ```text
//!   |Δ(A F)| ≤ 2 δ (perimeter of one + perimeter of the other)
//! ```
//!
//! because the vector irradiance of a Lambertian polygon has no sources outside it: what passes
//! through the old and the new outline differs by what passes through the ribbon between them,
//! whose area is at most δ times the perimeter, and no point receives more than 1 per area; twice
//! that, as the other polygon's horizon moves along. A corner that a clip puts in place and rounds
//! moves nothing else, and its ribbon is two triangles, of area δ times half the edges that meet
//! there.
//!
//! Where a height counts as 0 and lies h on the other side, the clip is not where it should be: a
//! strip is on the wrong side, however small h is beside rounding. Lines of one height in a convex
//! cell with heights up to H have a length concave in the height, so that no more than 4 h/H of its
//! area is within h of the plane; with H known to h, too, 5 h/H; and no point receives more than 1.
//! Polygons all of whose heights count as 0 lie in one plane, by definition.

use super::shape::Shape;
use crate::form_factor::Polygon;
use crate::geometry::{ClippedCorner, Vector, clip, clipped};
use crate::numeric::{DoubleDouble, vector_value};
use glam::DVec3;
use smallvec::SmallVec;

/// Heights of corners above the other polygon's plane, all ≥ 0, each within 3 ε of the distance.
pub(crate) type Heights = SmallVec<[f64; 4]>;

/// The part of a polygon in front of another one's plane.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum FrontPart {
    /// Nothing: the polygon lies in the plane.
    Within,
    /// Nothing: the polygon lies behind the plane, or behind it and in it.
    Behind,
    /// All of it.
    Front,
    /// The part that a clip leaves.
    Clipped(Box<Shape>),
}

/// Upper bounds on the displacement of corners.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Displacement {
    /// Above or below the other polygon's plane.
    pub height: f64,
    /// Anywhere, and the area of the ribbons that this leaves.
    pub place: f64,
    pub ribbon: f64,
    /// The area that may be on the wrong side of a clip; and of that only what the tilt of a plane
    /// does.
    pub strip: f64,
    pub tilted_strip: f64,
}

impl Displacement {
    /// The bounds for both polygons: the larger distance, and the sum of areas.
    pub(crate) const fn and(self, other: Self) -> Self {
        Self {
            height: self.height.max(other.height),
            place: self.place.max(other.place),
            ribbon: self.ribbon + other.ribbon,
            strip: self.strip + other.strip,
            tilted_strip: self.tilted_strip + other.tilted_strip,
        }
    }
}

impl FrontPart {
    /// Tells whether any of the polygon is in front.
    pub(crate) const fn is_in_front(&self) -> bool {
        matches!(self, Self::Front | Self::Clipped(_))
    }

    /// The outline in front of the plane, of a polygon that was `whole` before.
    pub(crate) fn shape<'a>(&'a self, whole: &'a Shape) -> &'a Shape {
        match self {
            Self::Clipped(shape) => shape,
            _ => whole,
        }
    }
}

/// Finds the part of a polygon in front of another one's plane, with bounds on the displacement of
/// its corners.
///
/// **Arguments** `heights`: empty; those of what is in front are put there.
pub(crate) fn side_of(
    polygon: &Polygon,
    plane: &Polygon,
    heights: &mut Heights,
) -> (FrontPart, Displacement) {
    let (shape, origin) = (&polygon.shape, plane.shape.corners[0]);
    let reach = shape.largest;
    // what the rounding of coordinates may do to a height
    let noise = 4.0 * f64::EPSILON * (reach + origin.abs().max_element());
    let distance = shape.centre.distance(origin) + shape.radius;
    let tilted = plane.tilt * distance;
    let mut slack = tilted;
    // how far corners that count as on the plane are below and above it
    let (mut below, mut above) = (f64::NEG_INFINITY, f64::NEG_INFINITY);
    let mut refined = |corner: &DVec3| -> f64 {
        let height = if plane.shape.corners.contains(corner) {
            0.0
        } else {
            plane.height(*corner)
        };
        if height.abs() > noise + tilted {
            return height;
        }
        slack = f64::max(slack, height.abs());
        below = f64::max(below, -height);
        above = f64::max(above, height);
        0.0
    };
    // the product is within 3 ε of the distance: on which side it is, is known
    let certain = 4.0 * f64::EPSILON * distance + 64.0 * noise;
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for corner in &shape.corners {
        let product = (*corner - origin).dot(plane.normal);
        let height = if product.abs() > certain {
            product
        } else {
            refined(corner)
        };
        (least, most) = (least.min(height), most.max(height));
        heights.push(height);
    }
    let wrong_side = match (least >= 0.0, most <= 0.0) {
        (true, true) => f64::NEG_INFINITY,
        (true, false) => below,
        (false, true) => above,
        (false, false) => below.max(above).max(0.0),
    };
    let mut displacement = Displacement {
        height: slack,
        ..Displacement::default()
    };
    // none where every height is certain
    if wrong_side > f64::NEG_INFINITY {
        let widths = [wrong_side.max(0.0) + tilted, tilted];
        [displacement.strip, displacement.tilted_strip] = strips(shape, heights, widths);
    }
    match (least >= 0.0, most <= 0.0) {
        (true, true) => return (FrontPart::Within, displacement),
        (true, false) => return (FrontPart::Front, displacement),
        (false, true) => return (FrontPart::Behind, displacement),
        (false, false) => {}
    }
    let (corners, clipped_heights, moved) = outline_in_front(shape, plane, heights);
    // a coordinate of a new corner, no farther out than the old ones, is rounded once: half an ε of
    // each of three
    displacement.place = 0.87 * f64::EPSILON * reach;
    displacement.ribbon = displacement.place * moved;
    match Shape::new(&corners, polygon.precise_normal) {
        Some(shape) => {
            *heights = heights_of(&shape, &corners, &clipped_heights);
            (FrontPart::Clipped(Box::new(shape)), displacement)
        }
        None => (FrontPart::Behind, displacement),
    }
}

/// Bounds on the areas of a shape that are so near to the plane above which its corners have these
/// heights.
fn strips(shape: &Shape, heights: &[f64], near: [f64; 2]) -> [f64; 2] {
    let mut areas = [0.0; 2];
    for (cell, [j, js, jt]) in shape.cells.iter().zip(&shape.jacobians) {
        let highest = cell.iter().map(|i| heights[*i].abs()).fold(0.0, f64::max);
        let (area, per_height) = (j + 0.5 * (js + jt), 5.0 / highest);
        for (sum, near) in areas.iter_mut().zip(near) {
            // the whole cell where this is not a number
            *sum += area * f64::min(near * per_height, 1.0);
        }
    }
    areas
}

/// Corners, their heights, and half the lengths of edges that meet in new ones.
type Outline = (SmallVec<[DVec3; 8]>, SmallVec<[f64; 8]>, f64);

/// The outline of what lies in front of the plane, with new corners where edges cross it.
fn outline_in_front(shape: &Shape, plane: &Polygon, heights: &[f64]) -> Outline {
    let (mut corners, mut kept, mut moved) = Outline::default();
    let mut new: SmallVec<[usize; 8]> = SmallVec::new();
    clip(heights, |corner| match corner {
        ClippedCorner::Kept(i) => {
            corners.push(shape.corners[i]);
            kept.push(heights[i]);
        }
        ClippedCorner::Crossing { edge, .. } => {
            let ends = edge.map(|k| shape.corners[k]);
            new.push(corners.len());
            corners.push(crossing(ends, plane));
            kept.push(0.0);
        }
    });
    let count = corners.len();
    for i in new {
        let [before, after] = [corners[(i + count - 1) % count], corners[(i + 1) % count]];
        moved += 0.5 * (corners[i].distance(before) + corners[i].distance(after));
    }
    (corners, kept, moved)
}

/// The point where an edge crosses a plane, to 106 bits before the last rounding.
fn crossing(ends: [DVec3; 2], plane: &Polygon) -> DVec3 {
    vector_value!(DVec3::ZERO, {
        // one by one: a closure over both would not have the vector code's fused products
        let (from, to) = (plane.precise_height(ends[0]), plane.precise_height(ends[1]));
        let (start, end) = (Vector::lifted(ends[0], from), Vector::lifted(ends[1], from));
        let along = end.minus(start);
        start.plus(along, from / (from - to)).to_doubles()
    })
}

/// The corners of a polygon in front of another one's plane, to 106 bits.
pub(crate) fn precise_outline(polygon: &Polygon, plane: &Polygon) -> Vec<Vector<DoubleDouble>> {
    let zero = DoubleDouble::from(0.0);
    let corners = &polygon.shape.corners;
    let lifted: Vec<_> = corners
        .iter()
        .map(|corner| Vector::lifted(*corner, zero))
        .collect();
    let on_it = |corner: &DVec3| plane.shape.corners.contains(corner);
    let height = |corner: &DVec3| {
        if on_it(corner) {
            zero
        } else {
            plane.precise_height(*corner)
        }
    };
    let heights: Vec<DoubleDouble> = corners.iter().map(height).collect();
    clipped(&lifted, &heights, |from, to, share| {
        from.plus(to.minus(from), share)
    })
}

/// The heights of a shape's corners, which are some of `corners`.
fn heights_of(shape: &Shape, corners: &[DVec3], heights: &[f64]) -> Heights {
    let of = |corner: &DVec3| {
        corners
            .iter()
            .position(|c| c == corner)
            .map_or(0.0, |k| heights[k])
    };
    shape.corners.iter().map(of).collect()
}
