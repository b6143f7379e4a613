//! Bounds on the change of what a scene's rows exchange, and of their sums, by its resolution.
//!
//! The bounds are those of [`Resolution`](crate::exchange::resolution::Resolution), summed over the
//! polygons of rows.

use crate::exchange::ScenePairs;
use crate::exchange::pairs::sights::Sight;
use crate::exchange::plan::facing::Facing;
use crate::exchange::rows::terms::RowTerm;
use crate::numeric::{Symmetric, parallel_map};
use rayon::prelude::*;

/// The part of what the resolution can change that an error of the computation may be, whatever the
/// tolerance: nobody sees more digits than that.
const UNFELT: f64 = 1e-3;

impl ScenePairs<'_> {
    /// The length by which each coordinate may be off; 0 if they are exact.
    #[must_use]
    pub fn resolution(&self) -> f64 {
        self.loose().map_or(0.0, |loose| loose.surfaces().length)
    }

    /// A bound on what the resolution of the scene can change of the exchange area of two rows; 0
    /// for an exact scene. It does not include the error of the computation, which stands beside.
    ///
    /// # Panics
    /// If there is no such row.
    #[must_use]
    pub fn resolution_error(&self, first: usize, second: usize) -> f64 {
        let Some(resolution) = self.loose() else {
            return 0.0;
        };
        let roots = self.terms().roots();
        let times = if first == second { 2.0 } else { 1.0 };
        let change = |[one, two]: [RowTerm; 2]| {
            let [one, two] = [one.polygon, two.polygon];
            if roots[one] == roots[two] {
                return 0.0;
            }
            let facing = self.facing_polygons(one, two);
            let change = resolution.change(one, two, facing);
            let Sight::Past(between) = self.exact_sight(one, two, facing) else {
                return change;
            };
            let between = between.iter();
            let moved = between.map(|surface| resolution.change_by(*surface, one, two));
            (change + moved.sum::<f64>()).min(resolution.most(one, two))
        };
        times * self.terms().pairs(first, second).map(change).sum::<f64>()
    }

    /// Bounds on what a row's sum of exchange areas may be off its area in a closed scene, by what
    /// the resolution explains of the cracks between its patches.
    #[must_use]
    pub fn crack_errors(&self) -> Vec<f64> {
        parallel_map(self.rows(), &|row| self.crack_error(row))
    }

    /// The bound of one row among [`crack_errors`](Self::crack_errors).
    pub(crate) fn crack_error(&self, row: usize) -> f64 {
        let Some(resolution) = self.loose() else {
            return 0.0;
        };
        let terms = self.terms().of_row(row).iter();
        terms
            .map(|term| resolution.lost_in_cracks(term.polygon))
            .sum()
    }

    /// The error of the computation that nobody feels beside what the resolution can change of the
    /// exchange area of two rows.
    pub(crate) fn unfelt(&self, first: usize, second: usize) -> f64 {
        UNFELT * self.resolution_error(first, second)
    }

    /// Whether the plan leaves out two rows as one lies behind the other's plane.
    pub(crate) fn is_behind(&self, first: usize, second: usize) -> bool {
        self.facing(first, second) == Facing::BackFacing
    }

    /// Bounds on what the resolution of the scene can change of the rows' areas.
    #[must_use]
    pub fn area_resolution_errors(&self) -> Vec<f64> {
        let Some(resolution) = self.loose() else {
            return vec![0.0; self.rows()];
        };
        let row = |row: usize| {
            let terms = self.terms().of_row(row).iter();
            terms.map(|term| resolution.area_change(term.polygon)).sum()
        };
        (0..self.rows()).map(row).collect()
    }
}

/// Bounds on what the resolution of a scene can change of exchange areas that are held, and of
/// areas.
#[derive(Debug, Clone, PartialEq)]
pub struct ResolutionErrors {
    length: f64,
    exchange: Symmetric<f64>,
    own: Vec<f64>,
    areas: Vec<f64>,
    cracks: Vec<f64>,
}

impl ResolutionErrors {
    /// The bounds of all pairs; none if coordinates are exact.
    pub(crate) fn of(pairs: &ScenePairs<'_>) -> Option<Self> {
        let resolution = pairs.loose()?;
        let n = pairs.rows();
        let mut exchange = Symmetric::filled(n, 0.0);
        let rows = exchange.rows_mut().into_par_iter().enumerate();
        rows.for_each(|(i, row)| {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry = pairs.resolution_error(i, j);
            }
        });
        let own: Vec<f64> = (0..n).map(|i| pairs.resolution_error(i, i)).collect();
        let areas = pairs.area_resolution_errors();
        Some(Self {
            length: resolution.surfaces().length,
            exchange,
            own,
            areas,
            cracks: pairs.crack_errors(),
        })
    }

    /// The length by which each coordinate may be off.
    #[must_use]
    pub const fn length(&self) -> f64 {
        self.length
    }

    /// The bounds off the diagonal, those of pairs that are left out included.
    #[must_use]
    pub const fn exchange(&self) -> &Symmetric<f64> {
        &self.exchange
    }

    /// The bounds on what rows exchange with themselves.
    #[must_use]
    pub fn own(&self) -> &[f64] {
        &self.own
    }

    /// The bounds on the rows' areas.
    #[must_use]
    pub fn areas(&self) -> &[f64] {
        &self.areas
    }

    /// Bounds on what a row's sum of exchange areas may be off its area in a closed scene
    /// ([`ScenePairs::crack_errors`]).
    #[must_use]
    pub fn cracks(&self) -> &[f64] {
        &self.cracks
    }
}
