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
use super::sight::{HalfPlane, Region, Sight};
use super::validity::{NONE, Validity};
use glam::DVec2;
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

/// The boundary at t; none if something cannot be told there.
pub(super) fn arrange(
    outer: &Outer,
    piece: &Piece,
    range: [f64; 2],
    t: f64,
) -> Option<Arrangement> {
    let sight = &outer.sight;
    let placed: Vec<Placed> = (0..sight.traces.len())
        .map(|line| place(sight, line, t))
        .collect();
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
            on_line(
                outer,
                piece,
                line,
                within,
                &placed,
                &mut validity,
                &mut segments,
            );
        }
        if !validity.is_certain {
            return None;
        }
    }
    // a side without end is none of a part of P
    let is_bounded = |segment: &Segment| segment.from != NONE && segment.to != NONE;
    segments.iter().all(is_bounded).then_some(Arrangement {
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
        places.extend(
            [from, to]
                .into_iter()
                .filter(|at| at.0 > low.0 && at.0 < high.0),
        );
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
        if own.is_some_and(|own| own * side < 0.0) {
            return false;
        }
        let mut covers = covers.iter();
        let is_covered = covers.any(|([from, to], only)| {
            *from < at && at < *to && only.is_none_or(|only| only * side > 0.0)
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
        if open.is_some_and(|(known, _)| known * state <= 0.0) {
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
        let (from, to) = if state > 0.0 {
            (start.1, end.1)
        } else {
            (end.1, start.1)
        };
        segments.push(Segment { line, from, to });
    }
}
