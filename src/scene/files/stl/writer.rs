//! A scene as binary STL.

use crate::geometry::Patch;
use crate::scene::files::error::NotExpressible;
use crate::scene::files::plain::{PlainRow, plain_rows};
use crate::scene::{PatchMaterial, Scene};
use glam::DVec3;

const FORMAT: &str = "STL";

/// A binary STL file, and what is not in it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StlFile {
    /// The file.
    pub bytes: Vec<u8>,
    /// The parts of the scene that are lost, a sentence each.
    pub losses: Vec<String>,
}

/// Writes a scene of triangles.
///
/// Coordinates are rounded to 32 bits; names and materials are lost. A row without area is a facet
/// that is one point.
///
/// # Errors
/// [`NotExpressible`] if a patch is not a triangle ([`Scene::triangulated`] makes triangles), or is
/// none after rounding; if polygons only obstruct, a patch lies in another one, or patches are
/// summed.
pub fn write_stl(scene: &Scene) -> Result<StlFile, NotExpressible> {
    let rows = plain_rows(scene, FORMAT)?;
    let count = u32::try_from(rows.len()).map_err(|_| NotExpressible {
        format: FORMAT,
        what: format!("there are {} patches", rows.len()),
        mend: "write Wavefront .obj",
    })?;
    // no reader may take this for the word with which a text begins
    let mut bytes = format!("{:<80}", "binary STL by infoscene").into_bytes();
    bytes.extend(count.to_le_bytes());
    let mut largest = 0.0_f64;
    for row in &rows {
        let rounded: Vec<DVec3> = row.corners.iter().copied().map(rounded).collect();
        let moved = row.corners.iter().zip(&rounded);
        let moved = moved.map(|(corner, rounded)| (*corner - *rounded).abs().max_element());
        largest = moved.fold(largest, f64::max);
        bytes.extend(single(normal(row, &rounded)?));
        bytes.extend(rounded.into_iter().flat_map(single));
        bytes.extend([0; 2]);
    }
    let mut losses = vec!["STL has no names of patches: they are lost".to_owned()];
    if rows.iter().any(|row| *row.material != PatchMaterial::BLACK) {
        losses.push("STL has no materials: all patches become black".to_owned());
    }
    if largest > 0.0 {
        losses.push(format!(
            "STL has coordinates of 32 bits: they are rounded, by up to {largest:.1e}"
        ));
    }
    Ok(StlFile { bytes, losses })
}

/// The normal of a triangle whose corners were rounded; zero for one without area.
fn normal(row: &PlainRow<'_>, rounded: &[DVec3]) -> Result<DVec3, NotExpressible> {
    let Some(index) = row.patch else {
        return Ok(DVec3::ZERO);
    };
    let not = |what: &str, mend: &'static str| NotExpressible {
        format: FORMAT,
        what: format!("patch {index} ({}) {what}", row.name),
        mend,
    };
    if rounded.len() > 3 {
        let what = format!("has {} corners", rounded.len());
        return Err(not(&what, NotExpressible::SPLIT));
    }
    let patch = Patch::try_new(rounded.to_vec()).map_err(|_| {
        let what = "has an area after its corners are rounded to 32 bits";
        not(
            what,
            "move the scene to the origin, or write Wavefront .obj",
        )
    })?;
    Ok(patch.normal())
}

fn rounded(corner: DVec3) -> DVec3 {
    corner.as_vec3().as_dvec3()
}

/// Three numbers of 32 bits.
fn single(vector: DVec3) -> impl Iterator<Item = u8> {
    let [x, y, z] = vector.as_vec3().to_array().map(f32::to_le_bytes);
    x.into_iter().chain(y).chain(z)
}
