//! The exchange areas of a scene's pairs, as its plan wants them.
//!
//! A pair has one value, whichever way it is asked for, so that `A_i F_ij = A_j F_ji` holds exactly. It is at least 0 and
//! at most the smaller area, so that `0 ≤ F ≤ 1`: what lies beyond is the error of a value at the limit, and putting it
//! there brings it nearer to the exact one.
//!
//! **Memory** O(n) and the distinct values; the ways to all pairs are in [`row_sums`](ScenePairs::row_sums) (each pair once, nothing held),
//! [`for_each_row`](ScenePairs::for_each_row) (a row at a time) and [`ExchangeAreas`](super::ExchangeAreas) (all of them).
//!
//! **Not covered**: occlusion.

use super::congruence::allowance;
use super::plan::{Congruence, Plan};
use super::planes::Sight;
use super::tally::{PlanSummary, Tally, Unreached};
use super::{Scene, SceneError};
use crate::form_factor::{Answer, ExchangeArea, Polygon, Route};
use rayon::prelude::*;

/// A scene whose pairs are ready to be evaluated.
#[derive(Debug, Clone)]
pub struct ScenePairs {
    pub(super) plan: Plan,
    polygons: Vec<Polygon>,
    areas: Vec<f64>,
    tolerance: f64,
    /// The value of each class of congruent pairs; none where they are not equal within the tolerance.
    shared: Vec<Option<Answer>>,
}

/// What a pass over all pairs came upon.
#[derive(Debug, Clone, PartialEq)]
pub struct Account {
    /// What was left out, shared and computed.
    pub plan: PlanSummary,
    /// How many pairs miss the tolerance.
    pub unreached: usize,
    /// The worst of them.
    pub worst: Option<Unreached>,
}

/// What a pair whose planes see nothing of each other exchanges.
const fn nothing(route: Route) -> Answer {
    let exchange = ExchangeArea {
        value: 0.0,
        error_bound: 0.0,
    };
    Answer { exchange, route }
}

impl ScenePairs {
    /// Makes the plan, and computes what congruent pairs share.
    ///
    /// **Arguments** `tolerance`: the relative error asked for, > 0.
    ///
    /// # Errors
    /// [`SceneError::Pair`] if two patches are refused; [`SceneError::NotAPatchOfItsOwn`] if one lies in another, or is
    /// summed with another.
    ///
    /// # Examples
    /// ```
    /// use infoscene::form_factor::DEFAULT_TOLERANCE;
    /// use infoscene::scene::{Congruence, Scene, ScenePairs};
    /// let cube = Scene::built_in("cube:4")?;
    /// let pairs = ScenePairs::try_new(&cube, DEFAULT_TOLERANCE, Congruence::Shared)?;
    /// // one value per pair: reciprocity is exact
    /// assert_eq!(pairs.pair(0, 20)?, pairs.pair(20, 0)?);
    /// # Ok::<(), infoscene::scene::SceneError>(())
    /// ```
    pub fn try_new(
        scene: &Scene,
        tolerance: f64,
        congruence: Congruence,
    ) -> Result<Self, SceneError> {
        let patches = scene.patches();
        for index in 0..patches.len() {
            let what = if scene.base_of(index).is_some() {
                "lies in another one"
            } else if scene.group_of(index) != index {
                "is summed with another one"
            } else {
                continue;
            };
            return Err(SceneError::NotAPatchOfItsOwn { index, what });
        }
        let mut pairs = Self {
            plan: Plan::of(scene, congruence),
            polygons: patches
                .iter()
                .map(|patch| Polygon::new(patch.shape()))
                .collect(),
            areas: patches.iter().map(|patch| patch.shape().area()).collect(),
            tolerance,
            shared: Vec::new(),
        };
        let spread = pairs.plan.spread();
        // half of the tolerance is for the differences between congruent pairs
        let asked = if spread > 0.0 {
            0.5 * tolerance
        } else {
            tolerance
        };
        let share = |[first, second]: &[usize; 2]| {
            let mut answer = pairs.compute(*first, *second, asked)?;
            let [one, other] = [first, second].map(|index| patches[*index].shape());
            let apart = allowance(spread, one, other);
            let exchange = &mut answer.exchange;
            exchange.error_bound += apart;
            Ok((apart <= 0.5 * tolerance * exchange.value).then_some(answer))
        };
        let shared: Vec<Result<_, SceneError>> =
            pairs.plan.representatives().par_iter().map(share).collect();
        pairs.shared = shared.into_iter().collect::<Result<_, _>>()?;
        Ok(pairs)
    }

    /// Number of patches.
    #[must_use]
    pub fn patches(&self) -> usize {
        self.areas.len()
    }

    /// The patches' areas.
    #[must_use]
    pub fn areas(&self) -> &[f64] {
        &self.areas
    }

    /// The relative error asked for.
    #[must_use]
    pub const fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// For each patch the sum of weights over the patches that the plan leaves out for it, itself included.
    #[must_use]
    pub fn unseen(&self, weights: &[f64]) -> Vec<f64> {
        let by_plane = self.plan.planes.unseen(weights);
        let plane = |patch| self.plan.planes.of_patch(patch);
        (0..self.patches())
            .map(|patch| by_plane[plane(patch)])
            .collect()
    }

    /// What two patches exchange, and how it was found; a patch with itself nothing.
    ///
    /// # Errors
    /// [`SceneError::NoSuchPatch`]; [`SceneError::Pair`] if the two are refused.
    pub fn pair(&self, first: usize, second: usize) -> Result<Answer, SceneError> {
        let last = self.patches() - 1;
        if let Some(index) = [first, second].into_iter().find(|index| *index > last) {
            return Err(SceneError::NoSuchPatch { index, last });
        }
        match self.plan.sight(first, second) {
            Sight::Open => self.look(first, second, &mut Tally::default()),
            Sight::Coplanar => Ok(nothing(Route::Coplanar)),
            Sight::BackFacing => Ok(nothing(Route::BackFacing)),
        }
    }

    /// A pair whose planes see each other.
    pub(super) fn look(
        &self,
        first: usize,
        second: usize,
        tally: &mut Tally,
    ) -> Result<Answer, SceneError> {
        let shared = self.plan.shared(first, second);
        let answer = match shared.and_then(|place| self.shared[place]) {
            Some(answer) => answer,
            None => {
                tally.alone += 1;
                self.compute(first, second, self.tolerance)?
            }
        };
        tally.pair([first, second], &answer, self.tolerance);
        Ok(answer)
    }

    /// One value per pair, between 0 and the smaller area.
    fn compute(&self, first: usize, second: usize, tolerance: f64) -> Result<Answer, SceneError> {
        let (first, second) = (first.min(second), first.max(second));
        let answer = self.polygons[first].exchange_area(&self.polygons[second], tolerance);
        let mut answer = answer.map_err(|source| SceneError::Pair {
            first,
            second,
            source,
        })?;
        let most = self.areas[first].min(self.areas[second]);
        answer.exchange.value = answer.exchange.value.min(most);
        Ok(answer)
    }

    /// Does a pair take the value of its class, and of which?
    pub(super) fn class(&self, first: usize, second: usize) -> Option<usize> {
        let place = self.plan.shared(first, second)?;
        self.shared[place].map(|_| place)
    }

    /// The counts of a pass over all pairs.
    pub(super) fn account(&self, tally: Tally) -> Account {
        let n = self.patches();
        let left_out = self.plan.planes.pairs_left_out();
        let classes = self.shared.iter().flatten().count();
        self.account_of(n * (n - 1) / 2, left_out, classes, tally)
    }

    /// The counts of a pass over some pairs, some of which were left out, while others took the values of classes.
    pub(super) fn account_of(
        &self,
        pairs: usize,
        [coplanar, back_facing]: [usize; 2],
        classes: usize,
        mut tally: Tally,
    ) -> Account {
        tally.count(Route::Coplanar, coplanar);
        tally.count(Route::BackFacing, back_facing);
        let computed = tally.alone + classes;
        let plan = PlanSummary {
            pairs,
            reciprocal: pairs,
            planes: self.plan.planes.count(),
            untouched: coplanar + back_facing,
            coplanar: tally.of(Route::Coplanar),
            back_facing: tally.of(Route::BackFacing),
            congruent: tally.seen - computed,
            computed,
            routes: tally.routes(),
        };
        Account {
            plan,
            unreached: tally.unreached,
            worst: tally.worst,
        }
    }
}
