//! Rows grouped by the planes that they lie in.
//!
//! Rows whose polygons lie in the same planes have the same *aspect*: they see the same. A row that is one patch has the aspect
//! of its plane; one that lies in several planes may see itself.

use super::facing::{FacingPlanes, Sight};
use super::members::Members;
use crate::numeric::compensated_sum;
use smallvec::SmallVec;
use std::collections::HashMap;

/// The planes of one aspect, in order.
type PlaneSet = SmallVec<[usize; 1]>;

/// The aspects of a scene's rows, numbered in the order of their first rows.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Aspects {
    /// The aspect of each row.
    of: Vec<usize>,
    /// The rows of each aspect, in order.
    rows: Vec<Vec<usize>>,
    planes: Vec<PlaneSet>,
}

impl Aspects {
    pub(super) fn of(members: &Members, planes: &FacingPlanes) -> Self {
        let mut aspects = Self {
            of: Vec::with_capacity(members.rows()),
            rows: Vec::new(),
            planes: Vec::new(),
        };
        let mut known: HashMap<PlaneSet, usize> = HashMap::new();
        for row in 0..members.rows() {
            let polygons = members.of_row(row).iter();
            let mut set: PlaneSet = polygons.map(|m| planes.of_patch(m.polygon)).collect();
            set.sort_unstable();
            set.dedup();
            let aspect = *known.entry(set).or_insert_with_key(|set| {
                aspects.planes.push(set.clone());
                aspects.rows.push(Vec::new());
                aspects.rows.len() - 1
            });
            aspects.of.push(aspect);
            aspects.rows[aspect].push(row);
        }
        aspects
    }

    pub(super) fn of_row(&self, row: usize) -> usize {
        self.of[row]
    }

    /// The rows of each aspect.
    pub(super) fn rows(&self) -> &[Vec<usize>] {
        &self.rows
    }

    /// What rows of two aspects can exchange; of the same aspect, what a row can exchange with itself.
    pub(super) fn sight(&self, planes: &FacingPlanes, first: usize, second: usize) -> Sight {
        let mut most = Sight::Coplanar;
        for one in &self.planes[first] {
            for other in &self.planes[second] {
                match planes.sight(*one, *other) {
                    Sight::Open => return Sight::Open,
                    Sight::BackFacing => most = Sight::BackFacing,
                    Sight::Coplanar => {}
                }
            }
        }
        most
    }

    /// For each row the sum of the weights of all rows that it exchanges nothing with, its own if it is one.
    pub(super) fn unseen(&self, planes: &FacingPlanes, weights: &[f64]) -> Vec<f64> {
        let sum = |rows: &Vec<usize>| compensated_sum(rows.iter().map(|row| weights[*row]));
        let sums: Vec<f64> = self.rows.iter().map(sum).collect();
        let unseen = |aspect: usize| {
            if !planes.are_compared() {
                // then a plane is behind none but itself
                let sees_itself = self.planes[aspect].len() > 1;
                return if sees_itself { 0.0 } else { sums[aspect] };
            }
            let dark = |other: &usize| self.sight(planes, aspect, *other) != Sight::Open;
            compensated_sum((0..sums.len()).filter(dark).map(|other| sums[other]))
        };
        let by_aspect: Vec<f64> = (0..sums.len()).map(unseen).collect();
        self.of.iter().map(|aspect| by_aspect[*aspect]).collect()
    }
}
