//! Which polygons make up each row, and with which sign.
//!
//! ```text
//!   A'_g = Σ_k c_gk A_k ,   A'_g F'_gh = Σ_k Σ_l c_gk c_hl A_k F_kl
//!   c_gk = [k is in the row g] − [the base of k is in the row g]
//! ```
//!
//! These are the formulas of [parts and rows](super::Scene::with_base), their sums exchanged. Where a part is summed into the row
//! of its base, its terms cancel: the base counts whole, and the part is no polygon of any sum.

use super::{NamedPatch, Scene};
use smallvec::SmallVec;
use std::borrow::Cow;

/// A polygon of a row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Member {
    pub polygon: usize,
    /// 1, or −1 for what lies in a base of the row.
    pub sign: f64,
}

/// The polygons that count, and what they count for.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Members {
    /// The patch that each polygon is, in order.
    pub patches: Vec<usize>,
    /// The polygon that each one lies in, and no other: itself unless it is a part.
    pub roots: Vec<usize>,
    rows: Vec<SmallVec<[Member; 1]>>,
    /// The polygon of each row that is one, side by side for speed.
    singles: Vec<u32>,
}

/// A row that is not one polygon.
const SEVERAL: u32 = u32::MAX;

impl Members {
    pub(super) fn of(scene: &Scene) -> Self {
        let group = |patch: usize| scene.group_of(patch);
        let counts = |patch: &usize| {
            let base = scene.base_of(*patch);
            base.is_none_or(|base| group(base) != group(*patch))
        };
        let patches: Vec<usize> = (0..scene.patches().len()).filter(counts).collect();
        let mut polygons = vec![0; scene.patches().len()];
        for (polygon, patch) in patches.iter().enumerate() {
            polygons[*patch] = polygon;
        }
        let root = |patch: &usize| polygons[scene.root_of(*patch)];
        let mut rows = vec![SmallVec::new(); scene.group_count()];
        for (polygon, patch) in patches.iter().enumerate() {
            rows[group(*patch)].push(Member { polygon, sign: 1.0 });
            if let Some(base) = scene.base_of(*patch) {
                let sign = -1.0;
                rows[group(base)].push(Member { polygon, sign });
            }
        }
        let single = |row: &SmallVec<[Member; 1]>| match row.as_slice() {
            [one] => u32::try_from(one.polygon).unwrap_or(SEVERAL),
            _ => SEVERAL,
        };
        Self {
            roots: patches.iter().map(root).collect(),
            singles: rows.iter().map(single).collect(),
            patches,
            rows,
        }
    }

    /// The patches that the polygons are.
    pub(super) fn shapes<'s>(&self, scene: &'s Scene) -> Cow<'s, [NamedPatch]> {
        let all = scene.patches();
        if self.patches.len() == all.len() {
            return Cow::Borrowed(all);
        }
        self.patches
            .iter()
            .map(|patch| all[*patch].clone())
            .collect()
    }

    /// Number of rows.
    pub(super) const fn rows(&self) -> usize {
        self.rows.len()
    }

    /// The polygons of a row, in order.
    pub(super) fn of_row(&self, row: usize) -> &[Member] {
        &self.rows[row]
    }

    /// The two polygons of two rows that are one polygon each.
    #[inline]
    pub(super) fn single(&self, first: usize, second: usize) -> Option<[usize; 2]> {
        let [one, other] = [self.singles[first], self.singles[second]];
        let are_single = one != SEVERAL && other != SEVERAL;
        (are_single && first != second).then_some([one as usize, other as usize])
    }

    /// The pairs of polygons that two rows are summed of, those of a row with itself once; with the signs of both.
    pub(super) fn pairs(&self, first: usize, second: usize) -> impl Iterator<Item = [Member; 2]> {
        let others = self.of_row(second);
        let ones = self.of_row(first).iter().enumerate();
        ones.flat_map(move |(place, one)| {
            let from = if first == second { place + 1 } else { 0 };
            others[from..].iter().map(move |other| [*one, *other])
        })
    }
}
