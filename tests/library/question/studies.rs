//! The questions for studies and for counterexamples.

use infoscene::exchange::Unheard;
use infoscene::question::{Study, StudyAnswer, StudySubject};
use infoscene::report::{Format, study_figure, study_report};
use serde_json::Value;

fn rows(subject: StudySubject) -> StudyAnswer {
    let quick = true;
    Study { subject, quick }.ask(&Unheard).unwrap()
}

/// The JSON of a report is the record of its answer, every key and digit of it, and begins with
/// the name of the study.
#[test]
fn the_record_of_a_study_is_its_json() {
    for (subject, name) in [
        (StudySubject::Profiles, "profiles"),
        (StudySubject::Directions, "directions"),
        (StudySubject::Walks, "walks"),
    ] {
        let answer = rows(subject);
        let report = study_report(&answer).unwrap();
        let printed: Value = serde_json::from_str(&report.render(Format::Json).unwrap()).unwrap();
        assert_eq!(printed, serde_json::to_value(&answer).unwrap());
        assert_eq!(printed["study"], name);
        assert!(study_figure(&answer).is_none());
    }
}

/// The mean-square cut of a bump in the middle has a twin by symmetry, and a rising profile has
/// one best cut only.
#[test]
fn only_cuts_of_symmetric_profiles_have_twins() {
    let StudyAnswer::Profiles(rows) = rows(StudySubject::Profiles) else {
        panic!("these are rows of another study");
    };
    for row in &rows {
        let is_symmetric = row.case.starts_with("bump at 0.5,");
        assert_eq!(row.has_twin, is_symmetric, "{}", row.case);
    }
    let methods: Vec<&str> = rows.iter().map(|row| row.method).collect();
    assert!(
        methods
            .chunks(2)
            .all(|both| both == ["mutual information", "mean square"])
    );
}

#[cfg(feature = "proptest")]
mod fuzzing {
    use super::{Format, Unheard, Value};
    use infoscene::question::{Fuzz, QuestionError};
    use infoscene::report::fuzz_report;
    use infoscene::study::gain::fuzz::Sabotage;

    #[test]
    fn a_broken_hypothesis_is_answered_by_a_counterexample() {
        let sound = Fuzz {
            cases: 50,
            ..Fuzz::default()
        };
        assert!(sound.ask(&Unheard).unwrap().counterexamples.is_empty());
        let broken = Fuzz {
            sabotage: Some(Sabotage::Covering),
            ..sound
        };
        let answer = broken.ask(&Unheard).unwrap();
        assert!(!answer.counterexamples.is_empty());
        let json = fuzz_report(&answer).unwrap().render(Format::Json).unwrap();
        let printed: Value = serde_json::from_str(&json).unwrap();
        assert_eq!(printed, serde_json::to_value(&answer).unwrap());
    }

    #[test]
    fn chains_of_one_state_are_refused() {
        for states in [1, 65] {
            let question = Fuzz {
                states,
                ..Fuzz::default()
            };
            let error = question.ask(&Unheard).unwrap_err();
            let QuestionError::StatesOutOfRange { states: named, .. } = error else {
                panic!("{error}");
            };
            assert_eq!(named, states);
        }
    }
}
