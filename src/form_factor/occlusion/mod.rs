//! Form factors of polygons past others that stand in the way.
//!
//! **Not covered**: everything yet but the bounds 0 and the unoccluded value.

mod arrangement;
mod occluders;
mod outer;
mod point;
mod rule;
mod setting;
mod share;
mod sight;
mod slack;

pub use occluders::Occluders;

pub use point::point_form_factor_past;
pub(crate) use point::{Sight, Viewpoint};

use super::{Answer, ExchangeArea, FormFactorError, Polygon, Route};
use arrangement::{Arrangement, arrange};
use glam::DVec3;
use outer::{Outer, Piece, Wanted, outers};
use rule::Panel;
use setting::Setting;
use share::Share;
use slack::slack;
use std::f64::consts::TAU;

impl Polygon {
    /// The exchange area of the parts of two polygons that see each other past others.
    ///
    /// # Errors
    /// As [`exchange_area`](Self::exchange_area).
    pub fn exchange_area_past(
        &self,
        other: &Self,
        occluders: &Occluders,
        tolerance: f64,
    ) -> Result<Answer, FormFactorError> {
        // a pair has one value, whichever way it is asked for
        let corners = |polygon: &Self| polygon.shape.corners.clone();
        let key = |corner: &DVec3| corner.to_array().map(f64::to_bits);
        if corners(other)
            .iter()
            .map(key)
            .lt(corners(self).iter().map(key))
        {
            return other.exchange_area_past(self, occluders, tolerance);
        }
        let whole = self.exchange_area(other, 0.25 * tolerance)?;
        if occluders.polygons.is_empty() || whole.exchange.value <= 0.0 {
            return Ok(whole);
        }
        let setting = Setting::of([self, other], occluders);
        let square = setting.unit * setting.unit;
        let ExchangeArea { value, error } = whole.exchange;
        let hidden = exchange(&setting, Wanted::Hidden, 0.1 * tolerance * value / square);
        let mut best = ExchangeArea {
            value: value - hidden.value * square,
            error: error + hidden.error * square,
        };
        if best.error > tolerance * best.value {
            let wanted = 0.2 * tolerance * best.value.max(1e-9 * value) / square;
            let seen = exchange(&setting, Wanted::Seen, wanted);
            if seen.error * square < best.error {
                best = ExchangeArea {
                    value: seen.value * square,
                    error: seen.error * square,
                };
            }
        }
        let value = best.value.clamp(0.0, value);
        best.error += (value - best.value).abs();
        best.value = value;
        Ok(Answer {
            exchange: best,
            route: Route::Occluded,
        })
    }
}

/// The exchange area of what is wanted.
fn exchange(setting: &Setting, wanted: Wanted, accuracy: f64) -> ExchangeArea {
    let mut stretches = Vec::new();
    for first in &setting.first {
        for second in &setting.second {
            stretches.extend(outers(setting, [first, second], wanted));
        }
    }
    let total: f64 = stretches
        .iter()
        .map(|outer| outer.sight.along.length())
        .sum();
    let mut sum = Share::default();
    for outer in &stretches {
        for piece in &outer.pieces {
            let share = stretch(outer, piece, accuracy * TAU / total);
            sum.add(Share {
                value: piece.sign * share.value,
                ..share
            });
        }
    }
    ExchangeArea {
        value: sum.value / TAU,
        error: (sum.truncation + sum.rounding) / TAU + slack(setting, &stretches),
    }
}

/// The integral along a stretch.
fn stretch(outer: &Outer, piece: &Piece, accuracy: f64) -> Share {
    let length = outer.sight.along.length();
    let mut sum = Share::default();
    let arrangements = arrangements(outer, piece, &mut sum);
    for found in &arrangements {
        let mut panels = vec![found.range];
        while let Some([from, to]) = panels.pop() {
            let panel = Panel::new(&outer.sight, found, [from, to]);
            let wanted = accuracy * length * (to - from).max(1e-3);
            match panel.integral(wanted) {
                Some(share) => sum.add(share),
                None if to - from < SHORTEST => sum.add(outer.sight.unsettled(to - from)),
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
/// added to the sum.
fn arrangements(outer: &Outer, piece: &Piece, sum: &mut Share) -> Vec<Arrangement> {
    let mut done: Vec<Arrangement> = Vec::new();
    let mut open = vec![Open::Range([0.0, 1.0])];
    let mut untold = 0;
    while let Some(next) = open.pop() {
        let [low, high] = match next {
            Open::Range(range) => range,
            Open::Found(found) => {
                done.push(found);
                continue;
            }
        };
        let width = high - low;
        if width < BRIDGED {
            continue;
        }
        let mut places = PLACES.iter().map(|place| low + place * width);
        let found = places.find_map(|place| {
            let found = arrange(outer, piece, [low, high], place)?;
            let panel = Panel::new(&outer.sight, &found, found.range);
            panel.is_closed().then_some(found)
        });
        if let Some(found) = found {
            let [from, to] = found.range;
            open.push(Open::Range([to, high]));
            if to - from >= BRIDGED {
                open.push(Open::Found(found));
            }
            open.push(Open::Range([low, from]));
        } else if untold < MOST_UNTOLD {
            untold += 1;
            let middle = 0.5 * (low + high);
            open.push(Open::Range([middle, high]));
            open.push(Open::Range([low, middle]));
        } else {
            sum.add(outer.sight.unsettled(width));
        }
    }
    bridged(outer, done, sum)
}

/// Closes the gaps between boundaries, and takes those that are the same as one.
fn bridged(outer: &Outer, found: Vec<Arrangement>, sum: &mut Share) -> Vec<Arrangement> {
    let mut done: Vec<Arrangement> = Vec::new();
    for mut next in found {
        let start = done.last().map_or(0.0, |last| last.range[1]);
        sum.add(outer.sight.bridge(start, next.range[0]));
        let middle = match done.last_mut() {
            None => 0.0,
            Some(last) if last.segments == next.segments => {
                last.range[1] = next.range[1];
                continue;
            }
            Some(last) => {
                last.range[1] = 0.5 * (start + next.range[0]);
                last.range[1]
            }
        };
        next.range[0] = middle;
        done.push(next);
    }
    match done.last_mut() {
        Some(last) => {
            sum.add(outer.sight.bridge(last.range[1], 1.0));
            last.range[1] = 1.0;
        }
        None => sum.add(outer.sight.unsettled(1.0)),
    }
    done
}

/// A range of a stretch, left to right on a stack.
enum Open {
    Range([f64; 2]),
    Found(Arrangement),
}

/// The most ranges of a stretch that are halved because nothing can be told there.
const MOST_UNTOLD: usize = 500;

/// The width of a gap between two boundaries, of the stretch.
const BRIDGED: f64 = 1e-10;

/// The shortest piece of a stretch on which anything is looked for, of its length.
const SHORTEST: f64 = 4.0 * f64::EPSILON;

/// Places at which the boundary is looked for.
const PLACES: [f64; 3] = [0.5, 0.382, 0.724];
