//! A face that is not planar, split into triangles.
//!
//! Seen along its mean normal (Newell's) the outline must be simple. Ears are cut off one by one:
//! an ear is a convex corner whose triangle holds no other corner. Among the ears those come first
//! whose plane has all other corners in front. If the outline is convex, these make up the hull of
//! the face as it is seen from behind: every triangle is in front of every other, and what is in
//! front of the face stays convex. Of a quadrilateral, that is the diagonal farther from the front.
//!
//! **Not covered**: an outline that no ears of positive area divide, as with three neighbouring
//! corners on one line.

use crate::geometry::{EarClipper, GeometryError, Patch};
use glam::{DVec2, DVec3};

/// The patches of a face: itself if it is planar, as far as the resolution of its coordinates goes,
/// else, if asked for, its triangles.
///
/// # Errors
/// The errors of [`Patch::try_new`], of the face or of a triangle.
pub(crate) fn patches_of_face(
    corners: Vec<DVec3>,
    faces: super::NonPlanarFaces,
    resolution: f64,
) -> Result<Vec<Patch>, GeometryError> {
    match Patch::within(corners.clone(), resolution) {
        Ok(patch) => Ok(vec![patch]),
        Err(GeometryError::NotPlanar { .. }) if faces == super::NonPlanarFaces::Triangulate => {
            triangulated(&corners)
        }
        Err(error) => Err(error),
    }
}

fn triangulated(corners: &[DVec3]) -> Result<Vec<Patch>, GeometryError> {
    let origin = corners[0];
    let distances = corners.iter().map(|c| c.distance(origin));
    // in units of the diameter, so that products stay in range
    let unit = distances.fold(0.0, f64::max);
    let local: Vec<DVec3> = corners.iter().map(|c| (*c - origin) / unit).collect();
    let doubled: DVec3 = local.windows(2).map(|pair| pair[0].cross(pair[1])).sum();
    let normal = doubled.normalize_or_zero();
    let flattened = local.iter().map(|c| *c - normal * c.dot(normal));
    Patch::try_new(flattened.collect())?; // is the outline simple?
    let across = normal.any_orthonormal_vector();
    let up = normal.cross(across);
    let flat: Vec<DVec2> = local
        .iter()
        .map(|c| DVec2::new(c.dot(across), c.dot(up)))
        .collect();
    let side = |p: DVec2, q: DVec2, r: DVec2| (q - p).perp_dot(r - p);
    let mut clipper = EarClipper::new(&flat, side);
    let mut triangles = Vec::with_capacity(corners.len() - 2);
    while clipper.left().len() > 3 {
        let of_hull =
            |place: &usize| has_all_in_front(&local, clipper.left(), clipper.triangle(*place));
        let ear = clipper
            .ears()
            .find(of_hull)
            .or_else(|| clipper.ears().next());
        // rounding may hide that a sliver is an ear: any corner keeps the outline closed
        triangles.push(clipper.cut(ear.unwrap_or(0)));
    }
    triangles.extend(<[usize; 3]>::try_from(clipper.left()));
    // in the order of the outline
    triangles.sort_unstable_by_key(|triangle| {
        let mut sorted = *triangle;
        sorted.sort_unstable();
        sorted
    });
    let patches = triangles.into_iter().map(|mut triangle| {
        let least = (0..3).min_by_key(|k| triangle[*k]).unwrap_or(0);
        triangle.rotate_left(least);
        Patch::try_new(triangle.map(|k| corners[k]).to_vec())
    });
    patches.collect()
}

/// Whether all remaining corners are in front of the plane of a triangle.
fn has_all_in_front(corners: &[DVec3], left: &[usize], triangle: [usize; 3]) -> bool {
    let [a, b, c] = triangle.map(|k| corners[k]);
    let normal = (b - a).cross(c - a);
    left.iter()
        .filter(|k| !triangle.contains(k))
        .all(|k| (corners[*k] - a).dot(normal) >= 0.0)
}
