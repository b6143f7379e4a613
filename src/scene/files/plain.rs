//! Scenes that are faces and nothing else: all that Wavefront OBJ and STL can say.

use super::error::NotExpressible;
use crate::scene::{EmptyRow, PatchMaterial, Scene};
use glam::DVec3;
use std::borrow::Cow;

/// A row of such a scene.
pub(crate) struct PlainRow<'s> {
    pub name: &'s str,
    pub material: &'s PatchMaterial,
    /// Three times the same one if the row has no area.
    pub corners: Cow<'s, [DVec3]>,
    /// The patch that the row is.
    pub patch: Option<usize>,
}

/// The rows of a scene, each of which is one patch or none.
///
/// # Errors
/// [`NotExpressible`] if polygons only obstruct, a patch lies in another one, or patches are
/// summed.
pub(crate) fn plain_rows<'s>(
    scene: &'s Scene,
    format: &'static str,
) -> Result<Vec<PlainRow<'s>>, NotExpressible> {
    let not = |what: String| NotExpressible {
        format,
        what,
        mend: "write View3D .vs3",
    };
    let count = scene.patches().len();
    if !scene.obstructions().is_empty() {
        return Err(not("a polygon only obstructs".to_owned()));
    }
    if let Some(part) = (0..count).find(|index| scene.base_of(*index).is_some()) {
        return Err(not(format!("patch {part} lies in another one")));
    }
    if scene.first_summed().is_some() {
        return Err(not("patches are summed into one row".to_owned()));
    }
    let mut empty = scene.empty_rows().iter().peekable();
    let mut rows = Vec::with_capacity(scene.group_count());
    for (index, patch) in scene.patches().iter().map(Some).chain([None]).enumerate() {
        while let Some(EmptyRow { name, material, .. }) =
            empty.next_if(|empty| empty.row == rows.len())
        {
            let place = scene.patches()[0].shape().corners()[0];
            rows.push(PlainRow {
                name,
                material,
                corners: Cow::Owned(vec![place; 3]),
                patch: None,
            });
        }
        rows.extend(patch.map(|patch| PlainRow {
            name: patch.name(),
            material: patch.material(),
            corners: Cow::Borrowed(patch.shape().given_corners()),
            patch: Some(index),
        }));
    }
    Ok(rows)
}
