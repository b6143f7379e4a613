//! SCENE: the argument that all questions about a scene share.

use infoscene::scene::files::{NonPlanarFaces, OpenError, open};
use infoscene::scene::{Occlusion, Scene};

#[derive(Debug, clap::Args)]
pub(super) struct SceneArgument {
    /// A scene file (Wavefront .obj or View3D .vs3), or a built-in scene: two-squares, three-squares, cube:N, box:X,Y,Z, tetrahedron,
    /// octahedron, dodecahedron, icosahedron or cornell-box.
    scene: String,
    /// Split faces that are not planar into triangles.
    #[arg(long)]
    triangulate: bool,
    /// Quarter every patch so many times: triangles and quadrilaterals into four alike.
    #[arg(long, value_name = "TIMES", default_value_t = 0, value_parser = clap::value_parser!(u32).range(0..=8))]
    subdivide: u32,
    /// Leave out that patches and obstructions hide others.
    #[arg(long)]
    unoccluded: bool,
}

impl SceneArgument {
    /// The scene, whatever lies or stands in it; what its reader has to say goes to standard error.
    pub(super) fn read(&self) -> Result<Scene, OpenError> {
        let faces = if self.triangulate {
            NonPlanarFaces::Triangulate
        } else {
            NonPlanarFaces::Refuse
        };
        let loaded = open(&self.scene, faces)?;
        for note in &loaded.notes {
            eprintln!("infoscene: {note}");
        }
        if self.subdivide == 0 {
            return Ok(loaded.scene);
        }
        Ok(loaded.scene.subdivided(self.subdivide)?.0)
    }

    /// What is asked for where something may stand between two patches.
    pub(super) const fn occlusion(&self) -> Occlusion {
        if self.unoccluded {
            Occlusion::Ignore
        } else {
            Occlusion::Refuse
        }
    }
}
