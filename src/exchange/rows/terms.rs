//! The signed polygons that each row is a sum of.
//!
//! ```text
//!   A'_g = Σ_k c_gk A_k ,   A'_g F'_gh = Σ_k Σ_l c_gk c_hl A_k F_kl
//!   c_gk = [k is in the row g] − [the base of k is in the row g]
//! ```
//!
//! These are the formulas of [parts and rows](crate::scene::Scene::with_base), with the order of
//! their sums exchanged. Where a part is summed into the row of its base, its terms cancel: the
//! base counts whole, and the part is no polygon of any sum.

use crate::scene::{NamedPatch, Scene};
use smallvec::SmallVec;
use std::borrow::Cow;
use std::num::NonZeroU32;

/// One polygon of a row, and its sign.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RowTerm {
    pub polygon: usize,
    /// 1, or −1 for what lies in a base of the row.
    pub sign: f64,
}

/// The polygons of all rows.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RowTerms {
    /// The patch that each polygon is, in order.
    patches: Vec<usize>,
    /// The polygon that each one lies in, and no other: itself unless it is a part.
    roots: Vec<usize>,
    rows: Vec<SmallVec<[RowTerm; 1]>>,
    /// The number, from 1, of the polygon of each row that is one polygon: side by side for speed.
    singles: Vec<Option<NonZeroU32>>,
}

impl RowTerms {
    pub(crate) fn of(scene: &Scene) -> Self {
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
            rows[group(*patch)].push(RowTerm { polygon, sign: 1.0 });
            if let Some(base) = scene.base_of(*patch) {
                let sign = -1.0;
                rows[group(base)].push(RowTerm { polygon, sign });
            }
        }
        let single = |row: &SmallVec<[RowTerm; 1]>| match row.as_slice() {
            [one] => u32::try_from(one.polygon + 1)
                .ok()
                .and_then(NonZeroU32::new),
            _ => None,
        };
        Self {
            roots: patches.iter().map(root).collect(),
            singles: rows.iter().map(single).collect(),
            patches,
            rows,
        }
    }

    /// The index of the patch that each polygon is, in order.
    pub(crate) fn patches(&self) -> &[usize] {
        &self.patches
    }

    /// The polygon that each one lies in, and no other: itself unless it is a part.
    pub(crate) fn roots(&self) -> &[usize] {
        &self.roots
    }

    /// The patches that the polygons are.
    pub(crate) fn shapes<'s>(&self, scene: &'s Scene) -> Cow<'s, [NamedPatch]> {
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
    pub(crate) const fn rows(&self) -> usize {
        self.rows.len()
    }

    /// The polygons of a row, in order.
    pub(crate) fn of_row(&self, row: usize) -> &[RowTerm] {
        &self.rows[row]
    }

    /// The polygons of some rows.
    pub(crate) fn polygons_of(&self, rows: &[usize]) -> Vec<usize> {
        let terms = rows.iter().flat_map(|row| self.of_row(*row));
        terms.map(|term| term.polygon).collect()
    }

    /// The two polygons of two rows that are one polygon each.
    #[inline]
    pub(crate) fn single(&self, first: usize, second: usize) -> Option<[usize; 2]> {
        if first == second {
            return None;
        }
        let [one, other] = [self.singles[first]?, self.singles[second]?];
        Some([one, other].map(|number| number.get() as usize - 1))
    }

    /// The pairs of polygons that two rows are summed of, with the signs of both; of a row with
    /// itself each pair once.
    pub(crate) fn pairs(&self, first: usize, second: usize) -> impl Iterator<Item = [RowTerm; 2]> {
        let others = self.of_row(second);
        let ones = self.of_row(first).iter().enumerate();
        ones.flat_map(move |(place, one)| {
            let from = if first == second { place + 1 } else { 0 };
            others[from..].iter().map(move |other| [*one, *other])
        })
    }
}
