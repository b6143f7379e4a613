//! The figures of a report, each with its caption.

use super::figure::BundleFigure;
use super::measured;
use crate::claims::Task;
use crate::question::{ReportAnswer, ReportedClaim, StudyAnswer, StudySubject};
use crate::report::answers::cuts::cuts_figure;
use crate::report::render::page::PageError;
use crate::report::render::view::View;
use crate::report::{Axis, Band, Figure, Line, Mark};

/// The figures of a report, those of the paper first.
///
/// # Errors
/// [`PageError::Missing`] if a figure lacks its data; [`PageError::Report`] if one cannot be drawn.
pub fn report_figures(answer: &ReportAnswer) -> Result<Vec<BundleFigure>, PageError> {
    let mut figures = of_the_paper(answer)?;
    figures.extend(measured::figures(answer)?);
    Ok(figures)
}

/// The views of scenes, by their names.
///
/// # Errors
/// [`PageError::Report`] if nothing is seen of one.
pub(super) fn views(answer: &ReportAnswer) -> Result<Vec<(&'static str, View)>, PageError> {
    let views = answer
        .scenes
        .iter()
        .map(|scene| Ok((scene.name, View::of(scene)?)));
    views.collect()
}

const CUT: &str = "cut, share of the patch from the common edge";
const GAIN: &str = "gain, bits";

/// The figures that the paper has, with what it prints.
fn of_the_paper(answer: &ReportAnswer) -> Result<Vec<BundleFigure>, PageError> {
    let mut figures = Vec::new();
    for (id, name, caption) in [
        (
            "fig1-dark-part",
            "fig1-dark",
            "Fig. 1: what a cut gains where the part beyond the marked line sees nothing.",
        ),
        (
            "fig1-lit-part",
            "fig1-lit",
            "Fig. 1: what a cut gains through the lit part, where the form factor is constant up \
             to the marked line.",
        ),
    ] {
        let figure = Figure {
            x: Axis::even(CUT),
            y: Axis::even(GAIN),
            lines: vec![curve(answer, id, "gain")?],
            marks: vec![abscissa(
                input(answer, id, "line")?,
                "line of discontinuity",
            )],
            ..Figure::default()
        };
        figures.push(BundleFigure::lines(
            name,
            caption,
            Some("two-squares"),
            &figure,
        )?);
    }
    figures.push(figure_2(answer)?);
    let printed = printed(answer, "fig3-cut")?;
    let figure = Figure {
        x: Axis::even("cut, share of the patch from one common edge"),
        y: Axis::even(GAIN),
        lines: vec![curve(answer, "fig3-curve", "three squares")?],
        marks: vec![abscissa(printed.0, &format!("printed {}", printed.1))],
        ..Figure::default()
    };
    let caption = "Fig. 3(b): mutual information gained by a cut of one of three squares in a \
                   corner, with the cut that the paper prints.";
    figures.push(BundleFigure::lines(
        "fig3",
        caption,
        Some("three-squares"),
        &figure,
    )?);
    figures.push(figure_4(answer)?);
    figures.push(figure_5(answer)?);
    figures.push(grids_by_cells(answer)?);
    figures.push(cuts_of_section_4_2(answer)?);
    Ok(figures)
}

fn figure_2(answer: &ReportAnswer) -> Result<BundleFigure, PageError> {
    let printed = printed(answer, "fig2-parallel-cut")?;
    let figure = Figure {
        x: Axis::even("cut, share of the patch"),
        y: Axis::even(GAIN),
        lines: vec![
            curve(answer, "fig2-curve", "parallel to the common edge")?,
            curve(answer, "fig2-orthogonal-small", "orthogonal to it")?,
        ],
        marks: vec![abscissa(printed.0, &format!("printed {}", printed.1))],
        ..Figure::default()
    };
    let caption = "Fig. 2(c): mutual information gained by a cut of one of two squares with a \
                   common edge, parallel and orthogonal to it, with the best cut that the paper \
                   prints.";
    Ok(BundleFigure::lines(
        "fig2",
        caption,
        Some("two-squares"),
        &figure,
    )?)
}

fn figure_4(answer: &ReportAnswer) -> Result<BundleFigure, PageError> {
    let printed = printed(answer, "fig4-optimum")?;
    let figure = Figure {
        x: Axis::even("first line from the edge; half an edge is 10"),
        y: Axis::even("mutual information, bits"),
        lines: vec![Line {
            name: "3 × 3 cells on every face".to_owned(),
            points: answer.first_lines.clone(),
        }],
        marks: vec![abscissa(printed.0, &format!("printed {}", printed.1))],
        ..Figure::default()
    };
    let caption = "Fig. 4(d): mutual information of 3 × 3 cells on every face of a cube against \
                   the place of the first line, with the best place that the paper prints.";
    Ok(BundleFigure::lines(
        "fig4",
        caption,
        Some("cube:3"),
        &figure,
    )?)
}

/// Half the width of a bar of fig. 5.
const BAR: f64 = 0.12;

/// Exact, expected and printed values of the three grids.
fn figure_5(answer: &ReportAnswer) -> Result<BundleFigure, PageError> {
    let missing = || PageError::without("study of fig. 5", "the report");
    let rows = match answer.study(StudySubject::Figure5) {
        Some(StudyAnswer::Figure5(rows)) => rows,
        _ => return Err(missing()),
    };
    let mut printed: Vec<_> = rows.iter().filter(|row| row.printed.is_some()).collect();
    printed.sort_by(|a, b| {
        b.printed
            .partial_cmp(&a.printed)
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    let places = || (1..).map(f64::from);
    let line = |name: &str, values: Vec<f64>| Line {
        name: name.to_owned(),
        points: places().zip(values).map(|(x, y)| [x, y]).collect(),
    };
    let bands = printed.iter().zip(places()).map(|(row, x)| {
        let ends = [row.expected - row.deviation, row.expected + row.deviation];
        Band {
            line: 1,
            points: [x - BAR, x + BAR].map(|x| [x, ends[0], ends[1]]).to_vec(),
        }
    });
    let expected = "expected of 200,000 random lines, ± 1 deviation";
    let figure = Figure {
        x: Axis::even("grid of 6 × 6 cells: 1 best, 2 regular, 3 lines at a quarter"),
        y: Axis::even("mutual information, bits"),
        dots: vec![
            line(
                "printed",
                printed.iter().filter_map(|row| row.printed).collect(),
            ),
            line(expected, printed.iter().map(|row| row.expected).collect()),
            line(
                "exact",
                printed.iter().map(|row| row.mutual_information).collect(),
            ),
        ],
        bands: bands.collect(),
        ..Figure::default()
    };
    let caption = "Fig. 5: mutual information of three grids on the faces of a cube, as printed, \
                   as random lines estimate it, and exact.";
    Ok(BundleFigure::lines(
        "fig5",
        caption,
        Some("cube:3"),
        &figure,
    )?)
}

fn grids_by_cells(answer: &ReportAnswer) -> Result<BundleFigure, PageError> {
    let printed = printed(answer, "fig5-regular")?;
    let line = |name: &str, grids: &[crate::question::GridAnswer]| Line {
        name: name.to_owned(),
        points: grids
            .iter()
            .map(|grid| [crate::numeric::real(grid.cells), grid.mutual_information])
            .collect(),
    };
    let figure = Figure {
        x: Axis::even("cells an edge"),
        y: Axis::even("mutual information, bits"),
        lines: vec![
            line("regular grid", &answer.regular_grids),
            line("best grid", &answer.best_grids),
        ],
        marks: vec![Mark {
            is_abscissa: false,
            at: printed.0,
            name: format!("printed, regular: {}", printed.1),
        }],
        ..Figure::default()
    };
    let caption = "Fig. 5: exact mutual information of regular and best grids on the faces of a \
                   cube; no regular grid has the value printed.";
    Ok(BundleFigure::lines(
        "fig5-cells",
        caption,
        Some("cube:3"),
        &figure,
    )?)
}

fn cuts_of_section_4_2(answer: &ReportAnswer) -> Result<BundleFigure, PageError> {
    let mut figure = cuts_figure(&answer.rising_cuts);
    for (ids, name) in [
        ("s42-information-cut", "printed, mutual information"),
        ("s42-mean-square-cut", "printed, mean square error"),
    ] {
        let points = (1..=4).map(|n| {
            let printed = printed(answer, &format!("{ids}-{n}"))?;
            Ok([f64::from(n), printed.0])
        });
        figure.dots.push(Line {
            name: name.to_owned(),
            points: points.collect::<Result<_, PageError>>()?,
        });
    }
    let caption = "§4.2: the best cuts of a patch whose radiosity grows as a power, by mutual \
                   information in both readings and by mean square error.";
    Ok(BundleFigure::lines("section-4-2", caption, None, &figure)?)
}

fn abscissa(at: f64, name: &str) -> Mark {
    Mark {
        is_abscissa: true,
        at,
        name: name.to_owned(),
    }
}

fn claim<'a>(answer: &'a ReportAnswer, id: &str) -> Result<&'a ReportedClaim, PageError> {
    let mut claims = answer.claims.iter();
    let found = claims.find(|claim| claim.claim.id == id);
    found.ok_or_else(|| PageError::without("claim", id))
}

/// The number that a claim prints, and its text.
fn printed(answer: &ReportAnswer, id: &str) -> Result<(f64, String), PageError> {
    let printed = claim(answer, id)?.claim.printed.as_ref();
    let printed = printed.ok_or_else(|| PageError::without("printed number", id))?;
    Ok((printed.value, printed.text.clone()))
}

/// An input of a claim's computation.
fn input(answer: &ReportAnswer, id: &str, name: &'static str) -> Result<f64, PageError> {
    match &claim(answer, id)?.claim.task {
        Task::Compute { input, .. } => Ok(input.number(name)?),
        _ => Err(PageError::without("computation", id)),
    }
}

/// The curve of a claim.
fn curve(answer: &ReportAnswer, id: &str, name: &str) -> Result<Line, PageError> {
    let curve = answer
        .curve(id)
        .ok_or_else(|| PageError::without("curve", id))?;
    Ok(Line {
        name: name.to_owned(),
        points: curve.to_vec(),
    })
}
