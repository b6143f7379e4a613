//! Rows grouped by the planes that they lie in.
//!
//! Rows whose polygons lie in the same planes have the same *plane set*: planes hide the same rows
//! from them. A row that is one patch has the set of its plane; one that lies in several planes may
//! see itself.

use super::terms::RowTerms;
use crate::exchange::plan::facing::{Facing, FacingPlanes};
use crate::numeric::compensated_sum;
use smallvec::SmallVec;
use std::collections::HashMap;
use std::ops::Range;

/// Planes, in order.
type PlaneSet = SmallVec<[usize; 1]>;

/// The plane sets of a scene's rows, numbered in the order of their first rows.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PlaneSets {
    /// The plane set of each row.
    of: Vec<usize>,
    /// The rows, in the order of their plane sets.
    order: Vec<usize>,
    /// The place in `order` at which the rows of each plane set start, and the end of the last.
    starts: Vec<usize>,
    planes: Vec<PlaneSet>,
}

impl PlaneSets {
    pub(crate) fn of(terms: &RowTerms, facings: &FacingPlanes) -> Self {
        let mut of = Vec::with_capacity(terms.rows());
        let mut rows: Vec<Vec<usize>> = Vec::new();
        let mut planes = Vec::new();
        let mut known: HashMap<PlaneSet, usize> = HashMap::new();
        for row in 0..terms.rows() {
            let polygons = terms.of_row(row).iter();
            let mut set: PlaneSet = polygons.map(|t| facings.of_patch(t.polygon)).collect();
            set.sort_unstable();
            set.dedup();
            let number = *known.entry(set).or_insert_with_key(|set| {
                planes.push(set.clone());
                rows.push(Vec::new());
                rows.len() - 1
            });
            of.push(number);
            rows[number].push(row);
        }
        let mut starts = vec![0];
        for rows in &rows {
            starts.push(starts[starts.len() - 1] + rows.len());
        }
        Self {
            of,
            order: rows.concat(),
            starts,
            planes,
        }
    }

    /// The plane set of a row.
    pub(crate) fn of_row(&self, row: usize) -> usize {
        self.of[row]
    }

    /// Number of plane sets.
    const fn count(&self) -> usize {
        self.planes.len()
    }

    /// All rows, in the order of their plane sets.
    pub(crate) fn order(&self) -> &[usize] {
        &self.order
    }

    /// The places of each plane set's rows in the [`order`](Self::order).
    pub(crate) fn places(&self) -> impl Iterator<Item = Range<usize>> {
        self.starts.windows(2).map(|ends| ends[0]..ends[1])
    }

    /// Whether rows of two plane sets can exchange anything; of the same set, whether a row can
    /// exchange anything with itself.
    pub(crate) fn facing(&self, facings: &FacingPlanes, first: usize, second: usize) -> Facing {
        let mut most = Facing::Coplanar;
        for one in &self.planes[first] {
            for other in &self.planes[second] {
                match facings.facing(*one, *other) {
                    Facing::Visible => return Facing::Visible,
                    Facing::BackFacing => most = Facing::BackFacing,
                    Facing::Coplanar => {}
                }
            }
        }
        most
    }

    /// Sums, for each row, the weights of all rows that it exchanges nothing with, its own included
    /// if it cannot see itself.
    pub(crate) fn unseen(&self, facings: &FacingPlanes, weights: &[f64]) -> Vec<f64> {
        let sum = |places: Range<usize>| {
            compensated_sum(self.order[places].iter().map(|row| weights[*row]))
        };
        let sums: Vec<f64> = self.places().map(sum).collect();
        let unseen = |set: usize| {
            if !facings.are_compared() {
                // then a plane is behind none but itself
                let sees_itself = self.planes[set].len() > 1;
                return if sees_itself { 0.0 } else { sums[set] };
            }
            let dark = |other: &usize| self.facing(facings, set, *other) != Facing::Visible;
            compensated_sum((0..sums.len()).filter(dark).map(|other| sums[other]))
        };
        let by_set: Vec<f64> = (0..self.count()).map(unseen).collect();
        self.of.iter().map(|set| by_set[*set]).collect()
    }
}
