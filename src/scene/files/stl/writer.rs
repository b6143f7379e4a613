//! A scene as binary STL.

use crate::geometry::Patch;
use crate::scene::files::error::NotExpressible;
use crate::scene::files::plain::check_plain;
use crate::scene::{Material, NamedPatch, Scene};
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
/// Coordinates are rounded to 32 bits; names and materials are lost.
///
/// # Errors
/// [`NotExpressible`] if a patch is not a triangle ([`Scene::triangulated`] makes triangles), or is
/// none after rounding; if polygons only obstruct, a patch lies in another one, or patches are
/// summed.
pub fn write_stl(scene: &Scene) -> Result<StlFile, NotExpressible> {
    check_plain(scene, FORMAT)?;
    let count = u32::try_from(scene.patches().len()).map_err(|_| NotExpressible {
        format: FORMAT,
        what: format!("there are {} patches", scene.patches().len()),
        mend: "write Wavefront .obj",
    })?;
    // no reader may take this for the word with which a text begins
    let mut bytes = format!("{:<80}", "binary STL by infoscene").into_bytes();
    bytes.extend(count.to_le_bytes());
    let mut largest = 0.0_f64;
    for (index, patch) in scene.patches().iter().enumerate() {
        let rounded = rounded(index, patch)?;
        let corners = patch.shape().corners().iter().zip(rounded.corners());
        let moved = corners.map(|(corner, rounded)| (*corner - *rounded).abs().max_element());
        largest = moved.fold(largest, f64::max);
        bytes.extend(single(rounded.normal()));
        bytes.extend(rounded.corners().iter().copied().flat_map(single));
        bytes.extend([0; 2]);
    }
    let mut losses = vec!["STL has no names of patches: they are lost".to_owned()];
    let is_black = |patch: &NamedPatch| patch.material() == Material::BLACK;
    if !scene.patches().iter().all(is_black) {
        losses.push("STL has no materials: all patches become black".to_owned());
    }
    if largest > 0.0 {
        losses.push(format!(
            "STL has coordinates of 32 bits: they are rounded, by up to {largest:.1e}"
        ));
    }
    Ok(StlFile { bytes, losses })
}

/// A triangle, its corners rounded to 32 bits.
fn rounded(index: usize, patch: &NamedPatch) -> Result<Patch, NotExpressible> {
    let not = |what: &str, mend: &'static str| NotExpressible {
        format: FORMAT,
        what: format!("patch {index} ({}) {what}", patch.name()),
        mend,
    };
    let corners = patch.shape().corners();
    if corners.len() > 3 {
        let what = format!("has {} corners", corners.len());
        return Err(not(&what, NotExpressible::SPLIT));
    }
    let corners = corners.iter().map(|corner| corner.as_vec3().as_dvec3());
    Patch::try_new(corners.collect()).map_err(|_| {
        let what = "has an area after its corners are rounded to 32 bits";
        not(
            what,
            "move the scene to the origin, or write Wavefront .obj",
        )
    })
}

/// Three numbers of 32 bits.
fn single(vector: DVec3) -> impl Iterator<Item = u8> {
    let [x, y, z] = vector.as_vec3().to_array().map(f32::to_le_bytes);
    x.into_iter().chain(y).chain(z)
}
