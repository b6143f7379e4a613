//! The report as a folder of files: tables, figures, a page, and what an author pastes.
//!
//! ```text
//!   index.html            one page with everything, without the network
//!   report.json           all records, as report.schema.json describes them
//!   tables/NAME.*         .tex (booktabs, for \input), .md, .csv, .json
//!   figures/NAME.*        .svg, .pdf; views of scenes
//!   timed/NAME.*          tables and figures that hold run times, and machine.json
//!   all.tex               inputs every table and figure
//!   infoscene.bib, methods.tex, artefact.md, findings.md
//! ```
//!
//! A part without its data is an error. Files come finished and in order; writing them is the
//! command's. What holds a run time is apart from what does not, so that the rest can be compared.
//!
//! **Not here**: computing, but for the numbers of the page of findings.

mod artefact;
mod figure;
mod figures;
mod latex;
mod measured;
mod page;
mod page_claims;
mod records;
mod tables;

use crate::question::ReportAnswer;
use crate::report::answers::pages::findings::findings_page;
use crate::report::answers::pages::trusted::trusted_page;
use crate::report::render::page::PageError;
use crate::report::render::sheet::Drawing;
use crate::report::{Format, json_text};
pub use figure::BundleFigure;
pub use figures::report_figures;
pub use tables::{BundleTable, report_tables};

/// The description of `report.json`, as a JSON schema.
pub const REPORT_SCHEMA: &str = include_str!("../templates/report.schema.json");

/// A file of a report.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BundleFile {
    /// The path in the folder, with `/` between names.
    pub path: String,
    /// The content.
    pub content: Vec<u8>,
}

/// Everything that the files are made of.
struct Parts<'a> {
    answer: &'a ReportAnswer,
    tables: Vec<BundleTable>,
    figures: Vec<BundleFigure>,
    views: Vec<(&'static str, String, Vec<u8>)>,
    /// The pages of findings and of what is trusted, in Markdown; a quick report has none.
    prose: Option<[String; 2]>,
}

/// All files of a report, in the order of their paths within each kind.
///
/// # Errors
/// [`PageError`] if a claim, a table or a figure lacks its data, or a number is not finite.
pub fn report_files(answer: &ReportAnswer) -> Result<Vec<BundleFile>, PageError> {
    let views = figures::views(answer)?.into_iter();
    let views = views.map(|(name, view)| Ok((name, view.svg()?, view.pdf()?)));
    let judgements = &answer.judgements;
    let parts = Parts {
        answer,
        tables: report_tables(answer)?,
        figures: report_figures(answer)?,
        views: views.collect::<Result<_, PageError>>()?,
        prose: match answer.is_quick {
            true => None,
            false => Some([findings_page(judgements)?, trusted_page(judgements)?]),
        },
    };
    let mut files = Vec::new();
    let mut add = |path: String, content: Vec<u8>| files.push(BundleFile { path, content });
    add("index.html".to_owned(), page::page(&parts)?.into_bytes());
    add(
        "report.json".to_owned(),
        records::records(&parts)?.into_bytes(),
    );
    add(
        "report.schema.json".to_owned(),
        REPORT_SCHEMA.as_bytes().to_vec(),
    );
    for table in &parts.tables {
        let folder = if table.is_timed { "timed" } else { "tables" };
        for (format, ending) in FORMATS {
            let text = table.report.render(format)?;
            add(
                format!("{folder}/{}.{ending}", table.name),
                text.into_bytes(),
            );
        }
    }
    for figure in &parts.figures {
        let folder = if figure.is_timed { "timed" } else { "figures" };
        let svg = figure.svg.clone().into_bytes();
        add(format!("{folder}/{}.svg", figure.name), svg);
        add(format!("{folder}/{}.pdf", figure.name), figure.pdf.clone());
    }
    for (name, svg, pdf) in &parts.views {
        let name = file_name(name);
        add(format!("figures/{name}.svg"), svg.clone().into_bytes());
        add(format!("figures/{name}.pdf"), pdf.clone());
    }
    add(
        "timed/machine.json".to_owned(),
        json_text(&answer.machine)?.into_bytes(),
    );
    add(
        "timed/times.json".to_owned(),
        json_text(&answer.timings)?.into_bytes(),
    );
    for (name, text) in [
        ("all.tex", latex::document(&parts)),
        ("infoscene.bib", latex::BIBLIOGRAPHY.to_owned()),
        ("methods.tex", latex::methods(answer)),
        ("artefact.md", artefact::notes(answer)),
    ] {
        add(name.to_owned(), text.into_bytes());
    }
    if let Some([findings, trusted]) = &parts.prose {
        add("findings.md".to_owned(), findings.clone().into_bytes());
        add("trusted.md".to_owned(), trusted.clone().into_bytes());
    }
    Ok(files)
}

const FORMATS: [(Format, &str); 4] = [
    (Format::Latex, "tex"),
    (Format::Markdown, "md"),
    (Format::Csv, "csv"),
    (Format::Json, "json"),
];

/// The name of a view's file: that of its scene, without what some systems forbid.
fn file_name(scene: &str) -> String {
    format!("view-{}", scene.replace(':', "-"))
}
