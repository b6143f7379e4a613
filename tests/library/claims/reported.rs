//! The report: what is committed of it is current, nothing of it is missing, and each format can
//! be read. To bring it up to date: `INFOSCENE_REFRESH=1 cargo test --test library claims`.

use super::JUDGEMENTS;
use super::tables::assert_current;
use infoscene::question::{Report, ReportAnswer, StudySubject};
use infoscene::report::{
    BundleFile, Format, REPORT_SCHEMA, report_figures, report_files, report_tables,
};
use std::collections::BTreeSet;
use std::sync::LazyLock;

/// A report of the claims and of the study behind fig. 5.
static REPORT: LazyLock<ReportAnswer> = LazyLock::new(|| {
    let question = Report { is_quick: true };
    let subjects = [StudySubject::Figure5, StudySubject::Limits];
    question.gather(JUDGEMENTS.clone(), &subjects).unwrap()
});

static FILES: LazyLock<Vec<BundleFile>> = LazyLock::new(|| report_files(&REPORT).unwrap());

fn text(path: &str) -> &'static str {
    let file = FILES.iter().find(|file| file.path == path);
    std::str::from_utf8(&file.unwrap_or_else(|| panic!("no {path}")).content).unwrap()
}

#[test]
fn the_tables_for_papers_are_current() {
    for table in report_tables(&REPORT).unwrap() {
        if !table.is_timed && table.name != "figure-5" {
            let latex = table.report.render(Format::Latex).unwrap();
            assert_current(&format!("data/report/tables/{}.tex", table.name), &latex);
        }
    }
}

#[test]
fn the_figures_of_the_paper_are_current() {
    for figure in report_figures(&REPORT).unwrap() {
        if !figure.is_timed {
            let name = format!("data/report/figures/{}.svg", figure.name);
            assert_current(&name, &figure.svg);
        }
    }
}

/// The values of an attribute on the page.
fn values<'a>(page: &'a str, attribute: &str) -> Vec<&'a str> {
    let begin = format!(" {attribute}=\"");
    let rest = page.split(begin.as_str()).skip(1);
    rest.map(|rest| rest.split('"').next().unwrap()).collect()
}

#[test]
fn every_link_of_the_page_lands_on_it() {
    let page = text("index.html");
    let ids = values(page, "id");
    let known: BTreeSet<&str> = ids.iter().copied().collect();
    assert_eq!(known.len(), ids.len(), "an id stands twice");
    let links = values(page, "href");
    assert!(links.len() > 50, "only {} links are seen", links.len());
    for link in links.iter().filter(|link| **link != "data:,") {
        let id = link.strip_prefix('#').unwrap_or_else(|| panic!("{link}"));
        assert!(known.contains(id), "{link}");
    }
    for judgement in JUDGEMENTS.iter() {
        assert!(known.contains(judgement.claim.id.as_str()));
    }
    assert!(values(page, "src").is_empty());
    assert!(page.len() < 3_000_000);
}

/// What a claim's entry must hold, and what a template must escape.
#[test]
fn every_claim_is_told_in_full() {
    let page = text("index.html");
    let escaped = |text: &str| {
        let text = text.replace('&', "&amp;").replace('<', "&lt;");
        text.replace('>', "&gt;")
            .replace('"', "&quot;")
            .replace('\'', "&#x27;")
    };
    // a statement is broken where its parts are joined
    let flat = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(page.contains("&lt; fig2_parallel_gain_upper &#x2f;\\\n  forall t,"));
    for judgement in JUDGEMENTS.iter() {
        let claim = &judgement.claim;
        let begin = format!("<details class=\"claim\" id=\"{}\"", claim.id);
        let (_, rest) = page.split_once(&begin).unwrap();
        let entry = rest
            .split("</details>")
            .next()
            .unwrap()
            .replace("&#x2f;", "/");
        let mut parts = vec![escaped(&claim.formula.text), escaped(&claim.quantity)];
        parts.extend(claim.printed.iter().map(|printed| printed.text.clone()));
        parts.extend(
            claim
                .proof
                .iter()
                .map(|theorem| escaped(&theorem.conclusion)),
        );
        parts.push(judgement.verdict.name().replace('_', " "));
        for part in parts {
            assert!(flat(&entry).contains(&flat(&part)), "{}: {part}", claim.id);
        }
    }
}

/// Of a report without its data nothing is made.
#[test]
fn a_report_without_its_data_is_refused() {
    let without = |change: fn(&mut ReportAnswer)| {
        let mut answer = REPORT.clone();
        change(&mut answer);
        report_files(&answer).map(|files| files.len())
    };
    assert!(without(|_| ()).is_ok());
    assert!(without(|answer| answer.studies.clear()).is_err());
    assert!(without(|answer| answer.scenes.clear()).is_err());
    assert!(without(|answer| answer.meshes.clear()).is_err());
    assert!(without(|answer| answer.claims.clear()).is_err());
    assert!(
        without(|answer| {
            let mut claims = answer.claims.iter_mut();
            let fig_3 = claims.find(|claim| claim.claim.id == "fig3-curve");
            fig_3.unwrap().judged = None;
        })
        .is_err()
    );
}

/// Records have one length, tables in Markdown one number of cells, and drawings name no file.
#[test]
fn strict_readers_take_every_format() {
    let mut read = [0; 4];
    for file in FILES.iter() {
        let ending = file.path.rsplit('.').next().unwrap();
        match ending {
            "csv" => {
                let mut reader = csv::Reader::from_reader(file.content.as_slice());
                assert!(
                    reader.records().all(|record| record.is_ok()),
                    "{}",
                    file.path
                );
                read[0] += 1;
            }
            "json" => {
                let value: Result<serde_json::Value, _> = serde_json::from_slice(&file.content);
                assert!(value.is_ok(), "{}", file.path);
                read[1] += 1;
            }
            "md" => {
                let text = std::str::from_utf8(&file.content).unwrap();
                let cells = |line: &str| line.replace("\\|", "").matches('|').count();
                let lines: Vec<&str> = text.lines().collect();
                for pair in lines
                    .windows(2)
                    .filter(|pair| pair.iter().all(|l| l.starts_with('|')))
                {
                    assert_eq!(cells(pair[0]), cells(pair[1]), "{}: {}", file.path, pair[1]);
                }
                read[2] += 1;
            }
            "pdf" => {
                assert!(file.content.starts_with(b"%PDF-1."), "{}", file.path);
                assert!(file.content.ends_with(b"%%EOF") || file.content.ends_with(b"%%EOF\n"));
                read[3] += 1;
            }
            _ => {}
        }
    }
    assert!(read.iter().all(|count| *count >= 5), "{read:?}");
}

/// Every key of the records is described, and every one described as required is there; that a
/// report follows the schema in all else is checked by a validator in `tests/command`.
#[test]
fn the_schema_knows_every_key() {
    let schema: serde_json::Value = serde_json::from_str(REPORT_SCHEMA).unwrap();
    let records: serde_json::Value = serde_json::from_str(text("report.json")).unwrap();
    let agree = |record: &serde_json::Value, schema: &serde_json::Value| {
        let required = schema["required"].as_array().unwrap();
        for key in required {
            assert!(record.get(key.as_str().unwrap()).is_some(), "{key}");
        }
        for key in record.as_object().unwrap().keys() {
            assert!(
                schema["properties"].get(key).is_some(),
                "{key} is not described"
            );
        }
    };
    agree(&records, &schema);
    for claim in records["claims"].as_array().unwrap() {
        agree(claim, &schema["$defs"]["claim"]);
    }
    for list in ["tables", "figures"] {
        for entry in records[list].as_array().unwrap() {
            agree(entry, &schema["$defs"]["shown"]);
        }
    }
}
