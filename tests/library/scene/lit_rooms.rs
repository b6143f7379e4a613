//! Rooms with a light: closed, without overlap, and of the materials and lights that are meant.

use glam::DVec3;
use infoscene::exchange::{ScenePoints, Unheard};
use infoscene::scene::{Occlusion, Scene};

/// Rooms, with the areas of light and of all else, and whether something stands in them.
const ROOMS: [(&str, f64, f64, bool); 8] = [
    ("lit-cube", 1.0 / 16.0, 6.0, false),
    ("lit-cube-edge", 1.0 / 16.0, 6.0, false),
    ("lit-hall", 1.0 / 16.0, 10.0, false),
    // 3 + 3 of floor and ceiling, eight unit squares around
    ("lit-wings", 1.0 / 16.0, 14.0, true),
    ("shaded-cube", 1.0 / 16.0, 6.0 + 50.0 / 256.0, true),
    ("shaded-cube-low", 1.0 / 16.0, 6.0 + 50.0 / 256.0, true),
    ("shaded-cube-sharp", 1.0 / 1024.0, 6.0 + 50.0 / 256.0, true),
    // both sides of the top, of two panels and of a screen
    (
        "lit-table",
        1.0 / 16.0,
        6.0 + 50.0 / 256.0 + 80.0 / 256.0 + 32.0 / 256.0,
        true,
    ),
];

#[test]
fn areas_and_lights_are_those_of_the_rooms() {
    for (name, light, area, is_occluded) in ROOMS {
        let room = Scene::built_in(name).unwrap();
        let emits = |patch: &&infoscene::scene::NamedPatch| {
            patch.material().grey().unwrap().emittance() > 0.0
        };
        let lit: f64 = room
            .patches()
            .iter()
            .filter(emits)
            .map(|p| p.shape().area())
            .sum();
        // all coordinates but the plate's height are multiples of 1/32
        assert_eq!((room.total_area(), lit), (area, light), "{name}");
        let refused = Occlusion::Refuse.check(&room).is_err();
        assert_eq!(refused, is_occluded, "{name}");
        assert!(Occlusion::Exact.check(&room).is_ok(), "{name}");
    }
}

/// From a point in each patch, 1 = Σ F over the fronts: nothing else is seen in a closed room.
#[test]
fn a_point_of_a_lit_room_sees_nothing_but_fronts() {
    for (name, ..) in ROOMS {
        let room = Scene::built_in(name).unwrap();
        let points = ScenePoints::try_new(&room, Occlusion::Exact).unwrap();
        let inside = |patch: &infoscene::scene::NamedPatch| {
            let corners = patch.shape().corners();
            let weights = [0.31, 0.23, 0.2, 0.26];
            let weighted = corners.iter().zip(weights).map(|(c, w)| *c * w);
            (weighted.sum::<DVec3>(), patch.shape().normal())
        };
        let places: Vec<_> = room.patches().iter().map(inside).collect();
        for row in points.seen_from(&places, &Unheard).unwrap() {
            let unseen = row.unseen.unwrap();
            assert!(
                unseen.value.abs() <= unseen.error && unseen.error < 1e-12,
                "{name}"
            );
        }
    }
}
