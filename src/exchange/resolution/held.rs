//! The bounds of all pairs of a scene, beside exchange areas that are held.

use crate::exchange::ScenePairs;
use crate::numeric::Symmetric;
use rayon::prelude::*;

/// What the resolution of a scene can change of exchange areas that are held, and of areas.
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
