//! SCENE: the argument that all questions about a scene share.

use crate::scene::files::{NonPlanarFaces, open};
use crate::scene::{Scene, SceneError};

#[derive(Debug, clap::Args)]
pub(super) struct SceneArgument {
    /// A scene file (Wavefront .obj or View3D .vs3), or a built-in scene: two-squares, three-squares, cube:N or cornell-box.
    scene: String,
    /// Split faces that are not planar into triangles.
    #[arg(long)]
    triangulate: bool,
    /// Leave out that patches and obstructions hide others.
    #[arg(long)]
    unoccluded: bool,
}

impl SceneArgument {
    /// The scene; what its reader has to say goes to standard error.
    pub(super) fn read(&self) -> Result<Scene, SceneError> {
        let faces = if self.triangulate {
            NonPlanarFaces::Triangulate
        } else {
            NonPlanarFaces::Refuse
        };
        let loaded = open(&self.scene, faces)?;
        for note in &loaded.notes {
            eprintln!("infoscene: {note}");
        }
        Ok(loaded.scene)
    }

    /// Was it asked to leave out occlusion?
    pub(super) const fn is_unoccluded(&self) -> bool {
        self.unoccluded
    }
}
