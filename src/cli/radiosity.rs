//! `infoscene radiosity SCENE`.

use super::light::MaterialArguments;
use super::output::{Output, finished, say};
use super::progress::Bar;
use super::scene::ScenePairsArguments;
use super::{Answer, Outcome};
use infoscene::exchange::Ranks;
use infoscene::question::{self, PatchValue};
use infoscene::report::radiosity_report;
use std::path::PathBuf;

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
    /// Read the form factors from the folder that `form-factor --store` wrote, once for each
    /// product with them, and hold none.
    #[arg(long, value_name = "DIR")]
    store: Option<PathBuf>,
    /// Go on with a solution over the store that was stopped.
    #[arg(long, requires = "store")]
    resume: bool,
    #[command(flatten)]
    output: Output,
}

impl Radiosity {
    pub(super) fn answer(&self, ranks: &dyn Ranks) -> Answer {
        self.output.check()?;
        let question = question::Radiosity {
            scene: self.scene.source(),
            tolerance: self.scene.tolerance(),
            congruence: self.scene.congruence(),
            materials: self.materials.changes(),
            importance: self.importance.clone(),
            store: self.store.clone(),
            resume: self.resume,
        };
        let answer = question.ask_among(ranks, &Bar::default())?;
        if ranks.number() > 0 {
            return Ok(Outcome::Done);
        }
        say(&answer.notes);
        self.output.write(&radiosity_report(&answer)?)?;
        Ok(finished(answer.unreached.as_ref()))
    }
}
