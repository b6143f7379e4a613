//! Planes of sight and the lines in which they meet P's plane.
//!
//! ```text
//!   n(t) = n0 + t n1,   n0 = (a − y0) × (b − a),   n1 = (b − a) × v
//! ```
//!
//! Both vectors are within 2ε of their lengths, from differences and products with what rounding
//! left of them: where y comes close to the line of the edge, |n| is much smaller than |a − y| |b −
//! a|, and rounded differences would leave nothing of it.
//!
//! An edge that is parallel to the stretch, up to what counts as touching, is seen in one plane all
//! along. That plane is put through the middles of both lines, whichever of the two the stretch is
//! on: as the stretch moves, the plane of each sweeps over as much, with opposite signs, and the
//! two together over no more than if the edges had been moved into the plane.

use crate::geometry::Vector;
use crate::numeric::{DoubleDouble, vector_value};
use glam::{DVec2, DVec3};

/// A stretch of an edge, `y(t) = start + t along`, from doubles and from 106 bits.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stretch {
    pub start: DVec3,
    pub along: DVec3,
    exact: [Vector<DoubleDouble>; 2],
}

/// y in the middle of a panel, as the sum of two doubles each coordinate.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Middle {
    pub t: f64,
    /// Half the length of the panel.
    pub half: f64,
    point: DVec3,
    rest: DVec3,
}

impl Middle {
    /// The height of y over P's plane.
    pub(crate) fn height(&self) -> f64 {
        self.point.z
    }

    /// A point seen from y, within 2u of the distance.
    pub(crate) fn to(&self, place: DVec3) -> DVec3 {
        (place - self.point) - self.rest
    }
}

impl Stretch {
    /// The part of a line from one share of it to another.
    pub(crate) fn of([start, end]: [DVec3; 2], [from, to]: [f64; 2]) -> Self {
        let lifted = |point: DVec3| Vector::lifted(point, DoubleDouble::from(0.0));
        let whole = lifted(end).minus(lifted(start));
        let [from, to] = [from, to].map(DoubleDouble::from);
        let exact = [lifted(start).plus(whole, from), whole.times(to - from)];
        Self {
            start: exact[0].to_doubles(),
            along: exact[1].to_doubles(),
            exact,
        }
    }

    /// The edge with ends put into P's plane that are nearly there, and the most they were moved.
    pub(crate) fn levelled(mut self, touching: f64) -> (Self, f64) {
        let zero = DoubleDouble::from(0.0);
        let [start, along] = &mut self.exact;
        let heights = [start.0[2], start.0[2] + along.0[2]];
        let [low, high] = heights.map(|height| {
            if height.high().abs() <= touching {
                zero
            } else {
                height
            }
        });
        let moved = [heights[0] - low, heights[1] - high].map(|moved| moved.high().abs());
        (start.0[2], along.0[2]) = (low, high - low);
        self.start = start.to_doubles();
        self.along = along.to_doubles();
        (self, moved[0].max(moved[1]))
    }

    pub(crate) fn middle(&self, t: f64, half: f64) -> Middle {
        let [start, along] = self.exact;
        let exact = start.plus(along, DoubleDouble::from(t));
        let point = exact.to_doubles();
        Middle {
            t,
            half,
            point,
            rest: DVec3::from_array(exact.0.map(DoubleDouble::low)),
        }
    }

    /// The normals of the planes of sight of an edge from a to b, n0 and n1.
    #[inline(always)]
    fn normals(&self, [a, b]: [DVec3; 2]) -> [DVec3; 2] {
        let [start, along] = self.exact.map(halves);
        let edge = difference(b, [a, DVec3::ZERO]);
        [cross(difference(a, start), edge), cross(edge, along)]
    }
}

/// A vector with what its rounding left.
type Halves = [DVec3; 2];

fn halves(exact: Vector<DoubleDouble>) -> Halves {
    let low = DVec3::from_array(exact.0.map(DoubleDouble::low));
    [exact.to_doubles(), low]
}

/// `to − from`, within u² of both.
#[inline(always)]
fn difference(to: DVec3, [from, rest]: Halves) -> Halves {
    let (to, from) = (to.to_array(), from.to_array());
    let exact = [0, 1, 2].map(|i| DoubleDouble::difference(to[i], from[i]));
    [
        DVec3::from_array(exact.map(DoubleDouble::high)),
        DVec3::from_array(exact.map(DoubleDouble::low)) - rest,
    ]
}

/// The product of two vectors, within 4u of itself and some u² of their sizes.
#[inline(always)]
fn cross([a, rest]: Halves, [b, other]: Halves) -> DVec3 {
    let exact = DVec3::new(
        product_difference([a.y, b.z], [a.z, b.y]),
        product_difference([a.z, b.x], [a.x, b.z]),
        product_difference([a.x, b.y], [a.y, b.x]),
    );
    exact + (a.cross(other) + rest.cross(b))
}

/// `a b − c d`, within 3u of itself.
///
/// Reference: Jeannerod, Louvet, Muller, "Further analysis of Kahan's algorithm for the accurate
/// computation of 2 × 2 determinants", *Math. Comp.* 82 (2013), 2245–2264.
#[inline(always)]
pub(crate) fn product_difference([a, b]: [f64; 2], [c, d]: [f64; 2]) -> f64 {
    let product = c * d;
    let rest = (-c).mul_add(d, product);
    a.mul_add(b, -product) + rest
}

/// A line in P's plane, as seen from y.
#[derive(Debug, Clone)]
pub(crate) struct Trace {
    /// The normal of the plane of sight, `n0 + t n1`.
    pub normal: [DVec3; 2],
    /// The constant α, and γ = `γ0 + t γ1`, of an edge in P's plane.
    pub edge: Option<(DVec2, [f64; 2])>,
    /// A bound on the error of the normal, or of γ, `e0 + t e1`.
    pub error: [f64; 2],
    /// The edges' line in space; none for a plane that holds the stretch.
    pub space: Option<usize>,
    /// Whether the plane holds the stretch.
    pub is_fixed: bool,
    /// The largest angle by which the rounding of corners turns such a plane.
    pub turned: f64,
    /// The normal of the line in P's plane but for a positive factor, linear in t, and its size.
    pub planar: [DVec2; 2],
    pub planar_size: f64,
    /// The size of the plane's normal.
    pub size: f64,
    /// Whether the plane of sight is level all along, so that it meets P's plane nowhere.
    pub is_level: bool,
}

impl Trace {
    /// The trace for a stretch of an edge from a to b, on a line of space.
    pub(crate) fn of_edge(stretch: &Stretch, [a, b]: [DVec3; 2], space: usize) -> Self {
        let normal = vector_value!([DVec3::ZERO; 2], stretch.normals([a, b]));
        let is_on_floor = a.z == 0.0 && b.z == 0.0;
        let edge = is_on_floor.then(|| {
            let run = (b - a).truncate();
            let from = stretch.middle(0.0, 0.0).to(a).truncate();
            let alpha = DVec2::new(run.y, -run.x);
            (alpha, [from.perp_dot(run), normal[1].z])
        });
        let error = if edge.is_some() {
            let run = 2.5 * f64::EPSILON * (b - a).length();
            [a - stretch.start, stretch.along].map(|along| run * along.length())
        } else {
            normal.map(|normal| 2.0 * f64::EPSILON * normal.length())
        };
        Self::new(normal, edge, error, Some(space))
    }

    /// The unit normal of the plane that holds two parallel lines, the first the direction's.
    pub(crate) fn plane_of([one, other]: [[DVec3; 2]; 2]) -> DVec3 {
        let lifted = |point: DVec3| Vector::lifted(point, DoubleDouble::from(0.0));
        let [from, to] = [one, other]
            .map(|[start, end]| lifted(start).plus(lifted(end), DoubleDouble::from(1.0)));
        let direction = lifted(one[1]).minus(lifted(one[0]));
        to.minus(from).cross(direction).to_doubles().normalize()
    }

    /// A plane that holds the stretch, with this unit normal, within this error, and what the
    /// rounding of corners turns it by.
    pub(crate) fn fixed(normal: DVec3, [error, turned]: [f64; 2]) -> Self {
        Self {
            is_fixed: true,
            turned,
            ..Self::new([normal, DVec3::ZERO], None, [error, 0.0], None)
        }
    }

    fn new(
        normal: [DVec3; 2],
        edge: Option<(DVec2, [f64; 2])>,
        error: [f64; 2],
        space: Option<usize>,
    ) -> Self {
        let planar = match edge {
            Some((alpha, _)) => [alpha, DVec2::ZERO],
            None => normal.map(DVec3::truncate),
        };
        let planar_size = planar[0].length() + planar[1].length();
        let size = normal[0].length() + normal[1].length();
        Self {
            normal,
            edge,
            error,
            space,
            is_fixed: false,
            turned: 0.0,
            planar,
            planar_size,
            size,
            is_level: edge.is_none() && planar_size <= LEVEL * size,
        }
    }
}

/// The slope below which a plane counts as level.
pub(crate) const LEVEL: f64 = 1e-14;

/// A line at one t: `α·X = γ`, its place nearest to y and its direction, the positive side on the
/// left.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Placed {
    pub alpha: DVec2,
    pub gamma: f64,
    pub origin: DVec2,
    pub direction: DVec2,
    /// Whether the trace is a line at all, and not at infinity.
    pub is_line: bool,
}
