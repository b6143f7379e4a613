//! A bound on the error of piecewise constant or linear radiosities, against the continuous
//! solution.
//!
//! ```text
//!   B = E + R K B,  (K b)(x) = ∫ k(x, y) b(y) dy,   B_h constant on leaves,   e = B − B_h
//!   A e = f,   A = 1/R − K,   f = (E − B_h)/R + K B_h       where R > 0; e = 0 where R = 0
//! ```
//!
//! An explicit operator N lies below the symmetric A (`minorant`), so that
//!
//! ```text
//!   ⟨e, N e⟩ ≤ ⟨e, A e⟩ = ⟨f, A⁻¹ f⟩ ≤ ⟨f, N⁻¹ f⟩ = η²
//! ```
//!
//! The residual f is measured with bounds on all that is left out (`residual`). A mean of e is
//! damped by little more than 1/R − 1; it is bounded by a discrete solution ψ of `A ψ = g`:
//!
//! ```text
//!   ⟨g, e⟩ = ⟨ψ, f⟩ + ⟨t, A⁻¹ f⟩,   |⟨t, A⁻¹ f⟩| ≤ √⟨t, N⁻¹ t⟩ η,   t = g − A ψ
//! ```
//!
//! N is some times too weak for light that hardly spreads. So most of the error is found out, and
//! only what is left is bounded: B̃ is gathered from B_h on a finer mesh (`refined`), and
//!
//! ```text
//!   ‖B − B_h‖² = ‖B̃ − B_h‖² + 2 ⟨B̃ − B_h, B − B̃⟩ + ‖B − B̃‖²
//! ```
//!
//! or, as `e = R f + R K e` and ‖K‖ ≤ 1, `‖B − B_h‖ ≤ ‖B̃ + R f − B_h‖ + max R ‖e‖`, of which f is
//! known but for a rest.
//!
//! Linear parts of B_h on its leaves meet the residual of B̃, too (`slopes`).
//!
//! What is left over a single leaf is what its residual shows and what it receives of the rest
//! (`local`), and at a point what it receives (`at_point`).
//!
//! Where something may stand between patches, what is certainly seen or certainly hidden counts as
//! such ([`sight`]). What is seen in part counts with its range, cut finer where much depends on
//! it, and with its mean, which the exchange area past what stands between tells (`doubt`).
//!
//! **How near**, by `meshes_of_rooms_with_patches_hidden_from_each_other_are_bounded` and
//! `linear_solutions_are_bounded`: constants on 100 and 300 elements under a plate 2.6 to 2.8 times
//! the error up to R = 0.9; at R = 0.95, on 100 elements, 2.5 times with a table and a screen, 4.4
//! times between blocks: cells of N that are hidden from each other do not damp each other. Linear
//! functions on 100 and 300 elements of a cube 1.6 to 8 times, as B̃ is constant on leaves and
//! may be farther from B than they are.
//!
//! **Grade**: a bound, up to rounding, which is less than 1e-9 of it.
//!
//! **Not covered**: patches that lie in another one; directions.

mod adapted;
mod adjoint;
mod at_point;
mod cells;
mod checks;
mod dark;
mod doubt;
mod edge;
mod frame;
mod jet;
mod judged;
mod kernel;
mod leaf;
mod local;
mod minorant;
mod piece;
mod refined;
mod residual;
mod ritz;
mod seen;
mod setting;
mod sight;
mod slopes;
mod sources;
mod task;
mod views;

use crate::geometry::{Patch, is_inside};
use crate::hierarchy::{Element, HierarchyError, Lighting, Tree};
use crate::numeric::{Bounded, tolerance};
use crate::scene::Scene;
use at_point::AtPoint;
use checks::{check_count, check_gradients, check_radiosities, is_closed};
use glam::DVec3;
use judged::Judged;
use local::Local;
use refined::Refined;
use setting::Setting;
use sight::Sight;
use slopes::Slopes;
use views::Views;

/// A bound on the error of radiosities that are constant or linear on the leaves of a tree.
#[derive(Debug, Clone)]
pub struct ErrorBound {
    /// A bound on `‖B − B_h‖`, in the mean square over all patches that reflect.
    pub absolute: f64,
    /// The same per `‖B‖` over the patches that reflect and emit nothing; over all that reflect, if
    /// there are none. Infinite if B may be 0.
    pub relative: f64,
    /// An estimate of `‖B − B_h‖`: by the residual, times R.
    pub estimate: f64,
    /// The parts of the leaves in the estimate's square.
    pub by_leaf: Vec<f64>,
    /// Bounds on `‖B − B_h‖` over each leaf; the root of their squares' sum is some times
    /// `absolute`, as light of any other leaf may meet each of them.
    pub bound_by_leaf: Vec<f64>,
    refined: Refined,
    judged: Judged,
    local: Local,
}

/// A weighted sum of radiosities, with a bound on its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WeightedSum {
    /// `∫ g B_h`, corrected as far as the error is known.
    pub value: f64,
    /// A bound on `|∫ g B − value|`.
    pub error: f64,
}

impl ErrorBound {
    /// Bounds the error of these radiosities, one a leaf, in the order of [`Tree::leaves`].
    ///
    /// # Errors
    /// [`HierarchyError::WrongCount`]; [`HierarchyError::WrongRadiosity`] for a radiosity that is
    /// not finite, or on a patch without reflection not its emittance;
    /// [`HierarchyError::NotDamped`] if too little is absorbed for a bound;
    /// [`HierarchyError::Scene`] for a scene whose patches overlap or lie in one another.
    pub fn try_new(
        scene: &Scene,
        tree: &Tree,
        light: &Lighting,
        values: &[f64],
    ) -> Result<Self, HierarchyError> {
        Self::of_linear(scene, tree, light, values, &vec![DVec3::ZERO; values.len()])
    }

    /// Bounds the error of radiosities that are linear on each leaf: these values at its centre of
    /// gravity, with these gradients.
    ///
    /// # Errors
    /// As [`try_new`](Self::try_new); [`HierarchyError::WrongGradient`] for one that is not finite.
    pub fn of_linear(
        scene: &Scene,
        tree: &Tree,
        light: &Lighting,
        values: &[f64],
        gradients: &[DVec3],
    ) -> Result<Self, HierarchyError> {
        check_count("radiosities", values.len(), tree.leaf_count())?;
        check_gradients(gradients, tree.leaf_count())?;
        let is_closed = is_closed(scene, tree, light)?;
        let sight = Sight::of(scene)?;
        let views = Views::of(scene, tree, light, &sight);
        check_radiosities(&views.leaves, light, values)?;
        let refined = Refined::of(&views, tree, light, values)?;
        let fine = Views::of(scene, &refined.tree, light, &sight);
        let setting = Setting::try_new(scene, fine, light, is_closed)?;
        let slope = |leaf: usize| gradients[refined.origins[leaf]];
        let mean = |leaf: usize| {
            let origin = refined.origins[leaf];
            let apart = setting.leaves()[leaf].centre - views.leaves[origin].centre;
            values[origin] + slope(leaf).dot(apart)
        };
        let leaves = 0..refined.values.len();
        let change: Vec<f64> = leaves
            .clone()
            .map(|leaf| refined.values[leaf] - mean(leaf))
            .collect();
        let slopes: Vec<DVec3> = leaves.map(slope).collect();
        let unlit = setting.unlit();
        let bright = unlit
            .iter()
            .zip(&refined.values)
            .map(|(unlit, b)| unlit * b);
        let goals = [unlit.clone(), change.clone(), bright.collect()];
        let fine = refined.values.clone();
        let (judged, [mean, changed, bright]) =
            Judged::try_new(setting, &refined.tree, light, fine, &goals)?;
        let rest = judged.norm_of_error(mean)?;
        let setting = &judged.setting;
        let slopes = Slopes::of(&judged, &slopes);
        let known = setting.square(&change) + slopes.square();
        let product = changed.upper() - slopes.least_product(rest);
        let absolute = (known + 2.0 * product + rest * rest).max(0.0).sqrt();
        let shown = judged.shown_by_residual(&change) + slopes.shown();
        let again = shown.max(0.0).sqrt() + judged.unknown(rest);
        let absolute = absolute.min(known.sqrt() + rest).min(again);
        let least = setting.square(&goals[2]) + 2.0 * bright.lower();
        let relative = if least > 0.0 {
            absolute / least.sqrt()
        } else {
            f64::INFINITY
        };
        let mut by_leaf = judged.by_leaf(&refined.origins, &change, values.len());
        let shown = judged.shown(&refined.origins, values.len());
        let local = Local::new(tree, light, &shown, rest);
        let mut known = vec![0.0; values.len()];
        for (leaf, (origin, change)) in refined.origins.iter().zip(&change).enumerate() {
            known[*origin] += setting.area(leaf) * change * change + slopes.squares[leaf];
            by_leaf[*origin] += slopes.squares[leaf] - 2.0 * slopes.products[leaf];
        }
        let parts = known.iter().zip(local.bounds());
        let bound_by_leaf = parts.map(|(known, left)| (known.sqrt() + left).min(absolute));
        Ok(Self {
            absolute,
            relative,
            estimate: by_leaf.iter().sum::<f64>().sqrt(),
            by_leaf,
            bound_by_leaf: bound_by_leaf.collect(),
            refined,
            judged,
            local,
        })
    }

    /// The integral of the radiosity with these weights, one a leaf: `g = 1/A` on a patch of area A
    /// and 0 elsewhere is its mean radiosity.
    ///
    /// # Errors
    /// [`HierarchyError::WrongCount`].
    pub fn goal(&self, weights: &[f64]) -> Result<WeightedSum, HierarchyError> {
        check_count("weights", weights.len(), self.by_leaf.len())?;
        let origins = self.refined.origins.iter();
        let fine: Vec<f64> = origins.map(|origin| weights[*origin]).collect();
        let correction = self.judged.goal(&fine);
        Ok(WeightedSum {
            value: self.judged.setting.product(&fine, &self.judged.values) + correction.value,
            error: correction.error,
        })
    }

    /// The radiosity at a point of a patch after one more gather, with a bound on its error.
    ///
    /// # Errors
    /// [`HierarchyError::NoBoundAt`] for a point that is not inside the patch, or on an edge of a
    /// leaf that it sees.
    pub fn gathered(&self, patch: usize, point: DVec3) -> Result<Bounded, HierarchyError> {
        let setting = &self.judged.setting;
        let shape = self.refined.tree.elements()[..setting.light.emittances().len()]
            .get(patch)
            .map(Element::shape)
            .filter(|shape| is_on(point, shape, setting.noise()));
        let shape = shape.ok_or(HierarchyError::NoBoundAt { patch, point })?;
        let emitted = setting.light.emittance(patch);
        let reflectance = setting.light.reflectance(patch);
        if reflectance <= 0.0 {
            return Ok(Bounded::bound(emitted, 0.0));
        }
        let (views, values) = (setting.views(), &self.judged.values);
        let at = AtPoint::new(views, patch, point, shape.normal());
        let mut squares = vec![0.0; self.by_leaf.len()];
        for (origin, square) in self.refined.origins.iter().zip(&at.squares) {
            squares[*origin] += square;
        }
        let left = self.local.product(&squares);
        if !left.is_finite() {
            return Err(HierarchyError::NoBoundAt { patch, point });
        }
        let found = self.judged.goal(&at.weights);
        let received = views.irradiance(patch, point, values) + found.value;
        let doubt = views.doubt(patch, point, values)?;
        let error = reflectance * (found.error + left + doubt);
        Ok(Bounded::bound(emitted + reflectance * received, error))
    }
}

/// Whether a point is on a polygon, to within `noise` or 1e-12 of its size.
fn is_on(point: DVec3, shape: &Patch, noise: f64) -> bool {
    let height = (point - shape.corners()[0]).dot(shape.normal()).abs();
    height <= (tolerance::PLANARITY * shape.area().sqrt()).max(noise) && is_inside(point, shape)
}
