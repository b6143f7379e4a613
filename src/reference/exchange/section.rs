//! Two polygons seen along the line where their planes meet.
//!
//! ```text
//!   d: unit vector along that line, any direction in the planes if they are parallel
//!   x = u e_P + s d,   y = v e_Q + t d        (e_P = n_P × d, e_Q = n_Q × d)
//! ```
//!
//! The height of y over the plane of P depends on v alone, that of x over the plane of Q on u
//! alone: what lies behind the other's plane is cut off by ending the range of v or u. Between two
//! neighbouring corners (in u or v) a polygon is a few trapezoids, whose ends s are linear in u: a
//! *slab*.

use crate::reference::fixed_float::FixedFloat;
use glam::DVec3;

type Vector<const N: usize> = [FixedFloat<N>; 3];

/// An edge inside a slab: `s(u) = at + slope·(u − from)`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Line<const N: usize> {
    pub from: FixedFloat<N>,
    pub at: FixedFloat<N>,
    pub slope: FixedFloat<N>,
    /// Whether the polygon lies on the side of smaller s, so that this is the upper end of a
    /// trapezoid.
    pub is_upper: bool,
}

impl<const N: usize> Line<N> {
    pub(crate) fn value(&self, u: FixedFloat<N>) -> FixedFloat<N> {
        self.at + self.slope * (u - self.from)
    }
}

/// The part of a polygon between two values of u, without a corner inside.
#[derive(Debug, Clone)]
pub(crate) struct Slab<const N: usize> {
    pub ends: [FixedFloat<N>; 2],
    /// Sorted by s: lower and upper ends of trapezoids in turn.
    pub lines: Vec<Line<N>>,
}

impl<const N: usize> Slab<N> {
    /// The extent of all its trapezoids along d at `u`.
    pub(crate) fn extent(&self, u: FixedFloat<N>) -> FixedFloat<N> {
        let ends = self.lines.iter().map(|line| {
            let value = line.value(u);
            if line.is_upper { value } else { -value }
        });
        ends.fold(FixedFloat::ZERO, |sum, end| sum + end)
    }

    /// The area.
    pub(crate) fn area(&self) -> FixedFloat<N> {
        let [lower, upper] = self.ends;
        self.extent((lower + upper).scaled(-1)) * (upper - lower)
    }
}

/// A linear function `at_zero + slope·v`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Linear<const N: usize> {
    pub at_zero: FixedFloat<N>,
    pub slope: FixedFloat<N>,
}

impl<const N: usize> Linear<N> {
    pub(crate) fn at(&self, v: FixedFloat<N>) -> FixedFloat<N> {
        self.at_zero + self.slope * v
    }
}

/// A pair of polygons in these coordinates, one of them integrated over inside, the other outside.
#[derive(Debug, Clone)]
pub(crate) struct Section<const N: usize> {
    pub inner: Vec<Slab<N>>,
    pub outer: Vec<Slab<N>>,
    /// The u of the foot of the perpendicular from the outer line v on the inner plane.
    pub foot: Linear<N>,
    /// The height of v over the inner plane.
    pub height: Linear<N>,
    /// The height of u over the outer plane.
    pub facing: Linear<N>,
}

fn minus<const N: usize>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    std::array::from_fn(|k| a[k] - b[k])
}

fn dot<const N: usize>(a: &Vector<N>, b: &Vector<N>) -> FixedFloat<N> {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross<const N: usize>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        a[i] * b[j] - a[j] * b[i]
    })
}

fn unit<const N: usize>(a: &Vector<N>) -> Vector<N> {
    let inverse = dot(a, a).sqrt().reciprocal();
    a.map(|x| x * inverse)
}

/// The corners exactly, and the unit normal of `Σ (v_i − v_0) × (v_{i+1} − v_0)`.
struct Plate<const N: usize> {
    corners: Vec<Vector<N>>,
    normal: Vector<N>,
}

impl<const N: usize> Plate<N> {
    fn new(corners: &[DVec3]) -> Self {
        let corners: Vec<Vector<N>> = corners
            .iter()
            .map(|c| c.to_array().map(FixedFloat::new))
            .collect();
        let arms: Vec<_> = corners.iter().map(|c| minus(c, &corners[0])).collect();
        let doubled = arms.windows(2).map(|pair| cross(&pair[0], &pair[1]));
        let sum = doubled.fold([FixedFloat::ZERO; 3], |sum: Vector<N>, next| {
            std::array::from_fn(|k| sum[k] + next[k])
        });
        Self {
            normal: unit(&sum),
            corners,
        }
    }

    fn longest_edge(&self) -> Vector<N> {
        let next = self.corners.iter().cycle().skip(1);
        let edges = self.corners.iter().zip(next).map(|(a, b)| minus(b, a));
        edges
            .reduce(|long, edge| {
                if dot(&edge, &edge) > dot(&long, &long) {
                    edge
                } else {
                    long
                }
            })
            .unwrap_or([FixedFloat::ZERO; 3])
    }

    /// Corners as (u, s), from `origin`.
    fn flat(
        &self,
        origin: &Vector<N>,
        across: &Vector<N>,
        along: &Vector<N>,
    ) -> Vec<[FixedFloat<N>; 2]> {
        let arms = self.corners.iter().map(|c| minus(c, origin));
        arms.map(|arm| [dot(&arm, across), dot(&arm, along)])
            .collect()
    }
}

/// The power of two, relative to the size of the pair, below which a number is rounding.
const fn negligible_power<const N: usize>() -> i64 {
    // two thirds of the digits
    -((N * 128 / 3) as i64)
}

impl<const N: usize> Section<N> {
    /// The pair; `None` if one plane has the other polygon behind it or in it.
    pub(crate) fn new(inner: &[DVec3], outer: &[DVec3]) -> Option<Self> {
        let (p, q) = (Plate::<N>::new(inner), Plate::<N>::new(outer));
        let (origin_p, origin_q) = (p.corners[0], q.corners[0]);
        let common = cross(&p.normal, &q.normal);
        let is_parallel =
            dot(&common, &common) < FixedFloat::new(1.0).scaled(2 * negligible_power::<N>());
        let along = unit(&if is_parallel {
            p.longest_edge()
        } else {
            common
        });
        let (across_p, across_q) = (cross(&p.normal, &along), cross(&q.normal, &along));
        let between = minus(&origin_q, &origin_p);
        let slope = |value: FixedFloat<N>| if is_parallel { FixedFloat::ZERO } else { value };
        let flat_p = p.flat(&origin_p, &across_p, &along);
        let mut flat_q = q.flat(&origin_q, &across_q, &along);
        // both polygons measure s and t from the same origin
        let shift = dot(&between, &along);
        flat_q.iter_mut().for_each(|c| c[1] = c[1] + shift);
        let size = flat_p.iter().chain(&flat_q).flatten();
        let size = size.fold(dot(&between, &between).sqrt(), |size, x| {
            if x.abs() > size { x.abs() } else { size }
        });
        let negligible = size.scaled(negligible_power::<N>());
        let height = Linear {
            at_zero: dot(&p.normal, &between),
            slope: slope(dot(&p.normal, &across_q)),
        };
        let facing = Linear {
            at_zero: -dot(&q.normal, &between),
            slope: slope(dot(&q.normal, &across_p)),
        };
        let inner = slabs(&flat_p, &facing, negligible);
        let outer = slabs(&flat_q, &height, negligible);
        (!inner.is_empty() && !outer.is_empty()).then_some(Self {
            inner,
            outer,
            foot: Linear {
                at_zero: dot(&across_p, &between),
                slope: dot(&across_p, &across_q),
            },
            height,
            facing,
        })
    }
}

/// The slabs of a polygon where `height` is positive.
fn slabs<const N: usize>(
    corners: &[[FixedFloat<N>; 2]],
    height: &Linear<N>,
    negligible: FixedFloat<N>,
) -> Vec<Slab<N>> {
    let mut breaks: Vec<FixedFloat<N>> = corners.iter().map(|c| c[0]).collect();
    if !height.slope.is_zero() {
        breaks.push(-height.at_zero / height.slope);
    }
    breaks.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
    breaks.dedup_by(|a, b| *a - *b < negligible);
    let least = corners
        .iter()
        .map(|c| c[0])
        .reduce(|a, b| if b < a { b } else { a });
    let most = corners
        .iter()
        .map(|c| c[0])
        .reduce(|a, b| if b > a { b } else { a });
    let (Some(least), Some(most)) = (least, most) else {
        return Vec::new();
    };
    let is_inside = |middle: FixedFloat<N>| least < middle && middle < most;
    let pairs = breaks.windows(2).map(|pair| [pair[0], pair[1]]);
    pairs
        .filter_map(|ends| {
            let middle = (ends[0] + ends[1]).scaled(-1);
            let is_in_front = if height.slope.is_zero() {
                height.at_zero > negligible
            } else {
                height.at(middle).is_positive()
            };
            (is_in_front && is_inside(middle)).then(|| Slab {
                ends,
                lines: lines(corners, middle),
            })
        })
        .filter(|slab| !slab.lines.is_empty())
        .collect()
}

/// The edges that cross `middle`, in order.
fn lines<const N: usize>(corners: &[[FixedFloat<N>; 2]], middle: FixedFloat<N>) -> Vec<Line<N>> {
    let next = corners.iter().cycle().skip(1);
    let crossing = corners.iter().zip(next).filter_map(|(a, b)| {
        let (a, b) = if a[0] < b[0] { (a, b) } else { (b, a) };
        (a[0] < middle && middle < b[0]).then(|| Line {
            from: a[0],
            at: a[1],
            slope: (b[1] - a[1]) / (b[0] - a[0]),
            is_upper: false,
        })
    });
    let mut lines: Vec<_> = crossing.collect();
    lines.sort_by(|a, b| {
        let [a, b] = [a, b].map(|line| line.value(middle));
        a.partial_cmp(&b).unwrap_or(std::cmp::Ordering::Equal)
    });
    for (k, line) in lines.iter_mut().enumerate() {
        line.is_upper = k % 2 == 1;
    }
    lines
}
