//! How many pairs took which way, and whether the tolerance was reached.
//!
//! Counted are pairs of patches, each once, whatever rows they are summed into. What a base lacks is counted with its part: that it is
//! subtracted, too, and computed again for it or to a finer tolerance, does not count. A part that is summed into the row of
//! its base is in no pair. The tolerance is asked of pairs of rows.

use crate::form_factor::{Answer, Route};
use std::collections::BTreeMap;

/// Room for the routes there are.
const ROUTES: usize = 16;

/// What was left out, what was shared, and which route the rest took.
///
/// ```text
///   pairs = untouched + congruent + computed = Σ routes
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default, serde::Serialize)]
pub struct PlanSummary {
    /// Pairs of patches `n(n − 1)/2`; a part in the row of its base is none of the n.
    pub pairs: usize,
    /// Values that are those of their mirror image, `A_j F_ji = A_i F_ij`.
    pub reciprocal: usize,
    /// Planes in which patches lie.
    pub planes: usize,
    /// Pairs never looked at: their planes are the same, or one lies behind the other.
    pub untouched: usize,
    /// Pairs that exchange nothing since they lie in one plane.
    pub coplanar: usize,
    /// Pairs that exchange nothing since one lies behind the other's plane.
    pub back_facing: usize,
    /// Pairs that took the value of a congruent one.
    pub congruent: usize,
    /// Pairs that were computed.
    pub computed: usize,
    /// Pairs by route; congruent ones are counted with the route of the one that was computed.
    pub routes: BTreeMap<&'static str, usize>,
}

/// A pair of rows whose error bound is beyond the tolerance asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unreached {
    /// The smaller index.
    pub first: usize,
    /// The larger index.
    pub second: usize,
    /// The exchange area.
    pub value: f64,
    /// The bound on its error.
    pub error_bound: f64,
}

impl Unreached {
    /// The relative error that is certain; infinite for 0.
    #[must_use]
    pub fn relative(&self) -> f64 {
        self.error_bound / self.value
    }
}

/// Counts of a pass over the pairs.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Tally {
    routes: [Option<(Route, usize)>; ROUTES],
    /// Pairs looked at.
    pub(super) seen: usize,
    /// Those computed on their own.
    pub(super) alone: usize,
    /// Those that miss the tolerance.
    pub(super) unreached: usize,
    /// The worst of them.
    pub(super) worst: Option<Unreached>,
}

impl Tally {
    pub(super) fn count(&mut self, route: Route, pairs: usize) {
        if pairs > 0 {
            let slot = &mut self.routes[route as usize % ROUTES];
            *slot = Some((route, slot.map_or(0, |(_, known)| known) + pairs));
        }
    }

    /// A pair of polygons that was looked at.
    pub(super) fn polygons(&mut self, route: Route, is_alone: bool) {
        self.count(route, 1);
        self.seen += 1;
        self.alone += usize::from(is_alone);
    }

    /// What a pair of rows exchanges.
    pub(super) fn rows(&mut self, [first, second]: [usize; 2], answer: &Answer, tolerance: f64) {
        let (value, error_bound) = (answer.exchange.value, answer.exchange.error_bound);
        if error_bound > tolerance * value {
            self.unreached += 1;
            let unreached = Unreached {
                first: first.min(second),
                second: first.max(second),
                value,
                error_bound,
            };
            self.keep_worst(&unreached);
        }
    }

    /// Of equally bad ones the first.
    fn keep_worst(&mut self, other: &Unreached) {
        let rank = |pair: &Unreached| {
            (
                pair.relative(),
                std::cmp::Reverse((pair.first, pair.second)),
            )
        };
        if self.worst.is_none_or(|worst| {
            let (one, known) = (rank(other), rank(&worst));
            one.0 > known.0 || (one.0 >= known.0 && one.1 > known.1)
        }) {
            self.worst = Some(*other);
        }
    }

    pub(super) fn merge(&mut self, other: &Self) {
        for (route, pairs) in other.routes.iter().flatten() {
            self.count(*route, *pairs);
        }
        self.seen += other.seen;
        self.alone += other.alone;
        self.unreached += other.unreached;
        if let Some(worst) = &other.worst {
            self.keep_worst(worst);
        }
    }

    pub(super) fn routes(&self) -> BTreeMap<&'static str, usize> {
        let routes = self.routes.iter().flatten();
        routes
            .map(|(route, pairs)| (route.name(), *pairs))
            .collect()
    }

    pub(super) fn of(&self, route: Route) -> usize {
        self.routes[route as usize % ROUTES].map_or(0, |(_, pairs)| pairs)
    }
}
