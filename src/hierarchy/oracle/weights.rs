//! The generalised areas of elements, `W = A B H` (§3.4), and the pairs that they are compared in.
//!
//! What a light that reflects nothing receives is known from the links that lead to it, turned
//! round.

use super::View;
use crate::hierarchy::link_factor::Visibility;
use crate::hierarchy::turned::{Turned, turned_links};
use crate::numeric::real;

/// A leaf, and an element that it exchanges light with.
pub(super) struct Pair<'v> {
    /// The other element.
    pub(super) other: usize,
    /// `A_i F_ij` of the leaf and the other.
    pub(super) exchange: f64,
    /// What stands between elements that the two are, or are parts of.
    pub(super) sight: &'v Visibility,
}

/// The generalised areas of a mesh.
pub(super) struct GeneralisedAreas<'v> {
    view: View<'v>,
    /// `W` of each element over the number of its leaves.
    of_leaf: Vec<f64>,
    /// The links that lead to each element of a light without links of its own.
    towards: Vec<Vec<Turned<'v>>>,
}

impl<'v> GeneralisedAreas<'v> {
    pub(super) fn of(view: &View<'v>) -> Self {
        let mut towards = vec![Vec::new(); view.tree.elements().len()];
        for turned in turned_links(view.tree, view.links, view.lighting) {
            if is_dark_light(view, turned.receiver) {
                towards[turned.receiver].push(turned);
            }
        }
        let mut areas = Self {
            view: *view,
            of_leaf: Vec::new(),
            towards,
        };
        areas.of_leaf = areas.means();
        areas
    }

    /// `W` of a leaf; of an element that is cut, the mean of its leaves.
    pub(super) fn of_leaf(&self, element: usize) -> f64 {
        self.of_leaf[element]
    }

    /// The pairs of a leaf.
    pub(super) fn pairs(&self, leaf: usize) -> Vec<Pair<'v>> {
        let area = self.view.element(leaf).shape().area();
        if is_dark_light(&self.view, leaf) {
            return self.pairs_of_light(leaf, area).collect();
        }
        let links = self.view.sights_of(leaf);
        let pairs = links.map(|(link, sight)| Pair {
            other: link.source as usize,
            exchange: area * self.view.at_centre(leaf, link).max(0.0),
            sight,
        });
        pairs.collect()
    }

    fn pairs_of_light(&self, leaf: usize, area: f64) -> impl Iterator<Item = Pair<'v>> + '_ {
        self.view.path(leaf).flat_map(move |at| {
            let share = area / self.view.element(at).shape().area();
            self.towards[at].iter().map(move |turned| Pair {
                other: turned.source,
                exchange: share * turned.exchange,
                sight: turned.sight,
            })
        })
    }

    fn means(&self) -> Vec<f64> {
        let count = self.view.tree.elements().len();
        let (mut sums, mut leaves) = (vec![0.0; count], vec![0_usize; count]);
        for index in (0..count).rev() {
            let element = self.view.element(index);
            if element.is_leaf() {
                leaves[index] = 1;
                let pairs = self.pairs(index).into_iter();
                let received = pairs.map(|pair| pair.exchange * self.view.radiosity(pair.other));
                sums[index] = self.view.radiosity(index) * received.sum::<f64>();
            }
            for child in element.children() {
                sums[index] += sums[child];
                leaves[index] += leaves[child];
            }
        }
        let means = sums.iter().zip(&leaves);
        means.map(|(sum, leaves)| sum / real(*leaves)).collect()
    }
}

/// Is it part of a light that reflects nothing?
fn is_dark_light(view: &View<'_>, element: usize) -> bool {
    view.emittance(element) > 0.0 && view.reflectance(element) <= 0.0
}
