//! Counts of pairs by route, and of those that miss the tolerance.
//!
//! Pairs of patches are counted, each once, whatever rows they are summed into. A part is counted
//! once: that it is subtracted from its base, too, and computed again for it or to a finer
//! tolerance, does not count. A part that is summed into the row of its base is in no pair. The
//! tolerance is asked of pairs of rows.

use crate::form_factor::{ExchangeArea, Route};
use crate::numeric::real;
use crate::scene::ResolvedSurfaces;
use std::collections::BTreeMap;

/// The pairs that were left out, shared and computed, and the routes that were taken.
///
/// ```text
///   pairs = untouched + congruent + computed + stored
///   pairs − stored = Σ routes
/// ```
#[derive(Debug, Clone, PartialEq, Default, serde::Serialize)]
pub struct PlanSummary {
    /// Pairs of patches `n(n − 1)/2`; a part in the row of its base is none of the n.
    pub pairs: usize,
    /// Values that are those of their mirror image, `A_j F_ji = A_i F_ij`.
    pub reciprocal: usize,
    /// Planes in which patches lie.
    pub planes: usize,
    /// Pairs that were left out: their planes are the same, or one lies behind the other, or convex
    /// bodies hide all.
    pub untouched: usize,
    /// Pairs that exchange nothing since they lie in one plane.
    pub coplanar: usize,
    /// Pairs that exchange nothing since one lies behind the other's plane.
    pub back_facing: usize,
    /// Pairs that took the value of a congruent one.
    pub congruent: usize,
    /// Pairs that were computed; past screens, also those that took the value of a congruent one.
    pub computed: usize,
    /// Pairs that were read from a store.
    #[serde(skip_serializing_if = "is_none")]
    pub stored: usize,
    /// Pairs by route; congruent ones are counted with the route of the one that was computed.
    pub routes: BTreeMap<&'static str, usize>,
    /// The surfaces that the resolution takes as plane, coplanar or touching; none where
    /// coordinates are exact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub resolution: Option<ResolvedSurfaces>,
    /// The pairs by what stands in their way; none where nothing can, or where it was refused.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub occlusion: Option<OcclusionCounts>,
    /// The occlusion that was ignored; none where nothing can stand in the way.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ignored: Option<IgnoredOcclusion>,
}

/// Whether a number of pairs is 0.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde gives a reference")]
const fn is_none(pairs: &usize) -> bool {
    *pairs == 0
}

/// Pairs whose planes face each other, by what stands in their way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize)]
pub struct OcclusionCounts {
    /// Pairs that nothing stands between.
    pub visible: usize,
    /// Pairs that see nothing of each other.
    pub hidden: usize,
    /// Pairs that were evaluated past what stands between them.
    pub partial: usize,
}

/// The occlusion that was ignored.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize)]
pub struct IgnoredOcclusion {
    /// Pairs of patches that something stands between.
    pub pairs: usize,
    /// A bound on what their exchange areas are too large by, in all: their sum.
    pub exchange_area: f64,
}

/// A pair of rows whose error bound is beyond the tolerance asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unreached {
    /// The smaller index.
    pub first: usize,
    /// The larger index.
    pub second: usize,
    /// The larger of their form factors: that from the smaller area.
    pub form_factor: f64,
    /// The bound on its absolute error.
    pub error: f64,
}

/// The outcome of a pass over all pairs.
#[derive(Debug, Clone, PartialEq)]
pub struct PassSummary {
    /// The numbers of pairs that were left out, shared and computed.
    pub plan: PlanSummary,
    /// Number of pairs of rows that miss the tolerance.
    pub unreached: usize,
    /// The worst of them.
    pub worst: Option<Unreached>,
    /// Whether all patches of the scene face away from each other
    /// ([`Scene::is_turned_away`](crate::scene::Scene::is_turned_away)).
    pub is_turned_away: bool,
}

/// Counts of a pass over the pairs.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PassCounts {
    routes: [usize; Route::ALL.len()],
    /// Pairs whose planes face each other.
    visible: usize,
    /// Pairs that were computed on their own.
    alone: usize,
    /// Pairs that were left out as hidden.
    left_out: usize,
    /// Pairs that were computed past what stands between, by whether something was left.
    occluded: [usize; 2],
    /// Pairs that something stands between, if that was ignored.
    ignored: IgnoredOcclusion,
    /// Pairs of rows that miss the tolerance.
    unreached: usize,
    /// The worst of them.
    worst: Option<Unreached>,
}

impl PassCounts {
    fn count(&mut self, route: Route, pairs: usize) {
        self.routes[route as usize] += pairs;
    }

    /// Counts a pair of polygons whose planes face each other.
    pub(crate) fn polygons(&mut self, route: Route, is_alone: bool) {
        self.count(route, 1);
        self.visible += 1;
        self.alone += usize::from(is_alone);
    }

    /// Counts a pair of polygons that something stands between.
    pub(crate) fn occluded(&mut self, route: Route, is_left_out: bool) {
        if is_left_out {
            self.count(route, 1);
            self.left_out += 1;
        } else {
            self.polygons(route, true);
            self.occluded[usize::from(route == Route::Hidden)] += 1;
        }
    }

    /// Counts a pair of polygons that was computed as if nothing stood between.
    pub(crate) fn ignored(&mut self, exchange: &ExchangeArea) {
        self.ignored.pairs += 1;
        self.ignored.exchange_area += exchange.value + exchange.error;
    }

    /// Counts a pair of rows that misses the tolerance, the smaller of which has this area.
    pub(crate) fn unreached(
        &mut self,
        [first, second]: [usize; 2],
        exchange: &ExchangeArea,
        smaller_area: f64,
    ) {
        self.unreached += 1;
        self.keep_worst(&Unreached {
            first: first.min(second),
            second: first.max(second),
            form_factor: exchange.value / smaller_area,
            error: exchange.error / smaller_area,
        });
    }

    /// Keeps the worse of two, and of equally bad ones the first.
    fn keep_worst(&mut self, other: &Unreached) {
        let rank = |pair: &Unreached| (pair.error, std::cmp::Reverse((pair.first, pair.second)));
        if self.worst.is_none_or(|worst| {
            let (one, known) = (rank(other), rank(&worst));
            one.0 > known.0 || (one.0 >= known.0 && one.1 > known.1)
        }) {
            self.worst = Some(*other);
        }
    }

    /// Number of the [numbers](Self::numbers) that stand for the counts.
    pub(crate) const NUMBERS: usize = Route::ALL.len() + 13;

    /// The counts as numbers, to be sent: whole ones are exact up to 2⁵³.
    pub(crate) fn numbers(&self) -> [f64; Self::NUMBERS] {
        let mut numbers = [0.0; Self::NUMBERS];
        let (routes, others) = numbers.split_at_mut(Route::ALL.len());
        for (number, pairs) in routes.iter_mut().zip(self.routes) {
            *number = real(pairs);
        }
        let worst = self.worst.map(|worst| {
            let pair = [worst.first, worst.second].map(real);
            [1.0, pair[0], pair[1], worst.form_factor, worst.error]
        });
        others[..8].copy_from_slice(&[
            real(self.visible),
            real(self.alone),
            real(self.left_out),
            real(self.occluded[0]),
            real(self.occluded[1]),
            real(self.ignored.pairs),
            self.ignored.exchange_area,
            real(self.unreached),
        ]);
        others[8..].copy_from_slice(&worst.unwrap_or_default());
        numbers
    }

    /// The counts that these numbers stand for.
    pub(crate) fn of_numbers(numbers: &[f64]) -> Self {
        let (routes, others) = numbers.split_at(Route::ALL.len());
        let [
            visible,
            alone,
            left_out,
            partial,
            hidden,
            pairs,
            unreached,
            first,
            second,
        ] = [0, 1, 2, 3, 4, 5, 7, 9, 10].map(|place| whole(others[place]));
        let mut counts = Self {
            visible,
            alone,
            left_out,
            occluded: [partial, hidden],
            ignored: IgnoredOcclusion {
                pairs,
                exchange_area: others[6],
            },
            unreached,
            worst: (others[8] > 0.0).then_some(Unreached {
                first,
                second,
                form_factor: others[11],
                error: others[12],
            }),
            ..Self::default()
        };
        for (pairs, number) in counts.routes.iter_mut().zip(routes) {
            *pairs = whole(*number);
        }
        counts
    }

    /// Adds the counts of another part of the pass.
    pub fn merge(&mut self, other: &Self) {
        for (pairs, more) in self.routes.iter_mut().zip(other.routes) {
            *pairs += more;
        }
        self.visible += other.visible;
        self.alone += other.alone;
        self.left_out += other.left_out;
        for (pairs, more) in self.occluded.iter_mut().zip(other.occluded) {
            *pairs += more;
        }
        self.ignored.pairs += other.ignored.pairs;
        self.ignored.exchange_area += other.ignored.exchange_area;
        self.unreached += other.unreached;
        if let Some(worst) = &other.worst {
            self.keep_worst(worst);
        }
    }

    /// The summary of a pass over `pairs` pairs in `planes` planes, some of which were left out,
    /// while others took the values of so many classes.
    pub(crate) fn summary(
        mut self,
        pairs: usize,
        planes: usize,
        [coplanar, back_facing]: [usize; 2],
        classes: usize,
    ) -> PassSummary {
        // where planes are not compared, some pairs find themselves that they see nothing
        let dark = [Route::Coplanar, Route::BackFacing].map(|route| self.routes[route as usize]);
        self.count(Route::Coplanar, coplanar);
        self.count(Route::BackFacing, back_facing);
        let computed = self.alone + classes;
        let [partial, hidden] = self.occluded;
        // each of its terms is rounded
        let roundings = 1.0 + 2.0 * f64::EPSILON * real(self.ignored.pairs);
        let routes = Route::ALL.into_iter().zip(self.routes);
        let plan = PlanSummary {
            pairs,
            reciprocal: pairs,
            planes,
            untouched: coplanar + back_facing + self.left_out,
            coplanar: self.routes[Route::Coplanar as usize],
            back_facing: self.routes[Route::BackFacing as usize],
            congruent: self.visible.saturating_sub(computed),
            computed,
            stored: 0,
            routes: routes
                .filter(|(_, pairs)| *pairs > 0)
                .map(|(route, pairs)| (route.name(), pairs))
                .collect(),
            resolution: None,
            occlusion: Some(OcclusionCounts {
                visible: self
                    .visible
                    .saturating_sub(partial + hidden + dark[0] + dark[1]),
                hidden: self.left_out + hidden,
                partial,
            }),
            ignored: Some(IgnoredOcclusion {
                pairs: self.ignored.pairs,
                exchange_area: self.ignored.exchange_area * roundings,
            }),
        };
        PassSummary {
            plan,
            unreached: self.unreached,
            worst: self.worst,
            is_turned_away: false,
        }
    }
}

/// A count that was sent as a number.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a whole number ≥ 0"
)]
const fn whole(number: f64) -> usize {
    number as usize
}
