//! The surfaces of a View3D file made into a scene.

use crate::geometry::check_contained;
use crate::scene::files::Reading;
use crate::scene::files::error::{Fault, FileError, excerpt};
use crate::scene::files::faces::patches_of_face;
use crate::scene::files::source::Source;
use crate::scene::{Material, NamedPatch, Scene};
use glam::DVec3;
use std::collections::{HashMap, HashSet};

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
    pub material: Material,
    pub name: String,
}

/// The patches or obstructions that a surface became, by index.
struct Placed<'a> {
    surface: &'a Surface,
    indices: std::ops::Range<usize>,
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

    fn corners(&self, vertices: &HashMap<usize, (usize, DVec3)>) -> Result<Vec<DVec3>, Fault> {
        for (place, vertex) in self.vertices.iter().enumerate() {
            if self.vertices[..place].contains(vertex) {
                let vertex = vertex.to_string();
                return Err(Fault::RepeatedCorner { vertex });
            }
        }
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

/// The scene of these surfaces, whose coordinates were written to half a unit in the last place.
pub(crate) fn assemble(
    source: &Source,
    vertices: &HashMap<usize, (usize, DVec3)>,
    surfaces: &[Surface],
    (reading, half_unit): (Reading, f64),
) -> Result<Scene, FileError> {
    let resolution = reading.resolution.unwrap_or(half_unit);
    let (mut patches, mut obstructions) = (Vec::new(), Vec::new());
    let mut placed = HashMap::new();
    for surface in surfaces {
        let list = if surface.obstructs {
            &mut obstructions
        } else {
            &mut patches
        };
        let start = list.len();
        let at = |fault| surface.fault(source, start, fault);
        let corners = surface.corners(vertices).map_err(at)?;
        let shapes = patches_of_face(corners, reading.faces, resolution)
            .map_err(|source| at(Fault::Geometry { source }))?;
        let parts = shapes.len();
        for (part, shape) in shapes.into_iter().enumerate() {
            let name = if parts == 1 {
                surface.name.clone()
            } else {
                format!("{} (triangle {part})", surface.name)
            };
            list.push(NamedPatch::new(name, shape).with_material(surface.material));
        }
        let indices = start..list.len();
        placed.insert(surface.number, Placed { surface, indices });
    }
    let scene = Scene::try_new(patches).map_err(|_| {
        let mend = "a patch is a line \"S n v1 v2 v3 v4 base cmb emit name\"";
        FileError::of_file(source.file(), Fault::NoPatch { mend })
    })?;
    let refused = |error| {
        let error = Box::new(error);
        FileError::of_file(source.file(), Fault::Scene { source: error })
    };
    let scene = scene.with_obstructions(obstructions);
    let mut scene = reading.resolved(scene, half_unit).map_err(refused)?;
    for surface in surfaces.iter().filter(|surface| surface.base > 0) {
        let own = &placed[&surface.number].indices;
        let at = |fault| surface.fault(source, own.start, fault);
        let base = placed.get(&surface.base).ok_or_else(|| {
            let (what, given) = ("surface", surface.base.to_string());
            at(Fault::Undefined { what, given })
        })?;
        if base.indices.len() > 1 || own.len() > 1 {
            return Err(at(Fault::NotSupported {
                what: "a base, or what lies in one, cannot be split into triangles".to_owned(),
                mend: "make both planar",
            }));
        }
        scene = if base.surface.obstructs {
            in_obstruction(scene, own.start, base).map_err(at)?
        } else {
            let with_base = scene.with_base(own.start, base.indices.start);
            with_base.map_err(|source| {
                at(Fault::Scene {
                    source: Box::new(source),
                })
            })?
        };
    }
    let labels = labels(source, surfaces, &placed)?;
    scene
        .with_groups(&labels)
        .map_err(Box::new)
        .map_err(|error| FileError::of_file(source.file(), Fault::Scene { source: error }))
}

/// Checks a part of an obstruction, which is a patch like any other: the obstruction does not
/// count.
fn in_obstruction(scene: Scene, part: usize, base: &Placed) -> Result<Scene, Fault> {
    let index = base.indices.start;
    let (inner, outer) = (&scene.patches[part], &scene.obstructions[index]);
    match check_contained(&inner.shape, &outer.shape, scene.part_noise()) {
        Ok(()) => Ok(scene),
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

/// The labels of all patches: the surface that each is summed into, and the triangle of it that
/// stays apart, as triangles of one surface do unless it is combined.
fn labels(
    source: &Source,
    surfaces: &[Surface],
    placed: &HashMap<usize, Placed>,
) -> Result<Vec<(usize, usize)>, FileError> {
    let mut labels = Vec::new();
    let leads: HashSet<usize> = surfaces.iter().map(|surface| surface.combined).collect();
    for surface in surfaces.iter().filter(|surface| !surface.obstructs) {
        let indices = placed[&surface.number].indices.clone();
        let into = surface.combined;
        if let Some(what) = placed.get(&into).and_then(|lead| not_a_lead(lead.surface)) {
            let mend = "name the surface that leads the row";
            let fault = Fault::NotSupported { what, mend };
            return Err(surface.fault(source, indices.start, fault));
        }
        let lead = if into > 0 { into } else { surface.number };
        let is_summed = leads.contains(&lead);
        labels.extend((0..indices.len()).map(|part| (lead, if is_summed { 0 } else { part })));
    }
    Ok(labels)
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
