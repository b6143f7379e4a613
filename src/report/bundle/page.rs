//! The page: one HTML file that needs nothing else.
//!
//! Templates in `templates` hold the words and the look; here are only the values that they show.
//! A policy in the page's head forbids it any request.

use super::Parts;
use super::page_claims::{PageClaim, claims};
use crate::claims::Verdict;
use crate::question::{Machine, PartTime};
use crate::report::render::page::PageError;
use crate::report::{ReportError, Table};
use minijinja::value::Serde;
use minijinja::{AutoEscape, Environment, Value};
use pulldown_cmark::{CowStr, Event, Options, Parser, Tag, TagEnd, html};

/// The contents of the page.
#[derive(serde::Serialize)]
struct Page<'a> {
    version: &'static str,
    is_quick: bool,
    left_out: Vec<&'a str>,
    verdicts: Vec<PageVerdict>,
    claims: Vec<PageClaim<'a>>,
    errata: Vec<usize>,
    tables: Vec<PageTable<'a>>,
    figures: Vec<PageFigure<'a>>,
    findings: Option<Value>,
    trusted: Option<Value>,
    bibliography: &'static str,
    methods: String,
    machine: &'a Machine,
    timings: &'a [PartTime],
    /// Curves of the live figure, as JSON.
    curves: Value,
}

#[derive(serde::Serialize)]
struct PageVerdict {
    name: &'static str,
    words: String,
    means: &'static str,
    count: usize,
}

#[derive(serde::Serialize)]
struct PageTable<'a> {
    name: &'a str,
    title: &'a str,
    columns: &'a [&'static str],
    /// Whether each column has numbers only.
    is_number: Vec<bool>,
    rows: &'a [Vec<String>],
    notes: &'a [(String, String)],
}

#[derive(serde::Serialize)]
struct PageFigure<'a> {
    name: &'a str,
    caption: &'a str,
    svg: Value,
    view: Option<Value>,
}

#[derive(serde::Serialize)]
struct LiveCurves<'a> {
    parallel: &'a [[f64; 2]],
    orthogonal: &'a [[f64; 2]],
    printed: &'a str,
    best: f64,
}

/// The text of the page.
pub(super) fn page(parts: &Parts<'_>) -> Result<String, PageError> {
    let answer = parts.answer;
    let claims = claims(answer, &parts.figures);
    let reported = || answer.claims.iter().enumerate();
    let refuted = reported().filter(|(_, claim)| claim.verdict() == Verdict::Refuted);
    let ids: Vec<&str> = answer
        .claims
        .iter()
        .map(|claim| claim.claim.id.as_str())
        .collect();
    let prose = |index: usize, prefix: &str| {
        let text = parts.prose.as_ref().map(|prose| prose[index].as_str());
        text.map(|text| Value::from_safe_string(prose_html(text, &ids, prefix)))
    };
    let page = Page {
        version: env!("CARGO_PKG_VERSION"),
        is_quick: answer.is_quick,
        left_out: answer.left_out(),
        verdicts: verdicts(parts),
        errata: refuted.map(|(index, _)| index).collect(),
        claims,
        tables: parts.tables.iter().map(table).collect(),
        figures: figures(parts)?,
        findings: prose(0, "findings-"),
        trusted: prose(1, "trusted-"),
        bibliography: super::latex::BIBLIOGRAPHY,
        methods: super::latex::methods(answer),
        machine: &answer.machine,
        timings: &answer.timings,
        curves: curves(parts)?,
    };
    Ok(environment()?
        .get_template("page.html")?
        .render(Serde(page))?)
}

/// The templates, with everything escaped that is not marked as HTML.
fn environment() -> Result<Environment<'static>, PageError> {
    let mut templates = Environment::new();
    templates.set_auto_escape_callback(|name| {
        if name.ends_with(".html") {
            AutoEscape::Html
        } else {
            AutoEscape::None
        }
    });
    templates.add_filter("conjuncts", conjuncts);
    templates.set_undefined_behavior(minijinja::UndefinedBehavior::Strict);
    templates.add_template("page.html", include_str!("../templates/page.html"))?;
    templates.add_template("claim.html", include_str!("../templates/claim.html"))?;
    templates.add_template("page.css", include_str!("../templates/page.css"))?;
    templates.add_template("page.js", include_str!("../templates/page.js"))?;
    Ok(templates)
}

/// A statement in Coq's notation with each part of an outermost conjunction on a line of its own.
fn conjuncts(statement: &str) -> String {
    let mut lines = String::new();
    let (mut rest, mut depth) = (statement, 0);
    while let Some(letter) = rest.chars().next() {
        if let (0, Some(after)) = (depth, rest.strip_prefix(" /\\ ")) {
            lines += " /\\\n  ";
            rest = after;
            continue;
        }
        depth += i32::from(letter == '(') - i32::from(letter == ')');
        lines.push(letter);
        rest = &rest[letter.len_utf8()..];
    }
    lines
}

fn verdicts(parts: &Parts<'_>) -> Vec<PageVerdict> {
    let claims = &parts.answer.claims;
    let verdicts = Verdict::ALL.map(|verdict| PageVerdict {
        name: verdict.name(),
        words: verdict.name().replace('_', " "),
        means: verdict.meaning(),
        count: claims
            .iter()
            .filter(|claim| claim.verdict() == verdict)
            .count(),
    });
    verdicts
        .into_iter()
        .filter(|verdict| verdict.count > 0)
        .collect()
}

fn table(table: &super::BundleTable) -> PageTable<'_> {
    let Table {
        columns,
        rows,
        notes,
        ..
    } = table.report.table();
    PageTable {
        name: table.name,
        title: table.title,
        columns,
        is_number: table.report.table().numeric_columns(),
        rows,
        notes,
    }
}

fn figures<'a>(parts: &'a Parts<'_>) -> Result<Vec<PageFigure<'a>>, PageError> {
    let figures = parts.figures.iter().map(|figure| {
        let view = figure.scene.map(|scene| {
            let found = parts.views.iter().find(|(name, _, _)| *name == scene);
            found.ok_or_else(|| PageError::without("view of the scene", figure.name))
        });
        let view = view.transpose()?;
        Ok(PageFigure {
            name: figure.name,
            caption: &figure.caption,
            svg: Value::from_safe_string(figure.svg.clone()),
            view: view.map(|(_, svg, _)| Value::from_safe_string(svg.clone())),
        })
    });
    figures.collect()
}

/// The curves of fig. 2 for the live figure, in which no `<` can end its element.
fn curves(parts: &Parts<'_>) -> Result<Value, PageError> {
    let answer = parts.answer;
    let curve = |id: &str| {
        answer
            .curve(id)
            .ok_or_else(|| PageError::without("curve", id))
    };
    let id = "fig2-parallel-cut";
    let claim = answer.claims.iter().find(|claim| claim.claim.id == id);
    let claim = claim.ok_or_else(|| PageError::without("claim", id))?;
    let printed = claim.claim.printed.as_ref();
    let best = claim.judged.as_ref().and_then(|judged| judged.computed);
    let live = LiveCurves {
        parallel: curve("fig2-curve")?,
        orthogonal: curve("fig2-orthogonal-small")?,
        printed: &printed
            .ok_or_else(|| PageError::without("printed number", id))?
            .text,
        best: best.ok_or_else(|| PageError::without("computed number", id))?,
    };
    let text = serde_json::to_string(&live).map_err(ReportError::from)?;
    Ok(Value::from_safe_string(text.replace('<', "\\u003c")))
}

/// A page in Markdown as HTML: names of claims lead to them, other links become plain text.
fn prose_html(text: &str, ids: &[&str], prefix: &str) -> String {
    let options = Options::ENABLE_TABLES;
    let is_kept = |event: &Event<'_>| {
        !matches!(
            event,
            Event::Start(Tag::Link { .. } | Tag::Image { .. })
                | Event::End(TagEnd::Link | TagEnd::Image)
        )
    };
    let events = Parser::new_ext(text, options)
        .filter(is_kept)
        .map(|event| match event {
            Event::Code(name) if ids.contains(&&*name) => {
                let link = format!("<a href=\"#{name}\"><code>{name}</code></a>");
                Event::InlineHtml(CowStr::from(link))
            }
            // the page has headings of its own above these
            Event::Start(Tag::Heading { level, .. }) => {
                Event::Html(CowStr::from(format!("<h3 class=\"{prefix}{level}\">")))
            }
            Event::End(TagEnd::Heading(_)) => Event::Html(CowStr::from("</h3>\n")),
            Event::Start(Tag::Table(_)) => {
                Event::Html(CowStr::from("<div class=\"scroll\" tabindex=\"0\"><table>"))
            }
            Event::End(TagEnd::Table) => Event::Html(CowStr::from("</tbody></table></div>\n")),
            other => other,
        });
    let mut page = String::new();
    html::push_html(&mut page, events);
    page
}
