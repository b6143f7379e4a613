//! The part of a side that lies in a cone.
//!
//! ```text
//!   side from a to b, circle with normal N′:   p·N′ has one zero at most, the side being below π
//!   s_a = a·N′,  s_b = b·N′,  opposite signs:  t = atan2(|s_a| |a × b|, |s_a| a·b + |s_b| a·a)
//! ```
//!
//! A sign is taken from doubles where it is certain: a scalar product of two unit vectors, each
//! within 2 ε, is within 6 ε. Elsewhere it is taken from 106 bits, where all but rounding is
//! [`ON_A_CIRCLE`](super::ON_A_CIRCLE). Every factor of t is positive or comes from 106 bits, so
//! that t is within `ANGLE_ERROR + ε`, relatively, whatever the angle between the circles is.

use super::cone::{Cone, Ray, Side};
use crate::numeric::functions::elementary::angle;
use crate::numeric::{DoubleDouble, Scalar, vector_value};
use smallvec::SmallVec;
use std::cmp::Ordering;

/// Scalar products of unit vectors in doubles have a certain sign above this.
const CERTAIN: f64 = 8.0 * f64::EPSILON;

/// The side of a great circle on which a ray lies: greater inside, equal on it.
pub(super) fn side_of(ray: &Ray, circle: &Side) -> Ordering {
    let quick = ray.unit.dot(circle.unit);
    if quick.abs() > CERTAIN {
        return if quick > 0.0 {
            Ordering::Greater
        } else {
            Ordering::Less
        };
    }
    let height = height(ray, circle).to_f64();
    // a ray is less than 2 long
    if height.abs() <= 2.0 * super::ON_A_CIRCLE * circle.scale {
        Ordering::Equal
    } else if height > 0.0 {
        Ordering::Greater
    } else {
        Ordering::Less
    }
}

/// The largest angle by which a corner lies outside a side of its own cone, as corners that do not
/// quite lie in one plane may.
pub(super) fn bend(cone: &Cone) -> f64 {
    let mut bend: f64 = 0.0;
    let count = cone.sides.len();
    for (i, side) in cone.sides.iter().enumerate() {
        // the other corners than its own ends
        for next in 2..count {
            let ray = &cone.sides[(i + next) % count].ends[0];
            if side_of(ray, side).is_lt() {
                bend = bend.max(4.0 * f64::EPSILON - ray.unit.dot(side.unit));
            }
        }
    }
    bend
}

fn height(ray: &Ray, circle: &Side) -> DoubleDouble {
    let (exact, normal) = (ray.exact, circle.normal);
    vector_value!(DoubleDouble::from(0.0), exact.dot(normal))
}

/// The angle that a side subtends.
pub(super) fn subtended(side: &Side) -> f64 {
    let [sine, cosine, _] = side.products;
    angle(sine.to_f64(), cosine.to_f64())
}

/// The angle from the start of a side to the circle of another one, which its ends lie astride.
fn crossing(side: &Side, circle: &Side) -> f64 {
    let [start, end] = side.ends.map(|end| end.exact);
    let (normal, [sine, cosine, square]) = (circle.normal, side.products);
    let [y, x] = vector_value!([0.0; 2], {
        let (from, to) = (start.dot(normal).abs(), end.dot(normal).abs());
        [
            (from * sine).to_f64(),
            (from * cosine + to * square).to_f64(),
        ]
    });
    angle(y, x)
}

/// The part of a side that lies in a cone, by angles from its start.
#[derive(Debug, Clone, Copy)]
pub(super) struct Span {
    pub start: f64,
    pub end: f64,
    /// The side of the cone on which the directions just beside lie, inwards of the side first;
    /// both unless the cone ends along it.
    pub beside: [bool; 2],
}

impl Span {
    /// Does a side of the cone lie along the side?
    pub(super) fn is_along(&self) -> bool {
        !(self.beside[0] && self.beside[1])
    }
}

/// The part of a side that lies in a cone, if it is more than a point.
pub(super) fn span(side: &Side, cone: &Cone) -> Option<Span> {
    let mut beside = [true; 2];
    let mut crossed: SmallVec<[(&Side, bool); 6]> = SmallVec::new();
    for circle in &cone.sides {
        let [from, to] = side.ends.map(|end| side_of(&end, circle));
        match (from, to) {
            (Ordering::Equal, Ordering::Equal) => {
                let outer = usize::from(side.unit.dot(circle.unit) > 0.0);
                beside[outer] = false;
            }
            (Ordering::Greater, Ordering::Less) => crossed.push((circle, true)),
            (Ordering::Less, Ordering::Greater) => crossed.push((circle, false)),
            (Ordering::Less, _) | (_, Ordering::Less) => return None,
            _ => {}
        }
    }
    let (mut start, mut end) = (0.0, subtended(side));
    for (circle, leaves) in crossed {
        let at = crossing(side, circle);
        if leaves {
            end = at.min(end);
        } else {
            start = at.max(start);
        }
    }
    (start < end).then_some(Span { start, end, beside })
}
