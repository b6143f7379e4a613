//! A scene as Wavefront OBJ and MTL.

use crate::scene::files::error::{NotExpressible, excerpt};
use crate::scene::{Material, NamedPatch, Scene};
use glam::DVec3;
use std::collections::HashMap;
use std::fmt::Write;

/// The two texts of a scene.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ObjText {
    /// The faces.
    pub obj: String,
    /// The materials that they name.
    pub mtl: String,
}

/// Writes a scene whose materials go to a file of the name `library`.
///
/// Shapes and materials read back exactly. Names do if they are a text and the number of the patch
/// among those of that text, as the reader makes them; else the reader puts such a number after
/// them. `#` and `\` in a name become `_`.
///
/// # Errors
/// [`NotExpressible`] if polygons only obstruct, a patch lies in another one, or patches are
/// summed; or if `library` is no name that such a file can hold.
pub fn write_obj(scene: &Scene, library: &str) -> Result<ObjText, NotExpressible> {
    let not = |what: &str| NotExpressible {
        format: "Wavefront OBJ",
        what: what.to_owned(),
        mend: "write View3D .vs3",
    };
    let count = scene.patches().len();
    if library.is_empty() || library.trim() != library || library.contains(['#', '\\', '\n']) {
        return Err(NotExpressible {
            format: "Wavefront OBJ",
            what: format!("its materials are in \"{}\"", excerpt(library)),
            mend: "choose a name without # and \\, and without spaces around it",
        });
    }
    if !scene.obstructions().is_empty() {
        return Err(not("a polygon only obstructs"));
    }
    if let Some(part) = (0..count).find(|index| scene.base_of(*index).is_some()) {
        return Err(not(&format!("patch {part} lies in another one")));
    }
    if scene.group_count() < count {
        return Err(not("patches are summed into one row"));
    }
    let (mut obj, mut mtl) = (format!("mtllib {library}\n"), String::new());
    let mut vertices = VertexNumbers::default();
    let mut materials: Vec<Material> = Vec::new();
    let mut named: HashMap<String, usize> = HashMap::new();
    let mut current = (String::new(), None);
    for patch in scene.patches() {
        let group = group_of(patch, &mut named);
        let material = materials
            .iter()
            .position(|known| *known == patch.material());
        let material = material.unwrap_or_else(|| {
            materials.push(patch.material());
            materials.len() - 1
        });
        let corners: Vec<usize> = patch
            .shape()
            .given_corners()
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
        if current.1 != Some(material) {
            let _ = writeln!(obj, "usemtl m{material}");
        }
        current = (group, Some(material));
        obj.push('f');
        for corner in corners {
            let _ = write!(obj, " {corner}");
        }
        obj.push('\n');
    }
    for (index, material) in materials.iter().enumerate() {
        let (kd, ke) = (material.reflectance(), material.emittance());
        let _ = write!(
            mtl,
            "newmtl m{index}\nKd {kd:?} {kd:?} {kd:?}\nKe {ke:?} {ke:?} {ke:?}\n"
        );
    }
    Ok(ObjText { obj, mtl })
}

/// The name without the number that the reader will put after it.
fn group_of(patch: &NamedPatch, named: &mut HashMap<String, usize>) -> String {
    let name = patch.name().replace(['#', '\\'], "_");
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
