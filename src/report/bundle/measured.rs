//! The figures of studies: error against run time, and the digits that routes keep.

use super::figure::{BundleFigure, own_figure};
use crate::question::{RefineAnswer, ReportAnswer, StudyAnswer};
use crate::report::answers::refine::refinement_net;
use crate::report::render::heat::Heat;
use crate::report::render::page::PageError;
use crate::report::{Axis, Figure, Line};
use crate::study::form_factors::extreme_pairs::StabilityRow;

/// Errors below this cannot be told from it in `f64`.
const LEAST_ERROR: f64 = 1e-17;
/// Lines that a figure tells apart.
const MOST_LINES: usize = 6;
/// Digits of a double.
const DIGITS: f64 = 16.0;

/// The figures of the studies that the report has.
pub(super) fn figures(answer: &ReportAnswer) -> Result<Vec<BundleFigure>, PageError> {
    let mut figures = Vec::new();
    for study in &answer.studies {
        figures.extend(of_study(&study.answer)?);
    }
    for (place, name) in MESHES.into_iter().enumerate() {
        let mesh = answer.meshes.get(place);
        let mesh = mesh.ok_or_else(|| PageError::without("mesh", name))?;
        figures.push(of_mesh(mesh, name)?);
    }
    Ok(figures)
}

/// The names of the figures of meshes.
const MESHES: [&str; 2] = ["mesh-lit", "mesh-shaded"];

/// A room unfolded, with its mesh and its light.
fn of_mesh(mesh: &RefineAnswer, name: &'static str) -> Result<BundleFigure, PageError> {
    let missing = || PageError::without("mesh", name);
    let last = mesh.steps.last().ok_or_else(missing)?;
    let net = refinement_net(mesh, true).ok_or_else(missing)?;
    let error = match (last.error_bound, last.error_estimate) {
        (Some(bound), _) => format!("at most {:.0} %", 100.0 * bound),
        (None, Some(estimate)) => format!("about {:.0} %, an estimate", 100.0 * estimate),
        (None, None) => return Err(missing()),
    };
    let caption = format!(
        "The room {} unfolded: {} elements by the oracle of the {}, with their radiosities; the \
         error against the continuous radiosity is {error}.",
        mesh.scene, last.elements, mesh.oracle
    );
    Ok(BundleFigure::net(name, &caption, &net)?)
}

fn of_study(study: &StudyAnswer) -> Result<Vec<BundleFigure>, PageError> {
    Ok(match study {
        StudyAnswer::Accuracy(rows) => {
            let first = rows.first().map_or("", |row| row.case.as_str());
            let rows = rows.iter().filter(|row| row.case == first);
            let rows = rows.map(|row| (row.method.to_owned(), row.seconds, row.relative_error));
            let unoccluded = Figure {
                x: Axis::logarithmic("seconds for a pair"),
                y: Axis::logarithmic("relative error"),
                lines: lines(rows, &ROUTES),
                ..Figure::default()
            };
            let caption =
                format!("Error against run time of the routes to a form factor: {first}.");
            let past = "Error against run time past plates half-way between the patches.";
            vec![
                BundleFigure::lines("error-unoccluded", &caption, None, &unoccluded)?.timed(),
                BundleFigure::lines("error-occluded", past, None, &own_figure(study)?)?.timed(),
            ]
        }
        StudyAnswer::Sampling(rows) => {
            let last = rows.last().map_or("", |row| row.case.as_str());
            let rows = rows.iter().filter(|row| row.case == last);
            let rows = rows.map(|row| {
                let kind = row
                    .kind
                    .map_or_else(String::new, |kind| format!(", {kind} lines"));
                (
                    format!("{}{kind}", row.method),
                    row.seconds,
                    row.relative_error,
                )
            });
            let figure = timed_figure("relative error", lines(rows, &[]));
            let caption = format!(
                "Error against run time of mutual information from random lines and by closed \
                 forms: {last}."
            );
            vec![BundleFigure::lines("error-information", &caption, None, &figure)?.timed()]
        }
        StudyAnswer::Precision(rows) => {
            let rows = rows.iter().filter(|row| row.method != "f64");
            let rows = rows.map(|row| (row.case.clone(), row.seconds, row.relative_error));
            let figure = timed_figure("relative width", lines_to(rows, &[], 1e-300));
            let caption = "Width of enclosures against run time, by bits of their ends.";
            vec![BundleFigure::lines("error-enclosures", caption, None, &figure)?.timed()]
        }
        StudyAnswer::Oracles(rows) => {
            let first = rows.first().map_or("", |row| row.case.as_str());
            let rows = rows.iter().filter(|row| row.case == first);
            let rows = rows.map(|row| (row.method.clone(), row.seconds, row.relative_error));
            let figure = timed_figure("relative error of the light", lines(rows, &ORACLES));
            let caption = format!("Error against run time of hierarchical radiosity, {first}.");
            let by_elements = "Error of hierarchical radiosity against the number of elements.";
            vec![
                BundleFigure::lines("error-hierarchy", &caption, None, &figure)?.timed(),
                BundleFigure::lines("oracles", by_elements, None, &by_oracle(study)?)?,
            ]
        }
        StudyAnswer::Tolerances(_) => {
            let caption = "The largest error and the largest bound over all pairs of a scene, \
                           against run time, from a tolerance of 1e-2 to one of 1e-14.";
            let figure = own_figure(study)?;
            vec![BundleFigure::lines("error-scenes", caption, None, &figure)?.timed()]
        }
        StudyAnswer::Refinement(_) => {
            let caption = "Mutual information that a mesh lacks of the continuous one.";
            vec![BundleFigure::lines(
                "convergence",
                caption,
                None,
                &own_figure(study)?,
            )?]
        }
        StudyAnswer::Stability(rows) => stability(rows)?,
        _ => Vec::new(),
    })
}

/// The routes and the oracles that are drawn, if there are more than can be told apart.
const ROUTES: [&str; MOST_LINES] = [
    "chooser",
    "contour",
    "gauss-order",
    "double-double",
    "local-lines",
    "quasi-random",
];
const ORACLES: [&str; MOST_LINES] = ["gradient", "true", "information", "paper", "power", "area"];

fn timed_figure(error: &str, lines: Vec<Line>) -> Figure {
    Figure {
        x: Axis::logarithmic("seconds"),
        y: Axis::logarithmic(error),
        lines,
        ..Figure::default()
    }
}

/// The study's own figure, of the oracles that are drawn.
fn by_oracle(study: &StudyAnswer) -> Result<Figure, PageError> {
    let mut figure = own_figure(study)?;
    figure
        .lines
        .retain(|line| ORACLES.contains(&line.name.as_str()));
    Ok(figure)
}

fn lines(rows: impl Iterator<Item = (String, f64, f64)>, wanted: &[&str]) -> Vec<Line> {
    lines_to(rows, wanted, LEAST_ERROR)
}

/// A line for each name, with times rising; of those wanted, or of the first that can be told
/// apart.
fn lines_to(
    rows: impl Iterator<Item = (String, f64, f64)>,
    wanted: &[&str],
    least: f64,
) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    for (name, seconds, error) in rows {
        if !wanted.is_empty() && !wanted.contains(&name.as_str()) {
            continue;
        }
        let point = [seconds, error.max(least)];
        match lines.iter().position(|line| line.name == name) {
            Some(index) => lines[index].points.push(point),
            None if lines.len() < MOST_LINES => lines.push(Line {
                name,
                points: vec![point],
            }),
            None => {}
        }
    }
    for line in &mut lines {
        line.points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    }
    lines
}

/// The families of the study of stability: the method that tells one, the name of its figure and
/// its caption.
const FAMILIES: [(&str, &str, &str); 4] = [
    (
        "difference",
        "stability-gains",
        "Digits that forms of the gain keep where the parts are nearly equal.",
    ),
    (
        "elimination",
        "stability-light",
        "Digits that solvers keep of stiff and extreme light.",
    ),
    (
        "contour",
        "stability-pairs",
        "Digits that routes keep of stiff and extreme pairs.",
    ),
    (
        "occluded",
        "stability-occluded",
        "Digits that routes keep of extreme pairs past others.",
    ),
];

/// A grid of digits for each family; a case of none of them is an error, as is an empty family.
fn stability(rows: &[StabilityRow]) -> Result<Vec<BundleFigure>, PageError> {
    let mut families: [Vec<&[StabilityRow]>; 4] = Default::default();
    for case in rows.chunk_by(|a, b| a.case == b.case) {
        let has = |name: &str| case.iter().any(|row| row.method == name);
        let place = FAMILIES.iter().position(|(method, _, _)| has(method));
        let place = place.ok_or_else(|| PageError::without("a family", &case[0].case))?;
        families[place].push(case);
    }
    let grids = families.iter().zip(FAMILIES);
    let grids = grids
        .map(|(cases, (_, name, caption))| Ok(BundleFigure::heat(name, caption, heat(cases))?));
    grids.collect()
}

fn heat(cases: &[&[StabilityRow]]) -> Heat {
    let mut columns: Vec<String> = Vec::new();
    for row in cases.iter().copied().flatten() {
        if !columns.contains(&row.method) {
            columns.push(row.method.clone());
        }
    }
    let digits = |row: &StabilityRow| {
        let error = row.relative_error?;
        Some((-error.log10()).clamp(0.0, DIGITS).floor())
    };
    let rows = cases.iter().map(|case| {
        let kept = columns.iter().map(|column| {
            let row = case.iter().find(|row| row.method == *column);
            row.and_then(digits)
        });
        (case[0].case.clone(), kept.collect())
    });
    let rows = rows.collect();
    Heat {
        quantity: format!("digits kept, of {DIGITS:.0}"),
        largest: DIGITS,
        columns,
        rows,
    }
}
