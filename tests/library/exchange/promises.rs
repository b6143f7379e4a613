//! The promise that no scene gets numbers that overlap or occlusion makes wrong.

use crate::support::rooms::level;
use infoscene::chain::{ChainError, continuous_chain};
use infoscene::discretize::{DiscretizeError, PatchSplit};
use infoscene::exchange::{Congruence, ExchangeError, ScenePairs, Selection, Unheard};
use infoscene::geometry::SplitAxis;
use infoscene::information::{
    LineKind, LineSample, chord_information, continuous_information, pair_losses,
};
use infoscene::scene::{NamedPatch, Obstacle, Occlusion, Scene, SceneError};

fn of_exchange(error: ExchangeError) -> SceneError {
    match error {
        ExchangeError::Scene(error) => error,
        other => panic!("the scene is not to blame: {other}"),
    }
}

fn of_chain(error: ChainError) -> SceneError {
    match error {
        ChainError::Scene(error) => error,
        ChainError::Exchange(error) => of_exchange(error),
        other => panic!("the scene is not to blame: {other}"),
    }
}

fn of_split(error: DiscretizeError) -> SceneError {
    match error {
        DiscretizeError::Scene(error) => error,
        DiscretizeError::Exchange(error) => of_exchange(error),
        other => panic!("the scene is not to blame: {other}"),
    }
}

fn pairs(scene: &Scene, occlusion: Occlusion) -> Result<ScenePairs<'static>, SceneError> {
    ScenePairs::try_new(scene, 1e-9, Congruence::Shared, occlusion).map_err(of_exchange)
}

fn split(scene: &Scene, against: &[usize], occlusion: Occlusion) -> Result<(), SceneError> {
    let split = PatchSplit::with_occlusion(scene, 0, against, SplitAxis::U, occlusion);
    split.map(|_| ()).map_err(of_split)
}

type Door = fn(&Scene) -> Result<(), SceneError>;

/// Every way from a scene to what its patches exchange that refuses occlusion.
const DOORS: [(&str, Door); 5] = [
    ("pairs", |scene| pairs(scene, Occlusion::Refuse).map(|_| ())),
    ("continuous chain", |scene| {
        let chain = continuous_chain(scene, |_, _| 1.0, 1e-3);
        chain.map(|_| ()).map_err(of_chain)
    }),
    ("continuous information", |scene| {
        continuous_information(scene).map(|_| ()).map_err(of_chain)
    }),
    ("losses of pairs", |scene| {
        pair_losses(scene, &Unheard).map(|_| ()).map_err(of_chain)
    }),
    ("split", |scene| {
        let others: Vec<usize> = (1..scene.patches().len()).collect();
        split(scene, &others, Occlusion::Refuse)
    }),
];

/// A room that is convex inside, whose corners do not tell that a shelf hangs in it.
fn room_with_shelf(x: [f64; 2], z: f64) -> Scene {
    let shelf = level("shelf", x, [0.4, 0.6], z, true);
    Scene::built_in("cube:1")
        .unwrap()
        .with_obstructions(vec![shelf])
}

/// A room whose walls have the right corners and areas, but the middle of the floor lies on another
/// patch: a gap and an overlap.
fn room_with_overlap() -> Scene {
    let mut patches = Scene::built_in("cube:3").unwrap().patches().to_vec();
    patches[4] = NamedPatch::new("rug".to_owned(), patches[0].shape().clone());
    Scene::try_new(patches).unwrap()
}

#[test]
fn doors_that_need_full_sight_refuse_a_blocked_scene_by_name() {
    let scene = room_with_shelf([0.4, 0.6], 0.5);
    for (name, door) in DOORS {
        let refusal = door(&scene).unwrap_err();
        let SceneError::MayBeBlocked {
            obstacle, name: by, ..
        } = &refusal
        else {
            panic!("{name}: {refusal}");
        };
        assert_eq!(
            (*obstacle, by.as_str()),
            (Obstacle::Obstruction(0), "shelf"),
            "{name}"
        );
        let without = scene.clone().with_obstructions(Vec::new());
        assert_eq!(door(&without), Ok(()), "{name}");
    }
}

#[test]
fn every_door_refuses_overlapping_patches_by_name() {
    let scene = room_with_overlap();
    let sampled = |scene: &Scene| {
        let sample = LineSample::draw(scene, LineKind::Local, 100, 1);
        sample.map(|_| ()).map_err(of_chain)
    };
    let chords = |scene: &Scene| {
        let found = chord_information(scene, 100, 1);
        found.map(|_| ()).map_err(of_chain)
    };
    let ignoring: [(&str, Door); 5] = [
        ("pairs past all that stands between", |scene| {
            pairs(scene, Occlusion::Exact).map(|_| ())
        }),
        ("sampled lines", sampled),
        ("chords", chords),
        ("pairs that ignore occlusion", |scene| {
            pairs(scene, Occlusion::Ignore).map(|_| ())
        }),
        ("split that ignores occlusion", |scene| {
            split(scene, &[20], Occlusion::Ignore)
        }),
    ];
    for (name, door) in DOORS.into_iter().chain(ignoring) {
        let refusal = door(&scene).unwrap_err();
        let SceneError::Overlap {
            first: 0,
            second: 4,
            names,
            ..
        } = &refusal
        else {
            panic!("{name}: {refusal}");
        };
        assert_eq!(names[1], "rug", "{name}");
    }
}

#[test]
fn ignored_occlusion_gives_the_values_of_the_empty_room() {
    let scene = room_with_shelf([0.4, 0.6], 0.5);
    let empty = Scene::built_in("cube:1").unwrap();
    let found = pairs(&scene, Occlusion::Ignore).unwrap();
    let expected = pairs(&empty, Occlusion::Refuse).unwrap();
    assert_eq!(
        found.row_pair(0, 5).unwrap(),
        expected.row_pair(0, 5).unwrap()
    );
    assert_eq!(split(&scene, &[1, 2, 3, 4, 5], Occlusion::Ignore), Ok(()));
}

/// Floor and wall x = 0 span the half x + z ≤ 1 of the cube; the shelf hangs in the other half.
#[test]
fn what_is_not_hidden_is_admitted() {
    let scene = room_with_shelf([0.85, 0.95], 0.9);
    let on = |axis: usize, level: f64| {
        let lies = |patch: &NamedPatch| {
            let mut corners = patch.shape().corners().iter();
            corners.all(|corner| corner[axis] == level)
        };
        scene.patches().iter().position(lies).unwrap()
    };
    let (floor, ceiling, wall) = (on(2, 0.0), on(2, 1.0), on(0, 0.0));
    let rows = |from: Option<usize>, to: Option<usize>| {
        let [from, to] = [from, to].map(|row| row.map(|row| vec![row]));
        let selection = Selection { from, to };
        let (own, occlusion) = (Congruence::Ignored, Occlusion::Refuse);
        ScenePairs::of_selection(&scene, 1e-12, own, occlusion, &selection)
            .map(|pairs| pairs.rows())
            .map_err(of_exchange)
    };
    assert_eq!(rows(Some(floor), Some(wall)), Ok(6));
    for (from, to) in [
        (Some(floor), Some(ceiling)),
        (Some(floor), None),
        (None, Some(floor)),
        (None, None),
    ] {
        let refusal = rows(from, to).unwrap_err();
        assert!(
            matches!(refusal, SceneError::MayBeBlocked { .. }),
            "{refusal}"
        );
    }
    let refusal = rows(Some(floor), Some(6)).unwrap_err();
    assert_eq!(refusal, SceneError::NoSuchPatch { index: 6, last: 5 });
    let refuse = Occlusion::Refuse;
    let cut = |other| PatchSplit::with_occlusion(&scene, floor, &[other], SplitAxis::U, refuse);
    assert!(cut(wall).is_ok());
    let refusal = of_split(cut(ceiling).unwrap_err());
    assert!(
        matches!(refusal, SceneError::MayBeBlocked { .. }),
        "{refusal}"
    );
}
