//! The pairs of a scene, ready to be evaluated by its plan.
//!
//! The exchange area of two rows is a sum over pairs of polygons
//! ([`row_pair`](ScenePairs::row_pair)); the plan, its classes and its counts refer to pairs of
//! polygons.
//!
//! The words are explained in [`exchange`](crate::exchange).
//!
//! **Memory** O(n) and the distinct values. The ways to all pairs are
//! [`row_sums`](ScenePairs::row_sums) (nothing is held), [`for_each_row`](ScenePairs::for_each_row)
//! (a row at a time), [`tile`](ScenePairs::tile) (a tile at a time) and
//! [`ExchangeAreas`](super::ExchangeAreas) (all of them).
//!
//! **Occlusion** is looked up pair by pair ([`Sights`]), where anything can be in the way at all.

use super::plan::{Congruence, Plan};
use super::progress::{Listener, Progress, Unheard};
use super::ranks::{Alone, Ranks, Team};
use super::resolution::Resolution;
use super::{ExchangeError, Selection, Tolerance};
use crate::exchange::pairs::sights::Sights;
use crate::exchange::plan::base_offsets::BaseOffsets;
use crate::exchange::plan::counts::{PassCounts, PassSummary};
use crate::exchange::plan::facing::{Facing, FacingPlanes};
use crate::exchange::rows::plane_sets::PlaneSets;
use crate::exchange::rows::polygons::Polygons;
use crate::exchange::rows::terms::RowTerms;
use crate::form_factor::Answer;
use crate::numeric::{compensated_sum, try_parallel_map};
use crate::scene::{NamedPatch, Occlusion, Scene};
use std::sync::Arc;

/// A scene whose pairs are ready to be evaluated, and who listens to the progress of passes.
#[derive(Debug, Clone)]
pub struct ScenePairs<'p> {
    pub(super) plan: Plan,
    pub(super) terms: RowTerms,
    plane_sets: PlaneSets,
    base_offsets: BaseOffsets,
    /// None if coordinates are exact.
    resolution: Option<Resolution>,
    listener: Listener<'p>,
    team: Team<'p>,
    pub(super) polygons: Polygons,
    /// The names of the rows.
    names: Arc<[String]>,
    /// The areas of the rows.
    areas: Vec<f64>,
    area_bounds: Vec<f64>,
    pub(super) tolerance: Tolerance,
    /// Whether all patches face away from each other.
    is_turned_away: bool,
    /// The value of each class of congruent pairs; none where they are not equal within the
    /// tolerance.
    pub(super) shared: Vec<Option<Answer>>,
    /// None if nothing can be in the way of a pair.
    pub(super) sights: Option<Sights>,
}

impl<'p> ScenePairs<'p> {
    /// Checks the scene, makes the plan, and computes what congruent pairs share.
    ///
    /// **Arguments** `tolerance`: the error accepted of every form factor, a number means a
    /// relative one; `occlusion`: the policy for scenes in which something may stand between two
    /// patches.
    ///
    /// # Errors
    /// [`ExchangeError::Scene`] if patches overlap, or if something may stand between two of them
    /// and occlusion is refused; [`ExchangeError::Pair`] if two patches are refused.
    ///
    /// # Examples
    /// ```
    /// use infoscene::form_factor::DEFAULT_TOLERANCE;
    /// use infoscene::exchange::{Congruence, ScenePairs};
    /// use infoscene::scene::{Occlusion, Scene};
    /// let (tolerance, cube) = (DEFAULT_TOLERANCE, Scene::built_in("cube:4")?);
    /// let pairs = ScenePairs::try_new(&cube, tolerance, Congruence::Shared, Occlusion::Exact)?;
    /// // one value per pair: reciprocity is exact
    /// assert_eq!(pairs.row_pair(0, 20)?, pairs.row_pair(20, 0)?);
    /// # Ok::<(), infoscene::exchange::ExchangeError>(())
    /// ```
    pub fn try_new(
        scene: &Scene,
        tolerance: impl Into<Tolerance>,
        congruence: Congruence,
        occlusion: Occlusion,
    ) -> Result<Self, ExchangeError> {
        occlusion.check(scene)?;
        Self::prepared(scene, tolerance.into(), congruence, occlusion, None)
    }

    /// The pairs of a scene of which only some will be asked for: what does not concern these is
    /// not checked.
    ///
    /// **Arguments** `congruence`: where it is ignored, nothing is prepared but these pairs, and
    /// the work grows with the number of patches if both ends are listed, not with that of all
    /// pairs. Where values are shared, the plan is that of the whole scene, and so is every value.
    ///
    /// # Errors
    /// [`ExchangeError::Scene`] if there is no such row, if a patch of the rows overlaps another
    /// one, or if something may stand between two of the rows and occlusion is refused.
    ///
    /// # Examples
    /// ```
    /// use infoscene::exchange::{Congruence, ScenePairs, Selection};
    /// use infoscene::scene::{Occlusion, Scene};
    /// let cube = Scene::built_in("cube:1")?;
    /// let pair = Selection { from: Some(vec![0]), to: Some(vec![1]) };
    /// let (own, occlusion) = (Congruence::Ignored, Occlusion::Exact);
    /// let pairs = ScenePairs::of_selection(&cube, 1e-12, own, occlusion, &pair)?;
    /// let (entries, _) = pairs.entries(&pair)?;
    /// // opposite faces of a cube
    /// assert!((entries[0].answer.exchange.value - 0.199_824_895_698_387).abs() < 1e-15);
    /// # Ok::<(), infoscene::exchange::ExchangeError>(())
    /// ```
    pub fn of_selection(
        scene: &Scene,
        tolerance: impl Into<Tolerance>,
        congruence: Congruence,
        occlusion: Occlusion,
        selection: &Selection,
    ) -> Result<Self, ExchangeError> {
        selection.check(scene.group_count())?;
        let Some(ends) = selection.ends() else {
            return Self::try_new(scene, tolerance, congruence, occlusion);
        };
        occlusion.check_rows(scene, ends, selection.other_ends())?;
        let alone = (congruence == Congruence::Ignored).then_some(selection);
        Self::prepared(scene, tolerance.into(), congruence, occlusion, alone)
    }

    /// The pairs of a scene that was checked before, or that nothing in it can overlap or hide.
    pub(crate) fn unchecked(
        scene: &Scene,
        tolerance: impl Into<Tolerance>,
        congruence: Congruence,
    ) -> Result<Self, ExchangeError> {
        let nothing = Occlusion::Refuse;
        Self::prepared(scene, tolerance.into(), congruence, nothing, None)
    }

    /// The pairs of a selection alone, or all, of a scene that its policy for occlusion accepts.
    fn prepared(
        scene: &Scene,
        tolerance: Tolerance,
        congruence: Congruence,
        occlusion: Occlusion,
        selection: Option<&Selection>,
    ) -> Result<Self, ExchangeError> {
        let terms = RowTerms::of(scene);
        let shapes = terms.shapes(scene);
        let ends = selection.and_then(Selection::ends);
        let asked = ends.map(|rows| terms.polygons_of(rows));
        let facings = FacingPlanes::of(scene, terms.patches(), terms.roots(), asked.as_deref());
        let others = selection.and_then(Selection::other_ends);
        let needed = asked.zip(others).map(|(mut asked, others)| {
            asked.extend(terms.polygons_of(others));
            asked
        });
        let plan = Plan::of(&shapes, facings, congruence);
        let is_few = selection.is_some_and(Selection::is_few);
        let classes = plan.classes();
        let sights = Sights::of(scene, occlusion, is_few, congruence, classes);
        let [areas, area_bounds] = areas(&terms, &shapes);
        let mut pairs = Self {
            plane_sets: PlaneSets::of(&terms, plan.facings()),
            base_offsets: BaseOffsets::of(scene, terms.patches()),
            resolution: Resolution::of(scene, terms.patches(), sights.is_some()),
            listener: Listener(&Unheard),
            team: Team(&Alone),
            names: scene.group_names().into_iter().map(str::to_owned).collect(),
            plan,
            terms,
            polygons: Polygons::of(&shapes, needed),
            areas,
            area_bounds,
            tolerance,
            is_turned_away: scene.is_turned_away(),
            shared: Vec::new(),
            sights,
        };
        pairs.shared = try_parallel_map(pairs.plan.classes(), &|class| {
            pairs.shared_value(class, &shapes)
        })?;
        Ok(pairs)
    }

    /// Tells a listener how many more pairs are done, of [`pairs`](Self::pairs) in each pass, from
    /// any thread.
    #[must_use]
    pub fn with_progress(mut self, progress: &'p dyn Progress) -> Self {
        self.listener = Listener(progress);
        self
    }

    /// Shares out passes over all pairs among the ranks of a job: each of them asks the same, and
    /// has the same answer.
    #[must_use]
    pub fn among(mut self, ranks: &'p dyn Ranks) -> Self {
        self.team = Team(ranks);
        self
    }

    /// The ranks that share out passes.
    pub(crate) const fn ranks(&self) -> &'p dyn Ranks {
        self.team.0
    }
}

impl ScenePairs<'_> {
    /// Number of rows: of the patches, unless some are summed.
    #[must_use]
    pub const fn rows(&self) -> usize {
        self.areas.len()
    }

    /// Number of pairs of different rows, `n(n − 1)/2`.
    #[must_use]
    pub const fn pairs(&self) -> usize {
        let n = self.rows();
        n * (n - 1) / 2
    }

    /// The names of the rows.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The names of the rows, to be kept.
    pub(crate) fn shared_names(&self) -> Arc<[String]> {
        Arc::clone(&self.names)
    }

    /// The rows' areas, without what lies in them.
    #[must_use]
    pub fn areas(&self) -> &[f64] {
        &self.areas
    }

    /// Bounds on the rounding of the areas and of one quotient by them: 4 ε of what they are summed
    /// of.
    #[must_use]
    pub fn area_bounds(&self) -> &[f64] {
        &self.area_bounds
    }

    /// The error that is accepted of form factors.
    #[must_use]
    pub const fn tolerance(&self) -> Tolerance {
        self.tolerance
    }

    /// Whether all patches face away from each other.
    pub(crate) const fn is_turned_away(&self) -> bool {
        self.is_turned_away
    }

    /// Sums, for each row, the weights of the rows that the plan leaves out for it, its own weight
    /// included unless it may see itself.
    #[must_use]
    pub fn unseen(&self, weights: &[f64]) -> Vec<f64> {
        self.plane_sets.unseen(self.plan.facings(), weights)
    }

    /// The polygons of each row.
    pub(crate) const fn terms(&self) -> &RowTerms {
        &self.terms
    }

    /// The planes that rows lie in.
    pub(crate) const fn plane_sets(&self) -> &PlaneSets {
        &self.plane_sets
    }

    /// Whether two rows can exchange anything, a row with itself included.
    pub(crate) fn facing(&self, first: usize, second: usize) -> Facing {
        let [one, other] = [first, second].map(|row| self.plane_sets.of_row(row));
        self.facing_sets(one, other)
    }

    /// Whether rows of two plane sets can exchange anything.
    pub(crate) fn facing_sets(&self, one: usize, other: usize) -> Facing {
        self.plane_sets.facing(self.plan.facings(), one, other)
    }

    /// Whether two polygons can exchange anything.
    pub(crate) fn facing_polygons(&self, one: usize, other: usize) -> Facing {
        self.plan.facing(one, other)
    }

    /// A bound on the change of an exchange area when a part is moved into its base's plane.
    pub(crate) fn offset_allowance(&self, part: usize, other: usize) -> f64 {
        self.base_offsets.allowance(part, other)
    }

    /// The polygons whose corners may be off; none if coordinates are exact.
    pub(crate) const fn loose(&self) -> Option<&Resolution> {
        self.resolution.as_ref()
    }

    /// Tells the listener that so many more pairs are done.
    pub(crate) fn advance(&self, pairs: usize) {
        self.listener.0.advance(pairs);
    }

    /// The summary of a pass over all pairs.
    pub(crate) fn summary(&self, counts: PassCounts) -> PassSummary {
        let n = self.terms.patches().len();
        let left_out = self.plan.facings().pairs_left_out();
        let is_taken = self.taken_classes();
        let shared = self.shared.iter().zip(is_taken);
        let classes = shared
            .filter(|(value, is_taken)| value.is_some() && *is_taken)
            .count();
        self.summary_of(n * (n - 1) / 2, left_out, classes, counts)
    }

    /// Whether a pair of any rank has taken the value of each class.
    fn taken_classes(&self) -> Vec<bool> {
        let Some(sights) = &self.sights else {
            return vec![true; self.shared.len()];
        };
        let own = (0..self.shared.len()).map(|class| f64::from(u8::from(sights.is_taken(class))));
        let mut all = self.ranks().gather(own.collect()).into_iter();
        let first = all.next().unwrap_or_default();
        let any = all.fold(first, |any, more| {
            any.iter().zip(more).map(|(a, b)| a.max(b)).collect()
        });
        any.into_iter().map(|taken| taken > 0.0).collect()
    }

    /// The summary of a pass over some pairs, some of which were left out, while others took the
    /// values of classes.
    pub(crate) fn summary_of(
        &self,
        pairs: usize,
        left_out: [usize; 2],
        classes: usize,
        counts: PassCounts,
    ) -> PassSummary {
        let are_exact = self.sights.as_ref().map(Sights::are_exact);
        let mut summary = counts.summary(pairs, self.plan.facings().count(), left_out, classes);
        summary.plan.occlusion = summary.plan.occlusion.filter(|_| are_exact == Some(true));
        summary.plan.ignored = summary.plan.ignored.filter(|_| are_exact == Some(false));
        summary.plan.resolution = self.loose().map(Resolution::surfaces);
        summary.is_turned_away = self.is_turned_away;
        summary
    }
}

/// The rows' areas and the bounds on their rounding.
fn areas(terms: &RowTerms, shapes: &[NamedPatch]) -> [Vec<f64>; 2] {
    let parts = |row: usize| {
        let polygons = terms.of_row(row).iter();
        polygons.map(|term| term.sign * shapes[term.polygon].shape().area())
    };
    let rows = || 0..terms.rows();
    let bound = |row| 4.0 * f64::EPSILON * compensated_sum(parts(row).map(f64::abs));
    [
        rows().map(|row| compensated_sum(parts(row))).collect(),
        rows().map(bound).collect(),
    ]
}
