//! Edges that no other patch shares, and neighbours whose fronts disagree.

use crate::support::rooms::{level, mapped, tiled_box};
use glam::{DQuat, DVec3};
use infoscene::scene::{NamedPatch, Scene};

fn without(scene: &Scene, patch: usize) -> Scene {
    let mut patches = scene.patches().to_vec();
    patches.remove(patch);
    Scene::try_new(patches).unwrap()
}

/// A room closes however its walls are divided and wherever it stands; without a patch the edges
/// round the hole are free, and their length is its circumference.
#[test]
fn free_edges_are_those_round_a_hole() {
    let turn = DQuat::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 0.7);
    let places: [fn(DVec3) -> DVec3; 2] = [|c| c, |c| 1e3 * c + DVec3::new(5.0, -7.0, 11.0)];
    for room in [
        Scene::built_in("cube:3").unwrap(),
        Scene::built_in("box:1,2,3").unwrap(),
        Scene::built_in("icosahedron").unwrap(),
        tiled_box([1.0, 2.0, 1.5], 2.0),
    ] {
        for place in places {
            let room = mapped(&room, |corner| turn * place(corner));
            assert!(room.joints().free.is_empty());
            assert!(room.joints().turned.is_empty());
            let hole = room.patches()[0].shape().corners();
            let n = hole.len();
            let around: f64 = (0..n).map(|i| hole[i].distance(hole[(i + 1) % n])).sum();
            let open = without(&room, 0).joints().free;
            let length: f64 = open.iter().map(infoscene::scene::FreeEdge::length).sum();
            assert!(
                (length / around - 1.0).abs() < 1e-12,
                "{length} of {around}"
            );
        }
    }
}

/// An edge of 3 against edges of 1 and 2, of which the longer one ends too early: what is left over
/// is named, from one end to the other.
#[test]
fn what_is_left_of_an_edge_is_named() {
    let patches = vec![
        level("long", [0.0, 3.0], [0.0, 1.0], 0.0, true),
        level("one", [0.0, 1.0], [-1.0, 0.0], 0.0, true),
        level("two", [1.0, 2.75], [-1.0, 0.0], 0.0, true),
    ];
    let free = Scene::try_new(patches).unwrap().joints().free;
    let left: Vec<_> = free
        .iter()
        .filter(|edge| edge.ends.iter().all(|end| end.y == 0.0))
        .collect();
    assert_eq!(left.len(), 1, "{left:?}");
    let ends = [DVec3::new(2.75, 0.0, 0.0), DVec3::new(3.0, 0.0, 0.0)];
    assert_eq!((left[0].patch, left[0].ends), (0, ends));
}

#[test]
fn a_patch_that_is_turned_disagrees_with_all_its_neighbours() {
    let mut patches: Vec<NamedPatch> = Scene::built_in("cube:1").unwrap().patches().to_vec();
    patches[2] = patches[2].clone().reversed();
    let joints = Scene::try_new(patches).unwrap().joints();
    assert!(joints.free.is_empty());
    // left: floor, ceiling, front, back
    assert_eq!(joints.turned, [[0, 2], [1, 2], [2, 4], [2, 5]]);
    // all turned agree again
    let outside = Scene::built_in("cube:1").unwrap().reversed();
    assert!(outside.joints().turned.is_empty());
}
