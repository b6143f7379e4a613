//! The corners of a face made into patches: the door that all readers go through.
//!
//! ```text
//!   planar and simple                 one patch
//!   a corner repeated, a spike        one patch, without them
//!   bridged around openings           several patches that make up one row
//!   all corners on one line           no patch: a row that exchanges nothing
//!   not planar, if asked for          triangles, each a patch
//! ```
//!
//! What is clear is mended, and [`Mend`] says so; an outline that crosses itself is refused.
//!
//! **Triangles.** Seen along the mean normal (Newell's) the outline must enclose its area once.
//! Ears are cut off one by one: an ear is a convex corner whose triangle holds no other corner.
//! Among the ears those come first whose plane has all other corners in front. If the outline is
//! convex, these make up the hull of the face as it is seen from behind: every triangle is in front
//! of every other, and what is in front of the face stays convex. Of a quadrilateral, that is the
//! diagonal farther from the front. Corners on one line never make up a triangle.

use super::NonPlanarFaces;
use crate::geometry::{CleanOutline, FlatOutline, GeometryError, Patch, is_on_one_line};
use glam::DVec3;

/// The treatment of a file's faces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FaceRules {
    /// The treatment of a face that is not planar.
    pub non_planar: NonPlanarFaces,
    /// The length by which each coordinate may be off.
    pub resolution: f64,
}

impl FaceRules {
    /// A planar simple polygon, by these rules.
    fn patch(self, corners: Vec<DVec3>) -> Result<Patch, GeometryError> {
        Patch::within(corners, self.resolution)
    }
}

impl From<NonPlanarFaces> for FaceRules {
    fn from(non_planar: NonPlanarFaces) -> Self {
        Self {
            non_planar,
            resolution: 0.0,
        }
    }
}

/// The change of an outline that a reader made on its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Mend {
    /// A corner counts once that was repeated.
    Repeat,
    /// The tip of a spike was left out.
    Spike,
    /// The outline is bridged around openings, and was divided.
    Openings,
}

/// A face as patches.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Face {
    /// The patches; none if the face has no area.
    pub patches: Vec<Patch>,
    /// Whether each patch is a row of its own, as triangles are; else all are summed into one.
    pub is_split: bool,
    /// The changes that were made.
    pub mends: Vec<Mend>,
}

/// The patches of the face with these corners.
///
/// # Errors
/// The errors of [`Patch::try_new`], of the face or of a triangle.
pub(crate) fn face_of(corners: Vec<DVec3>, rules: FaceRules) -> Result<Face, GeometryError> {
    let first = match rules.patch(corners.clone()) {
        Ok(patch) => return Ok(Face::whole(patch, Vec::new())),
        Err(refusal @ GeometryError::NotFinite { .. }) => return Err(refusal),
        Err(refusal) => refusal,
    };
    let outline = CleanOutline::of(&corners);
    if outline.corners.len() < 3 {
        return Ok(Face::without_area());
    }
    let mends = [
        (outline.has_repeats, Mend::Repeat),
        (outline.has_spikes, Mend::Spike),
    ];
    let mends = mends.into_iter().filter(|(is_made, _)| *is_made);
    let mends: Vec<Mend> = mends.map(|(_, mend)| mend).collect();
    let corners = outline.corners;
    let refusal = if mends.is_empty() {
        first
    } else {
        match rules.patch(corners.clone()) {
            Ok(patch) => return Ok(Face::whole(patch, mends)),
            Err(refusal) => refusal,
        }
    };
    match refusal {
        GeometryError::NoArea { .. } if is_on_one_line(&corners) => Ok(Face::without_area()),
        GeometryError::NotSimple { .. } => divided(&corners, rules, mends, refusal),
        GeometryError::NotPlanar { .. } if rules.non_planar == NonPlanarFaces::Triangulate => {
            triangulated(&corners, rules, mends)
        }
        refusal => Err(refusal),
    }
}

impl Face {
    fn whole(patch: Patch, mends: Vec<Mend>) -> Self {
        Self {
            patches: vec![patch],
            is_split: false,
            mends,
        }
    }

    const fn without_area() -> Self {
        Self {
            patches: Vec::new(),
            is_split: false,
            mends: Vec::new(),
        }
    }
}

/// A planar face that is bridged around openings, as polygons without them.
fn divided(
    corners: &[DVec3],
    rules: FaceRules,
    mut mends: Vec<Mend>,
    refusal: GeometryError,
) -> Result<Face, GeometryError> {
    let outline = FlatOutline::of(corners);
    if !outline.is_clear() {
        return Err(refusal);
    }
    mends.push(Mend::Openings);
    Ok(Face {
        patches: outline.pieces(corners, &|corners| rules.patch(corners))?,
        is_split: false,
        mends,
    })
}

/// A face that is not planar, as triangles in the order of its outline.
fn triangulated(
    corners: &[DVec3],
    rules: FaceRules,
    mut mends: Vec<Mend>,
) -> Result<Face, GeometryError> {
    let outline = FlatOutline::of(corners);
    let mut triangles = match Patch::try_new(outline.flattened()) {
        Ok(_) => outline.triangles(),
        Err(GeometryError::NotSimple { .. }) if outline.is_clear() => {
            mends.push(Mend::Openings);
            outline.triangles_between()
        }
        Err(refusal) => return Err(refusal),
    };
    triangles.sort_unstable_by_key(|triangle| {
        let mut sorted = *triangle;
        sorted.sort_unstable();
        sorted
    });
    let patches = triangles.into_iter().map(|mut triangle| {
        let least = (0..3).min_by_key(|k| triangle[*k]).unwrap_or(0);
        triangle.rotate_left(least);
        rules.patch(triangle.map(|k| corners[k]).to_vec())
    });
    Ok(Face {
        patches: patches.collect::<Result<_, _>>()?,
        is_split: true,
        mends,
    })
}
