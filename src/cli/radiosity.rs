//! `infoscene radiosity SCENE`.

use super::Answer;
use super::light::MaterialArguments;
use super::output::{Output, finished, say};
use super::progress::Bar;
use super::scene::ScenePairsArguments;
use infoscene::question::{self, PatchValue};
use infoscene::report::radiosity_report;

#[derive(Debug, clap::Args)]
pub(super) struct Radiosity {
    #[command(flatten)]
    scene: ScenePairsArguments,
    #[command(flatten)]
    materials: MaterialArguments,
    /// Also importances, for these direct ones: PATCH=VALUE,…, or PATCH alone for 1; PATCH is an
    /// index, a name, or all.
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    importance: Vec<PatchValue>,
    #[command(flatten)]
    output: Output,
}

impl Radiosity {
    pub(super) fn answer(&self) -> Answer {
        self.output.check()?;
        let question = question::Radiosity {
            scene: self.scene.source(),
            tolerance: self.scene.tolerance(),
            congruence: self.scene.congruence(),
            materials: self.materials.changes(),
            importance: self.importance.clone(),
        };
        let answer = question.ask(&Bar::default())?;
        say(&answer.notes);
        self.output.write(&radiosity_report(&answer)?)?;
        Ok(finished(answer.unreached.as_ref()))
    }
}
