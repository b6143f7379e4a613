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

use crate::form_factor::occlusion::view::region::{Cone, Region};
use crate::form_factor::occlusion::view::sight::Sight;
use crate::form_factor::occlusion::view::trace::Placed;
use glam::DVec2;

/// A place on a line, and the line that crosses there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    pub at: f64,
    pub line: usize,
}

/// Comparisons of lines at t, and the range in which all of them hold.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Validity<'a> {
    pub sight: &'a Sight<'a>,
    /// All lines at t.
    pub placed: &'a [Placed],
    pub t: f64,
    pub range: [f64; 2],
    pub is_certain: bool,
}

/// No line.
pub(crate) const NONE: usize = usize::MAX;

impl Validity<'_> {
    /// The sides of a cone that the plane of sight of a line cuts; none if it does not.
    pub(crate) fn crossing(&self, cone: &Cone, line: usize) -> Option<[usize; 2]> {
        let (mut above, mut below) = (0, 0);
        for corner in &cone.corners {
            let height = self.height(line, *corner);
            above += usize::from(height > 0.0);
            below += usize::from(height < 0.0);
        }
        // a side in the plane counts as across from the others, a corner does not
        let n = cone.corners.len();
        let is_up = match (above, below) {
            (0, 0) => return None,
            (_, 0) if above + 2 <= n => false,
            (0, _) if below + 2 <= n => true,
            (_, 0) | (0, _) => return None,
            _ => true,
        };
        let up = |corner: usize| {
            let height = self.height(line, corner);
            height > 0.0 || (height == 0.0 && is_up)
        };
        let mut found = [n; 2];
        let mut count = 0;
        let mut before = up(cone.corners[n - 1]);
        for (corner, name) in cone.corners.iter().enumerate() {
            let here = up(*name);
            if here != before && count < 2 {
                found[count] = if corner > 0 { corner - 1 } else { n - 1 };
                count += 1;
            }
            before = here;
        }
        (count == 2).then_some(found)
    }

    /// The height of a corner over the plane of sight of a line.
    fn height(&self, line: usize, corner: usize) -> f64 {
        let [start, end] = self.sight.ends_of_height(line, corner);
        start + self.t * (end - start)
    }

    /// All corners of a cone keep to their side of the plane of sight of a line.
    pub(crate) fn keeps_missing(&mut self, cone: &Cone, line: usize) {
        for corner in &cone.corners {
            self.keeps_height(line, *corner);
        }
    }

    /// A corner stays on its side of the plane of sight of a line.
    fn keeps_height(&mut self, line: usize, corner: usize) {
        let [start, end] = self.sight.ends_of_height(line, corner);
        if start == 0.0 && end == 0.0 {
            return;
        }
        let noise = 16.0 * f64::EPSILON * start.abs().max(end.abs());
        let here = start + self.t * (end - start);
        if here.abs() <= noise {
            self.is_certain = false;
        }
        if start * end > 0.0 {
            return;
        }
        let root = start / (start - end);
        if root > self.range[0] && root < self.t {
            self.range[0] = root;
        } else if root >= self.t && root < self.range[1] {
            self.range[1] = root;
        }
    }

    /// The height of P over a level plane of sight, or 0.
    pub(crate) fn level_height(&self, line: usize) -> f64 {
        let normal = self.sight.traces[line].normal;
        -(normal[0].z + self.t * normal[1].z)
    }

    /// Whether two lines have one direction all along.
    pub(crate) fn is_parallel(&self, line: usize, other: usize) -> bool {
        let [one, two] = [line, other].map(|line| &self.sight.traces[line]);
        let quadratic = product(one.planar, two.planar);
        let noise = NOISE * one.planar_size * two.planar_size;
        let outer = self.outer(quadratic);
        outer.iter().all(|value| value.abs() <= noise)
    }

    /// Parallels stay on the same side of each other.
    pub(crate) fn stays_beside(&mut self, line: usize, other: usize) {
        let [one, two] = [line, other].map(|line| self.sight.form(line));
        let direction = self.placed[line].direction.perp();
        let [one, two] = [one, two].map(|form| form.map(|n| [n.truncate().dot(direction), n.z]));
        let mixed = |i: usize, j: usize| one[i][1] * two[j][0] - two[j][1] * one[i][0];
        let quadratic = [mixed(0, 0), mixed(0, 1) + mixed(1, 0), mixed(1, 1)];
        let [one, two] = [line, other].map(|line| &self.sight.traces[line]);
        self.keeps_sign(quadratic, one.size * two.size);
    }

    /// Two lines go on to cross the way they do.
    pub(crate) fn turns(&mut self, line: usize, other: usize) {
        if other == NONE {
            return;
        }
        let [one, two] = [line, other].map(|line| &self.sight.traces[line]);
        let quadratic = product(one.planar, two.planar);
        self.keeps_sign(quadratic, one.planar_size * two.planar_size);
    }

    /// A beginning stays behind an end: nothing is between them.
    pub(crate) fn separates(&mut self, line: usize, ends: [usize; 2]) {
        for end in ends {
            self.turns(line, end);
        }
        self.ordered(line, ends[0], ends[1]);
    }

    /// The crossing of two lines stays in a region.
    pub(crate) fn contains(&mut self, line: usize, other: usize, region: &Region) {
        self.turns(line, other);
        for half in region.sides().filter(|half| half.line != line) {
            self.ordered(line, other, half.line);
        }
    }

    /// Finds something at t, and the range in which it is so, the widest that can be told; none if
    /// nothing can.
    pub(crate) fn widest<T>(&self, find: impl Fn(&mut Self) -> T) -> Option<(T, [f64; 2])> {
        // what changes sign somewhere else may be a tie on all of the range
        [[0.0, 1.0], self.range].into_iter().find_map(|range| {
            let mut validity = Self { range, ..*self };
            let found = find(&mut validity);
            validity.is_certain.then_some((found, validity.range))
        })
    }

    /// Restricts all that was found to this range.
    pub(crate) fn within(&mut self, [from, to]: [f64; 2]) {
        self.range[0] = self.range[0].max(from);
        self.range[1] = self.range[1].min(to);
    }

    /// Places on a line keep their order.
    pub(crate) fn follow(&mut self, line: usize, places: &[Place]) {
        for pair in places.windows(2) {
            self.ordered(line, pair[0].line, pair[1].line);
        }
    }

    /// The order of two places on a line is kept.
    pub(crate) fn ordered(&mut self, line: usize, one: usize, other: usize) {
        if one == other || one == NONE || other == NONE {
            return;
        }
        if self.sight.is_level {
            self.ordered_on_level(line, one, other);
            return;
        }
        let traces = [line, one, other].map(|line| &self.sight.traces[line]);
        let size: f64 = traces.iter().map(|trace| trace.size).product();
        let [a, b, c] = traces.map(|trace| trace.normal);
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
        self.keeps_sign(quadratic, size);
    }

    /// Compares crossings in P's plane, which planes of sight meet in lines through y.
    fn ordered_on_level(&mut self, line: usize, one: usize, other: usize) {
        let mut cones = Vec::new();
        let mut edges = Vec::new();
        for line in [line, one, other] {
            match self.sight.traces[line].edge {
                Some((_, gamma)) => edges.push((self.sight.traces[line].planar, gamma)),
                None => cones.push(self.sight.traces[line].planar),
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

    /// Narrows the range to where a quadratic has the sign that it has at t, if it has one.
    fn keeps_sign(&mut self, quadratic: [f64; 3], size: f64) {
        let [c, b, a] = quadratic;
        let noise = NOISE * size;
        let outer = self.outer(quadratic);
        if outer.iter().all(|value| value.abs() <= noise) {
            return;
        }
        let here = c + self.t * (b + self.t * a);
        if here.abs() <= noise {
            self.is_certain = false;
            return;
        }
        if outer.iter().all(|value| value * here > 0.0) {
            return;
        }
        for root in roots(quadratic).into_iter().flatten() {
            if root < self.t {
                self.range[0] = self.range[0].max(root);
            } else {
                self.range[1] = self.range[1].min(root);
            }
        }
    }

    fn outer(&self, quadratic: [f64; 3]) -> [f64; 3] {
        outer_coefficients(quadratic, self.range)
    }
}

/// The Bernstein coefficients of a quadratic on a range.
pub(crate) fn outer_coefficients([c, b, a]: [f64; 3], [low, high]: [f64; 2]) -> [f64; 3] {
    let at = |t: f64| c + t * (b + t * a);
    [
        at(low),
        c + 0.5 * b * (low + high) + a * low * high,
        at(high),
    ]
}

/// The part of the size of the terms that cannot be told from zero.
pub(crate) const NOISE: f64 = 64.0 * f64::EPSILON;

/// The roots of `c + b t + a t²`.
pub(crate) fn roots([c, b, a]: [f64; 3]) -> [Option<f64>; 2] {
    let square = b * b - 4.0 * a * c;
    if square < 0.0 {
        return [None; 2];
    }
    let sum = -0.5 * (b + square.sqrt().copysign(b));
    let finite = |root: f64| root.is_finite().then_some(root);
    [finite(sum / a), finite(c / sum)]
}

/// `(n1 × n2)_z`, a quadratic in t.
pub(crate) fn product(one: [DVec2; 2], other: [DVec2; 2]) -> [f64; 3] {
    [
        one[0].perp_dot(other[0]),
        one[0].perp_dot(other[1]) + one[1].perp_dot(other[0]),
        one[1].perp_dot(other[1]),
    ]
}

fn size(normal: [DVec2; 2]) -> f64 {
    normal[0].length() + normal[1].length()
}
