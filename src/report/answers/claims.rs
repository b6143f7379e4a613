//! The verdict table: what the paper says, what was computed, and what it comes to.

use crate::claims::{Theorem, Verdict};
use crate::numeric::Grade;
use crate::question::{CurveAnswer, CurvePoint, JudgedClaim, ReproduceAnswer};
use crate::report::{
    Axis, Figure, Line, Report, ReportError, Table, certain_digits, enclosed_digits, power_of_ten,
    scientific,
};

/// The answer to [`Reproduce`](crate::question::Reproduce): the verdict table of the claims, in
/// their order, with a note for each that is neither confirmed nor supported or rests on paper
/// beside its theorems, and a count. Of one claim alone the theorems that prove it are written out.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn reproduction_report(answer: &ReproduceAnswer) -> Result<Report, ReportError> {
    let table = Table {
        columns: vec![
            "id",
            "paper says",
            "computed",
            "certified ±",
            "evidence",
            "verdict",
        ],
        rows: answer.claims.iter().map(row).collect(),
        wrapped: Some(1),
        notes: notes(&answer.claims),
    };
    Report::list(table, "claims", &answer.claims)
}

fn notes(claims: &[JudgedClaim]) -> Vec<(String, String)> {
    let mut notes: Vec<(String, String)> = Vec::new();
    // of one claim alone there is room to say what is proved
    if let [claim] = claims {
        notes.extend(claim.proof.iter().map(theorem_in_full));
    }
    let settled = |c: &&JudgedClaim| matches!(c.verdict, Verdict::Confirmed | Verdict::Supported);
    for claim in claims.iter().filter(|claim| !settled(claim)) {
        note(&mut notes, words(claim.verdict), claim, &claim.note);
    }
    for claim in claims {
        if let Some(text) = &claim.on_paper {
            note(&mut notes, "on paper only".to_owned(), claim, text);
        }
    }
    for claim in claims
        .iter()
        .filter(|claim| claim.verdict != claim.recorded)
    {
        let recorded = claim.recorded.name();
        let text = format!("this run differs from the verdict on record, {recorded}");
        notes.push((claim.id.clone(), text));
    }
    let counts = Verdict::ALL.into_iter().filter_map(|verdict| {
        let of_verdict = claims.iter().filter(|claim| claim.verdict == verdict);
        let count = of_verdict.count();
        (count > 0).then(|| format!("{count} {}", words(verdict)))
    });
    let counts: Vec<String> = counts.collect();
    notes.push((format!("{} claims", claims.len()), counts.join(", ")));
    notes
}

/// Adds a note on a claim; claims of which the same is said share it.
fn note(notes: &mut Vec<(String, String)>, name: String, claim: &JudgedClaim, text: &str) {
    match notes.iter_mut().find(|(_, note)| note == text) {
        Some((names, _)) => *names += &format!(", {}", claim.id),
        None => notes.push((format!("{name}, {}", claim.id), text.to_owned())),
    }
}

/// A theorem in words, and as Coq states it.
fn theorem_in_full(theorem: &Theorem) -> (String, String) {
    let mut text = theorem.says.clone();
    for given in &theorem.hypotheses {
        text += &format!("; given {given}");
    }
    text += &format!("; then {}", theorem.conclusion);
    (format!("theorem {}", theorem.name), text)
}

fn words(verdict: Verdict) -> String {
    verdict.name().replace('_', " ")
}

fn row(claim: &JudgedClaim) -> Vec<String> {
    let printed = claim.printed_text.as_ref();
    let printed = printed.map_or_else(String::new, |text| format!(": {text}"));
    let says = format!("{}: {}{printed}", claim.place, claim.quantity);
    let evidence = claim.evidence.map_or("", Grade::name).to_owned();
    let [computed, error] = number_and_error(claim);
    vec![
        claim.id.clone(),
        says,
        computed,
        error,
        evidence,
        words(claim.verdict),
    ]
}

/// The number with the digits that are certain, and its error.
pub(crate) fn number_and_error(claim: &JudgedClaim) -> [String; 2] {
    let (Some(value), Some(error)) = (claim.computed, claim.error) else {
        return ["", ""].map(str::to_owned);
    };
    match &claim.enclosure {
        Some(enclosure) if enclosure.is_point() => [enclosed_digits(enclosure), "exact".to_owned()],
        Some(enclosure) => [
            enclosed_digits(enclosure),
            power_of_ten(0.5 * enclosure.width()),
        ],
        None if error > 0.0 => [
            certain_digits(value, error),
            format!("({})", scientific(error)),
        ],
        None => [certain_digits(value, error), "exact".to_owned()],
    }
}

/// The number with the digits that are certain, and its certainty in words; both empty for a claim
/// in words.
pub(crate) fn number_and_certainty(claim: &JudgedClaim) -> [String; 2] {
    let [number, error] = number_and_error(claim);
    let certainty = match error.strip_prefix('(').and_then(|e| e.strip_suffix(')')) {
        Some(stated) => format!("± {stated}, not certified"),
        None if error == "exact" => "exactly".to_owned(),
        None if error.is_empty() => error,
        None => format!("± {error}"),
    };
    [number, certainty]
}

/// The answer to [`Curve`](crate::question::Curve): its points.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn curve_report(answer: &CurveAnswer) -> Result<Report, ReportError> {
    let row = |point: &CurvePoint| {
        vec![
            format!("{}", point.x),
            certain_digits(point.y, 1e-13 * point.y.abs()),
        ]
    };
    let table = Table {
        columns: vec!["x", "y"],
        rows: answer.points.iter().map(row).collect(),
        ..Table::default()
    };
    Report::list(table, "points", &answer.points)
}

/// The figure of the curve, with the labels of its axes.
#[must_use]
pub fn curve_figure(answer: &CurveAnswer) -> Figure {
    let [x, y] = answer.axes.each_ref().map(|label| Axis {
        label: label.clone(),
        is_logarithmic: false,
    });
    let points = answer.points.iter();
    let line = Line {
        name: "the curve".to_owned(),
        points: points.map(|point| [point.x, point.y]).collect(),
    };
    Figure {
        x,
        y,
        lines: vec![line],
        ..Figure::default()
    }
}
