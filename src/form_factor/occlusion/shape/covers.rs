//! Parts of a line that shadows cover, and the segments of a boundary that they leave.

use super::validity::{Place, Validity};
use crate::form_factor::occlusion::view::pages::Part;
use smallvec::SmallVec;

/// A side of the boundary: a piece of a line between its crossings with two others, the region on
/// its left.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Segment {
    pub line: usize,
    pub from: usize,
    pub to: usize,
}

/// A part of a line, and the side of it that is in shadow there; none for both.
pub(crate) type Cover = ([Place; 2], Option<f64>);

/// The segments in a window of a line, from what is in shadow beside it.
///
/// **Arguments** the side of the line on which the region is, if the line bounds it, and the part
/// of the region that counts.
pub(crate) fn segments(
    line: usize,
    window: [Place; 2],
    covers: &[Cover],
    (own, part): (Option<f64>, Part),
) -> SmallVec<[Segment; 4]> {
    let belongs = |at: f64, side: f64| {
        if own.is_some_and(|own| own * side < 0.0) {
            return false;
        }
        let mut covers = covers.iter();
        let is_covered = covers.any(|([from, to], only)| {
            from.at < at && at < to.at && only.is_none_or(|only| only * side > 0.0)
        });
        is_covered == (part == Part::InShadow)
    };
    let mut open: Option<(f64, Place)> = None;
    let mut found: SmallVec<[Segment; 4]> = SmallVec::new();
    for pair in places(window, covers).windows(2) {
        if pair[1].at <= pair[0].at {
            continue;
        }
        let at = 0.5 * (pair[0].at + pair[1].at);
        let sides = [belongs(at, 1.0), belongs(at, -1.0)];
        let state = f64::from(u8::from(sides[0])) - f64::from(u8::from(sides[1]));
        if open.is_some_and(|(known, _)| known * state <= 0.0) {
            found.extend(segment(line, open.take(), pair[0]));
        }
        if open.is_none() && state != 0.0 {
            open = Some((state, pair[0]));
        }
    }
    found.extend(segment(line, open, window[1]));
    found
}

/// The ends of a window and of what covers it, in order.
pub(crate) fn places(window: [Place; 2], covers: &[Cover]) -> SmallVec<[Place; 8]> {
    let [low, high] = window;
    let inner = covers.iter().flat_map(|(ends, _)| *ends);
    let inner = inner.filter(|place| place.at > low.at && place.at < high.at);
    let mut places: SmallVec<[Place; 8]> = [low, high].into_iter().chain(inner).collect();
    places.sort_by(|one, other| one.at.total_cmp(&other.at));
    places
}

/// The union of what covers parts of a line, both sides of it.
pub(crate) fn joined(
    line: usize,
    mut covers: SmallVec<[Cover; 4]>,
    validity: &mut Validity,
) -> SmallVec<[Cover; 4]> {
    covers.sort_by(|one, other| one.0[0].at.total_cmp(&other.0[0].at));
    let mut joined: SmallVec<[Cover; 4]> = SmallVec::new();
    for ([low, high], _) in covers {
        if let Some((last, _)) = joined.last_mut() {
            validity.ordered(line, last[0].line, low.line);
            validity.ordered(line, last[1].line, low.line);
            if low.at <= last[1].at {
                validity.ordered(line, last[1].line, high.line);
                if high.at > last[1].at {
                    last[1] = high;
                }
                continue;
            }
        }
        joined.push(([low, high], None));
    }
    joined
}

/// A segment that is open to the right or to the left, up to its end.
fn segment(line: usize, open: Option<(f64, Place)>, end: Place) -> Option<Segment> {
    let (state, start) = open?;
    let (from, to) = if state > 0.0 {
        (start.line, end.line)
    } else {
        (end.line, start.line)
    };
    Some(Segment { line, from, to })
}
