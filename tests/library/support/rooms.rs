//! Rooms, screens and random polygons.

use glam::{DQuat, DVec3};
use infoscene::geometry::Patch;
use infoscene::scene::{Blocker, NamedPatch, Obstacle, Scene};
use proptest::prelude::*;

/// A polygon by its corners.
pub fn patch(corners: &[[f64; 3]]) -> Patch {
    let corners = corners.iter().map(|corner| DVec3::from_array(*corner));
    Patch::try_new(corners.collect()).unwrap()
}

/// A polygon under a name.
pub fn polygon(name: &str, corners: &[[f64; 3]]) -> NamedPatch {
    NamedPatch::new(name.to_owned(), patch(corners))
}

/// The rectangle `x × y` at height z, facing up or down.
pub fn level(name: &str, x: [f64; 2], y: [f64; 2], z: f64, up: bool) -> NamedPatch {
    let corners = [
        [x[0], y[0], z],
        [x[1], y[0], z],
        [x[1], y[1], z],
        [x[0], y[1], z],
    ];
    facing(name, corners, up)
}

/// The corners as given, or in reverse order.
pub fn facing<const N: usize>(
    name: &str,
    mut corners: [[f64; 3]; N],
    as_given: bool,
) -> NamedPatch {
    if !as_given {
        corners.reverse();
    }
    polygon(name, &corners)
}

/// A scene whose corners are mapped.
pub fn mapped(scene: &Scene, map: impl Fn(DVec3) -> DVec3) -> Scene {
    let patches = scene.patches().iter();
    Scene::try_new(patches.map(|patch| mapped_patch(patch, &map)).collect()).unwrap()
}

/// A patch whose corners are mapped.
pub fn mapped_patch(patch: &NamedPatch, map: impl Fn(DVec3) -> DVec3) -> NamedPatch {
    let corners = patch.shape().corners().iter().map(|c| map(*c)).collect();
    NamedPatch::new(patch.name().to_owned(), Patch::try_new(corners).unwrap())
}

/// The inside of a box whose edges are whole numbers, in squares, `cells` for each unit.
pub fn tiled_box(size: [f64; 3], cells: f64) -> Scene {
    let mut patches = Vec::new();
    for axis in 0..3 {
        let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
        let counts = [u, v].map(|k| (size[k] * cells).round() as u32);
        for (i, j) in (0..counts[0]).flat_map(|i| (0..counts[1]).map(move |j| (i, j))) {
            for (level, up) in [(0.0, true), (size[axis], false)] {
                let corners = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(di, dj)| {
                    let mut corner = [level; 3];
                    corner[u] = f64::from(i + di) / cells;
                    corner[v] = f64::from(j + dj) / cells;
                    corner
                });
                patches.push(facing(&format!("{axis} {level} {i} {j}"), corners, up));
            }
        }
    }
    Scene::try_new(patches).unwrap()
}

/// The room over a polygon in the plane z = 0 that runs counter-clockwise: floor, ceiling at z = 1,
/// and walls, fronts inward.
pub fn prism(floor: &[[f64; 2]]) -> Scene {
    let at = |z: f64| floor.iter().map(move |[x, y]| [*x, *y, z]);
    let mut down: Vec<[f64; 3]> = at(1.0).collect();
    down.reverse();
    let mut patches = vec![
        polygon("floor", &at(0.0).collect::<Vec<_>>()),
        polygon("ceiling", &down),
    ];
    for (k, [x, y]) in floor.iter().enumerate() {
        let [to_x, to_y] = floor[(k + 1) % floor.len()];
        let wall = [
            [*x, *y, 0.0],
            [*x, *y, 1.0],
            [to_x, to_y, 1.0],
            [to_x, to_y, 0.0],
        ];
        patches.push(polygon(&format!("wall {k}"), &wall));
    }
    Scene::try_new(patches).unwrap()
}

/// An L-shaped polygon with arms of width 1 and length 2.
pub const L: [[f64; 2]; 6] = [
    [0.0, 0.0],
    [2.0, 0.0],
    [2.0, 1.0],
    [1.0, 1.0],
    [1.0, 2.0],
    [0.0, 2.0],
];

/// A turn, a size and a shift, the shift often many times the size, but not so many that f64 cannot
/// hold an eighth of a room as flat as a patch must be.
pub fn placing() -> impl Strategy<Value = (DQuat, f64, DVec3)> {
    let size = prop_oneof![
        Just(1.0),
        0.1..10.0f64,
        (-6.0..6.0f64).prop_map(|e| 10f64.powf(e))
    ];
    let far = prop_oneof![
        Just(0.0),
        Just(1.0),
        (0.0..1.5f64).prop_map(|e| 10f64.powf(e))
    ];
    (super::strategies::motion(), size, far)
        .prop_map(|((turn, shift), size, far)| (turn, size, shift * far * size))
}

/// A triangle, a parallelogram or an L somewhere in the cube of edge 2.
pub fn any_polygon() -> impl Strategy<Value = NamedPatch> {
    let point = || (-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64).prop_map(DVec3::from);
    let third = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].to_vec();
    let shapes = vec![
        third,
        vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
        L.map(|[x, y]| [x / 2.0, y / 2.0]).to_vec(),
    ];
    let legs = (point(), point()).prop_filter("a polygon needs an area", |(u, v)| {
        u.cross(*v).length() > 0.05
    });
    (point(), legs, proptest::sample::select(shapes)).prop_map(|(origin, (u, v), shape)| {
        let corners = shape
            .iter()
            .map(|[x, y]| origin + u * *x + v * *y)
            .collect();
        NamedPatch::new("any".to_owned(), Patch::try_new(corners).unwrap())
    })
}

/// The scene of patches and what only obstructs.
pub fn among(patches: &[NamedPatch], obstructions: &[NamedPatch]) -> Scene {
    let scene = Scene::try_new(patches.to_vec()).unwrap();
    scene.with_obstructions(obstructions.to_vec())
}

/// The first blocked pair, and what blocks it.
pub fn blocked(
    patches: &[NamedPatch],
    obstructions: &[NamedPatch],
) -> Option<(usize, usize, Obstacle)> {
    let Blocker {
        first,
        second,
        obstacle,
        ..
    } = among(patches, obstructions).blocker()?;
    Some((first, second, obstacle))
}

/// Two unit squares that face each other at distance 1.
pub fn squares() -> Vec<NamedPatch> {
    Scene::facing_squares(1.0).unwrap().patches().to_vec()
}
