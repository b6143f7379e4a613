//! A scene as Wavefront OBJ and MTL.

use crate::scene::files::error::{NotExpressible, excerpt};
use crate::scene::files::plain::plain_rows;
use crate::scene::{Channels, PatchMaterial, Scene};
use glam::DVec3;
use std::collections::HashMap;
use std::fmt::Write;

const FORMAT: &str = "Wavefront OBJ";

/// The two texts of a scene.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ObjText {
    /// The faces.
    pub obj: String,
    /// The materials that they name.
    pub mtl: String,
}

/// The material that stands for all that are not known: no library defines it.
const UNKNOWN: &str = "unknown";

/// Writes a scene whose materials go to a file of the name `library`.
///
/// Shapes and materials read back exactly; a row without area is a face that is one point. Names do
/// if they are a text and the number of the patch among those of that text, as the reader makes
/// them; else the reader puts such a number after them. `\` in a name becomes `_`. Materials that
/// are not known are named and not defined.
///
/// # Errors
/// [`NotExpressible`] if polygons only obstruct, a patch lies in another one, or patches are
/// summed; or if `library` is no name that such a file can hold.
pub fn write_obj(scene: &Scene, library: &str) -> Result<ObjText, NotExpressible> {
    if library.is_empty() || library.trim() != library || library.contains(['#', '\\', '\n']) {
        return Err(NotExpressible {
            format: FORMAT,
            what: format!("its materials are in \"{}\"", excerpt(library)),
            mend: "choose a name without # and \\, and without spaces around it",
        });
    }
    let rows = plain_rows(scene, FORMAT)?;
    let (mut obj, mut mtl) = (format!("mtllib {library}\n"), String::new());
    let mut vertices = VertexNumbers::default();
    let mut materials: Vec<PatchMaterial> = Vec::new();
    let mut named: HashMap<String, usize> = HashMap::new();
    let mut current = (String::new(), String::new());
    for row in rows {
        let group = group_of(row.name, &mut named);
        let material = if is_known(row.material) {
            let place = materials.iter().position(|known| known == row.material);
            let place = place.unwrap_or_else(|| {
                materials.push(row.material.clone());
                materials.len() - 1
            });
            format!("m{place}")
        } else {
            UNKNOWN.to_owned()
        };
        let corners: Vec<usize> = row
            .corners
            .iter()
            .map(|corner| {
                vertices.number_or(*corner, |_| {
                    let DVec3 { x, y, z } = *corner;
                    let _ = writeln!(obj, "v {x:?} {y:?} {z:?}");
                })
            })
            .collect();
        if current.0 != group {
            let _ = writeln!(obj, "g {group}");
        }
        if current.1 != material {
            let _ = writeln!(obj, "usemtl {material}");
        }
        current = (group, material);
        obj.push('f');
        for corner in corners {
            let _ = write!(obj, " {corner}");
        }
        obj.push('\n');
    }
    for (index, material) in materials.iter().enumerate() {
        let _ = writeln!(mtl, "newmtl m{index}");
        for (keyword, property) in [("Kd", material.reflectance()), ("Ke", material.emittance())] {
            if let Ok(Channels { r, g, b }) = property {
                let _ = writeln!(mtl, "{keyword} {r:?} {g:?} {b:?}");
            }
        }
    }
    Ok(ObjText { obj, mtl })
}

/// Notes on what [`write_obj`] leaves out of a scene.
pub(crate) fn left_out_of_obj(scene: &Scene) -> Vec<String> {
    let patches = scene.patches().iter();
    let unknown = patches.filter(|patch| !is_known(patch.material())).count();
    let note = format!(
        "{unknown} patches whose material is not known have \"usemtl {UNKNOWN}\", which is not \
         defined"
    );
    (unknown > 0).then_some(note).into_iter().collect()
}

fn is_known(material: &PatchMaterial) -> bool {
    material.faults().next().is_none()
}

/// The name without the number that the reader will put after it.
fn group_of(name: &str, named: &mut HashMap<String, usize>) -> String {
    let name = name.replace('\\', "_");
    let words: Vec<&str> = name.split_whitespace().collect();
    let without_number = words.split_last().and_then(|(last, group)| {
        let group = group.join(" ");
        let next = named.get(&group).copied().unwrap_or(0);
        (!group.is_empty() && *last == next.to_string()).then_some(group)
    });
    let group = without_number.unwrap_or_else(|| words.join(" "));
    *named.entry(group.clone()).or_insert(0) += 1;
    group
}

/// Vertices numbered from 1 in the order in which they are first met, equal ones once.
#[derive(Debug, Default)]
pub(crate) struct VertexNumbers {
    numbers: HashMap<[u64; 3], usize>,
}

impl VertexNumbers {
    /// The number of a vertex; a new one is written first.
    pub(crate) fn number_or(&mut self, vertex: DVec3, write: impl FnOnce(usize)) -> usize {
        let next = self.numbers.len() + 1;
        *self
            .numbers
            .entry(vertex.to_array().map(f64::to_bits))
            .or_insert_with(|| {
                write(next);
                next
            })
    }
}
