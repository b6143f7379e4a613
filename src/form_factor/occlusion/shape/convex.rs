//! The boundary of a convex region at one t, and how far it keeps its shape.
//!
//! Without shadows the region is an intersection of half-planes, and so it is in a single one. It
//! is P, cut by one half-plane after the other; corners are crossings of two lines, and
//!
//! ```text
//!   the crossing of i and j is in half-plane k where  −s_k det(n_i, n_j, n_k)/(n_i × n_j)_z ≥ 0
//! ```
//!
//! of degree 2 in t both. While all corners stay in all half-planes the boundary is the same; while
//! one corner stays out of a half-plane, and both its lines run away from that, there is none.

use super::boundary::Arrangement;
use super::covers::Segment;
use super::validity::{NOISE, outer_coefficients, product, roots};
use crate::form_factor::occlusion::view::region::{HalfPlane, Region};
use crate::form_factor::occlusion::view::sight::Sight;
use crate::form_factor::occlusion::view::trace::Placed;
use glam::DVec3;
use smallvec::SmallVec;

/// A region that is an intersection of half-planes, those of P first.
#[derive(Debug)]
pub(crate) struct Convex<'a> {
    sight: &'a Sight<'a>,
    halves: SmallVec<[HalfPlane; 16]>,
    /// The corners of P.
    corners: Vec<Crossing>,
    /// The number of sides of P.
    first: usize,
    /// Whether P is on the other side of a level plane.
    is_empty: bool,
}

/// The crossing of two lines, as a point `(ξ, −1)` but for a factor, of degree 2.
#[derive(Debug, Clone, Copy)]
struct Crossing {
    halves: [usize; 2],
    point: [DVec3; 3],
    size: f64,
    /// The sign of that factor.
    turn: f64,
}

/// The side of a half-plane that a crossing is on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Side {
    In,
    On,
    Out,
}

/// The place at which the shape is asked for, and the range in which it is so.
#[derive(Debug, Clone, Copy)]
struct Scope {
    t: f64,
    range: [f64; 2],
}

/// A region, with what is known of it.
#[derive(Debug)]
pub(crate) struct Known<'a> {
    convex: Option<Convex<'a>>,
    found: Vec<Arrangement>,
}

impl<'a> Known<'a> {
    pub(crate) fn of(convex: Option<Convex<'a>>) -> Self {
        Self {
            convex,
            found: Vec::new(),
        }
    }

    /// The boundary at t with all of the range in which it is that; none if that cannot be told.
    pub(crate) fn at(&mut self, placed: &[Placed], t: f64) -> Option<&Arrangement> {
        let is_there = |found: &Arrangement| found.range[0] < t && t < found.range[1];
        let place = match self.found.iter().position(is_there) {
            Some(place) => place,
            None => {
                let found = self.convex.as_ref()?.arrange(placed, t)?;
                self.found.push(found);
                self.found.len() - 1
            }
        };
        self.found.get(place)
    }
}

type Corners = SmallVec<[Crossing; 12]>;

impl<'a> Convex<'a> {
    /// The part of a region that lies in a shadow, or all of it, if that is convex as seen.
    pub(crate) fn of(sight: &'a Sight, region: &Region, shadow: Option<&Region>) -> Option<Self> {
        if sight.is_level {
            // lines of sight are lines through y there
            return None;
        }
        let mut halves: SmallVec<[HalfPlane; 16]> = SmallVec::new();
        let first = region.cones.first()?.sides.len();
        let inner = shadow.into_iter().flat_map(Region::sides);
        let mut is_empty = false;
        for half in region.sides().chain(inner) {
            let trace = &sight.traces[half.line];
            if trace.is_level {
                // all of P is on one side of it
                let [start, slope] = trace.normal.map(|normal| -half.sign * normal.z);
                if start * (start + slope) <= 0.0 || halves.len() < first {
                    return None;
                }
                is_empty |= start < 0.0;
                continue;
            }
            match halves.iter().find(|known| known.line == half.line) {
                Some(known) if known.sign * half.sign < 0.0 || halves.len() < first => return None,
                Some(_) => {}
                None => halves.push(*half),
            }
        }
        let mut convex = Self {
            sight,
            halves,
            corners: Vec::new(),
            first,
            is_empty,
        };
        // its sides turn as they do wherever y is
        let corners = (0..first).map(|i| convex.crossing([i, (i + 1) % first], 0.5));
        convex.corners = corners.collect::<Option<_>>()?;
        Some(convex)
    }

    /// The boundary at t; none if something cannot be told there.
    pub(crate) fn arrange(&self, placed: &[Placed], t: f64) -> Option<Arrangement> {
        let mut scope = Scope {
            t,
            range: [0.0, 1.0],
        };
        let none = |scope: Scope| Arrangement {
            segments: Vec::new(),
            range: scope.range,
        };
        if self.is_empty {
            return Some(none(scope));
        }
        if !self.halves.iter().all(|half| placed[half.line].is_line) {
            return None;
        }
        let mut corners = Corners::from_slice(&self.corners);
        for k in self.first..self.halves.len() {
            if !self.cut(&mut corners, k, &scope)? {
                self.keeps_out(&corners, k, placed, &mut scope)?;
                return Some(none(scope));
            }
        }
        self.keeps(&corners, &mut scope)?;
        let line = |half: usize| self.halves[half].line;
        let last = corners.iter().cycle().skip(corners.len() - 1);
        let segments = last.zip(&corners).map(|(last, next)| Segment {
            line: line(next.halves[0]),
            from: line(last.halves[0]),
            to: line(next.halves[1]),
        });
        Some(Arrangement {
            segments: segments.collect(),
            range: scope.range,
        })
    }

    /// The crossing of two lines; none if it may be at infinity.
    fn crossing(&self, halves: [usize; 2], t: f64) -> Option<Crossing> {
        let [one, two] = halves.map(|half| &self.sight.traces[self.halves[half].line]);
        let ([a, b], [c, d]) = (one.normal, two.normal);
        let [q0, q1, q2] = product(one.planar, two.planar);
        let turn = q0 + t * (q1 + t * q2);
        (turn.abs() > NOISE * one.planar_size * two.planar_size).then_some(Crossing {
            halves,
            point: [a.cross(c), a.cross(d) + b.cross(c), b.cross(d)],
            size: one.size * two.size,
            turn: turn.signum(),
        })
    }

    /// The determinant that tells on which side of a half-plane a crossing is, and its noise.
    #[inline]
    fn determinant(&self, corner: &Crossing, k: usize) -> ([f64; 3], f64) {
        let trace = &self.sight.traces[self.halves[k].line];
        let ([c, d], [p, q, r]) = (trace.normal, corner.point);
        let factor = -self.halves[k].sign * corner.turn;
        let quadratic = [p.dot(c), q.dot(c) + p.dot(d), r.dot(c) + q.dot(d)];
        (
            quadratic.map(|part| factor * part),
            NOISE * corner.size * trace.size,
        )
    }

    /// The side of a half-plane on which a crossing is at t; none if that cannot be told.
    #[inline]
    fn side(&self, corner: &Crossing, k: usize, scope: &Scope) -> Option<Side> {
        if corner.halves.contains(&k) {
            return Some(Side::In);
        }
        let (quadratic, noise) = self.determinant(corner, k);
        scope.side(quadratic, noise)
    }

    /// Cuts what a half-plane leaves; whether it leaves anything.
    fn cut(&self, corners: &mut Corners, k: usize, scope: &Scope) -> Option<bool> {
        let n = corners.len();
        let mut sides: SmallVec<[Side; 16]> = SmallVec::new();
        for corner in corners.iter() {
            sides.push(self.side(corner, k, scope)?);
        }
        if !sides.contains(&Side::Out) {
            return Some(true);
        }
        // the last corner that is in, before the part that is cut off
        let is_last = |i: &usize| sides[*i] == Side::In && sides[(i + 1) % n] != Side::In;
        let Some(last) = (0..n).find(is_last) else {
            return (!sides.contains(&Side::In)).then_some(false);
        };
        let cut = (1..n).take_while(|i| sides[(last + i) % n] != Side::In);
        let cut = cut.count();
        let is_one_part = sides.iter().filter(|side| **side == Side::In).count() == n - cut;
        let is_out = (1..=cut).any(|i| sides[(last + i) % n] == Side::Out);
        if !is_one_part || !is_out {
            return None;
        }
        corners.rotate_left((last + 1) % n);
        let [into, from] = [corners[0].halves[0], corners[cut - 1].halves[1]];
        corners.rotate_left(cut % n);
        corners.truncate(n - cut);
        corners.push(self.crossing([into, k], scope.t)?);
        corners.push(self.crossing([k, from], scope.t)?);
        Some(true)
    }

    /// Narrows the range to where all corners stay in all half-planes.
    fn keeps(&self, corners: &Corners, scope: &mut Scope) -> Option<()> {
        for corner in corners {
            self.keeps_turning(corner.halves, scope)?;
            let of_first = corner.halves.iter().all(|half| *half < self.first);
            let others = if of_first { self.first } else { 0 }..self.halves.len();
            for k in others {
                if corner.halves.contains(&k) {
                    continue;
                }
                let (quadratic, noise) = self.determinant(corner, k);
                if scope.keeps(quadratic, noise)? == Side::Out {
                    return None;
                }
            }
        }
        Some(())
    }

    /// Narrows the range to where the corner nearest to a half-plane stays out of it, and nothing
    /// between its lines is nearer.
    fn keeps_out(
        &self,
        corners: &Corners,
        k: usize,
        placed: &[Placed],
        scope: &mut Scope,
    ) -> Option<()> {
        let half = self.halves[k];
        let own = &placed[half.line];
        let height = |corner: &Crossing| {
            let [one, other] = corner.halves.map(|half| &placed[self.halves[half].line]);
            let turn = one.alpha.perp_dot(other.alpha);
            let place = (other.gamma * one.alpha.perp() - one.gamma * other.alpha.perp()) / turn;
            half.sign * (own.alpha.dot(place) - own.gamma)
        };
        let nearest = corners.iter().max_by(|one, other| {
            let [one, other] = [one, other].map(|corner| height(corner));
            one.total_cmp(&other)
        })?;
        self.keeps_turning(nearest.halves, scope)?;
        for line in nearest.halves {
            self.keeps_turning([line, k], scope)?;
        }
        let (quadratic, noise) = self.determinant(nearest, k);
        (scope.keeps(quadratic, noise)? == Side::Out).then_some(())
    }

    /// Narrows the range to where two lines cross the way they do.
    fn keeps_turning(&self, halves: [usize; 2], scope: &mut Scope) -> Option<()> {
        let [one, two] = halves.map(|half| &self.sight.traces[self.halves[half].line]);
        let quadratic = product(one.planar, two.planar);
        let noise = NOISE * one.planar_size * two.planar_size;
        scope.keeps(quadratic, noise).map(|_| ())
    }
}

impl Scope {
    /// The sign of a quadratic at t; on is what vanishes all along.
    fn side(&self, [c, b, a]: [f64; 3], noise: f64) -> Option<Side> {
        let here = c + self.t * (b + self.t * a);
        if here > noise {
            return Some(Side::In);
        }
        if here < -noise {
            return Some(Side::Out);
        }
        let outer = outer_coefficients([c, b, a], [0.0, 1.0]);
        let is_tie = outer.iter().all(|value| value.abs() <= noise);
        is_tie.then_some(Side::On)
    }

    /// Narrows the range to where a quadratic has the sign that it has at t.
    fn keeps(&mut self, quadratic: [f64; 3], noise: f64) -> Option<Side> {
        let side = self.side(quadratic, noise)?;
        if side == Side::On {
            return Some(side);
        }
        let [first, middle, last] = outer_coefficients(quadratic, self.range);
        let is_one = first.min(middle).min(last) > 0.0 || first.max(middle).max(last) < 0.0;
        if !is_one {
            for root in roots(quadratic).into_iter().flatten() {
                if root < self.t {
                    self.range[0] = self.range[0].max(root);
                } else {
                    self.range[1] = self.range[1].min(root);
                }
            }
        }
        Some(side)
    }
}
