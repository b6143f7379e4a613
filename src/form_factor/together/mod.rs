//! Several pairs at once, eight in the lanes of a vector: what a pair costs before its first
//! integrand, and rules of few points, which leave vectors over points half empty.
//!
//! ```text
//!   octet     corners, planes and sizes of eight pairs, number beside number
//!   measures  heights above each other's planes, gap, reach, estimate: ClippedPair's, for eight
//!   plan      pair by pair, the chooser's
//!   kernel    eight that take the same rules; any other plan pair by pair
//! ```
//!
//! Every number is computed by the same operations in the same order as for one pair alone, so
//! that an answer has the same bits whether its pair was asked for alone or among others, whichever
//! they are. The test `pairs_together_have_the_bits_of_pairs_alone` holds it.
//!
//! **Not covered**, and answered alone: rectangles along the axes, whose closed forms are cheaper;
//! polygons of more than one cell; heights that rounding may take for 0, where a clip may be
//! needed.

mod kernel;
mod octet;

use super::clipped_pair::{ClippedPair, Measures};
use super::workspace::Workspace;
use super::{Answer, FormFactorError, Polygon, Route};
use crate::form_factor::chooser::Plan;
use crate::numeric::LANES;
use kernel::{Rule, kernel};
use octet::Octet;
use smallvec::SmallVec;

/// Pairs that are best asked for at a time.
pub(crate) const TOGETHER: usize = 64;

/// Two polygons, and the relative error that is accepted.
pub(crate) type Asked<'p> = ([&'p Polygon; 2], f64);

/// A pair with its measures, whose plan is a rule over both polygons.
#[derive(Debug, Clone, Copy)]
struct Waiting {
    /// The pair's place among those that are asked for.
    place: usize,
    rule: Rule,
    measures: Measures,
    /// The heights of each polygon's corners above the other's plane.
    heights: [[f64; 4]; 2],
    /// The distance by which the planes are off at the other polygon.
    tilted: f64,
}

impl Waiting {
    fn pair<'p>(&'p self, asked: &Asked<'p>) -> ClippedPair<'p> {
        octet::pair(asked, &self.heights, &self.measures, self.tilted)
    }
}

/// Pairs that wait for others with the same rule.
type Queue = SmallVec<[Waiting; TOGETHER]>;

/// Answers for pairs what [`Polygon::exchange_area`] does, with their places; none for those to be
/// asked for alone.
pub(crate) fn exchange_areas(
    pairs: &[Asked<'_>],
    mut answer: impl FnMut(usize, Result<Answer, FormFactorError>),
) {
    if pairs.is_empty() {
        return;
    }
    Workspace::with(|work| {
        let (mut queue, mut octet) = (Queue::new(), Octet::new());
        for (chunk, asked) in pairs.chunks(LANES).enumerate() {
            octet.fill(asked.iter());
            planned(&octet, asked, chunk * LANES, &mut queue, work, &mut answer);
        }
        // small keys, as what waits is large
        let keys = queue.iter().enumerate();
        let mut order: SmallVec<[(u32, usize); TOGETHER]> = keys
            .map(|(at, waiting)| (waiting.rule.order(), at))
            .collect();
        order.sort_unstable();
        for alike in order.chunk_by(|one, other| one.0 == other.0) {
            for some in alike.chunks(LANES) {
                let some: SmallVec<[&Waiting; LANES]> =
                    some.iter().map(|(_, at)| &queue[*at]).collect();
                octet.fill(some.iter().map(|waiting| &pairs[waiting.place]));
                followed(&octet, pairs, &some, work, &mut answer);
            }
        }
    });
}

/// Plans up to eight pairs, the first of which has this place: what takes a rule over both polygons
/// waits, all else is answered.
fn planned(
    octet: &Octet<'_>,
    asked: &[Asked<'_>],
    place: usize,
    queue: &mut Queue,
    work: &mut Workspace,
    answer: &mut impl FnMut(usize, Result<Answer, FormFactorError>),
) {
    let measured = octet.measured();
    for (lane, asked) in asked.iter().enumerate() {
        if !measured.is_served(lane) {
            continue;
        }
        let measures = measured.measures(lane);
        let (heights, tilted) = (measured.heights_of(lane), measured.tilted(lane));
        let pair = octet::pair(asked, &heights, &measures, tilted);
        match pair.first_plan() {
            Plan::Kernel { points } => queue.push(Waiting {
                place: place + lane,
                rule: Rule::of(&pair, points),
                measures,
                heights,
                tilted,
            }),
            _ => answer(place + lane, pair.answer(work)),
        }
    }
}

/// Answers up to eight pairs with the same rule, together if they fill vectors better so.
fn followed(
    octet: &Octet<'_>,
    pairs: &[Asked<'_>],
    alike: &[&Waiting],
    work: &mut Workspace,
    answer: &mut impl FnMut(usize, Result<Answer, FormFactorError>),
) {
    let rule = alike[0].rule;
    let measured = alike
        .iter()
        .map(|waiting| waiting.pair(&pairs[waiting.place]));
    let measured: SmallVec<[ClippedPair<'_>; LANES]> = measured.collect();
    let sums = rule.pays(alike.len()).then(|| {
        let (mut heights, mut reach) = ([[[0.0; LANES]; 4]; 2], [1.0; LANES]);
        for lane in 0..LANES {
            let at = if lane < alike.len() { lane } else { 0 };
            let pair = &measured[at];
            reach[lane] = pair.reach;
            for (k, lanes) in heights.iter_mut().enumerate() {
                for (lanes, height) in lanes.iter_mut().zip(alike[at].heights[k]) {
                    lanes[lane] = height;
                }
                let last = pair.heights[k].len() - 1;
                pair.with_precise_heights(k, |corner, height| {
                    // the last corner of a triangle counts twice
                    let end = if corner == last {
                        lanes.len()
                    } else {
                        corner + 1
                    };
                    for lanes in &mut lanes[corner..end] {
                        lanes[lane] = height;
                    }
                });
            }
        }
        kernel(octet, &heights, &reach, &rule, work)
    });
    for (lane, (waiting, pair)) in alike.iter().zip(&measured).enumerate() {
        let exchange = match sums {
            Some(sums) => pair.kernel_exchange(sums[lane], rule.points, rule.blocks()),
            None => pair.kernel(rule.points, &mut work.blocks),
        };
        let settled = pair.settle(Some(exchange), Route::Kernel, &mut None);
        let found = settled.map_or_else(|| pair.answer(work), Answer::in_range);
        answer(waiting.place, found);
    }
}
