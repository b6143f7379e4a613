//! Scenes that are faces and nothing else: all that Wavefront OBJ and STL can say.

use super::NonPlanarFaces;
use super::error::NotExpressible;
use super::faces::{FaceRules, face_of};
use crate::geometry::{Patch, united};
use crate::numeric::tolerance;
use crate::scene::{EmptyRow, NamedPatch, PatchMaterial, Scene};
use glam::DVec3;
use std::borrow::Cow;

/// A row of such a scene.
pub(crate) struct PlainRow<'s> {
    pub name: &'s str,
    pub material: &'s PatchMaterial,
    /// Three times the same one if the row has no area.
    pub corners: Cow<'s, [DVec3]>,
    /// The first patch of the row.
    pub patch: Option<usize>,
}

/// The treatment of a row of several patches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum SummedRows {
    /// The scene is refused.
    Refuse,
    /// The patches become one face, if they hang together: one that may be bridged around
    /// openings.
    Unite,
}

/// The rows of a scene, each of which is one face.
///
/// # Errors
/// [`NotExpressible`] if polygons only obstruct, a patch lies in another one, or patches are summed
/// that do not make up a face.
pub(crate) fn plain_rows<'s>(
    scene: &'s Scene,
    format: &'static str,
    summed: SummedRows,
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
    let mut members = vec![Vec::new(); scene.group_count()];
    for patch in 0..count {
        members[scene.group_of(patch)].push(patch);
    }
    let mut empty = scene.empty_rows().iter();
    let rows = members.iter().map(|patches| match patches.as_slice() {
        [] => Ok(empty.next().map(|empty| nothing(scene, empty))),
        [first, others @ ..] => {
            let patch = &scene.patches()[*first];
            let corners = if others.is_empty() {
                Cow::Borrowed(patch.shape().given_corners())
            } else {
                let face = one_face(scene, patches).filter(|_| summed == SummedRows::Unite);
                let refusal = || not("patches are summed into one row".to_owned());
                Cow::Owned(face.ok_or_else(refusal)?)
            };
            Ok(Some(PlainRow {
                name: patch.name(),
                material: patch.material(),
                corners,
                patch: Some(*first),
            }))
        }
    });
    rows.filter_map(Result::transpose).collect()
}

/// A row without area: a face that is one point.
fn nothing<'s>(scene: &'s Scene, empty: &'s EmptyRow) -> PlainRow<'s> {
    let place = scene.patches()[0].shape().corners()[0];
    PlainRow {
        name: &empty.name,
        material: &empty.material,
        corners: Cow::Owned(vec![place; 3]),
        patch: None,
    }
}

/// The outline of patches that make up one face of one material, as its reader would take it.
fn one_face(scene: &Scene, patches: &[usize]) -> Option<Vec<DVec3>> {
    let patches: Vec<&NamedPatch> = patches.iter().map(|i| &scene.patches()[*i]).collect();
    let is_even = patches
        .windows(2)
        .all(|pair| pair[0].material() == pair[1].material());
    let shapes: Vec<&[DVec3]> = patches
        .iter()
        .map(|patch| patch.shape().given_corners())
        .collect();
    let outline = united(&shapes).filter(|_| is_even)?;
    let rules = FaceRules {
        non_planar: NonPlanarFaces::Refuse,
        resolution: scene.resolution(),
    };
    let read = face_of(outline.clone(), rules).ok()?;
    let area: f64 = patches.iter().map(|patch| patch.shape().area()).sum();
    let again: f64 = read.patches.iter().map(Patch::area).sum();
    // the rounding of sums of areas
    ((area - again).abs() <= tolerance::PLANARITY * area).then_some(outline)
}
