//! The cells of the minorant, and the pieces on which the residual is measured.
//!
//! A cell is an element of the tree, or a part of a leaf. A piece is a leaf, or a part of a leaf
//! that is a cell: every piece lies in one leaf and in one cell. Patches that reflect nothing have
//! neither.

use crate::hierarchy::{Element, HierarchyError, Tree};

/// A mesh of cells over a tree whose leaves may be cut further.
#[derive(Debug, Clone)]
pub(super) struct Cells {
    mesh: Tree,
    /// By element of the mesh, the leaf of the tree in which it lies, counted among leaves.
    leaf_of: Vec<Option<usize>>,
    cells: Vec<usize>,
}

/// A part of one leaf in one cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct LeafPart {
    /// The element of the mesh.
    pub(super) element: usize,
    /// The leaf, counted among leaves.
    pub(super) leaf: usize,
    pub(super) cell: usize,
}

impl Cells {
    /// The patches with these reflectances, each a cell if it reflects.
    pub(super) fn new(tree: &Tree, reflectances: &[f64]) -> Self {
        let mut leaf_of = vec![None; tree.elements().len()];
        for (leaf, element) in tree.leaves().enumerate() {
            leaf_of[element] = Some(leaf);
        }
        let patches = 0..tree.patches();
        Self {
            mesh: tree.clone(),
            leaf_of,
            cells: patches.filter(|patch| reflectances[*patch] > 0.0).collect(),
        }
    }

    /// An element of the mesh.
    pub(super) fn element(&self, index: usize) -> &Element {
        &self.mesh.elements()[index]
    }

    /// The elements of the mesh, of which some are cells or pieces.
    pub(super) fn element_count(&self) -> usize {
        self.mesh.elements().len()
    }

    /// The cells.
    pub(super) fn cells(&self) -> Vec<&Element> {
        self.cells.iter().map(|cell| self.element(*cell)).collect()
    }

    /// Cuts the largest cells until there are about so many.
    ///
    /// # Errors
    /// [`HierarchyError::Element`].
    pub(super) fn cut_largest(&mut self, count: usize) -> Result<(), HierarchyError> {
        while self.cells.len() < count {
            let radius = |place: &usize| self.element(self.cells[*place]).radius();
            let places = 0..self.cells.len();
            let Some(largest) = places.max_by(|a, b| radius(a).total_cmp(&radius(b))) else {
                break;
            };
            self.cut(&[largest])?;
        }
        Ok(())
    }

    /// Cuts the cells at these places.
    ///
    /// # Errors
    /// [`HierarchyError::Element`].
    pub(super) fn cut(&mut self, places: &[usize]) -> Result<(), HierarchyError> {
        for place in places {
            let element = self.cells[*place];
            if self.element(element).is_leaf() {
                let leaf = self.leaf_of[element];
                self.mesh.quarter(element)?;
                self.leaf_of.resize(self.mesh.elements().len(), leaf);
            }
            let mut children = self.element(element).children();
            if let Some(first) = children.next() {
                self.cells[*place] = first;
                self.cells.extend(children);
            }
        }
        Ok(())
    }

    /// The pieces, in the order of the mesh's elements.
    pub(super) fn pieces(&self) -> Vec<LeafPart> {
        let mut cell_of = vec![None; self.element_count()];
        for (cell, element) in self.cells.iter().enumerate() {
            cell_of[*element] = Some(cell);
        }
        let mut pieces = Vec::new();
        // parents stand before their children
        for (element, at) in self.mesh.elements().iter().enumerate() {
            let inherited = at.parent().and_then(|parent| cell_of[parent]);
            cell_of[element] = cell_of[element].or(inherited);
            let place = (self.leaf_of[element], cell_of[element]);
            if let (true, (Some(leaf), Some(cell))) = (at.is_leaf(), place) {
                pieces.push(LeafPart {
                    element,
                    leaf,
                    cell,
                });
            }
        }
        pieces
    }
}
