//! The Cornell box: as published where it is published, and closed.

use glam::DVec3;
use infoscene::numeric::tolerance;
use infoscene::scene::files::{NonPlanarFaces, read};
use infoscene::scene::{NamedPatch, Scene};
use std::collections::HashMap;
use std::path::Path;

fn cornell_box() -> Scene {
    Scene::built_in("cornell-box").unwrap()
}

/// The patches of a surface by its name.
fn named<'a>(scene: &'a Scene, name: &str) -> Vec<&'a NamedPatch> {
    let patches = scene.patches().iter();
    patches
        .filter(|patch| patch.name().rsplit_once(' ').unwrap().0 == name)
        .collect()
}

fn area(patches: &[&NamedPatch]) -> f64 {
    patches.iter().map(|patch| patch.shape().area()).sum()
}

/// "Cornell Box Data" lists the corners in this order, and their fronts look into the room.
#[test]
fn published_corners_are_kept_in_their_order() {
    let scene = cornell_box();
    for (name, published) in [
        (
            "floor",
            [
                [552.8, 0.0, 0.0],
                [0.0, 0.0, 0.0],
                [0.0, 0.0, 559.2],
                [549.6, 0.0, 559.2],
            ],
        ),
        (
            "light",
            [
                [343.0, 548.8, 227.0],
                [343.0, 548.8, 332.0],
                [213.0, 548.8, 332.0],
                [213.0, 548.8, 227.0],
            ],
        ),
        (
            "back wall",
            [
                [549.6, 0.0, 559.2],
                [0.0, 0.0, 559.2],
                [0.0, 548.8, 559.2],
                [556.0, 548.8, 559.2],
            ],
        ),
        (
            "right wall",
            [
                [0.0, 0.0, 559.2],
                [0.0, 0.0, 0.0],
                [0.0, 548.8, 0.0],
                [0.0, 548.8, 559.2],
            ],
        ),
    ] {
        let [patch] = named(&scene, name)[..] else {
            panic!("{name}")
        };
        assert_eq!(
            patch.shape().corners(),
            published.map(DVec3::from_array),
            "{name}"
        );
    }
    // of the left wall and the ceiling, which are cut, all corners occur
    for (name, published) in [
        (
            "left wall",
            [
                [552.8, 0.0, 0.0],
                [549.6, 0.0, 559.2],
                [556.0, 548.8, 559.2],
                [556.0, 548.8, 0.0],
            ],
        ),
        (
            "ceiling",
            [
                [556.0, 548.8, 0.0],
                [556.0, 548.8, 559.2],
                [0.0, 548.8, 559.2],
                [0.0, 548.8, 0.0],
            ],
        ),
    ] {
        for corner in published.map(DVec3::from_array) {
            let mut patches = named(&scene, name).into_iter();
            assert!(patches.any(|patch| patch.shape().corners().contains(&corner)));
        }
    }
}

/// Reflectances at 500 nm: white 0.747, green 0.285, red 0.058; the light and the opening reflect
/// nothing.
#[test]
fn reflectances_are_the_published_ones() {
    let scene = cornell_box();
    let mut seen = 0;
    for (name, reflectance, emittance) in [
        ("floor", 0.747, 0.0),
        ("ceiling", 0.747, 0.0),
        ("back wall", 0.747, 0.0),
        ("right wall", 0.285, 0.0),
        ("left wall", 0.058, 0.0),
        ("light", 0.0, 1.0),
        ("front", 0.0, 0.0),
    ] {
        for patch in named(&scene, name) {
            let material = patch.material().grey().unwrap();
            assert_eq!(
                (material.reflectance(), material.emittance()),
                (reflectance, emittance)
            );
            seen += 1;
        }
    }
    assert_eq!((seen, scene.patches().len()), (11, 11));
}

/// Areas of rectangles and trapezia by hand.
#[test]
fn areas_are_those_of_the_published_corners() {
    let scene = cornell_box();
    let both = [named(&scene, "ceiling"), named(&scene, "light")].concat();
    for (patches, expected) in [
        (named(&scene, "floor"), 0.5 * (552.8 + 549.6) * 559.2),
        (named(&scene, "light"), 130.0 * 105.0),
        (both, 556.0 * 559.2),
        (named(&scene, "back wall"), 0.5 * (549.6 + 556.0) * 548.8),
        (named(&scene, "right wall"), 548.8 * 559.2),
        (named(&scene, "front"), 0.5 * (552.8 + 556.0) * 548.8),
    ] {
        assert!((area(&patches) - expected).abs() <= tolerance::PLANARITY * expected);
    }
}

/// Watertight: each edge from a to b is met by one from b to a, and by no other.
#[test]
fn every_edge_is_met_by_its_reverse() {
    let scene = cornell_box();
    let mut edges: HashMap<[[u64; 3]; 2], i32> = HashMap::new();
    let bits = |corner: DVec3| corner.to_array().map(f64::to_bits);
    for patch in scene.patches() {
        let corners = patch.shape().corners();
        for (k, corner) in corners.iter().enumerate() {
            let next = corners[(k + 1) % corners.len()];
            *edges.entry([bits(*corner), bits(next)]).or_default() += 1;
        }
    }
    for ([from, to], count) in &edges {
        assert_eq!((*count, edges.get(&[*to, *from])), (1, Some(&1)));
    }
    // 6 faces, one cut in two, one in four around a hole: E = V + F − 2 with 12 corners and 11
    // faces
    assert_eq!(edges.len(), 2 * 21);
}

/// Σ A n = 0 for any closed surface; the terms are near 3e5, and PLANARITY leaves each some 4000
/// roundings.
#[test]
fn the_vector_area_vanishes() {
    let scene = cornell_box();
    let patches = scene.patches().iter();
    let sum: DVec3 = patches
        .map(|patch| patch.shape().area() * patch.shape().normal())
        .sum();
    assert!(
        sum.length() <= tolerance::PLANARITY * scene.total_area(),
        "{sum}"
    );
    // without the front it does not
    let open = scene
        .patches()
        .iter()
        .filter(|patch| !patch.name().starts_with("front"));
    let sum: DVec3 = open
        .map(|patch| patch.shape().area() * patch.shape().normal())
        .sum();
    assert!(sum.length() > 0.1 * scene.total_area());
}

/// The room is convex, so that nothing hides anything: every corner is in front of every plane, and
/// the middle of the room well in front. With the other diagonal of the left wall it would not be.
#[test]
fn the_room_is_convex() {
    let scene = cornell_box();
    let lowest = |scene: &Scene| {
        let corners = scene
            .patches()
            .iter()
            .flat_map(|patch| patch.shape().corners().to_vec());
        let corners: Vec<DVec3> = corners.collect();
        let heights = scene.patches().iter().flat_map(|patch| {
            let (origin, normal) = (patch.shape().corners()[0], patch.shape().normal());
            corners
                .iter()
                .map(move |corner| (*corner - origin).dot(normal))
        });
        heights.fold(f64::INFINITY, f64::min)
    };
    assert!(
        lowest(&scene) >= -tolerance::PLANARITY * 1000.0,
        "{}",
        lowest(&scene)
    );
    for patch in scene.patches() {
        let middle = DVec3::new(278.0, 274.0, 280.0) - patch.shape().corners()[0];
        assert!(
            middle.dot(patch.shape().normal()) > 250.0,
            "{}",
            patch.name()
        );
    }
    let wall = [
        [552.8, 0.0, 0.0],
        [549.6, 0.0, 559.2],
        [556.0, 548.8, 559.2],
        [556.0, 548.8, 0.0],
    ];
    let wall = wall.map(DVec3::from_array);
    let other = [[0, 1, 3], [1, 2, 3]].map(|corners| {
        let shape = infoscene::geometry::Patch::try_new(corners.map(|k| wall[k]).to_vec()).unwrap();
        NamedPatch::new("left wall".to_owned(), shape)
    });
    // 3.2 across 785 of the diagonal: some 1.6 behind
    assert!(lowest(&Scene::try_new(other.to_vec()).unwrap()) < -1.0);
}

#[test]
fn the_built_in_room_is_the_file() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/scenes/cornell-box.obj");
    let loaded = read(&path, NonPlanarFaces::Refuse).unwrap();
    assert_eq!(loaded.scene, cornell_box());
    assert!(loaded.notes.is_empty());
}
