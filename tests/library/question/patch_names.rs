//! Names for patches, wherever an index does.

use infoscene::exchange::Unheard;
use infoscene::question::{FormFactors, PatchName, PatchNameError, QuestionError, Split};
use infoscene::scene::Scene;

fn rows(scene: &Scene, name: &str) -> Result<Vec<usize>, PatchNameError> {
    PatchName::from(name).rows(scene)
}

#[test]
fn a_name_means_all_pieces_of_what_has_it() {
    let cube = Scene::built_in("cube:2").unwrap();
    assert_eq!(rows(&cube, "floor").unwrap(), [0, 1, 2, 3]);
    assert_eq!(rows(&cube, " floor 1,0 ").unwrap(), [2]);
    assert_eq!(rows(&cube, "5").unwrap(), [5]);
    assert_eq!(rows(&cube, "all").unwrap().len(), 24);
    // of what is quartered, and quartered again
    let (finer, _) = cube.subdivided(2).unwrap();
    assert_eq!(rows(&finer, "floor").unwrap(), (0..64).collect::<Vec<_>>());
    assert_eq!(
        rows(&finer, "floor 0,1").unwrap(),
        (16..32).collect::<Vec<_>>()
    );
}

#[test]
fn a_name_that_nothing_has_is_refused_with_the_one_most_like_it() {
    let cube = Scene::built_in("cube:1").unwrap();
    for (name, meant) in [
        ("ceilling 0,0", Some("ceiling 0,0")),
        ("CEILING", Some("ceiling")),
        ("lfet", Some("left")),
        ("window", None),
        ("6", None),
        ("", None),
    ] {
        let PatchNameError::NoSuchPatch { similar, last, .. } = rows(&cube, name).unwrap_err()
        else {
            panic!("{name}");
        };
        assert_eq!((similar.as_deref(), last), (meant, 5), "{name}");
    }
}

/// The form factor of opposite faces, Howell C-11 with X = Y = 1, is that of all their parts
/// together.
#[test]
fn form_factors_and_cuts_take_names() {
    let question = FormFactors {
        scene: "cube:2".into(),
        from: Some("floor".into()),
        to: Some("ceiling".into()),
        ..FormFactors::default()
    };
    let answer = question.ask(&Unheard).unwrap();
    let sum: f64 = answer.records().map(|record| record.value).sum();
    assert_eq!(answer.records().count(), 16);
    assert!((sum / 4.0 - 0.199_824_895_698_387_4).abs() < 1e-14);
    // a third of the room's area, cut against all others: itself is left out
    let cut = |patch: &str, against: &str| {
        let question = Split {
            scene: "two-squares".into(),
            patch: patch.into(),
            against: vec![against.into()],
            ..Split::default()
        };
        question.ask(&Unheard)
    };
    let by_name = cut("floor", "wall").unwrap();
    assert_eq!(by_name, cut("0", "1").unwrap());
    assert_eq!(by_name, cut("floor", "all").unwrap());
    let several = Split {
        scene: "cube:2".into(),
        patch: "floor".into(),
        ..Split::default()
    };
    let refusal = several.ask(&Unheard).unwrap_err();
    assert!(
        matches!(
            refusal,
            QuestionError::PatchName(PatchNameError::SeveralPatches { rows: 4, .. })
        ),
        "{refusal}"
    );
}
