//! Measures of a polygon's outline for the routes: sizes, and cells for quadrature.
//!
//! ```text
//!   cell: x(s, t) = (1−s)(1−t) c0 + s(1−t) c1 + s t c2 + (1−s) t c3,   s, t in [0, 1]
//!   dA = J ds dt,   J = J0 + Js s + Jt t      (c2 = c3 for a triangle)
//! ```

use crate::form_factor::contour::edge::Edge;
use crate::geometry::{Vector, is_convex, triangulated};
use crate::numeric::{DoubleDouble, Scalar, real, vectorised};
use glam::DVec3;
use smallvec::SmallVec;

/// Four corners of a cell, as indices of the outline's corners; the last two are equal in a
/// triangle.
pub(crate) type Cell = [usize; 4];

/// An outline in a plane, counter-clockwise seen from its front.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Shape {
    pub corners: SmallVec<[DVec3; 4]>,
    /// The edges from each corner to the next.
    pub edges: SmallVec<[Edge<f64>; 4]>,
    pub cells: SmallVec<[Cell; 1]>,
    /// `J0, Js, Jt` of each cell, from 106 bits.
    pub jacobians: SmallVec<[[f64; 3]; 1]>,
    /// The largest Jacobian of a cell over its mean, and how much one changes along half a line,
    /// over its largest.
    pub peak: f64,
    pub slope: f64,
    pub area: f64,
    pub perimeter: f64,
    pub longest_edge: f64,
    pub centre: DVec3,
    /// The largest of all coordinates.
    pub largest: f64,
    /// Half the longest line of a cell along which a rule runs.
    pub half_length: f64,
    /// Largest distance of a corner from the centre.
    pub radius: f64,
    pub lines: CellLines,
}

/// The lines of the only cell of an outline, a quadrilateral, along which a rule runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CellLines {
    /// Half the longest; infinite where the outline is not one quadrilateral.
    pub half: f64,
    /// The largest distance of a line's middle from the outline's centre.
    pub middle: f64,
    /// The mean directions of lines along s and along t, and the sines by which others turn away.
    pub directions: [DVec3; 2],
    pub spreads: [f64; 2],
    /// How much the Jacobian changes along half a line, over what it is in its middle.
    pub unevenness: f64,
}

impl CellLines {
    const NONE: Self = Self {
        half: f64::INFINITY,
        middle: 0.0,
        directions: [DVec3::X; 2],
        spreads: [1.0; 2],
        unevenness: 1.0,
    };

    /// The lines between these corners.
    fn of([a, b, c, d]: [DVec3; 4], half: f64, [j, js, jt]: [f64; 3], centre: DVec3) -> Self {
        // lines along s join points of two sides, and so do their directions and middles
        let along = [[b - a, c - d], [d - a, c - b]];
        let mean = along.map(|[one, other]| (one + other).normalize_or_zero());
        let spread = |k: usize| {
            let off = along[k].map(|side| {
                let side = side.normalize_or_zero();
                // any, where it is not less than a right angle
                let is_acute = side.dot(mean[k]) > 0.0;
                if is_acute {
                    side.cross(mean[k]).length()
                } else {
                    1.0
                }
            });
            off[0].max(off[1]) + 8.0 * f64::EPSILON
        };
        let middles = [[a, b], [b, c], [c, d], [d, a]];
        let middle = middles.map(|[p, q]| (0.5 * ((p - centre) + (q - centre))).length());
        let change = |along: f64, across: f64| {
            let middle = j + 0.5 * along + f64::min(across, 0.0);
            (0.5 * along.abs() / middle).min(1.0)
        };
        Self {
            half,
            middle: middle.into_iter().fold(0.0, f64::max),
            directions: mean,
            spreads: [spread(0), spread(1)],
            unevenness: change(js, jt).max(change(jt, js)) + 8.0 * f64::EPSILON,
        }
    }
}

impl Shape {
    /// The outline with these corners, in a plane with this normal. Consecutive corners that
    /// coincide are taken as one; `None` if fewer than three are left.
    pub(crate) fn new(corners: &[DVec3], normal: Vector<DoubleDouble>) -> Option<Self> {
        let mut distinct: SmallVec<[DVec3; 4]> = corners.into();
        distinct.dedup();
        while distinct.len() > 1 && distinct.first() == distinct.last() {
            distinct.pop();
        }
        let corners = distinct;
        let n = corners.len();
        if n < 3 {
            return None;
        }
        let cells: SmallVec<[Cell; 1]> = if goes_round_convexly(&corners, normal.to_doubles()) {
            (1..n - 1)
                .step_by(2)
                .map(|i| [0, i, i + 1, (i + 2).min(n - 1)])
                .collect()
        } else {
            let triangles = triangulated(&corners, normal.to_doubles());
            triangles
                .into_iter()
                .map(|[a, b, c]| [a, b, c, c])
                .collect()
        };
        let mut jacobians: SmallVec<[[f64; 3]; 1]> = SmallVec::from_elem([0.0; 3], cells.len());
        let (all, of_corners, out) = (&cells, &corners, &mut jacobians);
        vectorised(
            #[inline(always)]
            move || {
                for (out, cell) in out.iter_mut().zip(all) {
                    *out = jacobian(cell.map(|i| of_corners[i]), normal);
                }
            },
        );
        let (mut peak, mut slope) = (1.0, 0.0);
        for [j, js, jt] in &jacobians {
            let largest = j + f64::max(*js, 0.0) + f64::max(*jt, 0.0);
            peak = f64::max(peak, largest / (j + 0.5 * (js + jt)));
            slope = f64::max(slope, 0.5 * js.abs().max(jt.abs()) / largest);
        }
        let area = jacobians
            .iter()
            .map(|[j, js, jt]| j + 0.5 * (js + jt))
            .sum();
        let centre = corners.iter().sum::<DVec3>() / real(n);
        let at = |i: usize| Vector(corners[i % n].to_array());
        let half_length = half_length(&corners, &cells);
        let lines = match (corners.as_slice(), cells.as_slice()) {
            (&[a, b, c, d], [_]) => CellLines::of([a, b, c, d], half_length, jacobians[0], centre),
            _ => CellLines::NONE,
        };
        let edges: SmallVec<[Edge<f64>; 4]> = (0..n).map(|i| Edge::new(at(i), at(i + 1))).collect();
        let radius = corners
            .iter()
            .map(|c| c.distance_squared(centre))
            .fold(0.0, f64::max)
            .sqrt();
        Some(Self {
            perimeter: edges.iter().map(|edge| edge.length).sum(),
            longest_edge: edges.iter().map(|edge| edge.length).fold(0.0, f64::max),
            edges,
            largest: corners
                .iter()
                .map(|c| c.abs().max_element())
                .fold(0.0, f64::max),
            // the Jacobian's rounding
            peak: peak * (1.0 + 8.0 * f64::EPSILON),
            slope: slope + 8.0 * f64::EPSILON,
            half_length,
            lines,
            corners,
            cells,
            jacobians,
            area,
            centre,
            radius,
        })
    }
}

/// Half the longest line `s = const` or `t = const` of a cell: one that joins points of two
/// opposite sides is at most the longer of the other two.
fn half_length(corners: &[DVec3], cells: &[Cell]) -> f64 {
    let longest = |cell: &Cell| {
        let [a, b, c, d] = cell.map(|i| corners[i]);
        [b - a, c - b, d - c, a - d]
            .into_iter()
            .map(DVec3::length_squared)
            .fold(0.0, f64::max)
    };
    0.5 * cells.iter().map(longest).fold(0.0, f64::max).sqrt()
}

/// Tells whether a polygon is convex and goes round once only.
fn goes_round_convexly(corners: &[DVec3], normal: DVec3) -> bool {
    corners.len() == 3 || is_convex(corners, normal, 0.0) && turns_once(corners, normal)
}

/// Tells whether a polygon that never turns right goes round once only. (A star goes round more
/// often.)
fn turns_once(corners: &[DVec3], normal: DVec3) -> bool {
    let n = corners.len();
    n == 4
        || (1..n - 1).all(|i| {
            (corners[i] - corners[0])
                .cross(corners[i + 1] - corners[0])
                .dot(normal)
                >= 0.0
        })
}

/// `J0, Js, Jt`: the corners' Jacobians are products of the sides that meet there.
#[inline(always)]
fn jacobian([a, b, c, d]: [DVec3; 4], normal: Vector<DoubleDouble>) -> [f64; 3] {
    let (like, is_triangle) = (DoubleDouble::from(0.0), c == d);
    let (a, b) = (Vector::lifted(a, like), Vector::lifted(b, like));
    let (c, d) = (Vector::lifted(c, like), Vector::lifted(d, like));
    let product = |u: Vector<_>, v: Vector<_>| u.cross(v).dot(normal);
    let origin = product(b.minus(a), d.minus(a));
    let along_s = product(b.minus(a), c.minus(b)) - origin;
    let along_t = if is_triangle {
        -origin
    } else {
        product(c.minus(d), d.minus(a)) - origin
    };
    [origin.to_f64(), along_s.to_f64(), along_t.to_f64()]
}
