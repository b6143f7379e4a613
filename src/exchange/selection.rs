//! A selection of a scene's pairs: from some rows, to some rows.

use super::ExchangeError;
use crate::scene::{SceneError, are_few};

/// The ordered pairs from some rows to some rows; all rows where none are listed.
///
/// # Examples
/// ```
/// use infoscene::exchange::Selection;
/// let column = Selection { from: None, to: Some(vec![2]) };
/// let pairs: Vec<[usize; 2]> = column.pairs(4).collect();
/// assert_eq!(pairs, [[0, 2], [1, 2], [2, 2], [3, 2]]);
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Selection {
    /// The rows that send, by number.
    pub from: Option<Vec<usize>>,
    /// The rows that receive.
    pub to: Option<Vec<usize>>,
}

impl Selection {
    /// Tells whether all pairs are selected.
    #[must_use]
    pub const fn is_all(&self) -> bool {
        self.from.is_none() && self.to.is_none()
    }

    /// The pairs in a scene of so many rows, in the order of the lists; each row with itself, too.
    pub fn pairs(&self, rows: usize) -> impl Iterator<Item = [usize; 2]> {
        let list = |given: &Option<Vec<usize>>| match given {
            Some(given) => given.clone(),
            None => (0..rows).collect(),
        };
        let (from, to) = (list(&self.from), list(&self.to));
        from.into_iter()
            .flat_map(move |from| to.clone().into_iter().map(move |to| [from, to]))
    }

    /// The rows of which one at least is in every pair; none if all pairs are selected.
    pub(crate) fn ends(&self) -> Option<&[usize]> {
        self.from.as_deref().or(self.to.as_deref())
    }

    /// The rows at the other end of the pairs; all if none are listed.
    pub(crate) fn other_ends(&self) -> Option<&[usize]> {
        self.from.as_ref().and(self.to.as_deref())
    }

    /// Tells whether the pairs are so few that every surface may be looked at for each.
    pub(crate) fn is_few(&self) -> bool {
        let ends = self.ends().zip(self.other_ends());
        ends.is_some_and(|(rows, others)| are_few(rows, others))
    }

    /// Tells for each of so many rows whether it is at both ends: both directions of a pair are
    /// selected if that is so of its two rows.
    pub(crate) fn at_both_ends(&self, rows: usize) -> Vec<bool> {
        let mut both = vec![true; rows];
        for list in [&self.from, &self.to].into_iter().flatten() {
            let mut listed = vec![false; rows];
            for row in list {
                listed[*row] = true;
            }
            for (both, listed) in both.iter_mut().zip(listed) {
                *both &= listed;
            }
        }
        both
    }

    /// Refuses rows that a scene of so many does not have.
    pub(crate) fn check(&self, rows: usize) -> Result<(), ExchangeError> {
        let last = rows - 1;
        let mut listed = [&self.from, &self.to].into_iter().flatten().flatten();
        match listed.find(|row| **row > last) {
            Some(index) => Err(SceneError::NoSuchPatch {
                index: *index,
                last,
            }
            .into()),
            None => Ok(()),
        }
    }
}
