//! The boundaries along a stretch, one after the other, and the integral over them.
//!
//! A boundary is looked for in the middle of what is open; it holds in a range around, and what is
//! left on both sides is open in turn. Ranges down to 1e-14 of the stretch are kept, as edges at a
//! distance of 1e-10 change shapes at such places; between ranges gaps are bridged.
//!
//! Where several lines coincide up to rounding nothing can be told. Ranges of that kind are halved
//! until what W can change by in them is nothing, and taken as their neighbours are; of those that
//! are left after many halvings the bound has all that they may change.

use super::rule::Panel;
use super::share::Share;
use crate::form_factor::occlusion::shape::arrangement::Roster;
use crate::form_factor::occlusion::shape::boundary::Arrangement;
use crate::form_factor::occlusion::view::outer::{Outer, Piece};

/// The integral along a stretch.
pub(crate) fn stretch(outer: &Outer, piece: &Piece, accuracy: f64) -> Share {
    let length = outer.sight.along.length();
    let mut sum = Share::default();
    let arrangements = arrangements(outer, piece, accuracy * length, &mut sum);
    let mut count = 0;
    let mut panel = Panel::of(&outer.sight);
    let mut panels = Vec::new();
    for found in &arrangements {
        if found.segments.is_empty() {
            continue;
        }
        panels.push(found.range);
        while let Some([from, to]) = panels.pop() {
            count += 1;
            if count > MOST_PANELS || to - from < SHORTEST {
                sum.add(outer.sight.unsettled(to - from));
                continue;
            }
            panel.set(found, [from, to]);
            let wanted = accuracy * length * (to - from).max(1e-3);
            match panel.integral(wanted) {
                Some(share) => sum.add(share),
                None => {
                    let middle = 0.5 * (from + to);
                    panels.extend([[middle, to], [from, middle]]);
                }
            }
        }
    }
    sum
}

/// The boundaries along a stretch, in order.
///
/// Where several things happen at nearly one place, what is between them is not asked for: the
/// boundaries on either side are taken to the middle of such a gap, and what that can change is
/// added to the sum. Wider gaps, where nothing could be told, are as one boundary ends.
fn arrangements(outer: &Outer, piece: &Piece, accuracy: f64, sum: &mut Share) -> Vec<Arrangement> {
    let mut done: Vec<Arrangement> = Vec::new();
    let mut open = vec![Open::Range([0.0, 1.0])];
    let (mut untold, mut narrow) = (0, 0);
    let mut roster = Roster::of(outer, piece);
    while let Some(next) = open.pop() {
        let [low, high] = match next {
            Open::Range(range) => range,
            Open::Found(found) => {
                done.push(found);
                continue;
            }
        };
        let width = high - low;
        if width < NARROWEST || (width < BRIDGED && narrow >= MOST_NARROW) {
            continue;
        }
        let found = widest(&mut roster, outer, [low, high]);
        if let Some(found) = found {
            let [from, to] = found.range;
            open.push(Open::Range([to, high]));
            if to - from >= BRIDGED || (to - from >= NARROWEST && narrow < MOST_NARROW) {
                narrow += usize::from(to - from < BRIDGED);
                open.push(Open::Found(found));
            }
            open.push(Open::Range([low, from]));
        } else if width >= BRIDGED && untold < MOST_UNTOLD {
            untold += 1;
            // what is not told between two boundaries is bridged, as soon as that costs nothing
            if outer.sight.bridge(low, high).truncation > NOTHING * accuracy {
                let middle = 0.5 * (low + high);
                open.push(Open::Range([middle, high]));
                open.push(Open::Range([low, middle]));
            }
        }
    }
    bridged(outer, done, accuracy, sum)
}

/// The boundary at some place in a range: the first that holds in much of it, else the widest.
fn widest(roster: &mut Roster, outer: &Outer, range: [f64; 2]) -> Option<Arrangement> {
    let [low, high] = range;
    let width = |found: &Arrangement| found.range[1] - found.range[0];
    let mut best: Option<Arrangement> = None;
    for place in PLACES {
        let Some(found) = roster.arrange(range, low + place * (high - low)) else {
            continue;
        };
        let is_closed =
            found.is_closed_by_name() || Panel::new(&outer.sight, &found, found.range).is_closed();
        if is_closed && best.as_ref().is_none_or(|best| width(&found) > width(best)) {
            let is_wide = width(&found) > WIDE * (high - low);
            best = Some(found);
            if is_wide {
                break;
            }
        }
    }
    best
}

/// Closes the gaps between boundaries, and takes those that are the same as one.
fn bridged(
    outer: &Outer,
    found: Vec<Arrangement>,
    accuracy: f64,
    sum: &mut Share,
) -> Vec<Arrangement> {
    let mut done: Vec<Arrangement> = Vec::new();
    for mut next in found {
        let start = done.last().map_or(0.0, |last| last.range[1]);
        let gap = [start, next.range[0]];
        let is_wide = gap[1] - gap[0] > BRIDGED;
        match done.last_mut() {
            Some(last) if last.segments == next.segments => {
                sum.add(outer.sight.bridge(gap[0], gap[1]));
                last.range[1] = next.range[1];
                continue;
            }
            last if is_wide => {
                let beside = last.as_deref().unwrap_or(&next);
                sum.add(as_beside(outer, beside, gap, accuracy));
            }
            last => {
                sum.add(outer.sight.bridge(gap[0], gap[1]));
                next.range[0] = 0.0;
                if let Some(last) = last {
                    last.range[1] = 0.5 * (gap[0] + gap[1]);
                    next.range[0] = last.range[1];
                }
            }
        }
        done.push(next);
    }
    match done.last_mut() {
        Some(last) if 1.0 - last.range[1] > BRIDGED => {
            sum.add(as_beside(outer, last, [last.range[1], 1.0], accuracy));
        }
        Some(last) => {
            sum.add(outer.sight.bridge(last.range[1], 1.0));
            last.range[1] = 1.0;
        }
        None => sum.add(outer.sight.unsettled(1.0)),
    }
    done
}

/// The integral over a gap, in which W is what it is in the mean of a strip beside it, but for what
/// it may change by.
fn as_beside(outer: &Outer, beside: &Arrangement, gap: [f64; 2], accuracy: f64) -> Share {
    let width = gap[1] - gap[0];
    let [low, high] = beside.range;
    let strip = if high <= gap[0] {
        [low.max(high - width), high]
    } else {
        [low, high.min(low + width)]
    };
    let change = outer
        .sight
        .bridge(strip[0].min(gap[0]), strip[1].max(gap[1]));
    let unsettled = outer.sight.unsettled(width);
    let mut panel = Panel::new(&outer.sight, beside, strip);
    let Some(share) = panel.integral(NOTHING * accuracy) else {
        return unsettled;
    };
    let times = width / (strip[1] - strip[0]);
    let truncation = times * share.truncation + change.truncation;
    if truncation < unsettled.truncation {
        Share {
            value: times * share.value,
            truncation,
            rounding: times * share.rounding,
        }
    } else {
        unsettled
    }
}

/// A range of a stretch, left to right on a stack.
enum Open {
    Range([f64; 2]),
    Found(Arrangement),
}

/// The most ranges of a stretch that are halved because nothing can be told there.
const MOST_UNTOLD: usize = 100;

/// The most panels of a stretch; what is left then stays unsettled.
const MOST_PANELS: usize = 1000;

/// The part of a stretch's accuracy that is left to a gap between two boundaries.
const NOTHING: f64 = 1e-3;

/// The width of a gap between two boundaries that is not halved, of the stretch.
const BRIDGED: f64 = 1e-10;

/// The narrowest range of a boundary that is looked for, of the stretch.
const NARROWEST: f64 = 1e-14;

/// The most boundaries with ranges below [`BRIDGED`] that are kept of a stretch.
const MOST_NARROW: usize = 50;

/// The shortest piece of a stretch on which anything is looked for, of its length.
const SHORTEST: f64 = 4.0 * f64::EPSILON;

/// The part of a range in which a boundary must hold for no other one to be looked for.
const WIDE: f64 = 1e-6;

/// Places at which the boundary is looked for.
const PLACES: [f64; 3] = [0.5, 0.382, 0.724];
