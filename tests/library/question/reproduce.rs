//! The questions for verdicts and curves.

use infoscene::claims::Verdict;
use infoscene::exchange::Unheard;
use infoscene::question::{Curve, QuestionError, Reproduce};
use infoscene::report::{Format, reproduction_report};
use serde_json::Value;
use std::sync::atomic::{AtomicUsize, Ordering};

fn claims(ids: &[&str]) -> Reproduce {
    Reproduce {
        claims: ids.iter().map(|id| (*id).to_owned()).collect(),
        ..Reproduce::default()
    }
}

/// `split_perp_par_bothdepth1_t` of `data/reference/splits.csv`, computed at 45 digits.
const FIGURE_2: &str = "0.3992010260453851252112455969";

#[test]
fn an_enclosed_claim_has_every_certified_digit() {
    let answer = claims(&["fig2-parallel-cut"]).ask(&Unheard).unwrap();
    let claim = &answer.claims[0];
    let [lower, upper] = [&claim.lower, &claim.upper].map(|end| end.as_deref().unwrap());
    assert!(lower.len() > 50, "{lower}");
    assert_eq!(&lower[..50], &upper[..50]);
    // the reference is rounded in its last digit
    assert!(
        lower.starts_with(&FIGURE_2[..FIGURE_2.len() - 2]),
        "{lower}"
    );
}

/// The JSON of a report is the record of its answer, every key and digit of it.
#[test]
fn the_record_of_verdicts_is_their_json() {
    let ids = ["fig2-parallel-cut", "theorem-1", "fig2-curve"];
    let answer = claims(&ids).ask(&Unheard).unwrap();
    let report = reproduction_report(&answer).unwrap();
    let printed: Value = serde_json::from_str(&report.render(Format::Json).unwrap()).unwrap();
    assert_eq!(printed, serde_json::to_value(&answer).unwrap());
}

#[test]
fn a_verdict_beside_the_record_is_noticed() {
    let mut answer = claims(&["theorem-1"]).ask(&Unheard).unwrap();
    assert!(answer.is_as_recorded());
    answer.claims[0].verdict = Verdict::Refuted;
    assert!(!answer.is_as_recorded());
}

#[test]
fn progress_advances_with_each_claim() {
    let heard = AtomicUsize::new(0);
    let listener = |finished: usize| {
        heard.fetch_add(finished, Ordering::Relaxed);
    };
    let ids = ["fig2-parallel-cut", "theorem-1"];
    claims(&ids).ask(&listener).unwrap();
    assert_eq!(heard.into_inner(), 2);
}

#[test]
fn a_claim_in_words_is_not_among_the_printed_ones() {
    let printed = |ids: &[&str]| Reproduce {
        printed_only: true,
        ..claims(ids)
    };
    let both = printed(&["theorem-1", "fig2-parallel-cut"]).selection();
    let left: Vec<String> = both.unwrap().into_iter().map(|claim| claim.id).collect();
    assert_eq!(left, ["fig2-parallel-cut"]);
    let error = printed(&["theorem-1"]).selection().unwrap_err();
    let QuestionError::NonePrinted { ids } = error else {
        panic!("{error}");
    };
    assert_eq!(ids, ["theorem-1"]);
}

#[test]
fn a_claim_without_a_curve_names_those_with_one() {
    let claim = "theorem-1".to_owned();
    let error = Curve { claim }.ask(&Unheard).unwrap_err();
    let QuestionError::NoCurve { id, with_curve } = error else {
        panic!("{error}");
    };
    assert_eq!(id, "theorem-1");
    assert!(
        with_curve.contains(&"fig2-curve".to_owned()),
        "{with_curve:?}"
    );
}
