//! An explicit operator below the one of radiosity, on means and fluctuations over cells.
//!
//! ```text
//!   A = 1/R − K      ⟨e, A e⟩ = ∫ (1/R − 1) e² + ½ ∫∫ k (e(x) − e(y))² + ∫ s e²    s = 1 − ∫ k dy
//!   κ_ij ≤ k on cells i × j
//!   ⟨e, A e⟩ ≥ Σ_i A_i (1/R_i − 1) e_i² + ½ Σ_ij κ_ij A_i A_j (e_i − e_j)² + Σ_i n_i V_i
//!   n_i = 1/R_i − 1 + Σ_j κ_ij A_j,   V_i = ∫_i (e − e_i)²,   e_i the mean
//! ```
//!
//! e is 0 on patches that reflect nothing: what reaches them is lost, and a cell there damps e_i.
//! As a matrix of `√A_i e_i` the part of the means has no positive entry off the diagonal and is
//! positive definite: its inverse has no negative entry.
//!
//! **κ**: of [`kernel`](super::kernel).
//!
//! **Least eigenvalue**, a *bound*: with w = √A the means' part N has `N w ≥ (1/R − 1) w`, so that
//! none is below the least 1/R − 1 (Collatz). More: Cholesky's factors of `N − λ` exist in floating
//! point only if no eigenvalue is below `−c`, with c less than 4 (n + 2) ε times the trace.
//!
//! Reference: Rump, "Verification of positive definiteness", *BIT* 46 (2006), 433–452.

use super::dark::Dark;
use super::kernel::least_kernel;
use super::piece::Integrals;
use super::ritz::Ritz;
use super::sight::{End, Sight};
use crate::hierarchy::{Element, HierarchyError};
use crate::numeric::{Bounded, parallel_map, real};
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// The least part of an eigenvalue's estimate that is tried as a bound.
const STEPS: [f64; 5] = [0.999, 0.99, 0.9, 0.7, 0.3];

/// The operator N.
#[derive(Debug, Clone)]
pub(super) struct Minorant {
    patches: Vec<usize>,
    areas: Vec<f64>,
    /// `n_i`.
    damping: Vec<f64>,
    means: DMatrix<f64>,
    factors: Cholesky<f64, Dyn>,
    /// A lower bound on the eigenvalues of the means' part.
    least: f64,
    /// A lower bound on them for means that add up to nothing.
    beside_mean: f64,
}

/// A function on the cells as far as N needs it: means, and fluctuations.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Split {
    /// `∫_i f`.
    pub(super) totals: Vec<f64>,
    /// `∫_i f² − (∫_i f)²/A_i`.
    pub(super) fluctuations: Vec<f64>,
}

/// A function's part that is known on cells, with its energy, and that of the rest.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Energy {
    pub(super) split: Split,
    /// `√⟨f, N⁻¹ f⟩` of the part that is known.
    pub(super) known: f64,
    /// A bound on that of the rest.
    pub(super) rest: f64,
}

impl Energy {
    /// A bound on `√⟨f, N⁻¹ f⟩`.
    pub(super) fn most(&self) -> f64 {
        self.known + self.rest
    }
}

impl Split {
    /// The split of a function with these integrals over cells with these areas.
    pub(super) fn new(integrals: &[Integrals], areas: &[f64]) -> Self {
        let cells = integrals.iter().zip(areas);
        // rounding may leave less than nothing of a square
        let fluctuation =
            |(f, area): (&Integrals, &f64)| (f.second - f.first * f.first / area).max(0.0);
        Self {
            totals: integrals.iter().map(|f| f.first).collect(),
            fluctuations: cells.map(fluctuation).collect(),
        }
    }
}

/// What damps cells, and what couples them.
#[derive(Debug, Clone)]
pub(super) struct Couplings {
    patches: Vec<usize>,
    areas: Vec<f64>,
    /// `n_i`.
    pub(super) damping: Vec<f64>,
    means: DMatrix<f64>,
    /// The least `1/R_i − 1`.
    absorbed: f64,
}

impl Couplings {
    /// The couplings of these cells, which all reflect, in the presence of dark patches.
    pub(super) fn of(cells: &[&Element], reflectances: &[f64], dark: &Dark, sight: &Sight) -> Self {
        let n = cells.len();
        let end = |cell: usize| End::of(cells[cell].patch(), cells[cell].shape());
        let rows = parallel_map(n, &|i| -> (Vec<f64>, f64) {
            let row = (0..i).map(|j| least_kernel(end(i), end(j), sight));
            (row.collect(), dark.taken(cells[i], sight))
        });
        let areas: Vec<f64> = cells.iter().map(|cell| cell.shape().area()).collect();
        let lost = cells
            .iter()
            .zip(&rows)
            .map(|(cell, (_, lost))| 1.0 / reflectances[cell.patch()] - 1.0 + lost);
        let mut damping: Vec<f64> = lost.collect();
        let mut means = DMatrix::zeros(n, n);
        for (i, (row, _)) in rows.iter().enumerate() {
            for (j, kernel) in row.iter().enumerate() {
                damping[i] += kernel * areas[j];
                damping[j] += kernel * areas[i];
                let entry = -kernel * (areas[i] * areas[j]).sqrt();
                (means[(i, j)], means[(j, i)]) = (entry, entry);
            }
        }
        debug_assert!(
            cells.iter().zip(&damping).all(|(cell, n)| {
                // no point sends out more than all
                *n <= (1.0 + 1e-12) / reflectances[cell.patch()]
            }),
            "a minorant that is above the kernel"
        );
        means.set_diagonal(&DVector::from_column_slice(&damping));
        let absorbed = cells
            .iter()
            .map(|cell| 1.0 / reflectances[cell.patch()] - 1.0);
        Self {
            patches: cells.iter().map(|cell| cell.patch()).collect(),
            areas,
            damping,
            means,
            absorbed: absorbed.fold(f64::INFINITY, f64::min),
        }
    }
}

impl Minorant {
    /// The operator of these couplings.
    ///
    /// # Errors
    /// [`HierarchyError::NotDamped`].
    pub(super) fn try_new(couplings: Couplings) -> Result<Self, HierarchyError> {
        let Couplings {
            patches,
            areas,
            damping,
            means,
            absorbed,
        } = couplings;
        let margin = margin(&means);
        if absorbed <= 2.0 * margin {
            return Err(HierarchyError::NotDamped);
        }
        let factors = Cholesky::new(means.clone()).ok_or(HierarchyError::NotDamped)?;
        let least = absorbed - margin;
        let minorant = Self {
            patches,
            areas,
            damping,
            means,
            factors,
            least,
            beside_mean: least,
        };
        let beside_mean = minorant.least_beside_mean().unwrap_or(least);
        Ok(Self {
            beside_mean,
            ..minorant
        })
    }

    /// The areas of the cells that reflect.
    pub(super) fn areas(&self) -> &[f64] {
        &self.areas
    }

    /// A bound on `√⟨f, N⁻¹ f⟩`.
    pub(super) fn norm(&self, f: &Split) -> f64 {
        let c = self.scaled(f);
        let x = self.factors.solve(&c);
        let image = &self.means * &x;
        let rest = (&c - &image).norm_squared() / self.least;
        let means = 2.0 * c.dot(&x) - x.dot(&image) + rest;
        (means.max(0.0) + self.fluctuations(f)).sqrt()
    }

    /// A bound on `‖e‖` for all e with `⟨e, N e⟩ ≤ ⟨f, e⟩`, f of this energy, and with this
    /// integral over patches that count.
    ///
    /// ```text
    ///   f = f_k + ρ,  η = √⟨f_k, N⁻¹ f_k⟩,  ⟨ρ, e⟩ ≤ σ √⟨e, N e⟩
    ///   ⟨e, N e⟩ ≤ (η + σ)²,      ⟨d, N d⟩ ≤ (η/2 + σ)²       d = e − ½ N⁻¹ f_k
    /// ```
    ///
    /// # Errors
    /// [`HierarchyError::NotDamped`].
    pub(super) fn norm_of_error(
        &self,
        f: &Energy,
        integral: Bounded,
        counts: &dyn Fn(usize) -> bool,
    ) -> Result<f64, HierarchyError> {
        let counted = self.patches.iter().zip(&self.areas);
        let counted = counted.map(|(patch, area)| if counts(*patch) { area.sqrt() } else { 0.0 });
        let v = DVector::from_iterator(self.areas.len(), counted);
        let ritz = Ritz::new(&self.means, &self.factors, &v);
        let c = self.scaled(&f.split);
        let x = self.factors.solve(&c);
        let rest = 0.5 * (c - &self.means * &x).norm() / self.least;
        let damped = f.split.fluctuations.iter().zip(&self.damping);
        let square = x.norm_squared() + damped.map(|(v, n)| v / (n * n)).sum::<f64>();
        let beside = (integral.value - 0.5 * v.dot(&x)).abs() + integral.error + v.norm() * rest;
        let beside = self.largest(0.5 * f.known + f.rest, beside, &v, &ritz)?;
        let whole = integral.value.abs() + integral.error;
        let whole = self.largest(f.most(), whole, &v, &ritz)?;
        Ok(whole.min(0.5 * square.sqrt() + rest + beside))
    }

    /// A bound on `‖e‖` for all e with `⟨e, N e⟩ ≤ energy²` and `|⟨v, e⟩| ≤ total`.
    ///
    /// ```text
    ///   ‖e‖² ≤ (energy² + τ total²)/λ_min(N + τ v vᵀ)        for any τ ≥ 0, v = √A, or 0
    /// ```
    fn largest(
        &self,
        energy: f64,
        total: f64,
        v: &DVector<f64>,
        ritz: &Ritz,
    ) -> Result<f64, HierarchyError> {
        let square = |weight: f64| energy * energy + weight * total * total;
        let area = v.norm_squared();
        let weights = (0..13).map(|k| {
            if k == 0 {
                0.0
            } else {
                2f64.powi(k - 10) / area
            }
        });
        let rough = |weight: f64| square(weight) / ritz.least(weight);
        let best = weights.min_by(|a, b| rough(*a).total_cmp(&rough(*b)));
        let weight = best.unwrap_or(0.0);
        let least = self.certified_least(weight, v, ritz.least(weight))?;
        let fluctuations = self.damping.iter().copied().fold(f64::INFINITY, f64::min);
        Ok((square(weight) / least.min(fluctuations)).sqrt())
    }

    /// A bound on `√⟨f, N⁻¹ f⟩` of an f with bounds on its means and fluctuations, and on `|∫ f|`.
    ///
    /// ```text
    ///   ⟨f, e⟩ = ⟨f, e − m⟩ + m ∫ f,   A m² ≤ ‖e‖² ≤ ⟨e, N e⟩/λ_min(N)           m: the mean of e
    ///   Σ A_i (e_i − m)² ≤ Σ A_i e_i N e_i/λ  if  N ⪰ λ (1 − v vᵀ/A), v = √A
    /// ```
    pub(super) fn norm_beside_mean(&self, f: &Split, total: f64) -> f64 {
        let means = f.totals.iter().zip(&self.areas).map(|(t, a)| t * t / a);
        let means = means.sum::<f64>() / self.beside_mean;
        let area: f64 = self.areas.iter().sum();
        (means + self.fluctuations(f)).sqrt() + total / (area * self.least).sqrt()
    }

    /// The means of a function, times the roots of areas.
    fn scaled(&self, f: &Split) -> DVector<f64> {
        let scaled = f.totals.iter().zip(&self.areas);
        let scaled = scaled.map(|(total, area)| total / area.sqrt());
        DVector::from_iterator(self.areas.len(), scaled)
    }

    /// `Σ V_i/n_i` of a function's fluctuations.
    fn fluctuations(&self, f: &Split) -> f64 {
        let damped = f.fluctuations.iter().zip(&self.damping);
        damped.map(|(v, n)| v / n).sum()
    }

    /// A number λ with `N ⪰ λ (1 − v vᵀ/A)`, v = √A.
    fn least_beside_mean(&self) -> Option<f64> {
        let v = DVector::from_iterator(self.areas.len(), self.areas.iter().map(|a| a.sqrt()));
        let area = v.norm_squared();
        let ritz = Ritz::new(&self.means, &self.factors, &v);
        let estimate = ritz.least(self.means.trace() / area);
        let mut steps = STEPS.iter().map(|step| step * estimate);
        steps.find(|least| self.is_raised_above(*least, least / area, &v))
    }

    /// A lower bound on the eigenvalues of `N + τ v vᵀ`, of which there is an estimate.
    fn certified_least(
        &self,
        weight: f64,
        v: &DVector<f64>,
        estimate: f64,
    ) -> Result<f64, HierarchyError> {
        let mut steps = STEPS.iter().map(|step| step * estimate);
        let found = steps.find(|least| self.is_raised_above(*least, weight, v));
        found.ok_or(HierarchyError::NotDamped)
    }

    /// Whether no eigenvalue of `N + τ v vᵀ` is below so much, for certain.
    fn is_raised_above(&self, least: f64, weight: f64, v: &DVector<f64>) -> bool {
        let n = self.areas.len();
        let raised = DMatrix::from_fn(n, n, |i, j| self.means[(i, j)] + weight * (v[i] * v[j]));
        let shifted = &raised - DMatrix::identity(n, n) * (least + margin(&raised));
        least > 0.0 && Cholesky::new(shifted).is_some()
    }
}

/// What rounding may do to the eigenvalues of a matrix, and to its factors.
fn margin(matrix: &DMatrix<f64>) -> f64 {
    4.0 * (real(matrix.nrows()) + 2.0) * f64::EPSILON * matrix.trace()
}
