//! Remedies of refusals: each is found behind every error that passes it on.

use infoscene::chain::ChainError;
use infoscene::claims::ClaimError;
use infoscene::discretize::DiscretizeError;
use infoscene::exchange::ExchangeError;
use infoscene::question::{QuestionError, Remedy};
use infoscene::scene::files::{NonPlanarFaces, OpenError, Source, read_obj};
use infoscene::study::StudyError;

/// A refusal of the scene's front sides, through every room from the exchange to the question.
#[test]
fn a_remedy_is_found_behind_every_room_that_passes_its_error_on() {
    let error = ExchangeError::TurnedAway;
    assert_eq!(Remedy::of(&error), [Remedy::Reversed]);
    let error = ChainError::from(error);
    assert_eq!(Remedy::of(&error), [Remedy::Reversed]);
    let error = DiscretizeError::from(error);
    assert_eq!(Remedy::of(&error), [Remedy::Reversed]);
    let error = ClaimError::from(error);
    assert_eq!(Remedy::of(&error), [Remedy::Reversed]);
    let error = StudyError::from(error);
    assert_eq!(Remedy::of(&error), [Remedy::Reversed]);
    assert_eq!(Remedy::of(&QuestionError::from(error)), [Remedy::Reversed]);
}

/// A question's own refusal is mended before the one that it passes on: an open scene.
#[test]
fn the_remedy_of_a_question_comes_before_that_of_its_cause() {
    let open = QuestionError::OpenScene(ExchangeError::TurnedAway);
    assert_eq!(Remedy::of(&open), [Remedy::StateOutside]);
    assert_eq!(
        Remedy::of(&QuestionError::NoLightMeant),
        [Remedy::ChainOfLight]
    );
    let no_name = std::io::Error::other("no remedy is known");
    assert!(Remedy::of(&no_name).is_empty());
}

/// Square faces whose last corner is lifted by the heights given.
fn refusal(lifts: &[&str]) -> QuestionError {
    let face = |(index, lift): (usize, &&str)| {
        let x = 3 * index;
        format!(
            "v {x}.00 0.00 0\nv {x}.00 1.00 0\nv {x}.50 1.00 0\nv {x}.50 0.00 {lift}\nf -4 -3 -2 -1\n"
        )
    };
    let text: String = lifts.iter().enumerate().map(face).collect();
    let no_materials = |_: &str| Ok(Source::new("none.mtl", ""));
    let source = Source::new("bent.obj", &text);
    let refused = read_obj(&source, &no_materials, NonPlanarFaces::Refuse).unwrap_err();
    QuestionError::from(OpenError::File(refused))
}

/// A bent face is flat at a coarser resolution: of several, at that of the most bent one.
#[test]
fn a_bent_face_is_split_or_taken_as_flat() {
    let resolution = |lifts: &[&str]| match Remedy::of(&refusal(lifts))[..] {
        [Remedy::Triangulated { is_all }, Remedy::Resolution(length)] => {
            assert_eq!(is_all, lifts.len() == 1);
            length
        }
        ref other => panic!("{other:?}"),
    };
    let [small, large] = [resolution(&["0.0005"]), resolution(&["0.0008"])];
    assert!(small < large, "{small} {large}");
    assert_eq!(resolution(&["0.0005", "0.0008"]).to_bits(), large.to_bits());
    assert_eq!(resolution(&["0.0008", "0.0005"]).to_bits(), large.to_bits());
}
