//! `infoscene check SCENE`.

use super::Answer;
use super::output::{Output, say};
use super::scene::SceneArgument;
use infoscene::question;
use infoscene::report::check_report;

#[derive(Debug, clap::Args)]
pub(super) struct Check {
    #[command(flatten)]
    scene: SceneArgument,
    #[command(flatten)]
    output: Output,
}

impl Check {
    pub(super) fn answer(&self) -> Answer {
        let question = question::Check {
            scene: self.scene.source(),
        };
        let answer = question.ask()?;
        say(&answer.notes);
        self.output.write(&check_report(&answer)?)
    }
}
