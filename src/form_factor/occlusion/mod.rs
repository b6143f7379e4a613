//! Form factors of polygons past others that stand in the way.
//!
//! **Not covered**: everything yet but the bounds 0 and the unoccluded value.

mod arrangement;
mod outer;
mod point;
mod rule;
mod setting;
mod sight;

pub use point::point_form_factor_past;
pub(crate) use point::{Sight, Viewpoint};

use super::{Answer, ExchangeArea, FormFactorError, Polygon, Route};
use arrangement::{Arrangement, arrange};
use outer::{Outer, Piece, Wanted, outers};
use rule::{Panel, Share};
use setting::Setting;
use std::f64::consts::TAU;

/// The polygons that may stand between two others, each blocking from both sides.
#[derive(Debug, Clone, Copy)]
pub struct Occluders<'a> {
    /// The polygons, in any order; those that take nothing away cost time only.
    pub polygons: &'a [&'a Polygon],
    /// The distance up to which corners, edges and planes count as meeting; 0 leaves rounding
    /// alone.
    pub touching: f64,
}

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
    let total: f64 = stretches.iter().map(|outer| outer.sight.along.length()).sum();
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
        error: (sum.truncation + sum.rounding) / TAU + setting.slack(&stretches),
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
                None if to - from < 1e-15 => sum.add(outer.sight.unsettled(to - from)),
                None => {
                    let middle = 0.5 * (from + to);
                    panels.extend([[middle, to], [from, middle]]);
                }
            }
        }
    }
    sum
}

/// The boundaries along a stretch, in order; what cannot be told is added to the sum.
fn arrangements(outer: &Outer, piece: &Piece, sum: &mut Share) -> Vec<Arrangement> {
    let mut done: Vec<Arrangement> = Vec::new();
    let mut keep = |found: Arrangement| match done.last_mut() {
        Some(last)
            if last.segments == found.segments && found.range[0] - last.range[1] <= 1e-15 =>
        {
            last.range[1] = found.range[1];
        }
        _ => done.push(found),
    };
    let mut open = vec![Open::Range([0.0, 1.0])];
    while let Some(next) = open.pop() {
        let [low, high] = match next {
            Open::Range(range) => range,
            Open::Found(found) => {
                keep(found);
                continue;
            }
        };
        let width = high - low;
        let mut places = PLACES.iter().map(|place| low + place * width);
        if let Some(found) = places.find_map(|place| arrange(outer, piece, [low, high], place)) {
            let [from, to] = found.range;
            if high - to > 1e-15 {
                open.push(Open::Range([to, high]));
            }
            open.push(Open::Found(found));
            if from - low > 1e-15 {
                open.push(Open::Range([low, from]));
            }
        } else if width < 1e-14 {
            sum.add(outer.sight.unsettled(width));
        } else {
            let middle = 0.5 * (low + high);
            open.push(Open::Range([middle, high]));
            open.push(Open::Range([low, middle]));
        }
    }
    done
}

/// A range of a stretch, left to right on a stack.
enum Open {
    Range([f64; 2]),
    Found(Arrangement),
}

/// Places at which the boundary is looked for.
const PLACES: [f64; 3] = [0.5, 0.382, 0.724];
