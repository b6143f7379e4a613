//! Form factors from a point of a surface to polygons, past others that stand in the way.
//!
//! ```text
//!   F = (1/2π) Σ_b ℓ_b n·N_b       b: arcs of great circles about what is visible of the receiver
//!                                  ℓ_b: angle of an arc,  N_b: unit normal of its plane, inwards
//! ```
//!
//! The receiver is cut into convex pieces and clipped at the point's horizon, blockers are cut into
//! convex pieces and clipped at the receiver's plane, what is behind it. Each piece is seen in a
//! convex cone (`cone`). The arcs are parts of the cones' sides: of a side of the receiver what
//! lies in no blocker, of a side of a blocker what lies in the receiver and in no other blocker
//! (`visible`). Such a part is a union of intervals, since a convex cone cuts a great circle in one
//! (`crossings`).
//!
//! **Bound.** Every decision is a sign from 106 bits, so that the arrangement is the exact one of
//! the corners as given, down to [`ON_A_CIRCLE`]: what is nearer together counts as one, and so do
//! the sides of neighbours with common corners. Each length is then a sum of differences of angles
//! that are within 3 ε relatively; rounding is summed term by term. Crossings that nearly coincide
//! do no harm: each side's length is right by itself.
//!
//! Three decisions are no matter of rounding. A point within [`Occluders::touching`] of a polygon's
//! plane, and what corners and rounding leave uncertain of it, is *on* it: it does not see this
//! polygon, and nothing is hidden by it. For a point *on* the plane but beside the polygon the
//! bound holds what that leaves out, 2 h/r at height h and distance r. A blocker within the same
//! distance of the receiver's plane is *in* it and hides nothing.
//!
//! **Not covered**: a point that itself lies on two sides of a surface, such as one on a wall that
//! stands on its own surface: the wall is seen edge-on there, and hides nothing.
//!
//! Reference: Lambert, *Photometria*, 1760.

mod cap;
mod cone;
mod crossings;
mod visible;

use super::Occluders;
use crate::form_factor::{ExchangeArea, FormFactorError, Polygon};
use crate::geometry::{Vector, convex_pieces};
use crate::numeric::{Bounded, DoubleDouble, Scalar, vector_value};
use cap::Cap;
use cone::{Cone, Ray};
use crossings::bend;
use glam::{DVec2, DVec3};
use std::borrow::Cow;
use std::cmp::Ordering;

/// Sines below this are 0: far above the rounding of 106 bits, 2⁻¹⁰², and far below all else.
const ON_A_CIRCLE: f64 = f64::EPSILON * f64::EPSILON * 256.0;
/// Coordinates beyond this have no squares and cubes in `f64`.
const LARGEST: f64 = 1e60;

/// A point of a surface from which polygons are seen.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Viewpoint {
    point: DVec3,
    normal: Vector<DoubleDouble>,
    touching: f64,
}

/// A polygon as it is seen from a point.
#[derive(Debug)]
pub(crate) struct Sight<'a> {
    polygon: &'a Polygon,
    /// The height of the point over the polygon's plane.
    height: DoubleDouble,
    /// None if the point is on the plane, or all is below its horizon.
    cones: Vec<Cone>,
    /// The side of the plane on which the point is: greater in front, equal on it.
    side: Ordering,
    /// The share that an edge-on view leaves out, and that corners off their plane change.
    error: f64,
    cap: Cap,
    /// The distance of the farthest corner.
    reach: f64,
}

impl Sight<'_> {
    /// Does the polygon's front face the point?
    pub(crate) fn is_front(&self) -> bool {
        self.side == Ordering::Greater
    }
}

impl Viewpoint {
    /// A point of a surface with this unit normal; up to `touching` from a plane it is on it.
    ///
    /// # Errors
    /// [`FormFactorError::NotAUnitNormal`]; [`FormFactorError::NotAPoint`].
    pub(crate) fn try_new(
        point: DVec3,
        normal: DVec3,
        touching: f64,
    ) -> Result<Self, FormFactorError> {
        let length = normal.length();
        if length.is_nan() || (length - 1.0).abs() > 1e-9 {
            return Err(FormFactorError::NotAUnitNormal { length });
        }
        if point.is_nan() || point.abs().max_element() > LARGEST {
            let DVec3 { x, y, z } = point;
            return Err(FormFactorError::NotAPoint { x, y, z });
        }
        let normal = Vector::lifted(normal, DoubleDouble::from(0.0));
        let normal = normal.times(DoubleDouble::from(1.0) / normal.length());
        Ok(Self {
            point,
            normal,
            touching,
        })
    }

    /// The polygon as it is seen from here.
    ///
    /// # Errors
    /// [`FormFactorError::OutOfRange`] if a coordinate has no square in `f64`.
    pub(crate) fn sight<'a>(&self, polygon: &'a Polygon) -> Result<Sight<'a>, FormFactorError> {
        let shape = &polygon.shape;
        if shape.largest > LARGEST {
            let value = shape.largest;
            return Err(FormFactorError::OutOfRange { value });
        }
        let point = self.point;
        let height = vector_value!(DoubleDouble::from(0.0), polygon.precise_height(point));
        let distances = shape.corners.iter().map(|corner| corner.distance(point));
        let reach = distances.fold(0.0, f64::max);
        let mut sight = Sight {
            polygon,
            height,
            cones: Vec::new(),
            side: height.to_f64().total_cmp(&0.0),
            error: 0.0,
            cap: Cap::EVERYWHERE,
            reach,
        };
        let noise = self.noise(polygon) + polygon.tilt * reach;
        if height.to_f64().abs() <= noise {
            sight.side = Ordering::Equal;
            sight.error = left_out(point, height.to_f64().abs(), noise, polygon);
            return Ok(sight);
        }
        let normal = self.normal.to_doubles();
        let below = |corner: &DVec3| (*corner - point).dot(normal) < -1e-12 * reach;
        if shape.corners.iter().all(below) {
            // nothing of it is seen, nor hides what is
            return Ok(sight);
        }
        let pieces = match shape.cells.len() {
            // a triangle, or a convex quadrilateral
            1 => vec![shape.corners.to_vec()],
            _ => convex_pieces(&shape.corners, polygon.normal),
        };
        for corners in pieces {
            let rays = corners.iter().filter_map(|c| Ray::between(point, *c));
            let mut rays: Vec<Ray> = rays.collect();
            if sight.side == Ordering::Greater {
                rays.reverse();
            }
            sight.cones.extend(Cone::of(&rays));
        }
        // by twice the bend along the whole outline
        let bend = sight.cones.iter().map(bend);
        sight.error = 2.0 * bend.sum::<f64>();
        let rays: Vec<Ray> = sight.cones.iter().flat_map(Cone::rays).copied().collect();
        sight.cap = Cap::around(&rays);
        Ok(sight)
    }

    /// The distance from a plane up to which corners, as they are rounded, may be on it.
    fn noise(&self, polygon: &Polygon) -> f64 {
        let largest = polygon.shape.largest.max(self.point.abs().max_element());
        self.touching + 8.0 * f64::EPSILON * largest
    }

    /// The form factor of what is seen of a polygon's front past others; those that hide nothing
    /// cost little.
    pub(crate) fn form_factor<'s, 'a: 's>(
        &self,
        receiver: &Sight<'a>,
        blockers: impl Iterator<Item = &'s Sight<'a>>,
    ) -> ExchangeArea {
        match receiver.side {
            Ordering::Less => ExchangeArea::NOTHING,
            _ => self.visible(receiver, blockers),
        }
    }

    /// The form factor of what is seen of the side of a polygon that faces the point.
    pub(crate) fn visible<'s, 'a: 's>(
        &self,
        receiver: &Sight<'a>,
        blockers: impl Iterator<Item = &'s Sight<'a>>,
    ) -> ExchangeArea {
        let lit = receiver.cones.iter();
        let lit: Vec<Cow<Cone>> = lit.filter_map(|cone| self.above_horizon(cone)).collect();
        let mut total = ExchangeArea {
            error: receiver.error,
            ..ExchangeArea::NOTHING
        };
        if lit.is_empty() {
            return total;
        }
        let mut before: Vec<Cow<'s, Cone>> = Vec::new();
        for blocker in blockers {
            if blocker.cap.meets(&receiver.cap) {
                total.error += blocker.error;
                self.cut_before(receiver, blocker, &mut before);
            }
        }
        let before: Vec<&Cone> = before.iter().map(AsRef::as_ref).collect();
        for cone in &lit {
            let part = visible::visible(cone, &before, self.normal);
            total.value += part.value;
            total.error += part.error + 0.5 * f64::EPSILON * total.value.abs();
        }
        total.value = total.value.clamp(0.0, 1.0);
        total.error = total.error.min(1.0);
        total
    }

    /// The part of a cone in front of the surface that the point is of.
    fn above_horizon<'c>(&self, cone: &'c Cone) -> Option<Cow<'c, Cone>> {
        let normal = self.normal.to_doubles();
        // scalar products of unit vectors are within 6 ε
        let certain = 8.0 * f64::EPSILON;
        if cone.rays().all(|ray| ray.unit.dot(normal) > certain) {
            return Some(Cow::Borrowed(cone));
        }
        if cone.rays().all(|ray| ray.unit.dot(normal) < -certain) {
            return None;
        }
        let height = |ray: &Ray| vector_value!(self.normal.0[0], ray.exact.dot(self.normal));
        cone.clipped(height).map(Cow::Owned)
    }

    /// Adds the cones of what a blocker has in front of the receiver's plane.
    fn cut_before<'s>(
        &self,
        receiver: &Sight,
        blocker: &'s Sight,
        before: &mut Vec<Cow<'s, Cone>>,
    ) {
        let (polygon, normal) = (receiver.polygon, receiver.polygon.precise_normal);
        let noise = self.noise(polygon).max(self.noise(blocker.polygon));
        let noise = noise + polygon.tilt * (receiver.reach + blocker.reach);
        let over = receiver.height.to_f64();
        // the side of the plane on which the point is counts as above
        let up = over.signum();
        let height = |ray: &Ray| up * (over + ray.distance * ray.unit.dot(polygon.normal));
        for cone in &blocker.cones {
            if cone.rays().all(|ray| height(ray) > noise) {
                before.push(Cow::Borrowed(cone));
            } else if cone.rays().any(|ray| height(ray) > noise) {
                let cut = cone.clipped(|ray| {
                    if height(ray).abs() <= noise {
                        return DoubleDouble::from(0.0);
                    }
                    let (exact, scale) = (ray.exact, DoubleDouble::from(ray.scale));
                    let up = DoubleDouble::from(up);
                    vector_value!(scale, (exact.dot(normal) + receiver.height * scale) * up)
                });
                before.extend(cut.map(Cow::Owned));
            }
        }
    }
}

/// A bound on what a polygon takes of the directions from a point at this height over its plane; 0
/// for a point on the polygon.
fn left_out(point: DVec3, height: f64, noise: f64, polygon: &Polygon) -> f64 {
    if height <= 0.0 {
        return 0.0;
    }
    let corners = &polygon.shape.corners;
    let next = corners.iter().cycle().skip(1);
    let (mut aside, mut is_inside) = (f64::INFINITY, false);
    let drop = polygon.normal.abs();
    let flat = |p: DVec3| {
        if drop.z >= drop.x && drop.z >= drop.y {
            p.truncate()
        } else if drop.x >= drop.y {
            DVec2::new(p.y, p.z)
        } else {
            DVec2::new(p.x, p.z)
        }
    };
    for (from, to) in corners.iter().zip(next) {
        let along = *to - *from;
        let share = (point - *from).dot(along) / along.length_squared();
        aside = aside.min(point.distance(*from + along * share.clamp(0.0, 1.0)));
        let [p, a, b] = [point, *from, *to].map(flat);
        if (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y) {
            is_inside = !is_inside;
        }
    }
    if is_inside || aside <= noise {
        0.0
    } else {
        2.0 * height / aside
    }
}

/// The fraction of what leaves a point of a surface that reaches a polygon past others.
///
/// **Arguments** `normal`: unit normal of the surface at `point`; the polygon's front receives,
/// occluders block from both sides, each piece of them that is nearer than the polygon's plane.
/// **Returns** a number in `[0, 1]`, dimensionless, with a bound on its error for corners and point
/// as given: exactly 0 if the point is not in front of the polygon or all of it is hidden.
/// **Accuracy** some ε for few blockers, held by `half_planes_hide_half_and_all`.
///
/// # Errors
/// [`FormFactorError::NotAUnitNormal`]; [`FormFactorError::NotAPoint`];
/// [`FormFactorError::OutOfRange`] if a coordinate is beyond 1e60.
///
/// # Examples
/// ```
/// use glam::DVec3;
/// use infoscene::form_factor::{Occluders, Polygon, point_form_factor_past};
/// use infoscene::geometry::{GeometryError, Patch};
/// // a square of side 2 at distance 2, seen from its axis past a plate over half of it
/// let level = |x: [f64; 2], z: f64| {
///     let corner = |x, y| DVec3::new(x, y, z);
///     let [a, b] = x.map(|x| [corner(x, 1.0), corner(x, -1.0)]);
///     Ok::<_, GeometryError>(Polygon::new(&Patch::try_new(vec![a[0], b[0], b[1], a[1]])?))
/// };
/// let (face, plate) = (level([-1.0, 1.0], 2.0)?, level([0.0, 1.0], 1.0)?);
/// let occluders = Occluders { polygons: &[&plate], touching: 0.0 };
/// let seen = point_form_factor_past(DVec3::ZERO, DVec3::Z, &face, &occluders)?;
/// // Howell, B-3, halved
/// let exact = 2.0 / std::f64::consts::PI / 5f64.sqrt() * (1.0 / 5f64.sqrt()).atan();
/// assert!((seen.value - exact).abs() <= seen.error && seen.error < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn point_form_factor_past(
    point: DVec3,
    normal: DVec3,
    polygon: &Polygon,
    occluders: &Occluders,
) -> Result<Bounded, FormFactorError> {
    let viewpoint = Viewpoint::try_new(point, normal, occluders.touching)?;
    let receiver = viewpoint.sight(polygon)?;
    let blockers = occluders.polygons.iter().map(|one| viewpoint.sight(one));
    let blockers = blockers.collect::<Result<Vec<_>, _>>()?;
    Ok(viewpoint.form_factor(&receiver, blockers.iter()).bounded())
}
