//! A scene in another format.

use super::QuestionError;
use super::scene::SceneSource;
use crate::scene::files::{
    LoadedScene, left_out_of_obj, left_out_of_view3d, write_obj, write_view3d,
};

/// The question for the text of a scene file.
///
/// # Examples
/// ```
/// use infoscene::question::{Convert, SceneFormat};
/// let cube = Convert { scene: "cube:1".into(), format: SceneFormat::View3d };
/// let written = cube.ask()?;
/// // one surface for each of six faces
/// assert_eq!(written.text.lines().filter(|line| line.starts_with("S ")).count(), 6);
/// # Ok::<(), infoscene::question::QuestionError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Convert {
    /// The scene, which may be occluded.
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
}

/// A scene file.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct ConvertAnswer {
    /// The text of the file.
    pub text: String,
    /// The text of the file of materials, if the format has one.
    pub materials: Option<String>,
    /// Remarks of the scene's reader.
    pub notes: Vec<String>,
}

impl Convert {
    /// Writes the scene.
    ///
    /// # Errors
    /// [`QuestionError::Scene`] if patches overlap; [`QuestionError::NotExpressible`] if the format
    /// has no words for the scene.
    pub fn ask(&self) -> Result<ConvertAnswer, QuestionError> {
        let LoadedScene { scene, mut notes } = self.scene.open()?;
        scene.check_overlap()?;
        let (text, materials) = match &self.format {
            SceneFormat::View3d => {
                notes.extend(left_out_of_view3d(&scene));
                (write_view3d(&scene)?, None)
            }
            SceneFormat::Obj { materials } => {
                notes.extend(left_out_of_obj(&scene));
                let written = write_obj(&scene, materials)?;
                (written.obj, Some(written.mtl))
            }
        };
        Ok(ConvertAnswer {
            text,
            materials,
            notes,
        })
    }
}
