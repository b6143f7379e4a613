//! `infoscene discontinuities SCENE --patch I --from J`.

use super::Answer;
use super::output::{Output, check_place, say, write_file};
use super::progress::Bar;
use super::scene::SceneArgument;
use infoscene::question::{self, PatchName};
use infoscene::report::{discontinuities_map, discontinuities_report, gain_figure};
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub(super) struct Discontinuities {
    #[command(flatten)]
    scene: SceneArgument,
    /// The patch with the lines: its index from 0, or its name.
    #[arg(long, value_name = "PATCH")]
    patch: PatchName,
    /// The patch that it sees past what stands between.
    #[arg(long, value_name = "PATCH")]
    from: PatchName,
    /// Draw the lines, too, over a map of the form factors from the patch's points, into an SVG
    /// file.
    #[arg(long, value_name = "PATH")]
    figure: Option<PathBuf>,
    /// Draw the gain as a function of the cut across axis u, too, into an SVG file.
    #[arg(long, value_name = "PATH")]
    gain_u: Option<PathBuf>,
    /// Draw the gain as a function of the cut across axis v, too, into an SVG file.
    #[arg(long, value_name = "PATH")]
    gain_v: Option<PathBuf>,
    #[command(flatten)]
    output: Output,
}

impl Discontinuities {
    pub(super) fn answer(&self) -> Answer {
        self.output.check()?;
        let gains = [("u", &self.gain_u), ("v", &self.gain_v)];
        let drawn = gains.iter().filter_map(|(_, path)| path.as_ref());
        let drawn: Vec<&PathBuf> = drawn.chain(&self.figure).collect();
        for path in &drawn {
            check_place(path)?;
        }
        let question = question::Discontinuities {
            scene: self.scene.source(),
            patch: self.patch.clone(),
            from: self.from.clone(),
            with_map: !drawn.is_empty(),
        };
        let answer = question.ask(&Bar::default())?;
        say(&answer.notes);
        if let Some((path, map)) = self.figure.as_ref().zip(discontinuities_map(&answer)) {
            write_file(path, map.to_svg()?.as_bytes())?;
        }
        for (axis, path) in gains {
            if let Some((path, figure)) = path.as_ref().zip(gain_figure(&answer, axis)) {
                write_file(path, figure.to_svg()?.as_bytes())?;
            }
        }
        self.output.write(&discontinuities_report(&answer)?)
    }
}
