//! Notes for those who evaluate the artefact: claim, command, expected output, run time.

use super::tables::named;
use crate::question::ReportAnswer;
use crate::report::Table;
use crate::report::answers::claims::number_and_error;

/// The notes in Markdown.
pub(super) fn notes(answer: &ReportAnswer) -> String {
    let rows = answer.claims.iter().map(|claim| {
        let number = claim.judged.as_ref().map(number_and_error);
        let [number, error] = number.unwrap_or_default();
        let number = if number.is_empty() {
            String::new()
        } else {
            format!(", {number} (± {error})")
        };
        vec![
            claim.claim.place.clone(),
            format!("`infoscene reproduce {}`", claim.claim.id),
            format!("{}{number}", claim.verdict().name().replace('_', " ")),
        ]
    });
    let claims = Table {
        columns: vec!["claim", "command", "expected output"],
        rows: rows.collect(),
        ..Table::default()
    };
    let rows = answer.timings.iter().map(|time| {
        let study = answer.studies.iter().map(|study| named(study.subject));
        let title = study.into_iter().find(|(name, _)| *name == time.part);
        vec![
            title.map_or(time.part, |(_, title)| title).to_owned(),
            format!("`{}`", time.command),
            format!("{:.1} s", time.seconds),
        ]
    });
    let times = Table {
        columns: vec!["part", "command", "run time"],
        rows: rows.collect(),
        ..Table::default()
    };
    let machine = &answer.machine;
    let build = if machine.is_release {
        "release"
    } else {
        "debugging"
    };
    format!(
        "# Artefact notes\n\n\
         Made by `infoscene report`, version {}. It needs a Rust toolchain and no network once its \
         dependencies are there: `cargo build --release`, then `cargo run --release -- report`. \
         `cargo test` fails when a verdict differs from the one expected here.\n\n\
         ## Claims\n\nEach takes less than a second on its own, those of figs. 4 and 5 and of \
         App. B.2 up to half a minute; all together take the time named below.\n\n{}\n\
         ## Parts\n\nRun times on {} ({} threads), compiled for {build} by {}.\n\n{}",
        env!("CARGO_PKG_VERSION"),
        claims.to_markdown(),
        machine.processor,
        machine.cores,
        machine.compiler,
        times.to_markdown(),
    )
}
