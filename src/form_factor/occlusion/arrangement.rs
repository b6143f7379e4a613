//! The boundary of a region that is seen from a point of a stretch, and how far it keeps its shape.
//!
//! ```text
//!   line ℓ runs with its positive side on the left; half-plane k begins or ends on it at
//!   s_k = (γ_k − α_k·p)/(α_k·w)         p: a point of ℓ, w: its direction
//!   k begins or ends by the sign of     (n_ℓ × n_k)_z,
//!   s_k < s_m depends on the sign of    det(n_ℓ, n_k, n_m)
//! ```
//!
//! On each line, a stretch is a boundary if just one of its sides belongs to the region; lines on
//! which sides of two shadows coincide are settled by that, too. Every comparison rests on the sign
//! of a polynomial of degree 2 in the place t along the stretch. The boundary is found at one t, and
//! whatever was compared narrows the range of t for which the boundary has the same corners and
//! sides: between the nearest zeros of the polynomials on either side.

use super::outer::{Outer, Part, Piece};
use super::sight::{Cone, HalfPlane, Region, Sight};
use glam::{DVec2, DVec3};
use smallvec::SmallVec;

/// A side of the boundary: a piece of a line between its crossings with two others, the region on
/// its left.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Segment {
    pub line: usize,
    pub from: usize,
    pub to: usize,
}

/// A boundary, and the range of t in which it is one.
#[derive(Debug, Clone)]
pub(super) struct Arrangement {
    pub segments: Vec<Segment>,
    pub range: [f64; 2],
}

/// A line at the t in question.
#[derive(Debug, Clone, Copy)]
struct Placed {
    alpha: DVec2,
    gamma: f64,
    origin: DVec2,
    direction: DVec2,
    /// Whether it is a line at all, and not at infinity.
    is_line: bool,
}

/// A place on a line: a number, and the line that crosses there.
type Place = (f64, usize);

/// What is compared, and where all comparisons hold.
struct Validity<'a> {
    sight: &'a Sight,
    t: f64,
    range: [f64; 2],
    is_certain: bool,
}

/// No line.
const NONE: usize = usize::MAX;

/// The boundary at t; none if something cannot be told there.
pub(super) fn arrange(
    outer: &Outer,
    piece: &Piece,
    range: [f64; 2],
    t: f64,
) -> Option<Arrangement> {
    let sight = &outer.sight;
    let placed: Vec<Placed> = (0..sight.traces.len()).map(|line| place(sight, line, t)).collect();
    let mut validity = Validity {
        sight,
        t,
        range,
        is_certain: true,
    };
    let regions = outer.shadows.iter().chain([&piece.region]);
    let sides = regions.flat_map(Region::sides);
    let mut lines: Vec<usize> = sides.map(|half| half.line).collect();
    lines.sort_unstable();
    lines.dedup();
    let mut segments = Vec::new();
    for line in lines {
        if !placed[line].is_line {
            continue;
        }
        let within = interval(&piece.region, line, &placed, &mut validity);
        if let Some(within) = within {
            on_line(outer, piece, line, within, &placed, &mut validity, &mut segments);
        }
        if !validity.is_certain {
            return None;
        }
    }
    Some(Arrangement {
        segments,
        range: validity.range,
    })
}

fn place(sight: &Sight, line: usize, t: f64) -> Placed {
    let (alpha, gamma) = sight.line_at(line, t);
    let length = alpha.length();
    let normal = sight.traces[line].normal[0] + t * sight.traces[line].normal[1];
    let is_line = sight.traces[line].edge.is_some() || length > 1e-14 * normal.length();
    let direction = DVec2::new(alpha.y, -alpha.x) / length;
    Placed {
        alpha,
        gamma,
        origin: alpha * (gamma / (length * length)),
        direction,
        is_line,
    }
}

/// The part of a line in a region, but for what the line itself bounds.
fn interval(
    region: &Region,
    line: usize,
    placed: &[Placed],
    validity: &mut Validity,
) -> Option<[Place; 2]> {
    let mut halves: SmallVec<[HalfPlane; 8]> = SmallVec::new();
    for cone in &region.cones {
        if validity.sight.is_level {
            halves.extend(cone.sides.iter().copied());
        } else {
            halves.extend(validity.crossed(cone, line)?);
        }
    }
    halves.extend(region.halves.iter().copied());
    let own = placed[line];
    let mut ends = [(f64::NEG_INFINITY, NONE), (f64::INFINITY, NONE)];
    let mut others: SmallVec<[(usize, usize); 8]> = SmallVec::new();
    for half in halves.iter().filter(|half| half.line != line) {
        let other = placed[half.line];
        if !other.is_line {
            // a plane of sight that is level: all of P is on one side of it
            if half.sign * validity.level_height(half.line) < 0.0 {
                return None;
            }
            continue;
        }
        let slope = half.sign * other.alpha.dot(own.direction);
        let height = half.sign * (other.alpha.dot(own.origin) - other.gamma);
        if !validity.turns(line, half.line) {
            if height < 0.0 {
                return None;
            }
            continue;
        }
        let at = -height / slope;
        let end = usize::from(slope < 0.0);
        others.push((end, half.line));
        let known = ends[end].0;
        if if end == 0 { at > known } else { at < known } {
            ends[end] = (at, half.line);
        }
    }
    for (end, other) in others {
        validity.ordered(line, ends[end].1, other);
    }
    validity.ordered(line, ends[0].1, ends[1].1);
    (ends[0].0 < ends[1].0).then_some(ends)
}

/// Finds the segments on a line.
fn on_line(
    outer: &Outer,
    piece: &Piece,
    line: usize,
    within: [Place; 2],
    placed: &[Placed],
    validity: &mut Validity,
    segments: &mut Vec<Segment>,
) {
    let own = piece.region.side_of(line);
    let [low, high] = within;
    let mut places = vec![low, high];
    // the range of each shadow, and the sides of the line on which it is
    let mut covers: Vec<([f64; 2], Option<f64>)> = Vec::new();
    for shadow in &outer.shadows {
        let Some([from, to]) = interval(shadow, line, placed, validity) else {
            continue;
        };
        validity.ordered(line, from.1, high.1);
        validity.ordered(line, low.1, to.1);
        if from.0 >= high.0 || to.0 <= low.0 {
            continue;
        }
        covers.push(([from.0, to.0], shadow.side_of(line)));
        places.extend([from, to].into_iter().filter(|at| at.0 > low.0 && at.0 < high.0));
        for end in [from, to] {
            validity.ordered(line, low.1, end.1);
            validity.ordered(line, end.1, high.1);
        }
    }
    places.sort_by(|one, other| one.0.total_cmp(&other.0));
    for pair in places.windows(2) {
        validity.ordered(line, pair[0].1, pair[1].1);
    }
    let belongs = |at: f64, side: f64| {
        if own.is_some_and(|own| own != side) {
            return false;
        }
        let mut covers = covers.iter();
        let is_covered = covers.any(|([from, to], only)| {
            *from < at && at < *to && only.is_none_or(|only| only == side)
        });
        is_covered == (piece.part == Part::InShadow)
    };
    let mut open: Option<(f64, Place)> = None;
    for pair in places.windows(2) {
        let at = 0.5 * (pair[0].0 + pair[1].0);
        let state = if pair[1].0 > pair[0].0 {
            let sides = [belongs(at, 1.0), belongs(at, -1.0)];
            f64::from(u8::from(sides[0])) - f64::from(u8::from(sides[1]))
        } else {
            continue;
        };
        if open.is_some_and(|(known, _)| known != state) {
            close(line, open.take(), pair[0], segments);
        }
        if open.is_none() && state != 0.0 {
            open = Some((state, pair[0]));
        }
    }
    close(line, open, high, segments);
}

fn close(line: usize, open: Option<(f64, Place)>, end: Place, segments: &mut Vec<Segment>) {
    if let Some((state, start)) = open {
        let (from, to) = if state > 0.0 { (start.1, end.1) } else { (end.1, start.1) };
        segments.push(Segment { line, from, to });
    }
}

impl Validity<'_> {
    /// The sides of a face between which the plane of sight of a line cuts it; none if it does not.
    fn crossed(&mut self, cone: &Cone, line: usize) -> Option<SmallVec<[HalfPlane; 2]>> {
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
    fn height(&mut self, line: usize, corner: usize) -> f64 {
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
    fn level_height(&self, line: usize) -> f64 {
        let normal = self.sight.traces[line].normal;
        -(normal[0].z + self.t * normal[1].z)
    }

    /// Whether two lines cross; they go on to do so where they do.
    fn turns(&mut self, line: usize, other: usize) -> bool {
        let [one, two] = [line, other].map(|line| self.planar(line));
        let quadratic = product(one, two);
        let size = size(one) * size(two);
        self.keeps_sign(quadratic, size)
    }

    /// The order of two places on a line is kept.
    fn ordered(&mut self, line: usize, one: usize, other: usize) {
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
                self.keeps_sign(product(mixed, *cone), size(mixed).max(size(*a) * size(*b)) * size(*cone));
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
