//! Radiosities on leaves with their residual, and bounds on weighted sums of their error.

use super::adapted::Adapted;
use super::minorant::Energy;
use super::setting::Setting;
use super::task::{FUNCTIONS, Measured};
use crate::hierarchy::{Element, HierarchyError, Lighting, Tree};
use crate::numeric::Bounded;
use std::array::from_fn;

/// The weighted sums that are bounded while the residual is measured.
pub(super) const GOALS: usize = FUNCTIONS - 1;

/// Radiosities, their residual f and its energy.
#[derive(Debug, Clone)]
pub(super) struct Judged {
    pub(super) setting: Setting,
    pub(super) adapted: Adapted,
    pub(super) values: Vec<f64>,
    pub(super) residual: Vec<Measured>,
    pub(super) energy: Energy,
    /// `∫ f` with a bound on its error, if it is known.
    total: Option<[f64; 2]>,
}

/// `⟨g, e⟩` as far as it is known, and a bound on what is not.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Correction {
    pub(super) value: f64,
    pub(super) error: f64,
}

impl Correction {
    /// An upper bound.
    pub(super) fn upper(&self) -> f64 {
        self.value + self.error
    }

    /// A lower bound.
    pub(super) fn lower(&self) -> f64 {
        self.value - self.error
    }
}

impl Judged {
    /// Radiosities of a tree's leaves, and for weights by leaf the sums of their errors.
    ///
    /// # Errors
    /// [`HierarchyError`], as [`ErrorBound::try_new`](super::ErrorBound::try_new) has it.
    pub(super) fn try_new(
        setting: Setting,
        tree: &Tree,
        light: &Lighting,
        values: Vec<f64>,
        goals: &[Vec<f64>; GOALS],
    ) -> Result<(Self, [Correction; GOALS]), HierarchyError> {
        let own = setting.constants(&values);
        let adjoints: [Vec<f64>; GOALS] = from_fn(|k| setting.operator.solved(&goals[k]));
        let others: [Vec<f64>; GOALS] =
            from_fn(|k| setting.adjoint_constants(&goals[k], &adjoints[k]));
        let functions = from_fn(|k| {
            if k == 0 {
                values.as_slice()
            } else {
                &adjoints[k - 1]
            }
        });
        let constants = from_fn(|k| {
            if k == 0 {
                own.as_slice()
            } else {
                &others[k - 1]
            }
        });
        let allowed = setting.allowed(functions, constants);
        let measure =
            |pieces: &[(usize, &Element)]| setting.measured(pieces, functions, constants, allowed);
        let (adapted, measured) = Adapted::try_new(tree, light, setting.sight(), &measure)?;
        let column = |k: usize| -> Vec<Measured> { measured.iter().map(|all| all[k]).collect() };
        let residual = column(0);
        let total = setting.total(&values, &own);
        let judged = Self {
            energy: adapted.energy(&residual, total),
            total,
            setting,
            adapted,
            values,
            residual,
        };
        let corrections = from_fn(|k| judged.correction(&adjoints[k], &others[k], &column(k + 1)));
        Ok((judged, corrections))
    }

    /// A bound on `‖e‖`, from `∫ e` over patches without light.
    ///
    /// # Errors
    /// [`HierarchyError::NotDamped`].
    pub(super) fn norm_of_error(&self, integral: Correction) -> Result<f64, HierarchyError> {
        let integral = Bounded::bound(integral.value, integral.error);
        let counts = |patch| self.setting.is_unlit(patch);
        self.adapted
            .minorant()
            .norm_of_error(&self.energy, integral, &counts)
    }

    /// By leaf of another tree about the squared error that a change by leaf and the residual show.
    pub(super) fn by_leaf(&self, origins: &[usize], change: &[f64], count: usize) -> Vec<f64> {
        let mut squares = vec![0.0; count];
        for (leaf, (origin, change)) in origins.iter().zip(change).enumerate() {
            squares[*origin] += self.setting.area(leaf) * change * change;
        }
        for (part, piece) in self.residual.iter().zip(self.adapted.pieces()) {
            let reflectance = self.setting.reflectance(piece.leaf);
            squares[origins[piece.leaf]] += reflectance * reflectance * part.known.second;
        }
        squares
    }

    /// `‖c + R f‖²` for a change c by leaf, as far as f is known.
    pub(super) fn shown_by_residual(&self, change: &[f64]) -> f64 {
        let parts = self.residual.iter().zip(self.adapted.pieces());
        let squares = parts.map(|(part, piece)| {
            let (reflectance, known) = (self.setting.reflectance(piece.leaf), &part.known);
            reflectance * (reflectance * known.second + 2.0 * change[piece.leaf] * known.first)
        });
        self.setting.square(change) + squares.sum::<f64>()
    }

    /// A bound on `‖R ρ + R K e‖` for the rest ρ of the residual, from a bound on ‖e‖.
    pub(super) fn unknown(&self, error: f64) -> f64 {
        let parts = self.residual.iter().zip(self.adapted.pieces());
        let squares = parts
            .map(|(part, piece)| self.setting.reflectance(piece.leaf).powi(2) * part.rest.second);
        let reflectances = self.setting.light.reflectances().iter().copied();
        squares.sum::<f64>().sqrt() + reflectances.fold(0.0, f64::max) * error
    }

    /// By leaf of another tree a bound on `‖f‖`.
    pub(super) fn shown(&self, origins: &[usize], count: usize) -> Vec<f64> {
        let mut squares = vec![[0.0; 2]; count];
        for (part, piece) in self.residual.iter().zip(self.adapted.pieces()) {
            let [known, rest] = &mut squares[origins[piece.leaf]];
            *known += part.known.second;
            *rest += part.rest.second;
        }
        squares.iter().map(|s| s[0].sqrt() + s[1].sqrt()).collect()
    }

    /// `⟨g, e⟩` for weights by leaf.
    pub(super) fn goal(&self, weights: &[f64]) -> Correction {
        let setting = &self.setting;
        let adjoint = setting.operator.solved(weights);
        let own = setting.adjoint_constants(weights, &adjoint);
        let nothing = vec![0.0; weights.len()];
        let functions = from_fn(|k| if k == 1 { adjoint.as_slice() } else { &nothing });
        let constants = from_fn(|k| if k == 1 { own.as_slice() } else { &nothing });
        let allowed = setting.allowed(functions, constants);
        let pieces = self.adapted.elements();
        let measured = setting.measured(&pieces, functions, constants, allowed);
        let measured: Vec<Measured> = measured.iter().map(|all| all[1]).collect();
        self.correction(&adjoint, &own, &measured)
    }

    /// `⟨g, e⟩`, for a discrete solution of `A ψ = g` and its residual.
    ///
    /// A constant part of ψ meets `∫ f`, if that is known, and not the bounds on its parts.
    fn correction(&self, adjoint: &[f64], constants: &[f64], rest: &[Measured]) -> Correction {
        let parts = || self.residual.iter().zip(self.adapted.pieces());
        let [total, slack] = self.total.unwrap_or_default();
        let mut level = 0.0;
        if self.total.is_some() {
            let slack: f64 = self.residual.iter().map(|part| part.rest.first).sum();
            let weighted = parts().map(|(part, piece)| part.rest.first * adjoint[piece.leaf]);
            let weighted: f64 = weighted.sum();
            level = if slack > 0.0 { weighted / slack } else { 0.0 };
        }
        let (mut value, mut error) = (level * total, level.abs() * slack);
        for (part, piece) in parts() {
            let weight = adjoint[piece.leaf] - level;
            value += weight * part.known.first;
            error += weight.abs() * part.rest.first;
        }
        let total = self.setting.total(adjoint, constants);
        error += self.adapted.energy(rest, total).most() * self.energy.most();
        Correction { value, error }
    }
}
