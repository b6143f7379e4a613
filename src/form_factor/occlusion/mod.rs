//! Form factors of polygons past others that stand in the way, with bounds.
//!
//! ```text
//!   A_P F = (1/2π) Σ_g ∫_g dy · W(R_g(y)),     W(R) = Σ ∮_∂R ln|x − y| dx
//! ```
//!
//! over the edges g of Q *and of the screens*, the polygons in the way. R_g(y) is the set of points
//! x of P that see y as a boundary of what they see of Q:
//!
//! ```text
//!   y on an edge of Q        P without the shadows of the screens, as cast from y
//!   y on an edge of a screen P ∩ (Q mirrored through y), without the shadows of screens below y
//!                            and the mirrored shadows of those above
//! ```
//!
//! Both are Stokes' theorem: once for the part of Q that x sees, once over P. A rule over P needs N²
//! nodes, this one N, and nothing is singular where a screen touches P, stands on it, pierces it or
//! lies close above it. As W is known in closed form for a polygon R, what is left is an integral
//! along g of a function that is analytic between the places where the shape of R changes.
//!
//! | step | file |
//! |---|---|
//! | the pair in the frame of P, clipped, cut into convex faces, edges and corners shared | `setting` |
//! | stretches of edges, and the faces through them, between which x looks past | `outer` |
//! | planes of sight through y(t) and an edge, linear in t | `sight` |
//! | the boundary of R at one t, and where it keeps this shape | `chord`, `arrangement`, `validity` |
//! | its corners as rational functions of t, Gauss rules with a-priori bounds | `corner`, `bound`, `rule` |
//! | what displaced corners can change | `slack` |
//! | from a point, in closed form | `point` |
//!
//! **Two forms.** Over the edges of Q the part of P in shadow gives what is hidden, which is taken
//! from the unoccluded value; where a quarter or less is left of that, so that digits cancel, the
//! lit part gives what is seen, and the better of the two is the answer. Screens that no line of
//! sight meets are left out before.
//!
//! **Bounds.** The error is the sum of the truncation of each rule, of what lies between shapes that
//! change at almost one place, of rounding, and of the rounding of corners. Shapes are decided by
//! signs of polynomials of degree 2 away from their zeros, and a boundary that does not close is
//! none; where nothing can be told, `|W| ≤ 2 √(π A_P) |v|` is added. A range in which two events
//! nearly coincide is not looked into; there W is taken as beside it, and the product of its rate
//! of change and the squared width is added.
//!
//! **Accuracy** within 1e-14 of two independent integrals for 54 pairs of 20 kinds, but for values
//! below 1e-5 of the unoccluded one, where 1e-16 of that is left
//! (`pairs_past_others_are_right_to_twelve_digits`). Rounding leaves bounds of some 1e-14 of the
//! squared size of the pair and its distance, so that small or distant pairs miss a tolerance of
//! 1e-12; the answer says so. Pairs a million times smaller than their distance or than they are
//! wide keep few digits, as the bound tells.
//!
//! **Not covered**: screens that let light through; curved ones.
//!
//! Reference: Nishita and Nakamae, "Continuous tone representation of three-dimensional objects
//! taking account of shadows and interreflection", *SIGGRAPH* 1985, for the contour of what a
//! point sees.

mod arrangement;
mod bound;
mod chord;
mod corner;
mod occluders;
mod outer;
mod point;
mod rule;
mod setting;
mod share;
mod sight;
mod slack;
mod validity;

pub use occluders::Occluders;

pub use point::point_form_factor_past;
pub(crate) use point::{Sight, Viewpoint};

use super::{Answer, ExchangeArea, FormFactorError, Polygon, Route};
use arrangement::{Arrangement, Roster};
use glam::DVec3;
use outer::{Outer, Piece, Wanted, outers};
use rule::Panel;
use setting::Setting;
use share::Share;
use slack::slack;
use std::f64::consts::TAU;

impl Polygon {
    /// The exchange area of two polygons past others, which block from both sides.
    ///
    /// **Arguments** `tolerance`: relative, 0 or more.
    /// **Returns** the value, in squared units of length, from 0 to the unoccluded one, with a bound
    /// on its error, which may exceed the tolerance. It is the same for either order of the pair.
    /// **Accuracy** see the module's text.
    ///
    /// # Errors
    /// As [`exchange_area`](Self::exchange_area).
    ///
    /// # Examples
    /// ```
    /// use glam::DVec3;
    /// use infoscene::form_factor::{Occluders, Polygon};
    /// use infoscene::geometry::{GeometryError, Patch};
    /// let square = |z: f64, mut corners: Vec<[f64; 2]>, is_up: bool| {
    ///     if !is_up {
    ///         corners.reverse();
    ///     }
    ///     let corners = corners.iter().map(|[x, y]| DVec3::new(*x, *y, z)).collect();
    ///     Ok::<_, GeometryError>(Polygon::new(&Patch::try_new(corners)?))
    /// };
    /// let whole = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let (floor, ceiling) = (square(0.0, whole.clone(), true)?, square(1.0, whole, false)?);
    /// // a plate from one wall to the middle hides half of what the two exchange
    /// let half = vec![[0.5, -9.0], [9.0, -9.0], [9.0, 9.0], [0.5, 9.0]];
    /// let plate = square(0.5, half, true)?;
    /// let polygons = [&plate];
    /// let occluders = Occluders { polygons: &polygons, touching: 0.0 };
    /// let past = floor.exchange_area_past(&ceiling, &occluders, 1e-12)?.exchange;
    /// let bare = floor.exchange_area(&ceiling, 1e-12)?.exchange;
    /// assert!((past.value - 0.5 * bare.value).abs() <= past.error + 0.5 * bare.error);
    /// assert!(past.error <= 1e-12 * past.value);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn exchange_area_past(
        &self,
        other: &Self,
        occluders: &Occluders,
        tolerance: f64,
    ) -> Result<Answer, FormFactorError> {
        let near: Vec<&Self> = occluders.near([self, other]).collect();
        if near.is_empty() {
            return self.exchange_area(other, tolerance);
        }
        let occluders = &Occluders {
            polygons: &near,
            ..*occluders
        };
        let tolerance = tolerance.max(FINEST);
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
        let whole = self.exchange_area(other, 0.1 * tolerance)?;
        if whole.exchange.value <= 0.0 {
            return Ok(whole);
        }
        let setting = Setting::of([self, other], occluders);
        if setting.screens.is_empty() && setting.lost == 0.0 {
            return Ok(whole);
        }
        let square = setting.unit * setting.unit;
        let ExchangeArea { value, error } = whole.exchange;
        if setting.first.is_empty() || setting.second.is_empty() {
            // too small for what counts as touching: nothing is known but the limits
            return Ok(Answer {
                exchange: ExchangeArea {
                    value: 0.5 * value,
                    error: 0.5 * value + error,
                },
                route: Route::Occluded,
            });
        }
        let hidden = exchange(&setting, Wanted::Hidden, 0.05 * tolerance * value / square);
        let mut best = ExchangeArea {
            value: value - hidden.value * square,
            error: error + hidden.error * square,
        };
        if best.error > tolerance * best.value && best.value < MOST_CANCELLED * value {
            let wanted = 0.2 * tolerance * best.value.max(1e-9 * value) / square;
            let seen = exchange(&setting, Wanted::Seen, wanted);
            if seen.error * square < best.error {
                best = ExchangeArea {
                    value: seen.value * square,
                    error: seen.error * square,
                };
            }
        }
        best = ExchangeArea {
            value: best.value.clamp(0.0, value),
            error: best.error + (best.value.clamp(0.0, value) - best.value).abs(),
        };
        // nothing is less than none of it or more than all
        best.error = best.error.min(best.value.max(value - best.value) + error);
        if !(best.value.is_finite() && best.error.is_finite()) {
            // sizes whose squares leave the range
            return Err(FormFactorError::OutOfRange {
                value: whole.exchange.value,
            });
        }
        Ok(Answer {
            exchange: best,
            route: Route::Occluded,
        })
    }
}

/// The share of the unoccluded value below which digits are lost by taking away what is hidden.
const MOST_CANCELLED: f64 = 0.25;

/// No finer relative tolerance is worked for.
const FINEST: f64 = 4.0 * f64::EPSILON;

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
        error: (sum.truncation + sum.rounding) / TAU + slack(setting, &stretches) + setting.lost,
    }
}

/// The integral along a stretch.
fn stretch(outer: &Outer, piece: &Piece, accuracy: f64) -> Share {
    let length = outer.sight.along.length();
    let mut sum = Share::default();
    let arrangements = arrangements(outer, piece, &mut sum);
    let mut count = 0;
    for found in &arrangements {
        let mut panels = vec![found.range];
        while let Some([from, to]) = panels.pop() {
            count += 1;
            if count > MOST_PANELS || to - from < SHORTEST {
                sum.add(outer.sight.unsettled(to - from));
                continue;
            }
            let panel = Panel::new(&outer.sight, found, [from, to]);
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
/// added to the sum.
fn arrangements(outer: &Outer, piece: &Piece, sum: &mut Share) -> Vec<Arrangement> {
    let mut done: Vec<Arrangement> = Vec::new();
    let mut open = vec![Open::Range([0.0, 1.0])];
    let mut untold = 0;
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
        if width < BRIDGED {
            continue;
        }
        let mut places = PLACES.iter().map(|place| low + place * width);
        let found = places.find_map(|place| {
            let found = roster.arrange([low, high], place)?;
            let is_closed = found.is_closed_by_name()
                || Panel::new(&outer.sight, &found, found.range).is_closed();
            is_closed.then_some(found)
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

/// The most panels of a stretch; what is left then stays unsettled.
const MOST_PANELS: usize = 1000;

/// The width of a gap between two boundaries, of the stretch.
const BRIDGED: f64 = 1e-10;

/// The shortest piece of a stretch on which anything is looked for, of its length.
const SHORTEST: f64 = 4.0 * f64::EPSILON;

/// Places at which the boundary is looked for.
const PLACES: [f64; 3] = [0.5, 0.382, 0.724];
