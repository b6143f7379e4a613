//! A convex piece of a plane, with exact integrals of quadratic functions and of their squares.
//!
//! ```text
//!   ∫ |x − c|² = Σ_triangles A/12 (|a|² + |b|² + |d|² + |a + b + d|²)       corners from c
//!   ∫ |x − c|⁶ ≤ s⁴ ∫ |x − c|²,   ∫ |x − c|³ ≤ s ∫ |x − c|²                 s: the farthest corner
//! ```
//!
//! A Gauss rule of 3 × 3 points on each triangle is exact for the fourth degree.

use super::jet::Jet;
use crate::numeric::{GaussLegendre, real};
use glam::DVec2;
use smallvec::SmallVec;

/// A convex polygon in the plane, counter-clockwise.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Piece {
    pub(super) corners: SmallVec<[DVec2; 4]>,
    pub(super) centre: DVec2,
    pub(super) area: f64,
    /// The distance of the farthest corner from the centre.
    pub(super) radius: f64,
    /// `∫ |x − c|²`.
    pub(super) inertia: f64,
}

/// `∫ f` and `∫ f²`, and of functions that are known `∫ x f`.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Integrals {
    pub(super) first: f64,
    pub(super) second: f64,
    /// In the coordinates of the plane.
    pub(super) moment: DVec2,
}

impl Integrals {
    /// Raises a function on a piece by a constant.
    pub(super) fn raise(&mut self, constant: f64, piece: &Piece) {
        self.second += constant * (2.0 * self.first + constant * piece.area);
        self.first += constant * piece.area;
        self.moment += constant * piece.area * piece.centre;
    }

    /// Adds those over another piece.
    pub(super) fn add(&mut self, other: &Self) {
        self.first += other.first;
        self.second += other.second;
        self.moment += other.moment;
    }
}

impl Piece {
    /// The polygon with these corners.
    pub(super) fn new(corners: SmallVec<[DVec2; 4]>) -> Self {
        let triangles = || (1..corners.len() - 1).map(|i| [corners[0], corners[i], corners[i + 1]]);
        let area = |[a, b, c]: [DVec2; 3]| 0.5 * (b - a).perp_dot(c - a);
        let total: f64 = triangles().map(area).sum();
        let moment = triangles().map(|t| (t[0] + t[1] + t[2]) * (area(t) / 3.0));
        let centre = moment.sum::<DVec2>() / total;
        let inertia = triangles().map(|t| {
            let [a, b, c] = t.map(|corner| corner - centre);
            let squares = a.length_squared() + b.length_squared() + c.length_squared();
            area(t) / 12.0 * (squares + (a + b + c).length_squared())
        });
        let inertia = inertia.sum();
        let radius = corners.iter().map(|corner| corner.distance(centre));
        Self {
            centre,
            area: total,
            radius: radius.fold(0.0, f64::max),
            inertia,
            corners,
        }
    }

    /// The parts that its middle and the middles of its edges make.
    pub(super) fn parts(&self) -> impl Iterator<Item = Self> + '_ {
        let n = self.corners.len();
        let corner = move |i: usize| self.corners[i % n];
        let middle = move |i: usize| 0.5 * (corner(i) + corner(i + 1));
        let hub = self.corners.iter().sum::<DVec2>() / real(n);
        let inner =
            (n == 3).then(|| Self::new([middle(0), middle(1), middle(2)].into_iter().collect()));
        let outer = (0..n).map(move |i| {
            let [start, before] = [middle(i), middle(i + n - 1)];
            let mut part: SmallVec<[DVec2; 4]> = SmallVec::new();
            part.extend([corner(i), start]);
            if n > 3 {
                part.push(hub);
            }
            part.push(before);
            Self::new(part)
        });
        outer.chain(inner)
    }

    /// The integrals of functions about the centre.
    pub(super) fn integrals<const N: usize>(&self, functions: &[Jet; N]) -> [Integrals; N] {
        let rule = GaussLegendre::with(3);
        let nodes = || rule.nodes.iter().zip(&rule.weights);
        let start = self.corners[0] - self.centre;
        let mut sums = [Integrals::default(); N];
        for i in 1..self.corners.len() - 1 {
            let [a, b] = [i, i + 1].map(|k| self.corners[k] - self.corners[0]);
            let doubled = a.perp_dot(b);
            for (u, weight) in nodes() {
                let (u, weight) = (0.5 + 0.5 * u, 0.25 * weight * doubled);
                for (v, share) in nodes() {
                    let v = 0.5 + 0.5 * v;
                    let at = start + u * ((1.0 - v) * a + v * b);
                    let weight = weight * share * u;
                    for (sum, function) in sums.iter_mut().zip(functions) {
                        let value = function.at(at);
                        sum.first += weight * value;
                        sum.second += weight * value * value;
                        sum.moment += weight * value * (self.centre + at);
                    }
                }
            }
        }
        sums
    }
}
