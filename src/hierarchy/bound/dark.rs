//! The light that patches take which reflect nothing.

use super::kernel::least_kernel;
use super::sight::{End, Sight};
use crate::hierarchy::{Element, HierarchyError, Tree};

/// The elements, about.
const COUNT: usize = 1024;
/// The size of an element, per distance, up to which it is taken as a whole.
const APART: f64 = 0.2;

/// The patches that reflect nothing, cut into elements of one size.
#[derive(Debug)]
pub(super) struct Dark {
    tree: Tree,
    patches: Vec<usize>,
}

impl Dark {
    /// The dark patches of a tree.
    ///
    /// # Errors
    /// [`HierarchyError::Element`].
    pub(super) fn of(tree: &Tree, reflectances: &[f64]) -> Result<Self, HierarchyError> {
        let patches = 0..tree.patches();
        let patches: Vec<usize> = patches
            .filter(|patch| reflectances[*patch] <= 0.0)
            .collect();
        let mut dark = Tree::new(patches.iter().map(|patch| tree.elements()[*patch].shape()));
        let mut next = 0;
        while dark.patches() > 0 && dark.leaf_count() < COUNT {
            dark.quarter(next)?;
            next += 1;
        }
        Ok(Self {
            tree: dark,
            patches,
        })
    }

    /// A lower bound on the part of the light from any point of a cell that dark patches take.
    pub(super) fn taken(&self, cell: &Element, sight: &Sight) -> f64 {
        let mut open: Vec<usize> = (0..self.patches.len()).collect();
        let mut sum = 0.0;
        while let Some(index) = open.pop() {
            let element = &self.tree.elements()[index];
            let gap = element.centre().distance(cell.centre()) - cell.radius();
            if !element.is_leaf() && element.radius() >= APART * gap {
                open.extend(element.children());
                continue;
            }
            let dark = End::of(self.patches[element.patch()], element.shape());
            let kernel = least_kernel(End::of(cell.patch(), cell.shape()), dark, sight);
            sum += kernel * element.shape().area();
        }
        sum
    }
}
