//! The frames along whose axes many polygons of a scene lie, however the scene is turned.
//!
//! ```text
//!   s(a₁, a₂, a₃) = Σ_i Σ_k w_k (a_i · d_k)⁴     the same whatever the order and signs of the axes
//!   axis of a frame = Σ ± edges along it         then made orthonormal to 106 bits
//! ```
//!
//! The axes of a polygon are two edges at a right angle and its normal; without a right angle, its
//! longest edge, the direction across in its plane, and its normal. Polygons are sorted by the
//! number `s` of their axes, and those with one number compared, in O(n log n). The axes of a frame
//! are sums over the edges of all its polygons, as a single short edge is turned by the rounding of
//! its ends: where polygons adjoin, edges add up to the width of what they divide.
//!
//! **Not covered**: more than [`MOST_FRAMES`] frames; the smallest are left out.

use crate::geometry::{Patch, Vector};
use crate::numeric::{DoubleDouble, Scalar, tolerance};
use crate::scene::NamedPatch;
use glam::DVec3;

/// Most frames that are kept.
const MOST_FRAMES: usize = 8;

/// Fewest polygons of a frame.
pub(crate) const FEWEST_POLYGONS: usize = 6;

/// The numbers of axes of one frame differ by less: axes that rounding turns by up to 1e-10.
const ALIKE: f64 = 1e-9;

/// The largest sine between directions that count as parallel before their mean is known.
const TURNED: f64 = 1e-9;

/// The directions in which fourth powers of axes are taken, at no symmetric places.
const PROBES: [[f64; 3]; 4] = [
    [0.83, 0.37, 0.19],
    [-0.41, 0.77, 0.29],
    [0.23, -0.31, 0.91],
    [0.61, 0.53, -0.71],
];

/// Orthonormal axes, to 106 bits.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Frame([Vector<DoubleDouble>; 3]);

impl Frame {
    /// The coordinate axes.
    pub(crate) fn straight() -> Self {
        let axis = |axis: DVec3| Vector::lifted(axis, DoubleDouble::from(0.0));
        Self(DVec3::AXES.map(axis))
    }

    /// The coordinates of a point along the axes, from an origin.
    pub(crate) fn coordinates(&self, point: DVec3, origin: DVec3) -> [DoubleDouble; 3] {
        let [point, origin] = [point, origin].map(|p| Vector::lifted(p, DoubleDouble::from(0.0)));
        self.0.map(|axis| axis.dot(point.minus(origin)))
    }

    /// The coordinates of a direction along the axes, rounded.
    pub(crate) fn direction(&self, direction: DVec3) -> [f64; 3] {
        self.0.map(|axis| axis.to_doubles().dot(direction))
    }

    /// The frame of these sums of edges, of which one may be missing.
    fn along(mut sums: [Vector<DoubleDouble>; 3]) -> Option<Self> {
        // the longest sums are known best
        sums.sort_by(|one, other| {
            let [one, other] = [one, other].map(|sum| sum.to_doubles().length_squared());
            other.total_cmp(&one)
        });
        let unit = |sum: Vector<DoubleDouble>| {
            let length = sum.length();
            let is_known = length.to_f64() > 0.0;
            is_known.then(|| sum.times(DoubleDouble::from(1.0) / length))
        };
        let first = unit(sums[0])?;
        let across = sums[1].plus(first, -sums[1].dot(first));
        let second = unit(across)?;
        Some(Self([first, second, first.cross(second)]))
    }
}

/// The axes of a polygon.
struct Axes {
    polygon: usize,
    /// Two edges at a right angle, or an edge and the direction across.
    edges: [DVec3; 2],
    number: f64,
}

impl Axes {
    fn of(polygon: usize, patch: &Patch) -> Option<Self> {
        let edges = right_angle(patch).or_else(|| longest_edge(patch))?;
        let [u, v] = edges.map(DVec3::normalize);
        let probed = |axis: DVec3| {
            let powers = PROBES.into_iter().zip(1u8..);
            let powers =
                powers.map(|(probe, w)| f64::from(w) * axis.dot(DVec3::from_array(probe)).powi(4));
            powers.sum::<f64>()
        };
        let number = [u, v, u.cross(v)].map(probed).iter().sum::<f64>();
        number.is_finite().then_some(Self {
            polygon,
            edges,
            number,
        })
    }
}

/// The edges at the first right angle of a polygon.
fn right_angle(patch: &Patch) -> Option<[DVec3; 2]> {
    let corners = patch.corners();
    let largest = corners
        .iter()
        .fold(0.0, |most: f64, c| most.max(c.abs().max_element()));
    let allowed = tolerance::ALIGNMENT * largest;
    let n = corners.len();
    (0..n).find_map(|k| {
        let [u, v] = [(k + 1) % n, (k + n - 1) % n].map(|next| corners[next] - corners[k]);
        let is_right = u.dot(v).abs() <= allowed * u.length().max(v.length());
        is_right.then_some([u, v])
    })
}

/// The first of the longest edges of a polygon, and as long a way across it in the plane.
fn longest_edge(patch: &Patch) -> Option<[DVec3; 2]> {
    let corners = patch.corners();
    let next = corners.iter().cycle().skip(1);
    let edges = corners.iter().zip(next).map(|(from, to)| *to - *from);
    // edges that rounding alone makes longer are not
    let longest = edges.reduce(|one, other| {
        if other.length() > one.length() * (1.0 + ALIKE) {
            other
        } else {
            one
        }
    })?;
    Some([longest, patch.normal().cross(longest)])
}

/// The frames of many polygons, with those that they were found by, in order: the largest first.
///
/// **Arguments** `candidates`: the polygons looked at, in order.
pub(crate) fn frames(
    patches: &[NamedPatch],
    candidates: impl Iterator<Item = usize>,
) -> Vec<(Frame, Vec<usize>)> {
    let mut axes: Vec<Axes> = candidates
        .filter_map(|polygon| Axes::of(polygon, patches[polygon].shape()))
        .collect();
    axes.sort_by(|one, other| one.number.total_cmp(&other.number));
    let mut groups: Vec<&[Axes]> = axes
        .chunk_by(|one, other| other.number - one.number <= ALIKE)
        .filter(|group| group.len() >= FEWEST_POLYGONS)
        .collect();
    let first = |group: &[Axes]| group.iter().map(|axes| axes.polygon).min();
    groups.sort_by_key(|group| (std::cmp::Reverse(group.len()), first(group)));
    groups.truncate(MOST_FRAMES);
    groups.into_iter().filter_map(frame_of).collect()
}

/// The frame of polygons that have one number, and those of them that lie along its axes.
fn frame_of(group: &[Axes]) -> Option<(Frame, Vec<usize>)> {
    // that with the longest edge is turned least
    let length = |axes: &Axes| {
        axes.edges[0]
            .length_squared()
            .max(axes.edges[1].length_squared())
    };
    let rank = |axes: &&Axes| (length(axes), std::cmp::Reverse(axes.polygon));
    let leader = group.iter().max_by(|one, other| {
        let (one, other) = (rank(one), rank(other));
        one.0.total_cmp(&other.0).then(one.1.cmp(&other.1))
    })?;
    let [u, v] = leader.edges.map(DVec3::normalize);
    let leading = [u, v, u.cross(v).normalize()];
    let mut sums = [Vector([DoubleDouble::from(0.0); 3]); 3];
    let mut members = Vec::new();
    let mut in_order: Vec<&Axes> = group.iter().collect();
    in_order.sort_by_key(|axes| axes.polygon);
    for axes in in_order {
        let along = axes.edges.map(|edge| axis_along(edge, &leading));
        let [Some(one), Some(other)] = along else {
            continue;
        };
        if one == other {
            continue;
        }
        members.push(axes.polygon);
        for (edge, axis) in axes.edges.into_iter().zip([one, other]) {
            let sign = leading[axis].dot(edge).signum();
            let edge = Vector::lifted(edge, DoubleDouble::from(0.0));
            sums[axis] = sums[axis].plus(edge, DoubleDouble::from(sign));
        }
    }
    let frame = Frame::along(sums)?;
    (members.len() >= FEWEST_POLYGONS).then_some((frame, members))
}

/// The axis that an edge is parallel to.
fn axis_along(edge: DVec3, axes: &[DVec3; 3]) -> Option<usize> {
    let length = edge.length();
    (0..3).find(|axis| {
        let along = edge.dot(axes[*axis]);
        (edge - along * axes[*axis]).length() <= TURNED * length
    })
}
