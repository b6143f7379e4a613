//! A scene in another format.

use super::QuestionError;
use super::scene::SceneSource;
use crate::scene::files::{
    LoadedScene, NonPlanarFaces, left_out_of_obj, left_out_of_view3d, write_obj, write_stl,
    write_view3d,
};
use crate::scene::{Scene, SceneError};

/// The question for the content of a scene file.
///
/// # Examples
/// ```
/// use infoscene::question::{Convert, SceneFormat};
/// let cube = Convert { scene: "cube:1".into(), format: SceneFormat::View3d };
/// let written = cube.ask()?;
/// // one surface for each of six faces
/// let lines = written.content.split(|byte| *byte == b'\n');
/// assert_eq!(lines.filter(|line| line.starts_with(b"S ")).count(), 6);
/// # Ok::<(), infoscene::question::QuestionError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Convert {
    /// The scene, which may be occluded. If faces are [triangulated](NonPlanarFaces::Triangulate),
    /// so are patches of more corners than the format can hold.
    pub scene: SceneSource,
    /// The format to write.
    pub format: SceneFormat,
}

/// A format of scene files.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SceneFormat {
    /// View3D, `.vs3`.
    View3d,
    /// Wavefront, `.obj`, with its materials in a file of their own.
    Obj {
        /// The name of the file of materials, which the scene file refers to.
        materials: String,
    },
    /// Binary STL, `.stl`.
    Stl,
}

impl SceneFormat {
    /// The most corners that a face of this format has.
    const fn most_corners(&self) -> usize {
        match self {
            Self::View3d => 4,
            Self::Obj { .. } => usize::MAX,
            Self::Stl => 3,
        }
    }
}

/// A scene file.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct ConvertAnswer {
    /// The content of the file.
    pub content: Vec<u8>,
    /// The text of the file of materials, if the format has one.
    pub materials: Option<String>,
    /// Remarks of the scene's reader, and what the format cannot hold.
    pub notes: Vec<String>,
}

impl Convert {
    /// Writes the scene.
    ///
    /// # Errors
    /// [`QuestionError::Scene`] if patches overlap, or cannot be triangulated;
    /// [`QuestionError::NotExpressible`] if the format has no words for the shape of the scene.
    pub fn ask(&self) -> Result<ConvertAnswer, QuestionError> {
        let LoadedScene { scene, mut notes } = self.scene.open()?;
        scene.check_overlap()?;
        let scene = self.split(scene)?;
        let (content, materials) = match &self.format {
            SceneFormat::View3d => {
                notes.extend(left_out_of_view3d(&scene));
                (write_view3d(&scene)?.into_bytes(), None)
            }
            SceneFormat::Obj { materials } => {
                notes.extend(left_out_of_obj(&scene));
                let written = write_obj(&scene, materials)?;
                (written.obj.into_bytes(), Some(written.mtl))
            }
            SceneFormat::Stl => {
                let written = write_stl(&scene)?;
                notes.extend(written.losses);
                (written.bytes, None)
            }
        };
        Ok(ConvertAnswer {
            content,
            materials,
            notes,
        })
    }

    /// The scene with the patches split that the format cannot hold, if that was asked for.
    fn split(&self, scene: Scene) -> Result<Scene, SceneError> {
        let most = self.format.most_corners();
        let fits = |count: usize| count <= most;
        let patches = scene.patches().iter();
        if self.scene.faces != NonPlanarFaces::Triangulate
            || patches
                .clone()
                .all(|patch| fits(patch.shape().corners().len()))
        {
            return Ok(scene);
        }
        let (split, parents) = scene.triangulated(most)?;
        if self.format == SceneFormat::View3d {
            // the triangles of a patch are summed into the row that it was
            let rows: Vec<usize> = parents
                .iter()
                .map(|parent| scene.group_of(*parent))
                .collect();
            return split.with_groups(&rows);
        }
        Ok(split)
    }
}
