//! The table of a scene's state.

use crate::question::{CheckAnswer, PatchMark};
use crate::report::{Report, ReportError, Table, scientific};

/// Renders the state of a scene.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn check_report(answer: &CheckAnswer) -> Result<Report, ReportError> {
    let table = Table {
        columns: vec!["question", "answer"],
        rows: lines(answer)
            .into_iter()
            .map(|(question, text)| vec![question.to_owned(), text])
            .collect(),
        notes: notes(answer),
        ..Table::default()
    };
    Report::one(table, answer)
}

fn lines(answer: &CheckAnswer) -> Vec<(&'static str, String)> {
    let surfaces = match answer.obstructions {
        0 => answer.patches.to_string(),
        more => format!("{}, and {more} surfaces that only obstruct", answer.patches),
    };
    let point = |[x, y, z]: [f64; 3]| format!("({x}, {y}, {z})");
    let [one, other] = [answer.low, answer.high].map(point);
    let fronts = if answer.turned_away {
        "all outside: no patch faces another one".to_owned()
    } else if answer.turned_neighbours > 0 {
        format!("{} neighbours disagree", answer.turned_neighbours)
    } else {
        "agree along all edges that two patches share".to_owned()
    };
    let closes = match answer.volume {
        Some(volume) => format!("yes: no edge is free; volume {}", volume.abs()),
        None => format!(
            "no: {} free edges, {:.6} long together",
            answer.free_edges, answer.free_length
        ),
    };
    let pair = |[one, other]: &[PatchMark; 2]| format!("{} and {}", mark(one), mark(other));
    let overlap = answer.overlap.as_ref().map(pair);
    let blocked = answer.blocked.as_ref();
    let blocked =
        blocked.map(|found| format!("{}: {} stands between", pair(&found.patches), found.by));
    let mut lines = vec![
        ("patches", surfaces),
        ("rows", answer.rows.to_string()),
        ("total area", answer.total_area.to_string()),
        ("from", one),
        ("to", other),
        ("planes", answer.planes.to_string()),
        (
            "places closer than this count as one",
            scientific(answer.noise),
        ),
        ("fronts", fronts),
        ("closes", closes),
        ("overlap", overlap.unwrap_or_else(|| "none".to_owned())),
        ("occlusion", blocked.unwrap_or_else(|| "none".to_owned())),
    ];
    lines.retain(|(question, _)| *question != "rows" || answer.rows != answer.patches);
    lines
}

fn mark(patch: &PatchMark) -> String {
    format!("{} ({})", patch.index, patch.name)
}

fn notes(answer: &CheckAnswer) -> Vec<(String, String)> {
    let free = answer.longest_free_edges.iter().map(|edge| {
        let point = |[x, y, z]: [f64; 3]| format!("({x}, {y}, {z})");
        let text = format!(
            "{} from {} to {}",
            mark(&edge.patch),
            point(edge.from),
            point(edge.to)
        );
        ("free edge".to_owned(), text)
    });
    let turned = answer.first_turned_neighbours.iter().map(|[one, other]| {
        let text = format!(
            "{} and {} run along their edge the same way",
            mark(one),
            mark(other)
        );
        ("fronts".to_owned(), text)
    });
    free.chain(turned).collect()
}
