//! Every verdict is computed, is the recorded one, and turns when its input is perturbed.

use infoscene::claims::{
    Claim, Evidence, Finding, Inputs, Task, Verdict, computations, judge, judge_control, registry,
};

fn computed() -> Vec<Claim> {
    let claims = registry().unwrap().into_iter();
    claims
        .filter(|claim| matches!(claim.task, Task::Compute { .. }))
        .collect()
}

#[test]
fn every_verdict_is_the_recorded_one() {
    for claim in registry().unwrap() {
        let judgement = judge(&claim).unwrap();
        assert_eq!(
            judgement.verdict,
            judgement.recorded(),
            "{}: {:?}",
            claim.id,
            judgement.finding
        );
    }
}

/// The control of each claim breaks its premise, or takes another printed number.
#[test]
fn every_verdict_turns_under_its_control() {
    for claim in computed() {
        let (plain, control) = (judge(&claim).unwrap(), judge_control(&claim).unwrap());
        assert_ne!(
            plain.verdict, control.verdict,
            "{}: {:?}",
            claim.id, control.finding
        );
    }
}

/// A printed number two units of its last decimal off is no longer supported.
#[test]
fn every_printed_number_is_compared() {
    let mut compared = 0;
    for mut claim in computed() {
        if judge(&claim).unwrap().verdict != Verdict::Supported {
            continue;
        }
        let Some(printed) = claim.printed.as_mut() else {
            continue;
        };
        compared += 1;
        printed.value += 2.0 * 0.1f64.powi(i32::try_from(printed.decimals).unwrap());
        assert_eq!(
            judge(&claim).unwrap().verdict,
            Verdict::Undecided,
            "{}",
            claim.id
        );
    }
    assert!(compared >= 11, "{compared} printed numbers are supported");
}

/// Whatever is not settled says why.
#[test]
fn every_open_verdict_has_its_reason() {
    for claim in registry().unwrap() {
        let judgement = judge(&claim).unwrap();
        let settled = matches!(judgement.verdict, Verdict::Confirmed | Verdict::Supported);
        assert!(
            settled || judgement.note().len() > 20,
            "{}: {:?}",
            claim.id,
            judgement.note()
        );
    }
}

/// Every function is used by a claim, and its input is used by the function.
#[test]
fn every_computation_has_a_claim() {
    for (name, compute) in computations() {
        let uses = |claim: &Claim| match &claim.task {
            Task::Compute { computation, .. } => computation == name,
            Task::NotChecked { .. } => false,
        };
        assert!(computed().iter().any(uses), "{name} has no claim");
        if name != "limit_of_the_discontinuity_line" {
            assert!(
                compute(&Inputs::default()).is_err(),
                "{name} ignores its input"
            );
        }
    }
}

fn example(printed: Option<&str>, complete: bool) -> Claim {
    let mut claim = computed().remove(0);
    claim.printed = printed.map(|text| infoscene::claims::Printed::parse(text).unwrap());
    claim.complete = complete;
    claim
}

/// The table of the rule, cell by cell.
#[test]
fn verdicts_follow_the_rule() {
    let with = |mut finding: Finding, evidence| {
        finding.evidence = evidence;
        finding
    };
    let number = |value, error, evidence| with(Finding::value(value, error), evidence);
    let printed = |complete| example(Some("0.40"), complete);
    let cases = [
        (
            true,
            number(0.399, 1e-3, Evidence::Estimate),
            Verdict::Supported,
        ),
        (
            true,
            number(0.399, 1e-3, Evidence::Bound),
            Verdict::Supported,
        ),
        (
            true,
            number(0.399, 1e-3, Evidence::Enclosure),
            Verdict::Confirmed,
        ),
        (
            true,
            number(0.399, 1e-3, Evidence::Proof),
            Verdict::Confirmed,
        ),
        (
            true,
            number(0.394, 2e-3, Evidence::Enclosure),
            Verdict::Undecided,
        ), // overlap
        (
            true,
            number(0.38, 1e-3, Evidence::Estimate),
            Verdict::Undecided,
        ),
        (
            true,
            number(0.38, 1e-3, Evidence::Enclosure),
            Verdict::Refuted,
        ),
        (
            false,
            number(0.38, 1e-3, Evidence::Enclosure),
            Verdict::Undecided,
        ),
    ];
    for (complete, finding, expected) in cases {
        assert_eq!(
            Verdict::of(&printed(complete), &finding),
            expected,
            "{finding:?}"
        );
    }
    let statement = |holds, evidence| with(Finding::statement(holds, 0.0, 0.0), evidence);
    let words = |complete| example(None, complete);
    let cases = [
        (true, statement(true, Evidence::Sample), Verdict::Supported),
        (true, statement(true, Evidence::Proof), Verdict::Confirmed),
        (true, statement(false, Evidence::Sample), Verdict::Undecided),
        (
            true,
            statement(false, Evidence::Enclosure),
            Verdict::Refuted,
        ),
        (
            false,
            statement(false, Evidence::Enclosure),
            Verdict::Undecided,
        ),
    ];
    for (complete, finding, expected) in cases {
        assert_eq!(
            Verdict::of(&words(complete), &finding),
            expected,
            "{finding:?}"
        );
    }
    // a number without a printed one to compare with decides nothing
    assert_eq!(
        Verdict::of(&words(true), &Finding::value(1.0, 0.0)),
        Verdict::Undecided
    );
}
