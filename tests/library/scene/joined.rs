//! Neighbours in one plane joined: what comes out, what stays apart, and that nothing else changes.

use glam::DVec3;
use infoscene::geometry::Patch;
use infoscene::scene::files::{NonPlanarFaces, Source, read_obj};
use infoscene::scene::{Material, NamedPatch, Scene};
use proptest::prelude::*;

const CUBE: [[usize; 4]; 6] = [
    [0, 1, 3, 2],
    [4, 6, 7, 5],
    [0, 2, 6, 4],
    [1, 5, 7, 3],
    [0, 4, 5, 1],
    [2, 3, 7, 6],
];

fn corner(index: usize) -> DVec3 {
    DVec3::from_array([0, 1, 2].map(|bit| f64::from(u8::from(index & (1 << bit) > 0))))
}

fn scene(faces: &[(&str, &[DVec3])]) -> Scene {
    let patches = faces.iter().enumerate().map(|(index, (object, corners))| {
        let shape = Patch::try_new(corners.to_vec()).unwrap();
        NamedPatch::new(format!("{object} {index}"), shape)
    });
    Scene::try_new(patches.collect()).unwrap()
}

fn flat(points: &[[f64; 2]]) -> Vec<DVec3> {
    points
        .iter()
        .map(|[x, y]| DVec3::new(*x, *y, 0.0))
        .collect()
}

fn joined(scene: &Scene) -> Scene {
    let (joined, members) = scene.joined().unwrap();
    let mut all = members.concat();
    all.sort_unstable();
    let count = scene.patches().len();
    assert_eq!(all, (0..count).collect::<Vec<_>>());
    let area = scene.total_area();
    assert!((joined.total_area() - area).abs() <= 1e-13 * area);
    joined
}

/// A cube of twelve triangles is the cube of six squares, to the last bit of every form factor.
#[test]
fn a_cube_of_triangles_becomes_a_cube_of_squares() {
    let squares = CUBE.map(|face| face.map(corner));
    let halves = squares.map(|[a, b, c, d]| [[a, b, c], [a, c, d]]);
    let triangles: Vec<(&str, &[DVec3])> = halves
        .as_flattened()
        .iter()
        .map(|half| ("room", half.as_slice()))
        .collect();
    let joined = joined(&scene(&triangles));
    let squares: Vec<(&str, &[DVec3])> = squares
        .iter()
        .map(|face| ("room", face.as_slice()))
        .collect();
    let squares = scene(&squares);
    let corners = |scene: &Scene| -> Vec<Vec<DVec3>> {
        scene
            .patches()
            .iter()
            .map(|patch| patch.shape().corners().to_vec())
            .collect()
    };
    assert_eq!(corners(&joined), corners(&squares));
    let names: Vec<&str> = joined.patches().iter().map(NamedPatch::name).collect();
    assert_eq!(
        names,
        ["room 0", "room 2", "room 4", "room 6", "room 8", "room 10"]
    );
    let [one, two] = [joined, squares].map(|scene| scene.exchange_areas().unwrap());
    for (i, j) in (0..6).flat_map(|i| (0..6).map(move |j| (i, j))) {
        assert_eq!(one.get(i, j), two.get(i, j));
    }
    // Howell, C-11
    assert!((one.get(0, 1).exchange.value - 0.199_824_895_698_387_38).abs() < 1e-15);
}

#[test]
fn walls_of_any_shape_become_one_polygon_each() {
    let l = flat(&[
        [0.0, 0.0],
        [2.0, 0.0],
        [2.0, 1.0],
        [1.0, 1.0],
        [1.0, 2.0],
        [0.0, 2.0],
    ]);
    let of = |places: [usize; 3]| places.map(|place| l[place]);
    let halves = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]].map(of);
    let pieces: Vec<(&str, &[DVec3])> = halves
        .iter()
        .map(|half| ("wall", half.as_slice()))
        .collect();
    let whole = joined(&scene(&pieces));
    assert_eq!(whole.patches().len(), 1);
    assert_eq!(whole.patches()[0].shape().corners(), l);
    // what was cut comes together again, straight corners left out
    for (name, times, corners) in [
        ("dodecahedron", 2, 5),
        ("cube:1", 3, 4),
        ("octahedron", 1, 3),
    ] {
        let solid = Scene::built_in(name).unwrap();
        let (cut, parents) = solid.subdivided(times).unwrap();
        let (back, members) = cut.joined().unwrap();
        assert_eq!(back.patches().len(), solid.patches().len(), "{name}");
        for (index, (patch, members)) in back.patches().iter().zip(members).enumerate() {
            assert!(
                members.iter().all(|member| parents[*member] == index),
                "{name}"
            );
            assert_eq!(patch.shape().corners().len(), corners, "{name}");
            let area = solid.patches()[index].shape().area();
            assert!((patch.shape().area() - area).abs() < 1e-14 * area, "{name}");
        }
    }
}

#[test]
fn what_does_not_belong_together_stays_apart() {
    let square = |x: f64, y: f64| flat(&[[x, y], [x + 1.0, y], [x + 1.0, y + 1.0], [x, y + 1.0]]);
    let (one, beside, apart, across) = (
        square(0.0, 0.0),
        square(1.0, 0.0),
        square(3.0, 0.0),
        square(2.0, 1.0),
    );
    let mut behind = beside.clone();
    behind.reverse();
    let mut folded = beside.clone();
    for corner in &mut folded[1..3] {
        corner.z = 1e-9;
    }
    // half of the edge is shared, and no corner of it
    let offset = square(1.0, 0.5);
    let count = |faces: &[(&str, &[DVec3])]| joined(&scene(faces)).patches().len();
    assert_eq!(count(&[("a", &one), ("a", &beside)]), 1);
    for (what, other, object) in [
        ("a gap", &apart, "a"),
        ("a corner alone", &across, "a"),
        ("another object", &beside, "b"),
        ("the other side", &behind, "a"),
        ("a fold", &folded, "a"),
        ("no common corners", &offset, "a"),
    ] {
        assert_eq!(count(&[("a", &one), (object, other)]), 2, "{what}");
    }
    let grey = Material::try_new(0.5, 0.0).unwrap();
    let mut patches = scene(&[("a", &one), ("a", &beside)]).patches().to_vec();
    patches[1] = patches[1].clone().with_material(grey);
    assert_eq!(joined(&Scene::try_new(patches).unwrap()).patches().len(), 2);
}

/// A wall around a window: no polygon has an opening, and what they exchange with a square in
/// front adds up to what the triangles did.
#[test]
fn a_wall_with_an_opening_becomes_several_polygons() {
    let outer = flat(&[[0.0, 0.0], [3.0, 0.0], [3.0, 3.0], [0.0, 3.0]]);
    let inner = flat(&[[1.0, 1.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0]]);
    let triangles = (0..4).flat_map(|side| {
        let next = (side + 1) % 4;
        [
            [outer[side], outer[next], inner[side]],
            [outer[next], inner[next], inner[side]],
        ]
    });
    let triangles: Vec<[DVec3; 3]> = triangles.collect();
    let front =
        [[0.0, 0.0], [0.0, 3.0], [3.0, 3.0], [3.0, 0.0]].map(|[x, y]| DVec3::new(x, y, 1.0));
    let mut faces: Vec<(&str, &[DVec3])> = vec![("front", &front)];
    faces.extend(
        triangles
            .iter()
            .map(|triangle| ("wall", triangle.as_slice())),
    );
    let apart = scene(&faces);
    let together = joined(&apart);
    assert!(
        (3..=4).contains(&together.patches().len()),
        "{}",
        together.patches().len()
    );
    let from_front = |scene: &Scene| {
        let areas = scene.exchange_areas().unwrap();
        (1..scene.patches().len())
            .map(|wall| areas.get(0, wall).exchange.value)
            .sum::<f64>()
    };
    let [one, two] = [&apart, &together].map(from_front);
    assert!((one - two).abs() < 1e-12, "{one} {two}");
}

/// Bases, their parts and rows that are summed are not joined, and keep their places.
#[test]
fn parts_and_summed_rows_stay_as_they_are() {
    let text = "F 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nV 4 0 1 0\nV 5 2 0 0\nV 6 2 1 0\nV 7 3 0 0\n\
        V 8 3 1 0\nV 9 4 0 0\nV 10 4 1 0\nV 11 5 0 0\nV 12 5 1 0\n\
        S 1 1 2 3 4 0 0 .5 floor\nS 2 2 5 6 3 0 0 .5 floor\nS 3 1 2 3 0 1 0 .5 mat\n\
        S 4 5 7 8 6 0 0 .5 floor\nS 5 7 9 10 8 0 4 .5 floor\n\
        S 6 9 11 12 10 0 0 .5 floor\nO 7 1 2 3 0\nEnd of data\n";
    let source = Source::new("room.vs3", text);
    let scene = infoscene::scene::files::read_view3d(&source, NonPlanarFaces::Refuse)
        .unwrap()
        .scene;
    // nothing is left to be joined
    assert_eq!(joined(&scene), scene);
    let text = text.replace("0 4 .5 floor", "0 0 .5 floor");
    let source = Source::new("room.vs3", text);
    let scene = infoscene::scene::files::read_view3d(&source, NonPlanarFaces::Refuse)
        .unwrap()
        .scene;
    let scene = joined(&scene);
    assert_eq!(scene.patches().len(), 3);
    assert_eq!((scene.base_of(2), scene.obstructions().len()), (Some(0), 1));
    // four squares beside the base, less nothing
    assert_eq!(scene.row_areas(), [0.5, 4.0, 0.5]);
}

/// Faces without area keep their places among the rows.
#[test]
fn rows_without_area_stay() {
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 0 1 1\nf 1 1 2\n\
        f 1 2 3\nf 2 2 3\nf 1 3 4\nf 3 3 3\nf 1 4 6 5\nf 4 4 4\n";
    let library = |_: &str| Ok(Source::new("a.mtl", ""));
    let loaded = read_obj(
        &Source::new("a.obj", text),
        &library,
        NonPlanarFaces::Refuse,
    )
    .unwrap();
    assert_eq!(
        loaded.scene.row_areas(),
        [0.0, 0.5, 0.0, 0.5, 0.0, 1.0, 0.0]
    );
    let scene = joined(&loaded.scene);
    assert_eq!(scene.row_areas(), [0.0, 1.0, 0.0, 0.0, 1.0, 0.0]);
    assert_eq!(
        scene.group_names()[..4],
        ["face 0", "face 1", "face 2", "face 4"]
    );
}

proptest! {
    /// Steps of any heights, cut into triangles in any order and turned in space: a disc, so that
    /// one polygon comes out, with as many corners as the steps have.
    #[test]
    fn a_region_without_an_opening_becomes_one_polygon(
        heights in proptest::collection::vec(1..5u8, 1..6),
        diagonals in proptest::collection::vec(any::<bool>(), 32),
        order in proptest::collection::vec(any::<u32>(), 64),
        turn in 0.0..6.2f64,
    ) {
        let rotation = glam::DQuat::from_rotation_z(turn) * glam::DQuat::from_rotation_x(1.0);
        let at = |x: usize, y: usize| rotation * DVec3::new(x as f64, y as f64, 0.0);
        let mut triangles = Vec::new();
        for (x, height) in heights.iter().enumerate() {
            for y in 0..usize::from(*height) {
                let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
                if diagonals[(5 * x + y) % 32] {
                    triangles.extend([[a, b, c], [a, c, d]]);
                } else {
                    triangles.extend([[a, b, d], [b, c, d]]);
                }
            }
        }
        let mut shuffled: Vec<_> = triangles.into_iter().zip(order.iter().cycle()).collect();
        shuffled.sort_by_key(|(_, key)| **key);
        let faces: Vec<(&str, &[DVec3])> =
            shuffled.iter().map(|(corners, _)| ("steps", corners.as_slice())).collect();
        let whole = joined(&scene(&faces));
        let [patch] = whole.patches() else {
            panic!("{} polygons of {heights:?}", whole.patches().len());
        };
        let steps = heights.windows(2).filter(|pair| pair[0] != pair[1]).count();
        prop_assert_eq!(patch.shape().corners().len(), 4 + 2 * steps);
    }
}
