//! `infoscene report [--output DIR] [--quick]`.

use super::progress::Bar;
use super::report_folder::NewFolder;
use super::{Answer, Outcome};
use infoscene::question;
use infoscene::report::report_files;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub(super) struct Report {
    /// The folder to write; an earlier report in it is replaced.
    #[arg(long, value_name = "DIR", default_value = "report")]
    output: PathBuf,
    /// Leave out claims and studies that take seconds.
    #[arg(long)]
    quick: bool,
}

impl Report {
    pub(super) fn answer(&self) -> Answer {
        let folder = NewFolder::beside(&self.output)?;
        let question = question::Report {
            is_quick: self.quick,
        };
        let answer = question.ask(&Bar::default())?;
        let files = report_files(&answer)?;
        for file in &files {
            folder.write(&file.path, &file.content)?;
        }
        folder.move_into_place()?;
        let page = self.output.join("index.html");
        eprintln!("infoscene: {} files; open {}", files.len(), page.display());
        Ok(if answer.reproduction().is_as_recorded() {
            Outcome::Done
        } else {
            Outcome::Differs
        })
    }
}
