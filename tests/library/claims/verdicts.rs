//! Every verdict is computed, is the recorded one, and turns when its input is perturbed.

use super::{AGAIN, CONTEXT, JUDGEMENTS};
use infoscene::claims::{
    Case, Claim, Computation, Context, Control, Finding, Inputs, Judgement, Printed, Task, Verdict,
    judge_control, registry,
};
use infoscene::numeric::{Grade, Interval};

fn computed() -> Vec<Claim> {
    let claims = registry().unwrap().into_iter();
    claims
        .filter(|claim| matches!(claim.task, Task::Compute { .. }))
        .collect()
}

#[test]
fn every_verdict_is_the_recorded_one() {
    for judgement in JUDGEMENTS.iter() {
        assert_eq!(
            judgement.verdict,
            judgement.recorded(),
            "{}: {:?}",
            judgement.claim.id,
            judgement.finding
        );
    }
}

/// Whether a control turned a verdict: both by computation, as theorems say nothing of controls.
fn is_turned(plain: &Judgement, control: &Judgement) -> bool {
    plain.by_computation() != control.by_computation()
}

/// The control of each claim breaks its premise, or takes another printed number.
#[test]
fn every_verdict_turns_under_its_control() {
    let mut idle = Vec::new();
    for plain in JUDGEMENTS.iter() {
        if let Task::Compute { .. } = plain.claim.task {
            let control = judge_control(&plain.claim, &CONTEXT).unwrap();
            assert!(!control.is_proved, "{}", plain.claim.id);
            if !is_turned(plain, &control) {
                idle.push(format!("{}: {:?}", plain.claim.id, control.finding));
            }
        }
    }
    assert!(idle.is_empty(), "idle controls:\n{}", idle.join("\n"));
}

/// A control that changes nothing is a second run, which turns nothing, whatever theorems a claim
/// names.
#[test]
fn a_control_that_changes_nothing_turns_no_verdict() {
    for (plain, idle) in JUDGEMENTS.iter().zip(AGAIN.iter()) {
        assert!(!is_turned(plain, idle), "{}", plain.claim.id);
        let Task::Compute { input, .. } = &plain.claim.task else {
            continue;
        };
        assert_eq!(*input, input.changed_by(&Inputs::default()));
    }
    // the first claim with a theorem, by the very road of the other controls
    let mut claim = JUDGEMENTS
        .iter()
        .find(|j| j.is_proved)
        .unwrap()
        .claim
        .clone();
    if let Task::Compute { control, .. } = &mut claim.task {
        *control = Control::default();
    }
    let idle = judge_control(&claim, &CONTEXT).unwrap();
    assert!(
        !idle.is_proved && idle.verdict == Verdict::Supported,
        "{idle:?}"
    );
}

/// Fig. 5: no regular grid of any number of cells has the printed value. From 448 cells on the
/// chain rule decides, so that thinning up to a thousand leaves none out.
#[test]
#[ignore = "eighty grids of intervals: \
            cargo test --release --test library no_regular_grid -- --ignored"]
fn no_regular_grid_of_any_size_has_the_printed_value() {
    let mut claim = JUDGEMENTS
        .iter()
        .find(|j| j.claim.id == "fig5-regular")
        .unwrap()
        .claim
        .clone();
    if let Task::Compute { control, .. } = &mut claim.task {
        *control = Control {
            inputs: serde_json::from_str(r#"{"thinned_up_to": 1000}"#).unwrap(),
            printed: None,
        };
    }
    let judgement = judge_control(&claim, &CONTEXT).unwrap();
    assert_eq!(judgement.verdict, Verdict::Refuted, "{judgement:?}");
}

/// A claim says in its data if its computation can decide to one side only.
#[test]
fn one_sided_computations_are_where_the_data_say() {
    let mut wrong = Vec::new();
    for judgement in JUDGEMENTS.iter() {
        let Task::Compute { can_only, .. } = &judgement.claim.task else {
            continue;
        };
        let found = judgement.one_sided();
        if found != *can_only {
            wrong.push(format!("{}: {found:?}", judgement.claim.id));
        }
    }
    assert!(wrong.is_empty(), "can_only should be\n{}", wrong.join("\n"));
}

/// A statement of several parts stands and falls with them.
#[test]
fn a_conjunction_is_settled_as_its_least_settled_part() {
    use Verdict::{Confirmed, NotChecked, Refuted, Supported, Undecided};
    for (parts, whole) in [
        (vec![Confirmed, Confirmed], Confirmed),
        (vec![Confirmed, Supported], Supported),
        (vec![Supported, Undecided], Undecided),
        (vec![Undecided, NotChecked], NotChecked),
        (vec![NotChecked, Confirmed, Refuted], Refuted),
    ] {
        assert_eq!(Verdict::of_all(&parts), whole, "{parts:?}");
    }
    let conjunctions = JUDGEMENTS.iter().filter(|j| !j.members.is_empty());
    for judgement in conjunctions {
        let parts: Vec<Verdict> = judgement.members.iter().map(|part| part.verdict).collect();
        assert!(parts.len() > 1, "{}", judgement.claim.id);
        assert_eq!(judgement.verdict, Verdict::of_all(&parts));
    }
}

/// Every claim is judged.
#[test]
fn nothing_is_left_unchecked() {
    let open = JUDGEMENTS
        .iter()
        .filter(|j| j.verdict == Verdict::NotChecked);
    let open: Vec<&str> = open.map(|judgement| judgement.claim.id.as_str()).collect();
    assert_eq!(open, [""; 0]);
}

/// A printed number two units of its last decimal off is refuted, or undecided where the paper
/// leaves its configuration open.
#[test]
fn every_printed_number_is_compared() {
    let mut compared = 0;
    for judgement in JUDGEMENTS.iter() {
        let (Some(printed), Some(finding)) = (&judgement.claim.printed, &judgement.finding) else {
            continue;
        };
        if judgement.verdict != Verdict::Confirmed {
            continue;
        }
        compared += 1;
        let decimals = usize::try_from(printed.decimals).unwrap();
        let moved = printed.value + 2.0 * 0.1f64.powi(i32::try_from(decimals).unwrap());
        let mut claim = judgement.claim.clone();
        claim.printed = Printed::parse(&format!("{moved:.decimals$}"));
        let expected = if claim.complete {
            Verdict::Refuted
        } else {
            Verdict::Undecided
        };
        assert_eq!(Verdict::of(&claim, finding), expected, "{}", claim.id);
    }
    assert!(compared >= 11, "{compared} printed numbers are confirmed");
}

/// Whatever is not settled says why.
#[test]
fn every_open_verdict_has_its_reason() {
    for judgement in JUDGEMENTS.iter() {
        let settled = matches!(judgement.verdict, Verdict::Confirmed | Verdict::Supported);
        assert!(
            settled || judgement.note().len() > 20,
            "{}: {:?}",
            judgement.claim.id,
            judgement.note()
        );
    }
}

/// A claim says in its data whether it has a curve.
#[test]
fn curves_are_where_the_data_say() {
    for judgement in JUDGEMENTS.iter() {
        let has_curve = judgement
            .finding
            .as_ref()
            .is_some_and(|finding| !finding.curve.is_empty());
        assert_eq!(
            judgement.claim.curve_axes.is_some(),
            has_curve,
            "{}",
            judgement.claim.id
        );
    }
}

/// Every computation is used by a claim, and refuses to go without its input.
#[test]
fn every_computation_has_a_claim() {
    let context = Context::default();
    let nothing = Case::new(Inputs::default(), &context);
    for computation in Computation::ALL {
        let uses = |claim: &Claim| match &claim.task {
            Task::Compute {
                computation: used, ..
            } => used == computation,
            Task::Proved { .. } | Task::NotChecked { .. } | Task::AllOf { .. } => false,
        };
        let name = computation.name();
        assert!(computed().iter().any(uses), "{name} has no claim");
        assert!(
            computation.compute(&nothing).is_err(),
            "{name} ignores its input"
        );
    }
}

/// The first computed claim, with or without a printed number, of a complete or an open
/// configuration.
fn example(printed: Option<&str>, complete: bool) -> Claim {
    let mut claim = computed().remove(0);
    claim.printed = printed.map(|text| Printed::parse(text).unwrap());
    claim.complete = complete;
    claim
}

const COMPLETE: bool = true;
const OPEN: bool = false;

/// A number beside the printed 0.40, which stands for [0.395, 0.405]: value, error, evidence,
/// verdict.
const NUMBERS: [(bool, f64, f64, Grade, Verdict); 8] = [
    (COMPLETE, 0.399, 1e-3, Grade::Estimate, Verdict::Supported),
    (COMPLETE, 0.399, 1e-3, Grade::Bound, Verdict::Supported),
    (COMPLETE, 0.399, 1e-3, Grade::Enclosure, Verdict::Confirmed),
    (COMPLETE, 0.399, 1e-3, Grade::Proof, Verdict::Confirmed),
    // it overlaps
    (COMPLETE, 0.394, 2e-3, Grade::Enclosure, Verdict::Undecided),
    (COMPLETE, 0.38, 1e-3, Grade::Estimate, Verdict::Undecided),
    (COMPLETE, 0.38, 1e-3, Grade::Enclosure, Verdict::Refuted),
    (OPEN, 0.38, 1e-3, Grade::Enclosure, Verdict::Undecided),
];

#[test]
fn a_number_is_judged_by_its_evidence() {
    for (complete, value, error, evidence, verdict) in NUMBERS {
        let mut finding = Finding::value(value, error);
        finding.grade = evidence;
        let found = Verdict::of(&example(Some("0.40"), complete), &finding);
        assert_eq!(found, verdict, "{complete} {finding:?}");
    }
}

/// A statement in words: whether it holds, evidence, verdict.
const STATEMENTS: [(bool, bool, Grade, Verdict); 5] = [
    (COMPLETE, true, Grade::Sample, Verdict::Supported),
    (COMPLETE, true, Grade::Proof, Verdict::Confirmed),
    (COMPLETE, false, Grade::Sample, Verdict::Undecided),
    (COMPLETE, false, Grade::Enclosure, Verdict::Refuted),
    (OPEN, false, Grade::Enclosure, Verdict::Undecided),
];

#[test]
fn a_statement_is_judged_by_its_evidence() {
    for (complete, holds, evidence, verdict) in STATEMENTS {
        let mut finding = Finding::statement(holds, 0.0, 0.0);
        finding.grade = evidence;
        let found = Verdict::of(&example(None, complete), &finding);
        assert_eq!(found, verdict, "{complete} {finding:?}");
    }
}

/// Cases that doubles could not decide: the end of [0.395, 0.405] itself, 1e-26 inside of it, and a
/// third.
#[test]
fn enclosures_are_compared_with_the_exact_decimal_ends() {
    let third = Interval::precise(1.0, 128) / Interval::precise(3.0, 128);
    let parsed = |text| Interval::parse(text, 128).unwrap();
    for (enclosure, verdict) in [
        (parsed("0.395"), Verdict::Undecided),
        (parsed("0.39500000000000000000000001"), Verdict::Confirmed),
        (third, Verdict::Refuted),
    ] {
        let finding = Finding::enclosed(enclosure);
        let found = Verdict::of(&example(Some("0.40"), COMPLETE), &finding);
        assert_eq!(found, verdict, "{finding:?}");
    }
}

#[test]
fn a_number_without_a_printed_one_decides_nothing() {
    let found = Verdict::of(&example(None, COMPLETE), &Finding::value(1.0, 0.0));
    assert_eq!(found, Verdict::Undecided);
}

/// The grades are ordered as listed, and JSON has their names.
#[test]
fn grades_rise_and_are_written_by_name() {
    assert!(Grade::ALL.windows(2).all(|pair| pair[0] < pair[1]));
    let words = ["sample", "estimate", "bound", "enclosure", "proof"];
    for (grade, word) in Grade::ALL.into_iter().zip(words) {
        assert_eq!(grade.name(), word);
        assert_eq!(serde_json::to_value(grade).unwrap(), word);
    }
}
