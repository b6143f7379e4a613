//! Questions about scenes: a scene may come from the program, and refusals are those of the
//! library.

use crate::support::rooms::{L, prism};
use infoscene::chain::ChainError;
use infoscene::exchange::{ExchangeError, Unheard};
use infoscene::information::OpenScene;
use infoscene::numeric::Grade;
use infoscene::question::{
    FormFactors, Light, MaterialChanges, MatrixEntries, Measure, QuestionError, Radiosity, Sample,
    SceneSource, Split,
};
use infoscene::scene::files::{NonPlanarFaces, Source, read_obj};
use infoscene::scene::{Occlusion, Scene, SceneError};

/// Three parallel squares that face each other in turn: the second hides the third from the first.
const BLOCKED: &str = "
    v 0 0 0 \n v 1 0 0 \n v 1 1 0 \n v 0 1 0
    v 0 0 1 \n v 1 0 1 \n v 1 1 1 \n v 0 1 1
    v 0 0 2 \n v 1 0 2 \n v 1 1 2 \n v 0 1 2
    f 1 2 3 4 \n f 5 8 7 6 \n f 9 12 11 10
";

fn blocked() -> Scene {
    let source = Source::new("blocked.obj", BLOCKED);
    let no_materials = |_: &str| Ok(Source::new("none.mtl", ""));
    let loaded = read_obj(&source, &no_materials, NonPlanarFaces::Refuse);
    loaded.unwrap().scene
}

fn is_blocked(error: &QuestionError) -> bool {
    let scene = match error {
        QuestionError::Scene(scene) | QuestionError::Exchange(ExchangeError::Scene(scene)) => scene,
        _ => return false,
    };
    matches!(scene, SceneError::MayBeBlocked { .. })
}

/// The third square sees nothing of the first: exactly nothing, unless occlusion is ignored or
/// refused.
#[test]
fn a_blocked_scene_is_answered_past_what_stands_between() {
    let mut measure = Measure {
        scene: blocked().into(),
        open_scene: OpenScene::AddOutsideState,
        ..Measure::default()
    };
    let past = measure.ask(&Unheard).unwrap();
    assert_eq!(past.plan.occlusion.unwrap().hidden, 1);
    assert!(past.notes.is_empty(), "{:?}", past.notes);
    // Howell, C-11: parallel unit squares at distance 1, and nothing else
    assert!((past.contributions[0].row_sum - 0.199_824_895_698_387).abs() < 1e-14);
    assert_eq!(past.contributions[2].row_sum, 0.0);
    measure.scene.occlusion = Occlusion::Ignore;
    let bare = measure.ask(&Unheard).unwrap();
    assert_eq!(bare.plan.ignored.unwrap().pairs, 1);
    assert!(
        bare.notes[0].starts_with("something stands between 1 pairs"),
        "{:?}",
        bare.notes
    );
    measure.scene.occlusion = Occlusion::Refuse;
    assert!(is_blocked(&measure.ask(&Unheard).unwrap_err()));
    measure.scene.occlusion = Occlusion::Exact;
    measure.continuous = true;
    // open: a chord has two ends
    let refused = measure.ask(&Unheard).unwrap_err();
    let QuestionError::Chain(ChainError::Exchange(ExchangeError::LinesEscape { .. })) = refused
    else {
        panic!("{refused:?}");
    };
    measure.pairs = true;
    assert!(is_blocked(&measure.ask(&Unheard).unwrap_err()));
    let hidden = FormFactors {
        scene: blocked().into(),
        from: Some(0.into()),
        to: Some(2.into()),
        ..FormFactors::default()
    };
    let hidden = hidden.ask(&Unheard).unwrap();
    let record = hidden.records().next().unwrap();
    assert_eq!(
        (record.route, record.value, record.error),
        ("hidden", 0.0, 0.0)
    );
    let radiosity = Radiosity {
        scene: blocked().into(),
        materials: MaterialChanges {
            reflectance: vec!["all=0.5".parse().unwrap()],
            emittance: vec!["all=0".parse().unwrap(), "face 0=1".parse().unwrap()],
        },
        ..Radiosity::default()
    };
    let lit = radiosity.ask(&Unheard).unwrap();
    assert_eq!(lit.patches[2].radiosity, 0.0);
}

/// Past what stands in the way the continuous mutual information is that of chords, and it is not
/// below the discrete one of any mesh.
#[test]
fn the_continuous_one_is_sampled_where_something_stands_in_the_way() {
    let measured = |scene: Scene| {
        let question = Measure {
            scene: scene.into(),
            continuous: true,
            tolerance: 1e-6.into(),
            ..Measure::default()
        };
        question.ask(&Unheard).unwrap()
    };
    let coarse = measured(prism(&L));
    let fine = measured(prism(&L).subdivided(1).unwrap().0);
    for answer in [&coarse, &fine] {
        let value = answer.continuous_mutual_information.unwrap();
        let error = answer.continuous_error.unwrap();
        assert_eq!(answer.continuous_error_grade, Some(Grade::Sample));
        assert_eq!(answer.continuous_lines, Some(1_000_000));
        assert!(error > 0.0 && error < 0.01, "{error}");
        let lower = answer.continuous_lower_bound.unwrap();
        assert!((lower - answer.mutual_information).abs() < 1e-3);
        assert!(
            value + 5.0 * error > lower,
            "{value} ± {error}, at least {lower}"
        );
    }
    // the same room: the lines differ, as patches are drawn in another order
    let [one, other] = [&coarse, &fine].map(|answer| answer.continuous_mutual_information);
    let apart = (one.unwrap() - other.unwrap()).abs();
    assert!(
        apart < 5.0 * 2.0 * coarse.continuous_error.unwrap(),
        "{apart}"
    );
    assert!(coarse.continuous_lower_bound < fine.continuous_lower_bound);
}

#[test]
fn a_scene_made_in_the_program_is_answered_as_its_name_is() {
    let made = || SceneSource::from(Scene::built_in("cube:2").unwrap());
    let named = || SceneSource::from("cube:2");
    let measured = [made(), named()].map(|scene| {
        let question = Measure {
            scene,
            continuous: true,
            ..Measure::default()
        };
        question.ask(&Unheard).unwrap()
    });
    assert_eq!(measured[0], measured[1]);
    let cut = [made(), named()].map(|scene| {
        let question = Split {
            scene,
            ..Split::default()
        };
        question.ask(&Unheard).unwrap()
    });
    assert_eq!(cut[0], cut[1]);
}

#[test]
fn light_is_refused_for_the_chain_that_has_none() {
    let lamp = Light {
        materials: MaterialChanges {
            emittance: vec!["0".parse().unwrap()],
            ..MaterialChanges::default()
        },
        ..Light::default()
    };
    let measure = Measure {
        scene: "cube:1".into(),
        light: lamp,
        ..Measure::default()
    };
    let refused = measure.ask(&Unheard).unwrap_err();
    assert!(matches!(refused, QuestionError::NoLightMeant));
}

#[test]
fn an_open_scene_is_refused_by_row_and_taken_with_a_state_outside() {
    let mut measure = Measure {
        scene: "two-squares".into(),
        ..Measure::default()
    };
    let refused = measure.ask(&Unheard).unwrap_err();
    let QuestionError::OpenScene(ExchangeError::OpenScene { row, sum, .. }) = refused else {
        panic!("{refused}");
    };
    // Howell, C-14: unit squares with a common edge
    assert_eq!(row, 0);
    assert!((sum - 0.200_043_776_075_4).abs() < 1e-12);
    measure.open_scene = OpenScene::AddOutsideState;
    assert!(
        measure
            .ask(&Unheard)
            .unwrap()
            .outside_contribution
            .is_some()
    );
}

#[test]
fn a_matrix_has_the_form_factors_of_the_records_and_comes_only_if_asked_for() {
    let mut question = FormFactors {
        scene: "cube:2".into(),
        from: Some(0.into()),
        ..FormFactors::default()
    };
    assert!(question.ask(&Unheard).unwrap().matrix().is_none());
    question.matrix = true;
    let answer = question.ask(&Unheard).unwrap();
    let mut first = Vec::new();
    let matrix = answer.matrix().unwrap();
    let unreached = matrix.for_each_line(|line| {
        if line.index() == 0 {
            first = line.row(MatrixEntries::FormFactors).collect();
        }
        Ok::<(), ExchangeError>(())
    });
    assert_eq!(unreached.unwrap(), None);
    for record in answer.records() {
        assert_eq!(record.value, first[record.to]);
    }
    // a closed room: the row sums to one
    assert!((first.iter().sum::<f64>() - 1.0).abs() < 1e-12);
}

#[test]
fn exact_values_stand_beside_a_sample_only_if_asked_for() {
    let mut sample = Sample {
        scene: "cube:1".into(),
        lines: 1000,
        ..Sample::default()
    };
    let without = sample.ask(&Unheard).unwrap().sampled;
    assert_eq!(without.exact_mutual_information, None);
    sample.exact = true;
    let exact = sample.ask(&Unheard).unwrap().sampled;
    // one patch per face, from a 50-digit evaluation
    let information = exact.exact_mutual_information.unwrap();
    assert!((information - 0.263_034_544_099_12).abs() < 1e-14);
    assert_eq!(exact.corrected, without.corrected);
    sample.scene.occlusion = Occlusion::Ignore;
    let refused = sample.ask(&Unheard).unwrap_err();
    assert!(matches!(refused, QuestionError::OccludedLines));
}
