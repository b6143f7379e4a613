//! `infoscene convert SCENE OUT`.

use super::output::{check_place, say, write_file};
use super::scene::SceneArgument;
use super::{Answer, Outcome};
use infoscene::question::{self, SceneFormat};
use std::error::Error;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub(super) struct Convert {
    #[command(flatten)]
    scene: SceneArgument,
    /// The file to write: a View3D .vs3, a Wavefront .obj with its .mtl beside it, or an .stl,
    /// which holds triangles only (with --triangulate all are).
    #[arg(value_name = "OUT")]
    out: PathBuf,
}

impl Convert {
    pub(super) fn answer(&self) -> Answer {
        let question = question::Convert {
            scene: self.scene.source(),
            format: self.format()?,
        };
        let written = question.ask()?;
        say(&written.notes);
        // neither of the two if one cannot be
        check_place(&self.out)?;
        if let Some(materials) = &written.materials {
            write_file(&self.materials(), materials.as_bytes())?;
        }
        write_file(&self.out, &written.content)?;
        Ok(Outcome::Done)
    }

    /// The file of materials.
    fn materials(&self) -> PathBuf {
        self.out.with_extension("mtl")
    }

    /// The format that the name of the file says.
    fn format(&self) -> Result<SceneFormat, Box<dyn Error>> {
        let extension = self.out.extension().unwrap_or_default();
        if extension.eq_ignore_ascii_case("vs3") {
            return Ok(SceneFormat::View3d);
        }
        if extension.eq_ignore_ascii_case("stl") {
            return Ok(SceneFormat::Stl);
        }
        if !extension.eq_ignore_ascii_case("obj") {
            let out = self.out.display();
            let message = format!(
                "{out}: a scene is written as .obj, .vs3 or .stl, so let its name end in one of \
                 them"
            );
            return Err(message.into());
        }
        let materials = self.materials();
        let name = materials.file_name().and_then(|name| name.to_str());
        let name = name.ok_or("the name of the file to write is not UTF-8: choose another one")?;
        Ok(SceneFormat::Obj {
            materials: name.to_owned(),
        })
    }
}
