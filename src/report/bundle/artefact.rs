//! Notes for those who evaluate the artefact: claim, command, expected output, run time.

use super::tables::named;
use crate::question::ReportAnswer;
use crate::report::Table;
use crate::report::answers::claims::number_and_certainty;

/// The notes in Markdown.
pub(super) fn notes(answer: &ReportAnswer) -> String {
    let rows = answer.claims.iter().map(|claim| {
        let number = claim.judged.as_ref().map(number_and_certainty);
        let number = number.filter(|[number, _]| !number.is_empty());
        let number = number.map_or_else(String::new, |number| format!(", {}", number.join(" ")));
        vec![
            claim.claim.place.clone(),
            format!("`infoscene reproduce {}`", claim.claim.id),
            format!("{}{number}", claim.verdict().name().replace('_', " ")),
            claim.seconds.map_or_else(String::new, run_time),
        ]
    });
    let claims = Table {
        columns: vec!["claim", "command", "expected output", "run time"],
        rows: rows.collect(),
        ..Table::default()
    };
    let rows = answer.timings.iter().map(|time| {
        let study = answer.studies.iter().map(|study| named(study.subject));
        let title = study.into_iter().find(|(name, _)| *name == time.part);
        vec![
            title.map_or(time.part, |(_, title)| title).to_owned(),
            format!("`{}`", time.command),
            run_time(time.seconds),
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
         Run times are those of the run that made this report, on {} ({} threads), compiled for \
         {build} by {}.\n\n\
         ## Claims\n\nClaims were judged side by side; what several share is counted with one of \
         them.\n\n{}\n\
         ## Parts\n\n{}",
        env!("CARGO_PKG_VERSION"),
        machine.processor,
        machine.cores,
        machine.compiler,
        claims.to_markdown(),
        times.to_markdown(),
    )
}

/// A run time, to a tenth of a second.
pub(super) fn run_time(seconds: f64) -> String {
    if seconds < 0.05 {
        "< 0.1 s".to_owned()
    } else {
        format!("{seconds:.1} s")
    }
}
