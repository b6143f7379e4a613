//! Scenes, as Python hands them over.

use super::refusal::Refusal;
use crate::question::SceneSource;
use crate::scene::files::{MeshArrays, NonPlanarFaces, Reading};
use crate::scene::{Occlusion, Scene};
use numpy::{PyReadonlyArray1, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// A mesh of polygons: arrays of any length, aligned and contiguous.
#[derive(FromPyObject)]
pub(super) struct GivenMesh<'py> {
    vertices: PyReadonlyArray2<'py, f64>,
    corners: PyReadonlyArray1<'py, i64>,
    offsets: PyReadonlyArray1<'py, i64>,
    is_single: bool,
}

/// A scene, with the choices of its reader.
#[derive(FromPyObject)]
pub(super) struct GivenScene<'py> {
    name: Option<String>,
    mesh: Option<GivenMesh<'py>>,
    obstacles: Vec<GivenMesh<'py>>,
    triangulate: bool,
    resolution: Option<f64>,
    join: bool,
    reverse: bool,
    subdivide: u32,
    occlusion: String,
}

/// A scene that is independent of Python.
pub(super) struct Recipe {
    source: SceneSource,
    mesh: Option<MeshArrays>,
    obstacles: Vec<MeshArrays>,
}

/// A scene that was opened.
pub(super) struct Opened {
    pub(super) scene: Scene,
    occlusion: Occlusion,
    /// Remarks of the reader.
    notes: Vec<String>,
}

impl GivenMesh<'_> {
    fn arrays(&self) -> PyResult<MeshArrays> {
        let (vertices, _) = self.vertices.as_slice()?.as_chunks::<3>();
        Ok(MeshArrays {
            vertices: vertices.to_vec(),
            corners: self.corners.as_slice()?.to_vec(),
            offsets: self.offsets.as_slice()?.to_vec(),
            is_single: self.is_single,
        })
    }
}

impl GivenScene<'_> {
    /// The scene without its ties to Python.
    pub(super) fn recipe(&self) -> PyResult<Recipe> {
        let obstacles = self.obstacles.iter().map(GivenMesh::arrays);
        let source = SceneSource {
            faces: if self.triangulate {
                NonPlanarFaces::Triangulate
            } else {
                NonPlanarFaces::Refuse
            },
            resolution: self.resolution,
            join: self.join,
            reverse: self.reverse,
            subdivide: self.subdivide,
            occlusion: occlusion(&self.occlusion)?,
            ..SceneSource::from(self.name.clone().unwrap_or_default())
        };
        Ok(Recipe {
            source,
            mesh: self.mesh.as_ref().map(GivenMesh::arrays).transpose()?,
            obstacles: obstacles.collect::<PyResult<_>>()?,
        })
    }
}

fn occlusion(name: &str) -> PyResult<Occlusion> {
    match name {
        "exact" => Ok(Occlusion::Exact),
        "refuse" => Ok(Occlusion::Refuse),
        "ignore" => Ok(Occlusion::Ignore),
        _ => Err(PyValueError::new_err(format!(
            "occlusion is {name:?}: it must be \"exact\", \"refuse\" or \"ignore\""
        ))),
    }
}

impl Recipe {
    /// Opens the scene as its source says.
    pub(super) fn open(mut self) -> Result<Opened, Refusal> {
        let reading = Reading {
            faces: self.source.faces,
            resolution: self.source.resolution,
        };
        let mut notes = Vec::new();
        let occlusion = self.source.occlusion;
        if let Some(mesh) = &self.mesh {
            let loaded = mesh.scene(&self.obstacles, reading)?;
            notes.extend(loaded.notes);
            self.source = SceneSource {
                origin: SceneSource::from(loaded.scene).origin,
                ..self.source
            };
        }
        let loaded = self.source.open()?;
        notes.extend(loaded.notes);
        let mut scene = loaded.scene;
        if self.mesh.is_none() && !self.obstacles.is_empty() {
            let more = MeshArrays::obstructions(&self.obstacles, reading)?;
            let all = [scene.obstructions(), &more].concat();
            scene = scene.with_obstructions(all);
        }
        Ok(Opened {
            scene,
            occlusion,
            notes,
        })
    }
}

impl Opened {
    /// The scene as that of a question.
    pub(super) fn source(&self) -> SceneSource {
        SceneSource {
            occlusion: self.occlusion,
            ..SceneSource::from(self.scene.clone())
        }
    }

    /// The number of rows.
    pub(super) fn rows(&self) -> usize {
        self.scene.group_count()
    }

    /// The names of the rows.
    pub(super) fn names(&self) -> Vec<String> {
        let names = self.scene.group_names().into_iter();
        names.map(str::to_owned).collect()
    }

    /// The remarks of the reader and those on an answer, each once.
    pub(super) fn remarks(self, of_answer: Vec<String>) -> Vec<String> {
        let mut notes = self.notes;
        for note in of_answer {
            if !notes.contains(&note) {
                notes.push(note);
            }
        }
        notes
    }
}
