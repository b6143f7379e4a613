//! Rows that the faces of a file become, in its order.

use crate::scene::{EmptyRow, PatchMaterial, Scene, SceneError};
use std::collections::HashSet;

/// The rows of the patches read so far, and of the faces without area among them.
#[derive(Debug, Default)]
pub(crate) struct Rows {
    /// For each patch the number of its face, or of what that is summed into, and of its part.
    labels: Vec<(usize, usize)>,
    known: HashSet<(usize, usize)>,
    empty: Vec<EmptyRow>,
}

impl Rows {
    /// The number of rows so far.
    pub(crate) fn len(&self) -> usize {
        self.known.len() + self.empty.len()
    }

    /// Adds the patches of a face.
    ///
    /// **Arguments** `face`: its number, or that of the face it is summed into; `is_split`: whether
    /// each patch is a row of its own.
    pub(crate) fn push(&mut self, face: usize, patches: usize, is_split: bool) {
        for part in 0..patches {
            let label = (face, if is_split { part } else { 0 });
            self.labels.push(label);
            self.known.insert(label);
        }
    }

    /// Adds a face without area.
    pub(crate) fn push_empty(&mut self, name: String, material: PatchMaterial) {
        let row = self.len();
        self.empty.push(EmptyRow {
            row,
            name,
            material,
        });
    }

    /// The scene of the patches with these rows.
    ///
    /// # Errors
    /// [`SceneError::LabelCount`] unless the scene has the patches that were added.
    pub(crate) fn of(self, scene: Scene) -> Result<Scene, SceneError> {
        scene.with_groups(&self.labels)?.with_empty_rows(self.empty)
    }
}
