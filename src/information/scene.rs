//! Positional entropy, entropy rate and mutual information of a scene's visibility chain, from its
//! pairs as they come.
//!
//! The matrix is never held. With the areas as weights the sums over rows need one pass, because
//! the total N of an open chain can be put in afterwards:
//!
//! ```text
//!   q_ij = A_i A_j / A_T
//!   Σ_j J_ij ln(J_ij N/(A_i A_j)) = Σ_j q_ij φ(J_ij/q_ij − 1) + (r_i − A_i) + r_i ln(N/A_T)
//! ```
//!
//! where `r_i = Σ_j J_ij`. For a closed scene the last two vanish and the rest is a sum of
//! terms ≥ 0; pairs left out by the plan give `Σ q_ij`, plane by plane.
//!
//! **Errors** `f(J) = J log2(J/q) − (J − q)/ln 2` is convex with slope `log2(J/q)`. If J is known
//! to ± e < J,
//!
//! ```text
//!   |Δf| ≤ e (|log2(J/q)| + e/((J − e) ln 2)),
//! ```
//!
//! summed over all pairs: a *bound* for a closed scene, whose exact weights are the areas. For an
//! open scene the errors also move the escaping parts and N; their first-order effect is added, and
//! the result is an *estimate*.
//!
//! **Not covered**: terms below 1e-308 of the total.

use super::chain::{Unit, divergence_error, pair_divergence};
use super::resolution::{Changes, InformationResolution};
use crate::chain::ChainError;
use crate::exchange::{Closure, PairSource, PassSummary, ScenePairs};
use crate::form_factor::ExchangeArea;
use crate::numeric::functions::elementary::{ln, log2};
use crate::numeric::{Bounded, Grade, compensated_sum, tolerance, x_log2_x};
use std::f64::consts::LN_2;

/// The treatment of power that meets no patch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OpenScene {
    /// An open scene is refused.
    Refuse,
    /// One more state, `outside`, takes what escapes.
    AddOutsideState,
}

/// The information of a scene's chain, in bits.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneInformation {
    /// Positional entropy, eq. (1).
    pub positional_entropy: f64,
    /// Entropy rate, eq. (2): `H_p − I`.
    pub entropy_rate: f64,
    /// Mutual information, eq. (3); its error is a bound for a closed scene, an estimate for an
    /// open one.
    pub mutual_information: Bounded,
    /// Bounds on what the resolution of the coordinates can change, beside the error; none where
    /// that is not known.
    pub resolution: Option<InformationResolution>,
    /// The terms of eq. (3) by patch, or by the row that several are summed into,
    /// `w_i Σ_j P_ij log2(P_ij/w_j)`.
    pub contributions: Vec<f64>,
    /// The term of the state `outside`, if there is one.
    pub outside_contribution: Option<f64>,
    /// Stationary probabilities of the patches: areas, or generalised areas, over their sum.
    pub weights: Vec<f64>,
    /// Sum of the areas.
    pub total_area: f64,
    /// The sums of the rows of form factors.
    pub closure: Closure,
    /// The plan, and whether the tolerance was reached.
    pub summary: PassSummary,
}

/// Sums of one row, in units of [`Unit`] and nats.
const VALUE: usize = 0;
const BOUND: usize = 1;
const DIVERGENCE: usize = 2;
const DIVERGENCE_ERROR: usize = 3;

/// The information of a scene's visibility chain, each pair taken once and none held.
///
/// **Arguments** `pairs`: those of the scene, or its stored matrix.
///
/// # Errors
/// [`ChainError::Exchange`] for an open scene without [`OpenScene::AddOutsideState`], for rows
/// above one, and if two patches are refused.
///
/// # Examples
/// ```
/// use infoscene::information::{OpenScene, scene_information};
/// use infoscene::exchange::{Congruence, ScenePairs};
/// use infoscene::scene::{Occlusion, Scene};
/// let cube = Scene::built_in("cube:1")?;
/// let pairs = ScenePairs::try_new(&cube, 1e-12, Congruence::Shared, Occlusion::Exact)?;
/// let cube = scene_information(&pairs, OpenScene::Refuse)?;
/// // one patch per face, from a 50-digit evaluation
/// assert!((cube.mutual_information.value - 0.263_034_544_099_120_5).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn scene_information<'s>(
    pairs: impl Into<PairSource<'s>>,
    open_scene: OpenScene,
) -> Result<SceneInformation, ChainError> {
    let (information, _) = information_with_sums(pairs.into(), open_scene, |_, _, terms| terms)?;
    Ok(information)
}

/// The terms of a pair in the sums of a row: value, bound, divergence, error of the divergence.
pub(super) type PairTerms = [f64; 4];

/// The information of [`scene_information`], and sums over rows that were taken in the same pass.
///
/// **Arguments** `terms`: the terms of a pair of rows, from its exchange area and the terms of the
/// information, which come first and unchanged.
pub(super) fn information_with_sums<const N: usize>(
    source: PairSource<'_>,
    open_scene: OpenScene,
    terms: impl Fn([usize; 2], &ExchangeArea, PairTerms) -> [f64; N] + Sync,
) -> Result<(SceneInformation, Vec<[f64; N]>), ChainError> {
    let pairs = source.pairs();
    let scene = RowSums::of(source, terms)?;
    match open_scene {
        OpenScene::Refuse => scene.closure.require_closed()?,
        OpenScene::AddOutsideState => scene.closure.require_at_most_one()?,
    }
    let is_closed = scene.closure.is_closed();
    let outside = scene.outside(is_closed);
    let contributions = scene.contributions(pairs, &outside, is_closed);
    let outside_contribution = (!is_closed).then(|| {
        let terms = scene.areas.iter().enumerate();
        compensated_sum(terms.map(|(i, w)| outside.term(i, *w))) / (outside.total * LN_2)
    });
    let all = contributions.iter().copied().chain(outside_contribution);
    let mutual_information = compensated_sum(all);
    let weights = scene.areas.iter().copied().chain([outside.weight]);
    let positional_entropy =
        0.0 - compensated_sum(weights.map(|weight| x_log2_x(weight / outside.total)));
    let rounding = tolerance::INFORMATION * (2.0 + mutual_information);
    let error = scene.error(&outside, is_closed, mutual_information);
    let information = SceneInformation {
        positional_entropy,
        // a difference below rounding may come out on the other side of 0
        entropy_rate: (positional_entropy - mutual_information).max(0.0),
        mutual_information: Bounded::of_grade(
            mutual_information,
            error / outside.total + rounding,
            if is_closed {
                Grade::Bound
            } else {
                Grade::Estimate
            },
        ),
        resolution: Some(scene.resolution(&outside, is_closed, mutual_information)),
        contributions,
        outside_contribution,
        weights: scene
            .areas
            .iter()
            .map(|area| area / outside.total)
            .collect(),
        total_area: scene.total_area,
        closure: scene.closure,
        summary: scene.summary,
    };
    Ok((information, scene.sums))
}

/// The sums over the rows of a scene, in units of [`Unit`].
struct RowSums<const N: usize> {
    /// The area in the unit of the scene.
    total_area: f64,
    area: f64,
    areas: Vec<f64>,
    area_bounds: Vec<f64>,
    sums: Vec<[f64; N]>,
    closure: Closure,
    summary: PassSummary,
    /// None if coordinates are exact.
    changes: Option<Changes>,
}

impl<const N: usize> RowSums<N> {
    /// One pass over all pairs.
    fn of(
        source: PairSource<'_>,
        terms: impl Fn([usize; 2], &ExchangeArea, PairTerms) -> [f64; N] + Sync,
    ) -> Result<Self, ChainError> {
        let pairs = source.pairs();
        let total_area = compensated_sum(pairs.areas().iter().copied());
        let unit = Unit::of_total(total_area);
        let in_unit = |numbers: &[f64]| -> Vec<f64> {
            numbers.iter().map(|number| unit.times(*number)).collect()
        };
        let (areas, area_bounds) = (in_unit(pairs.areas()), in_unit(pairs.area_bounds()));
        let area = unit.times(total_area);
        let (sums, summary) = source.row_sums(|i, j, exchange| {
            let (value, bound) = (unit.times(exchange.value), unit.times(exchange.error));
            let probability = areas[j] / area;
            let divergence = pair_divergence(value, areas[i], probability);
            let error = divergence_error(value, bound, areas[i] * probability);
            terms([i, j], exchange, [value, bound, divergence, error])
        })?;
        let closure = Closure::new(
            pairs.shared_names(),
            [&areas, &area_bounds],
            sums.iter().map(|sum| [sum[VALUE], sum[BOUND]]),
            summary.is_turned_away,
        );
        let mut changes = None;
        if pairs.resolution() > 0.0 {
            let (moved, _) = source.row_sums(|i, j, exchange| {
                let change = unit.times(pairs.resolution_error(i, j));
                let product = areas[i] * (areas[j] / area);
                [
                    change,
                    divergence_error(unit.times(exchange.value), change, product),
                ]
            })?;
            changes = Some(Changes::of(pairs, |x| unit.times(x), &areas, &moved));
        }
        let closure = match &changes {
            Some(_) => closure.resolved(pairs.areas(), &pairs.crack_errors()),
            None => closure,
        };
        Ok(Self {
            total_area,
            area,
            areas,
            area_bounds,
            sums,
            closure,
            summary,
            changes,
        })
    }

    /// A bound on what the resolution can change of the information.
    fn resolution(&self, outside: &Outside, is_closed: bool, bits: f64) -> InformationResolution {
        let Some(changes) = &self.changes else {
            return InformationResolution::default();
        };
        let from_escaping = if is_closed {
            0.0
        } else {
            outside.error(self.area, &self.areas, changes.of_rows(), bits)
        };
        changes.bounds(&self.areas, from_escaping, bits)
    }

    fn outside(&self, is_closed: bool) -> Outside {
        let escaping = if is_closed {
            vec![0.0; self.areas.len()]
        } else {
            let areas = self.areas.iter().enumerate();
            areas
                .map(|(i, area)| area * self.closure.escaping(i))
                .collect()
        };
        Outside::new(self.area, escaping)
    }

    /// The terms of eq. (3) by row, in bits.
    fn contributions(
        &self,
        pairs: &ScenePairs<'_>,
        outside: &Outside,
        is_closed: bool,
    ) -> Vec<f64> {
        let unseen = pairs.unseen(&self.areas);
        let rows = self.areas.iter().zip(&self.sums).zip(unseen).enumerate();
        rows.map(|(i, ((weight, sum), unseen))| {
            let dark = weight * (unseen / self.area); // φ(−1) = 1
            let closed = sum[DIVERGENCE] + dark;
            let nats = if is_closed {
                closed
            } else {
                let growth = ln(outside.total / self.area);
                let inside = (sum[VALUE] - weight) + sum[VALUE] * growth;
                closed + inside + outside.term(i, *weight)
            };
            nats / (outside.total * LN_2)
        })
        .collect()
    }

    /// The error of the mutual information, in bits times the total: what the errors of pairs, of
    /// areas and of what escapes may change.
    fn error(&self, outside: &Outside, is_closed: bool, bits: f64) -> f64 {
        let errors = self.sums.iter().map(|sum| sum[DIVERGENCE_ERROR]);
        let from_pairs = compensated_sum(errors) / LN_2;
        // Σ |q − J| ≤ 2 A_i in row and column i; where an area is one patch's, its 4 ε are in the
        // rounding
        let areas = self.areas.iter().zip(&self.area_bounds);
        let from_areas = compensated_sum(areas.map(|(area, bound)| {
            let more = bound - 4.0 * f64::EPSILON * area;
            4.0 * more / LN_2
        }));
        let from_escaping = if is_closed {
            0.0
        } else {
            let bounds = self.sums.iter().map(|sum| sum[BOUND]);
            outside.error(self.area, &self.areas, bounds, bits)
        };
        from_pairs + from_areas + from_escaping
    }
}

/// The state that takes the escaping power.
struct Outside {
    escaping: Vec<f64>,
    weight: f64,
    total: f64,
}

impl Outside {
    fn new(area: f64, escaping: Vec<f64>) -> Self {
        let weight = compensated_sum(escaping.iter().copied());
        Self {
            escaping,
            weight,
            total: area + weight,
        }
    }

    /// The term `J ln(J N/(A_i w_out))` of the power that escapes from i, in nats.
    fn term(&self, i: usize, area: f64) -> f64 {
        let escaping = self.escaping[i];
        if escaping > 0.0 {
            escaping * ln(escaping / area / (self.weight / self.total))
        } else {
            0.0
        }
    }

    /// The first-order effect of the rows' bounds on the escaping parts and on N, in bits times the
    /// total.
    fn error(&self, area: f64, areas: &[f64], bounds: impl Iterator<Item = f64>, bits: f64) -> f64 {
        let growth = log2(self.total / area);
        let rows = areas.iter().zip(&self.escaping).zip(bounds);
        compensated_sum(rows.map(|((weight, escaping), bound)| {
            if bound <= 0.0 {
                return 0.0;
            }
            let ratio = escaping.max(bound) / weight / (self.weight / self.total);
            // there and back, and the share of N
            bound * (growth + 2.0 * (log2(ratio).abs() + 1.0 / LN_2) + bits)
        }))
    }
}
