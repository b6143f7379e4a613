//! The surfaces of a View3D file made into a scene.

use super::Reader;
use crate::geometry::check_contained;
use crate::scene::files::Reading;
use crate::scene::files::error::{FileError, FileErrors, excerpt};
use crate::scene::files::faces::{FaceRules, face_of};
use crate::scene::files::fault::Fault;
use crate::scene::files::rows::Rows;
use crate::scene::files::source::Source;
use crate::scene::{Material, MaterialFault, NamedPatch, PatchMaterial, Scene};
use glam::DVec3;
use std::collections::{HashMap, HashSet};
use std::ops::Range;
use std::sync::Arc;

/// A line `S` or `O`.
#[derive(Debug)]
pub(crate) struct Surface {
    pub line: usize,
    pub number: usize,
    pub vertices: Vec<usize>,
    pub obstructs: bool,
    /// 0 for none.
    pub base: usize,
    /// 0 for none.
    pub combined: usize,
    pub material: Result<Material, Fault>,
    pub name: String,
}

/// The patches or obstructions that a surface became, by index.
struct Placed<'a> {
    surface: &'a Surface,
    indices: Range<usize>,
    /// The row, as far as no surface is summed into another.
    row: usize,
    is_split: bool,
}

impl Surface {
    /// A fault of this surface, as the patch with this index.
    fn fault(&self, source: &Source, index: usize, fault: Fault) -> FileError {
        let name = excerpt(&self.name);
        let patch = if self.obstructs {
            format!("O {} ({name})", self.number)
        } else {
            format!("{index} (S {}, {name})", self.number)
        };
        source.patch_fault(self.line, patch, fault)
    }

    /// The material, unknown if its line says nothing that can be; nothing emits light by itself.
    fn patch_material(&self, source: &Source, index: usize) -> PatchMaterial {
        match &self.material {
            Ok(material) => (*material).into(),
            Err(fault) => PatchMaterial {
                reflectance: Err(MaterialFault::new(self.fault(source, index, fault.clone()))),
                ..PatchMaterial::BLACK
            },
        }
    }

    fn corners(&self, vertices: &HashMap<usize, (usize, DVec3)>) -> Result<Vec<DVec3>, Fault> {
        let corners = self.vertices.iter().map(|vertex| {
            let found = vertices.get(vertex).map(|(_, corner)| *corner);
            found.ok_or_else(|| Fault::Undefined {
                what: "vertex",
                given: vertex.to_string(),
            })
        });
        corners.collect()
    }
}

/// The patches and the obstructions of a file.
#[derive(Default)]
struct Parts<'a> {
    patches: Vec<NamedPatch>,
    obstructions: Vec<NamedPatch>,
    placed: HashMap<usize, Placed<'a>>,
    /// The number of rows so far, as far as no surface is summed into another.
    rows: usize,
}

/// The scene of the surfaces that were read, unless there are faults.
pub(crate) fn assemble(
    source: &Source,
    reader: &mut Reader,
    reading: Reading,
    mut faults: FileErrors,
) -> Result<Scene, FileErrors> {
    let half_unit = reader.places.half_unit();
    let rules = reading.rules(half_unit);
    let surfaces = std::mem::take(&mut reader.surfaces);
    let mut parts = Parts::default();
    for surface in &surfaces {
        faults.keep(place(source, reader, rules, surface, &mut parts));
    }
    // what is missing may be at fault
    faults.none_or_refused()?;
    let mut faults = FileErrors::default();
    let Parts {
        patches,
        obstructions,
        placed,
        ..
    } = parts;
    let whole = |fault| FileError::of_file(source.file(), fault);
    let scene = Scene::try_new(patches).map_err(|_| {
        let mend = "a patch with an area is a line \"S n v1 v2 v3 v4 base cmb emit name\"";
        whole(Fault::NoPatch { mend })
    })?;
    let refused = |error| {
        whole(Fault::Scene {
            source: Box::new(error),
        })
    };
    let scene = scene.with_obstructions(obstructions);
    let mut scene = reading.resolved(scene, half_unit).map_err(refused)?;
    for surface in surfaces.iter().filter(|surface| surface.base > 0) {
        let own = &placed[&surface.number];
        let lies = lay(&mut scene, surface, own, placed.get(&surface.base));
        faults.keep(lies.map_err(|fault| surface.fault(source, own.row, fault)));
    }
    let rows = rows(source, &surfaces, &placed, &mut faults);
    faults.none_or_refused()?;
    let scene = rows.of(scene).map_err(Box::new);
    Ok(scene.map_err(|source| whole(Fault::Scene { source }))?)
}

/// Makes patches or obstructions of a surface.
fn place<'a>(
    source: &Source,
    reader: &mut Reader,
    rules: FaceRules,
    surface: &'a Surface,
    parts: &mut Parts<'a>,
) -> Result<(), FileError> {
    let row = parts.rows;
    // also if it is at fault
    parts.rows += usize::from(!surface.obstructs);
    let at = |fault| surface.fault(source, row, fault);
    let corners = surface.corners(&reader.vertices).map_err(at)?;
    if corners.iter().any(|corner| !corner.is_finite()) {
        // the fault of a vertex, which is told already
        return Ok(());
    }
    let face = face_of(corners, rules).map_err(|source| at(Fault::Geometry { source }))?;
    reader.remarks.count_face(&face, surface.line);
    let list = if surface.obstructs {
        &mut parts.obstructions
    } else {
        &mut parts.patches
    };
    let start = list.len();
    let material = surface.patch_material(source, row);
    let whole = face.is_split.then(|| surface.name.clone());
    let wholes: Arc<[String]> = whole.into_iter().collect();
    for (part, shape) in face.patches.into_iter().enumerate() {
        let name = if face.is_split {
            format!("{} (triangle {part})", surface.name)
        } else {
            surface.name.clone()
        };
        let patch = NamedPatch::new(name, shape).with_material(material.clone());
        list.push(patch.with_wholes(Arc::clone(&wholes)));
    }
    if face.is_split && !surface.obstructs {
        parts.rows += list.len() - start - 1;
    }
    let placed = Placed {
        surface,
        indices: start..list.len(),
        row,
        is_split: face.is_split,
    };
    parts.placed.insert(surface.number, placed);
    Ok(())
}

/// Makes a surface lie in its base.
fn lay(
    scene: &mut Scene,
    surface: &Surface,
    own: &Placed,
    base: Option<&Placed>,
) -> Result<(), Fault> {
    let base = base.ok_or_else(|| Fault::Undefined {
        what: "surface",
        given: surface.base.to_string(),
    })?;
    if own.indices.is_empty() {
        // nothing lies there
        return Ok(());
    }
    if base.indices.len() != 1 || own.indices.len() > 1 {
        return Err(Fault::NotSupported {
            what: "a base, or what lies in one, cannot be divided or without area".to_owned(),
            mend: "make both planar and simple",
        });
    }
    if base.surface.obstructs {
        return in_obstruction(scene, own.indices.start, base);
    }
    let lies = scene.lay(own.indices.start, base.indices.start);
    lies.map_err(|source| Fault::Scene {
        source: Box::new(source),
    })
}

/// Checks a part of an obstruction, which is a patch like any other: the obstruction does not
/// count.
fn in_obstruction(scene: &Scene, part: usize, base: &Placed) -> Result<(), Fault> {
    let index = base.indices.start;
    let (inner, outer) = (&scene.patches[part], &scene.obstructions[index]);
    match check_contained(&inner.shape, &outer.shape, scene.part_noise()) {
        Ok(()) => Ok(()),
        Err(_) => Err(Fault::NotSupported {
            what: format!(
                "it is not inside the obstruction that is its base, surface {}, facing the same \
                 way",
                base.surface.number
            ),
            mend: "move it there, or write 0 as its base",
        }),
    }
}

/// The rows of all surfaces: surfaces that are summed have one, and so has one that is not, unless
/// it is split into triangles. One without area has a row if all that are summed have none.
fn rows(
    source: &Source,
    surfaces: &[Surface],
    placed: &HashMap<usize, Placed>,
    faults: &mut FileErrors,
) -> Rows {
    let mut rows = Rows::default();
    let lead_of = |surface: &Surface| match surface.combined {
        0 => surface.number,
        into => into,
    };
    let patches = || surfaces.iter().filter(|surface| !surface.obstructs);
    let leads: HashSet<usize> = surfaces.iter().map(|surface| surface.combined).collect();
    let with_area = patches().filter(|surface| !placed[&surface.number].indices.is_empty());
    let mut known: HashSet<usize> = with_area.map(lead_of).collect();
    for surface in patches() {
        let own = &placed[&surface.number];
        let lead = placed.get(&surface.combined);
        if let Some(what) = lead.and_then(|lead| not_a_lead(lead.surface)) {
            let mend = "name the surface that leads the row";
            let fault = Fault::NotSupported { what, mend };
            faults.push(surface.fault(source, own.row, fault));
        }
        let lead = lead_of(surface);
        let is_split = own.is_split && !leads.contains(&lead);
        rows.push(lead, own.indices.len(), is_split);
        if known.insert(lead) {
            let material = surface.patch_material(source, own.row);
            rows.push_empty(surface.name.clone(), material);
        }
    }
    rows
}

/// Why no row can be summed into this surface.
fn not_a_lead(surface: &Surface) -> Option<String> {
    let number = surface.number;
    if surface.obstructs {
        Some(format!("surface {number} only obstructs and has no row"))
    } else if ![0, number].contains(&surface.combined) {
        let into = surface.combined;
        Some(format!(
            "surface {number} is itself summed into surface {into}"
        ))
    } else {
        None
    }
}
