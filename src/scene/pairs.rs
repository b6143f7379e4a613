//! The pairs of a scene, ready to be evaluated as its plan wants them.
//!
//! A row is a patch, less what lies in it, or several that are summed ([`Scene::group_of`]); it stands for what is called a patch
//! wherever pairs are listed, measured or summed. What two rows exchange is a sum over pairs of polygons
//! ([`pair`](ScenePairs::pair)); the plan, its classes and its counts are of these.
//!
//! **Memory** O(n) and the distinct values; the ways to all pairs are in [`row_sums`](ScenePairs::row_sums) (nothing held),
//! [`for_each_row`](ScenePairs::for_each_row) (a row at a time) and [`ExchangeAreas`](super::ExchangeAreas) (all of them).
//!
//! **Not covered**: computing with occlusion; an occluded scene is refused ([`Occlusion`]).

use super::aspects::Aspects;
use super::congruence::allowance;
use super::facing::{FacingPlanes, Sight};
use super::members::Members;
use super::plan::{Congruence, Plan};

use super::progress::Progress;
use super::shifts::Shifts;
use super::tally::{PlanSummary, Tally, Unreached};
use super::{ExchangeError, NamedPatch, Occlusion, Scene, SceneError};
use crate::form_factor::{Answer, Polygon, Route};
use crate::numeric::{compensated_sum, try_parallel_map};

/// A scene whose pairs are ready to be evaluated.
#[derive(Debug, Clone)]
pub struct ScenePairs {
    pub(super) plan: Plan,
    pub(super) members: Members,
    pub(super) aspects: Aspects,
    pub(super) shifts: Shifts,
    pub(super) progress: Progress,
    polygons: Vec<Polygon>,
    /// Of the rows.
    areas: Vec<f64>,
    area_bounds: Vec<f64>,
    tolerance: f64,
    /// The value of each class of congruent pairs; none where they are not equal within the tolerance.
    shared: Vec<Option<Answer>>,
}

/// What a pass over all pairs came upon.
#[derive(Debug, Clone, PartialEq)]
pub struct Account {
    /// What was left out, shared and computed.
    pub plan: PlanSummary,
    /// How many pairs of rows miss the tolerance.
    pub unreached: usize,
    /// The worst of them.
    pub worst: Option<Unreached>,
}

impl ScenePairs {
    /// Checks the scene, makes the plan, and computes what congruent pairs share.
    ///
    /// **Arguments** `tolerance`: the relative error asked for, > 0; `occlusion`: the policy for
    /// scenes in which something may stand between two patches.
    ///
    /// # Errors
    /// [`ExchangeError::Scene`] if patches overlap, or if something may stand between two of them
    /// and occlusion is not ignored; [`ExchangeError::Pair`] if two patches are refused.
    ///
    /// # Examples
    /// ```
    /// use infoscene::form_factor::DEFAULT_TOLERANCE;
    /// use infoscene::scene::{Congruence, Occlusion, Scene, ScenePairs};
    /// let (tolerance, cube) = (DEFAULT_TOLERANCE, Scene::built_in("cube:4")?);
    /// let pairs = ScenePairs::try_new(&cube, tolerance, Congruence::Shared, Occlusion::Refuse)?;
    /// // one value per pair: reciprocity is exact
    /// assert_eq!(pairs.pair(0, 20)?, pairs.pair(20, 0)?);
    /// # Ok::<(), infoscene::scene::ExchangeError>(())
    /// ```
    pub fn try_new(
        scene: &Scene,
        tolerance: f64,
        congruence: Congruence,
        occlusion: Occlusion,
    ) -> Result<Self, ExchangeError> {
        occlusion.check(scene)?;
        Self::unchecked(scene, tolerance, congruence)
    }

    /// The pairs of a scene that was checked before, or that nothing in it can overlap or hide.
    pub(crate) fn unchecked(
        scene: &Scene,
        tolerance: f64,
        congruence: Congruence,
    ) -> Result<Self, ExchangeError> {
        let members = Members::of(scene);
        let shapes = members.shapes(scene);
        let planes = FacingPlanes::of(scene, &members.patches, &members.roots);
        let plan = Plan::of(&shapes, planes, congruence);
        let [areas, area_bounds] = areas(&members, &shapes);
        let mut pairs = Self {
            aspects: Aspects::of(&members, &plan.planes),
            shifts: Shifts::of(scene, &members.patches),
            progress: Progress::default(),
            plan,
            members,
            polygons: shapes
                .iter()
                .map(|patch| Polygon::new(patch.shape()))
                .collect(),
            areas,
            area_bounds,
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
        let representatives = pairs.plan.representatives();
        pairs.shared = try_parallel_map(representatives.len(), &|class| {
            let [first, second] = representatives[class];
            let mut answer = pairs.compute(first, second, asked)?;
            let [one, other] = [first, second].map(|index| shapes[index].shape());
            let apart = allowance(spread, one, other);
            let exchange = &mut answer.exchange;
            exchange.error_bound += apart;
            Ok::<_, ExchangeError>((apart <= 0.5 * tolerance * exchange.value).then_some(answer))
        })?;
        Ok(pairs)
    }

    /// Number of rows: of the patches, unless some are summed.
    #[must_use]
    pub fn patches(&self) -> usize {
        self.areas.len()
    }

    /// The rows' areas, without what lies in them.
    #[must_use]
    pub fn areas(&self) -> &[f64] {
        &self.areas
    }

    /// Bounds on the rounding of the areas and of one quotient by them: 4 ε of what they are summed of.
    #[must_use]
    pub fn area_bounds(&self) -> &[f64] {
        &self.area_bounds
    }

    /// The relative error asked for.
    #[must_use]
    pub const fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// For each row the sum of weights over the rows that the plan leaves out for it, itself included unless it may see itself.
    #[must_use]
    pub fn unseen(&self, weights: &[f64]) -> Vec<f64> {
        self.aspects.unseen(&self.plan.planes, weights)
    }

    /// What two rows can exchange, a row with itself, too.
    pub(super) fn sight(&self, first: usize, second: usize) -> Sight {
        let [one, other] = [first, second].map(|row| self.aspects.of_row(row));
        self.aspects.sight(&self.plan.planes, one, other)
    }

    /// What a pair of polygons exchanges whose planes see each other.
    #[inline]
    pub(super) fn look(
        &self,
        first: usize,
        second: usize,
        tally: &mut Tally,
    ) -> Result<Answer, ExchangeError> {
        let shared = self.plan.shared(first, second);
        let shared = shared.and_then(|place| self.shared[place]);
        let answer = match shared {
            Some(answer) => answer,
            None => self.compute(first, second, self.tolerance)?,
        };
        tally.polygons(answer.route, shared.is_none());
        Ok(answer)
    }

    /// One value per pair, between 0 and the smaller area.
    pub(super) fn compute(
        &self,
        first: usize,
        second: usize,
        tolerance: f64,
    ) -> Result<Answer, ExchangeError> {
        let (first, second) = (first.min(second), first.max(second));
        let answer = self.polygons[first].exchange_area(&self.polygons[second], tolerance);
        let mut answer = answer.map_err(|source| ExchangeError::Pair {
            first: self.members.patches[first],
            second: self.members.patches[second],
            source,
        })?;
        let most = self.polygons[first]
            .area()
            .min(self.polygons[second].area());
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
        let n = self.polygons.len();
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

/// The rows' areas and the bounds on their rounding.
fn areas(members: &Members, shapes: &[NamedPatch]) -> [Vec<f64>; 2] {
    let terms = |row: usize| {
        let polygons = members.of_row(row).iter();
        polygons.map(|member| member.sign * shapes[member.polygon].shape.area())
    };
    let rows = || 0..members.rows();
    let bound = |row| 4.0 * f64::EPSILON * compensated_sum(terms(row).map(f64::abs));
    [
        rows().map(|row| compensated_sum(terms(row))).collect(),
        rows().map(bound).collect(),
    ]
}
