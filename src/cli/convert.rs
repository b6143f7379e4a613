//! `infoscene convert SCENE OUT`.

use super::output::{check_place, write_file};
use super::scene::SceneArgument;
use super::{Answer, Outcome};
use infoscene::scene::files::{write_obj, write_view3d};
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub(super) struct Convert {
    #[command(flatten)]
    scene: SceneArgument,
    /// The file to write: a View3D .vs3, or a Wavefront .obj with its .mtl beside it.
    #[arg(value_name = "OUT")]
    out: PathBuf,
}

impl Convert {
    pub(super) fn answer(&self) -> Answer {
        let extension = self.out.extension().unwrap_or_default();
        let is_view3d = extension.eq_ignore_ascii_case("vs3");
        if !is_view3d && !extension.eq_ignore_ascii_case("obj") {
            let out = self.out.display();
            let message = format!(
                "{out}: a scene is written as .obj or .vs3, so let its name end in one of them"
            );
            return Err(message.into());
        }
        let scene = self.scene.read()?;
        scene.check_overlap()?;
        if is_view3d {
            write_file(&self.out, write_view3d(&scene)?.as_bytes())?;
            return Ok(Outcome::Done);
        }
        let materials = self.out.with_extension("mtl");
        let name = materials.file_name().and_then(|name| name.to_str());
        let name = name.ok_or("the name of the file to write is not UTF-8: choose another one")?;
        let written = write_obj(&scene, name)?;
        // neither of the two if one cannot be
        check_place(&self.out)?;
        write_file(&materials, written.mtl.as_bytes())?;
        write_file(&self.out, written.obj.as_bytes())?;
        Ok(Outcome::Done)
    }
}
