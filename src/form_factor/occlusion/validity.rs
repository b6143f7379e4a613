//! Comparisons of places on lines, and the range of t in which they come out the same.
//!
//! ```text
//!   a corner is above a plane of sight    by n(t)·(w − y(t)), linear in t
//!   k begins or ends on ℓ                 by (n_ℓ × n_k)_z, of degree 2
//!   s_k < s_m on ℓ                        by det(n_ℓ, n_k, n_m), of degree 2, as n·v is constant
//! ```
//!
//! The range is cut at the zeros next to t. What is zero all along, up to rounding, is a tie, and
//! either order will do; what cannot be told from zero at t alone makes the comparison uncertain.

use super::sight::{Cone, HalfPlane, Sight};
use glam::{DVec2, DVec3};
use smallvec::SmallVec;

/// What is compared, and where all comparisons hold.
pub(super) struct Validity<'a> {
    pub sight: &'a Sight,
    pub t: f64,
    pub range: [f64; 2],
    pub is_certain: bool,
}

/// No line.
pub(super) const NONE: usize = usize::MAX;

impl Validity<'_> {
    /// The sides of a face between which the plane of sight of a line cuts it; none if it does not.
    pub(super) fn crossed(&mut self, cone: &Cone, line: usize) -> Option<SmallVec<[HalfPlane; 2]>> {
        let heights = cone.corners.iter().map(|corner| self.height(line, *corner));
        let heights: SmallVec<[f64; 8]> = heights.collect();
        let has = |sign: f64| heights.iter().any(|height| height * sign > 0.0);
        let is_up = match [has(1.0), has(-1.0)] {
            [true, true] => true,
            [false, false] => return None,
            // a corner in the plane counts as across from the others
            [up, _] if heights.contains(&0.0) => !up,
            _ => return None,
        };
        let up = |height: f64| if height == 0.0 { is_up } else { height > 0.0 };
        let next = heights.iter().cycle().skip(1);
        let pairs = heights.iter().zip(next).zip(&cone.sides);
        let turning = pairs.filter(|((one, other), _)| up(**one) != up(**other));
        Some(turning.map(|(_, side)| *side).collect())
    }

    /// The height of a corner over the plane of sight of a line, whose sign is kept.
    pub(super) fn height(&mut self, line: usize, corner: usize) -> f64 {
        let [start, end] = self.sight.ends_of_height(line, corner);
        if start == 0.0 && end == 0.0 {
            return 0.0;
        }
        let noise = 16.0 * f64::EPSILON * start.abs().max(end.abs());
        let here = start + self.t * (end - start);
        if here.abs() <= noise {
            self.is_certain = false;
        }
        let root = start / (start - end);
        if root > self.range[0] && root < self.t {
            self.range[0] = root;
        } else if root >= self.t && root < self.range[1] {
            self.range[1] = root;
        }
        here
    }

    /// The height of P over a level plane of sight, or 0.
    pub(super) fn level_height(&self, line: usize) -> f64 {
        let normal = self.sight.traces[line].normal;
        -(normal[0].z + self.t * normal[1].z)
    }

    /// Whether two lines cross; they go on to do so where they do.
    pub(super) fn turns(&mut self, line: usize, other: usize) -> bool {
        let [one, two] = [line, other].map(|line| self.planar(line));
        let quadratic = product(one, two);
        let size = size(one) * size(two);
        self.keeps_sign(quadratic, size)
    }

    /// The order of two places on a line is kept.
    pub(super) fn ordered(&mut self, line: usize, one: usize, other: usize) {
        if one == other || one == NONE || other == NONE {
            return;
        }
        if self.sight.is_level {
            self.ordered_on_level(line, one, other);
            return;
        }
        let [a, b, c] = [line, one, other].map(|line| self.sight.traces[line].normal);
        let cross = [
            a[0].cross(b[0]),
            a[0].cross(b[1]) + a[1].cross(b[0]),
            a[1].cross(b[1]),
        ];
        let quadratic = [
            cross[0].dot(c[0]),
            cross[1].dot(c[0]) + cross[0].dot(c[1]),
            cross[2].dot(c[0]) + cross[1].dot(c[1]),
        ];
        let size = [a, b, c].map(|n| n[0].length() + n[1].length());
        self.keeps_sign(quadratic, size[0] * size[1] * size[2]);
    }

    /// The same in P's plane: planes of sight meet it in lines through y.
    fn ordered_on_level(&mut self, line: usize, one: usize, other: usize) {
        let mut cones = Vec::new();
        let mut edges = Vec::new();
        for line in [line, one, other] {
            match self.sight.traces[line].edge {
                Some((_, gamma)) => edges.push((self.planar(line), gamma)),
                None => cones.push(self.planar(line)),
            }
        }
        match (cones.as_slice(), edges.as_slice()) {
            ([a, b], [(alpha, gamma)]) => {
                self.keeps_sign(product(*a, *b), size(*a) * size(*b));
                let largest = gamma[0].abs() + gamma[1].abs();
                self.keeps_sign([gamma[0], gamma[1], 0.0], largest.max(size(*alpha)));
            }
            ([cone], [(a, g), (b, k)]) => {
                // α1 γ2 − α2 γ1, linear in t
                let mixed = [a[0] * k[0] - b[0] * g[0], a[0] * k[1] - b[0] * g[1]];
                self.keeps_sign(
                    product(mixed, *cone),
                    size(mixed).max(size(*a) * size(*b)) * size(*cone),
                );
            }
            ([], [(a, f), (b, g), (c, k)]) => {
                let [ab, bc, ca] = [
                    a[0].perp_dot(b[0]),
                    b[0].perp_dot(c[0]),
                    c[0].perp_dot(a[0]),
                ];
                let at = |i: usize| ab * k[i] + bc * f[i] + ca * g[i];
                self.keeps_sign([at(0), at(1), 0.0], size(*a) * size(*b) * size(*c));
            }
            _ => {}
        }
    }

    /// The normal of a line in the plane, but for a positive factor.
    fn planar(&self, line: usize) -> [DVec2; 2] {
        let trace = &self.sight.traces[line];
        match trace.edge {
            Some((alpha, _)) => [alpha, DVec2::ZERO],
            None => trace.normal.map(DVec3::truncate),
        }
    }

    /// Narrows the range to where a quadratic has the sign that it has at t; whether it has one.
    fn keeps_sign(&mut self, quadratic: [f64; 3], size: f64) -> bool {
        let [c, b, a] = quadratic;
        let noise = 64.0 * f64::EPSILON * size;
        let at = |t: f64| c + t * (b + t * a);
        let [low, high] = self.range;
        // Bernstein coefficients on the range
        let inner = c + 0.5 * b * (low + high) + a * low * high;
        let outer = [at(low), inner, at(high)];
        if outer.iter().all(|value| value.abs() <= noise) {
            return false;
        }
        let here = at(self.t);
        if here.abs() <= noise {
            self.is_certain = false;
            return true;
        }
        if outer.iter().all(|value| value * here > 0.0) {
            return true;
        }
        for root in roots(quadratic).into_iter().flatten() {
            if root < self.t {
                self.range[0] = self.range[0].max(root);
            } else {
                self.range[1] = self.range[1].min(root);
            }
        }
        true
    }
}

/// The roots of `c + b t + a t²`.
fn roots([c, b, a]: [f64; 3]) -> [Option<f64>; 2] {
    let square = b * b - 4.0 * a * c;
    if square < 0.0 {
        return [None; 2];
    }
    let sum = -0.5 * (b + square.sqrt().copysign(b));
    let finite = |root: f64| root.is_finite().then_some(root);
    [finite(sum / a), finite(c / sum)]
}

fn product(one: [DVec2; 2], other: [DVec2; 2]) -> [f64; 3] {
    [
        one[0].perp_dot(other[0]),
        one[0].perp_dot(other[1]) + one[1].perp_dot(other[0]),
        one[1].perp_dot(other[1]),
    ]
}

fn size(normal: [DVec2; 2]) -> f64 {
    normal[0].length() + normal[1].length()
}
