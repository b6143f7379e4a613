//! Scenes whose fronts are all outside: found, named, and mended by turning them.

use infoscene::chain::{ChainError, visibility_chain};
use infoscene::discretize::{DiscretizeError, PatchSplit};
use infoscene::exchange::ExchangeError;
use infoscene::geometry::SplitAxis;
use infoscene::information::{LineKind, LineSample};
use infoscene::scene::{NamedPatch, Scene};

#[test]
fn turned_rooms_say_so_at_every_door() {
    for name in [
        "cube:2",
        "box:1,2,3",
        "tetrahedron",
        "icosahedron",
        "two-squares",
    ] {
        let inside = Scene::built_in(name).unwrap();
        assert!(!inside.is_turned_away(), "{name}");
        let outside = inside.clone().reversed();
        assert!(outside.is_turned_away(), "{name}");
        assert_eq!(outside.clone().reversed(), inside, "{name}");
        let refusal = visibility_chain(&outside).unwrap_err();
        assert_eq!(refusal, ChainError::Exchange(ExchangeError::TurnedAway));
        let refusal = LineSample::draw(&outside, LineKind::Local, 100, 1).unwrap_err();
        assert_eq!(refusal, ChainError::Exchange(ExchangeError::TurnedAway));
    }
    let outside = Scene::built_in("cube:1").unwrap().reversed();
    let refusal = PatchSplit::try_new(&outside, 0, &[1], SplitAxis::U).unwrap_err();
    assert_eq!(
        refusal,
        DiscretizeError::Exchange(ExchangeError::TurnedAway)
    );
}

/// Turning mends nothing where two patches lie in one plane, or where some see each other already.
#[test]
fn what_turning_would_not_mend_is_not_called_turned() {
    let cube = Scene::built_in("cube:2").unwrap();
    let of = |indices: &[usize]| {
        let patches = indices.iter().map(|index| cube.patches()[*index].clone());
        Scene::try_new(patches.collect()).unwrap()
    };
    // one patch, and two of one face
    assert!(!of(&[0]).reversed().is_turned_away());
    assert!(!of(&[0, 1]).reversed().is_turned_away());
    // floor and ceiling
    assert!(of(&[0, 4]).reversed().is_turned_away());
    // a single face turned leaves the others
    let mut patches: Vec<NamedPatch> = Scene::built_in("cube:1").unwrap().patches().to_vec();
    patches[0] = patches[0].clone().reversed();
    assert!(!Scene::try_new(patches).unwrap().is_turned_away());
}
