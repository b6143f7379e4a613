//! Rows that the faces of a file become, in its order.

use crate::scene::{EmptyRow, PatchMaterial, Scene, SceneError};

/// The rows of the patches read so far, and of the faces without area among them.
#[derive(Debug, Default)]
pub(crate) struct Rows {
    /// The number of each patch's face, or of what that is summed into, and of its part.
    labels: Vec<(usize, usize)>,
    largest: Option<usize>,
    /// Whether a row may have several patches.
    is_summed: bool,
    /// The number of rows, as far as no face is summed into another.
    count: usize,
    /// The rows without a patch, by the number of patches before them.
    empty: Vec<EmptyRow>,
}

impl Rows {
    /// The number of rows so far, as far as no face is summed into another.
    pub(crate) fn len(&self) -> usize {
        self.count
    }

    /// Adds the patches of a face.
    ///
    /// **Arguments** `face`: its number, or that of the face it is summed into; `is_split`: whether
    /// each patch is a row of its own.
    pub(crate) fn push(&mut self, face: usize, patches: usize, is_split: bool) {
        let label = |part| (face, if is_split { part } else { 0 });
        self.labels.extend((0..patches).map(label));
        self.count += if is_split { patches } else { 1 };
        self.is_summed |= (patches > 1 && !is_split) || Some(face) <= self.largest;
        self.largest = self.largest.max(Some(face));
    }

    /// Adds a face without area.
    pub(crate) fn push_empty(&mut self, name: String, material: PatchMaterial) {
        self.count += 1;
        self.empty.push(EmptyRow {
            row: self.labels.len(),
            name,
            material,
        });
    }

    /// The scene of the patches with these rows.
    ///
    /// # Errors
    /// [`SceneError::LabelCount`] unless the scene has the patches that were added.
    pub(crate) fn of(mut self, mut scene: Scene) -> Result<Scene, SceneError> {
        if self.is_summed {
            scene = scene.with_groups(&self.labels)?;
        }
        // rows are numbered in the order of their first patches
        let (mut place, mut rows) = (0, 0);
        for (earlier, empty) in self.empty.iter_mut().enumerate() {
            while place < empty.row {
                rows = rows.max(scene.group_of(place) + 1);
                place += 1;
            }
            empty.row = rows + earlier;
        }
        scene.with_empty_rows(self.empty)
    }
}
