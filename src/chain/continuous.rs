//! The chain of a scene under a brightness that varies over its patches (§3.4, §3.5, as integrals).
//!
//! ```text
//!   J_ij = ∫_{S_i} ∫_{S_j} β(x) F(x, y) β(y) dy dx = w_i P_ij,     β = B, or R I
//! ```
//!
//! The patches are [quartered](crate::geometry::quartered()), again and again. Between small cells
//! the exchange areas are exact and β is taken at the middle, so that the kernel's peaks at common
//! edges do no harm: the error is of second order in the size of the cells, and two successive
//! values are extrapolated.
//!
//! The paper's weight `∫ B (B − E)/R` is the row sum if B solves the radiosity equation;
//! [`patch_integrals`] computes it as printed, for comparison.
//!
//! **Not covered**: jumps of β inside a patch, which leave an error of first order: cut the patch
//! there; occlusion.

use super::error::ChainError;
use super::reversible::ReversibleChain;
use crate::exchange::{Congruence, ScenePairs};
use crate::form_factor::DEFAULT_TOLERANCE;
use crate::geometry::centroid;
use crate::numeric::{Grade, compensated_sum};
use crate::scene::{NamedPatch, Occlusion, Scene, SceneError};
use glam::DVec3;
use nalgebra::DMatrix;

/// The chain of a varying brightness, found by quadrature.
#[derive(Debug, Clone, PartialEq)]
pub struct ContinuousChain {
    /// The chain, one state for each patch.
    pub chain: ReversibleChain,
    /// The largest absolute error of an entry `w_i P_ij`; all entries together are 1. It is found
    /// from the last two extrapolations.
    pub error: f64,
    /// The number of cells of the finest division.
    pub cells: usize,
}

impl ContinuousChain {
    /// The grade of the error.
    pub const GRADE: Grade = Grade::Estimate;
}

/// The largest number of cells that is tried: the exchange areas of all pairs are held.
const MOST_CELLS: usize = 8_000;

/// The chain of a scene under a brightness that varies over its patches.
///
/// **Arguments** `brightness`: the brightness of a patch at a point of it, ≥ 0; `tolerance`: the
/// largest [`ContinuousChain::error`] wanted; the division ends there, or before it has more than
/// 8,000 cells.
///
/// # Errors
/// [`ChainError::InvalidWeight`] if the brightness is negative or not finite somewhere;
/// [`ChainError::NoMass`]; [`ChainError::Scene`], [`ChainError::Exchange`], also if patches overlap
/// or something may stand between two of them.
///
/// # Examples
/// ```
/// use infoscene::chain::continuous_chain;
/// use infoscene::scene::Scene;
/// // B = 1 on one square, 1 + x on the other: more light from where it is brighter
/// let squares = Scene::built_in("two-squares")?;
/// let brightness = |patch, x: glam::DVec3| if patch == 0 { 1.0 } else { 1.0 + x.y };
/// let chain = continuous_chain(&squares, brightness, 1e-6)?;
/// assert_eq!(chain.chain.transition_probability(0, 1), 1.0);
/// // by symmetry y is ½ in the mean, and F is 0.2000437760754
/// assert!((chain.chain.joint()[(0, 1)] - 1.5 * 0.200_043_776_075_4).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn continuous_chain(
    scene: &Scene,
    brightness: impl Fn(usize, DVec3) -> f64 + Sync,
    tolerance: f64,
) -> Result<ContinuousChain, ChainError> {
    debug_assert!(tolerance >= 0.0, "{tolerance}");
    // cells hide no more of each other than their patches do
    Occlusion::Refuse.check(scene)?;
    let mut last = joint(scene, &brightness, 0)?;
    let mut extrapolated: Option<DMatrix<f64>> = None;
    let mut times = 1;
    loop {
        let next = joint(scene, &brightness, times)?;
        let better = next.0.zip_map(&last.0, |fine, coarse| {
            let value = fine + (fine - coarse) / 3.0;
            if value > 0.0 { value } else { fine }
        });
        let total = better.sum();
        let known = extrapolated.as_ref().unwrap_or(&next.0);
        let error = (&better - known).amax() / total;
        let is_last = next.1 * 4 > MOST_CELLS;
        if is_last || (times > 1 && error <= tolerance) {
            return Ok(ContinuousChain {
                chain: ReversibleChain::try_new(better)?,
                error,
                cells: next.1,
            });
        }
        extrapolated = Some(better);
        last = next;
        times += 1;
    }
}

/// The integral of a function over each patch, by the cells of [`continuous_chain`].
///
/// Only tests use it, to compare the paper's weights with row sums.
///
/// **Arguments** `times`: how many times the patches are quartered for the finer of two values; 0
/// counts as 1.
/// **Returns** for each patch the extrapolated integral; its error is of fourth order in the size
/// of the cells for smooth functions.
///
/// # Errors
/// [`ChainError::Scene`] if a patch cannot be cut; [`ChainError::Exchange`] if a pair is refused.
pub fn patch_integrals(
    scene: &Scene,
    integrand: impl Fn(usize, DVec3) -> f64,
    times: u32,
) -> Result<Vec<f64>, ChainError> {
    let sums = |times: u32| -> Result<Vec<f64>, ChainError> {
        let (fine, parents) = scene.subdivided(times)?;
        let mut terms = vec![Vec::new(); scene.patches().len()];
        for (cell, parent) in fine.patches().iter().zip(parents) {
            let value = integrand(parent, centroid(cell.shape()));
            terms[parent].push(value * cell.shape().area());
        }
        Ok(terms.into_iter().map(compensated_sum).collect())
    };
    let times = times.max(1);
    let (coarse, fine) = (sums(times - 1)?, sums(times)?);
    Ok(fine
        .into_iter()
        .zip(coarse)
        .map(|(fine, coarse)| fine + (fine - coarse) / 3.0)
        .collect())
}

/// The joint matrix with β constant in each cell, and the number of cells.
fn joint(
    scene: &Scene,
    brightness: &impl Fn(usize, DVec3) -> f64,
    times: u32,
) -> Result<(DMatrix<f64>, usize), ChainError> {
    let (fine, parents) = scene.subdivided(times)?;
    let cells = fine.patches().iter().zip(&parents);
    let checked = cells.map(|(cell, parent): (&NamedPatch, &usize)| {
        let value = brightness(*parent, centroid(cell.shape()));
        if value.is_finite() && value >= 0.0 {
            Ok(value)
        } else {
            let state = *parent;
            Err(ChainError::InvalidWeight { state, value })
        }
    });
    let values: Vec<f64> = checked.collect::<Result<_, _>>()?;
    if let Some(cell) = fine.first_summed() {
        let (index, what) = (parents[cell], "is summed with others");
        return Err(SceneError::NotAPatchOfItsOwn { index, what }.into());
    }
    let pairs = ScenePairs::unchecked(&fine, DEFAULT_TOLERANCE, Congruence::Shared)?;
    let exchange = pairs.exchange_areas()?;
    let n = scene.patches().len();
    let mut joint = DMatrix::zeros(n, n);
    for (second, to) in parents.iter().enumerate() {
        for (first, from) in parents[..=second].iter().enumerate() {
            let [one, other] = [first, second].map(|cell| fine.group_of(cell));
            let flux = values[first] * values[second] * exchange.get(one, other).exchange.value;
            joint[(*from, *to)] += flux;
            if first != second {
                joint[(*to, *from)] += flux;
            }
        }
    }
    // entries (i, j) and (j, i) sum equal terms in another order: one of them counts for both
    Ok((
        DMatrix::from_fn(n, n, |i, j| joint[(i.min(j), i.max(j))]),
        parents.len(),
    ))
}
