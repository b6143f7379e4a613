//! Scene files: Wavefront OBJ with MTL, View3D `.vs3`, and STL; read and written.
//!
//! ```text
//!   .obj   v x y z | f v…                 one face, one patch    o g: names
//!          mtllib usemtl: Kd reflectance, Ke emittance, of three channels
//!   .vs3   V n x y z | S n v1 v2 v3 v4 base cmb emit name        O: obstructs only
//!          reflectance = 1 − emit
//!   .stl   binary or text: one facet, one patch; no materials
//! ```
//!
//! A reader tells all faults of a file, where each is and what would mend it ([`FileErrors`]). What
//! is clear it mends, what has no effect it ignores, and says so once for each kind
//! ([`LoadedScene::notes`]). Faults of materials are notes, too, and leave the material of the
//! patches concerned [unknown](super::PatchMaterial). Numbers are written so that they read back to
//! the same `f64`. Coordinates may be rounded: a reader takes note of their last place, and the
//! scene takes it as its [resolution](Scene::resolution) where surfaces miss each other on that
//! scale.
//!
//! Open `obj`, `view3d` or `stl` for a format (each with its `writer`), `source` for lines and
//! their numbers, `faces` for the way from an outline to patches, `rows` for their rows, `remarks`
//! for what is mended or ignored, `unknown_materials` for notes on these, `last_place` for the
//! decimals of coordinates, `decimal` for emissivities, `plain` for what OBJ and STL cannot say,
//! `mesh` for faces that come in arrays, and `error` for the refusals.
//!
//! All readers are our own: the libraries for OBJ and STL keep coordinates in 32 bits or cut
//! polygons into triangles, and none says in which line a number is wrong, or which patch is not
//! planar; for `.vs3` there is none.

pub(crate) mod decimal;
pub(crate) mod error;
pub(crate) mod faces;
mod fault;
pub(crate) mod last_place;
pub(crate) mod mesh;
pub(crate) mod obj;
pub(crate) mod plain;
pub(crate) mod remarks;
pub(crate) mod rows;
pub(crate) mod source;
pub(crate) mod stl;
pub(crate) mod unknown_materials;
pub(crate) mod view3d;

pub use error::{FileError, FileErrors, NotExpressible, OpenError};
pub use fault::Fault;
pub use mesh::MeshArrays;
use obj::library;
pub use obj::read_obj;
pub(crate) use obj::writer::left_out_of_obj;
pub use obj::writer::{ObjText, write_obj};
pub use source::Source;
pub use stl::read_stl;
pub use stl::writer::{StlFile, write_stl};
pub use view3d::read_view3d;
pub(crate) use view3d::writer::left_out_of_view3d;
pub use view3d::writer::write_view3d;

use super::{Scene, SceneError};
use std::path::Path;

/// The treatment of a face that is not planar.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum NonPlanarFaces {
    /// The file is refused, with the deviation.
    #[default]
    Refuse,
    /// The face is split into triangles, each a patch. Triangles that fold towards the front are
    /// preferred, so that the space in front of a bulging wall stays convex (of a quadrilateral:
    /// the diagonal farther from the front). Faces that are planar stay whole.
    Triangulate,
}

/// The choices of a reader. A [`NonPlanarFaces`] alone is one, too.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Reading {
    /// The treatment of faces that are not planar.
    pub faces: NonPlanarFaces,
    /// The length by which each coordinate may be off, 0 for none; if it is not given, the decimals
    /// of the file say it, where surfaces miss each other on that scale
    /// ([`Scene::resolution`]).
    pub resolution: Option<f64>,
}

impl From<NonPlanarFaces> for Reading {
    fn from(faces: NonPlanarFaces) -> Self {
        Self {
            faces,
            resolution: None,
        }
    }
}

impl Reading {
    /// The treatment of faces whose coordinates were written to half a unit in the last place.
    fn rules(self, half_unit: f64) -> faces::FaceRules {
        faces::FaceRules {
            non_planar: self.faces,
            resolution: self.resolution.unwrap_or(half_unit),
        }
    }

    /// The scene of a file whose coordinates were written to half a unit in the last place.
    fn resolved(self, scene: Scene, half_unit: f64) -> Result<Scene, SceneError> {
        match self.resolution {
            Some(resolution) => scene.with_resolution(resolution),
            None => Ok(scene.with_last_place(half_unit)),
        }
    }
}

/// The remark of a reader on the resolution of a scene, unless its coordinates are exact.
fn remark(source: &Source, scene: &Scene) -> Option<String> {
    let surfaces = scene.resolved_surfaces()?;
    Some(format!("{}: {surfaces}", source.file().display()))
}

/// A scene, and what its reader has to say about it.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadedScene {
    /// The scene.
    pub scene: Scene,
    /// Mends, and statements that were read and have no effect: a sentence for each kind.
    pub notes: Vec<String>,
}

/// The scene that a name stands for: a built-in one ([`Scene::built_in`]) or a file ([`read`]).
///
/// # Errors
/// [`SceneError::UnknownName`] if it is neither; [`OpenError::File`] if the file is at fault.
pub fn open(name: &str, reading: impl Into<Reading>) -> Result<LoadedScene, OpenError> {
    let reading = reading.into();
    match Scene::built_in(name) {
        Ok(scene) => Ok(LoadedScene {
            scene: reading.resolved(scene, 0.0)?,
            notes: Vec::new(),
        }),
        Err(SceneError::UnknownName { .. }) if is_path(name) => Ok(read(Path::new(name), reading)?),
        Err(error) => Err(error.into()),
    }
}

/// Whether a name looks like a path rather than a misspelt built-in scene.
fn is_path(name: &str) -> bool {
    let path = Path::new(name);
    path.extension().is_some() && !name.starts_with("cube:")
        || path.components().count() > 1
        || (!name.is_empty() && path.exists())
}

/// Reads a scene file; what follows the last dot of its name says of which format it is.
///
/// # Errors
/// All faults of the file.
pub fn read(path: &Path, reading: impl Into<Reading>) -> Result<LoadedScene, FileErrors> {
    let reading = reading.into();
    let extension = path
        .extension()
        .map(|extension| extension.to_string_lossy());
    let is = |format: &str| {
        extension
            .as_ref()
            .is_some_and(|extension| extension.eq_ignore_ascii_case(format))
    };
    if is("obj") {
        let beside = |name: &str| library::read_beside(path, name);
        read_obj(&Source::read(path)?, &beside, reading)
    } else if is("vs3") {
        read_view3d(&Source::read(path)?, reading)
    } else if is("stl") {
        read_stl(path, Source::bytes(path)?, reading)
    } else {
        Source::check(path)?;
        Err(FileError::of_file(path, Fault::UnknownFormat).into())
    }
}

/// The Cornell box, empty or with its two blocks, from the files that come with the source.
pub(crate) fn cornell_box(with_blocks: bool) -> Result<Scene, SceneError> {
    let (name, text) = if with_blocks {
        (
            "cornell-box-blocks",
            include_str!("../../../data/scenes/cornell-box-blocks.obj"),
        )
    } else {
        (
            "cornell-box",
            include_str!("../../../data/scenes/cornell-box.obj"),
        )
    };
    let materials = |_: &str| {
        Ok(Source::new(
            "cornell-box.mtl",
            include_str!("../../../data/scenes/cornell-box.mtl"),
        ))
    };
    let exact = Reading {
        resolution: Some(0.0),
        ..Reading::default()
    };
    match read_obj(&Source::new(name, text), &materials, exact) {
        Ok(loaded) => Ok(loaded.scene),
        Err(error) => Err(SceneError::BuiltIn {
            name,
            reason: error.to_string(),
        }),
    }
}
