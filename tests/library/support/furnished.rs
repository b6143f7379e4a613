//! Rooms with furniture, all closed: what a piece stands on is cut out under it.

use super::rooms::{facing, level, prism};
use infoscene::scene::{NamedPatch, Scene};

type Span = [f64; 2];

/// The cells between lines at a height, but those whose lower corners are left out.
fn cells(
    name: &str,
    [xs, ys]: [&[f64]; 2],
    z: f64,
    up: bool,
    left_out: &[[f64; 2]],
) -> Vec<NamedPatch> {
    let mut found = Vec::new();
    for x in xs.windows(2) {
        for y in ys.windows(2) {
            if !left_out.contains(&[x[0], y[0]]) {
                found.push(level(name, [x[0], x[1]], [y[0], y[1]], z, up));
            }
        }
    }
    found
}

/// The four upright sides of a box, fronts outside or inside.
pub fn sides(name: &str, [x0, x1]: Span, [y0, y1]: Span, z: Span, out: bool) -> Vec<NamedPatch> {
    let around = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
    let side = |k: usize| {
        let ([a, b], [c, d]) = (around[k], around[(k + 1) % 4]);
        let corners = [[a, b, z[0]], [c, d, z[0]], [c, d, z[1]], [a, b, z[1]]];
        facing(name, corners, out)
    };
    (0..4).map(side).collect()
}

/// A box without a bottom, fronts outside.
pub fn standing(name: &str, x: Span, y: Span, z: Span) -> Vec<NamedPatch> {
    let mut faces = sides(name, x, y, z, true);
    faces.push(level(name, x, y, z[1], true));
    faces
}

/// The walls and the ceiling of the room 4 × 3 × 2.5.
fn shell() -> Vec<NamedPatch> {
    let mut faces = sides("wall", [0.0, 4.0], [0.0, 3.0], [0.0, 2.5], false);
    faces.push(level("ceiling", [0.0, 4.0], [0.0, 3.0], 2.5, false));
    faces
}

/// Two boxes of different heights.
pub fn two_boxes() -> Scene {
    let lines: [&[f64]; 2] = [&[0.0, 0.5, 1.25, 2.0, 3.0, 4.0], &[0.0, 0.75, 1.5, 3.0]];
    let mut patches = shell();
    let floor = cells("floor", lines, 0.0, true, &[[0.5, 0.75], [2.0, 0.75]]);
    patches.extend(floor);
    patches.extend(standing("low", [0.5, 1.25], [0.75, 1.5], [0.0, 0.5]));
    patches.extend(standing("high", [2.0, 3.0], [0.75, 1.5], [0.0, 1.5]));
    Scene::try_new(patches).unwrap()
}

/// A table: a plate on one leg, which floor and plate are cut out under and over.
pub fn table() -> Scene {
    let (leg, plate) = ([1.75, 2.25], [1.25, 2.75]);
    let lines: [&[f64]; 2] = [&[0.0, 1.75, 2.25, 4.0], &[0.0, 1.25, 1.75, 3.0]];
    let mut patches = shell();
    patches.extend(cells("floor", lines, 0.0, true, &[[1.75, 1.25]]));
    patches.extend(sides("leg", leg, [1.25, 1.75], [0.0, 0.75], true));
    let lines: [&[f64]; 2] = [&[1.25, 1.75, 2.25, 2.75], &[1.0, 1.25, 1.75, 2.0]];
    patches.extend(cells("under", lines, 0.75, false, &[[1.75, 1.25]]));
    patches.extend(standing("plate", plate, [1.0, 2.0], [0.75, 0.875]));
    Scene::try_new(patches).unwrap()
}

/// A shelf on the wall y = 0, which is cut out behind it.
pub fn shelf() -> Scene {
    let (x, z) = ([1.0, 3.0], [1.25, 1.5]);
    let mut patches = shell();
    // the wall y = 0 comes first
    patches.remove(0);
    let lines: [&[f64]; 2] = [&[0.0, 1.0, 3.0, 4.0], &[0.0, 1.25, 1.5, 2.5]];
    for x in lines[0].windows(2) {
        for z in lines[1].windows(2) {
            if [x[0], z[0]] != [1.0, 1.25] {
                let at = |x: f64, z: f64| [x, 0.0, z];
                let corners = [
                    at(x[0], z[0]),
                    at(x[0], z[1]),
                    at(x[1], z[1]),
                    at(x[1], z[0]),
                ];
                patches.push(facing("behind", corners, true));
            }
        }
    }
    patches.push(level("floor", [0.0, 4.0], [0.0, 3.0], 0.0, true));
    let mut faces = standing("shelf", x, [0.0, 0.5], z);
    // its back is on the wall
    faces.remove(0);
    faces.push(level("shelf", x, [0.0, 0.5], z[0], false));
    patches.extend(faces);
    Scene::try_new(patches).unwrap()
}

/// A U-shaped room.
pub fn u_room() -> Scene {
    prism(&[
        [0.0, 0.0],
        [3.0, 0.0],
        [3.0, 2.0],
        [2.0, 2.0],
        [2.0, 1.0],
        [1.0, 1.0],
        [1.0, 2.0],
        [0.0, 2.0],
    ])
}

/// A wall with two fronts that stands on the line between two patches of the floor.
pub fn partition() -> Scene {
    let mut patches = shell();
    for x in [[0.0, 2.0], [2.0, 4.0]] {
        patches.push(level("floor", x, [0.0, 3.0], 0.0, true));
    }
    let at = |y: f64, z: f64| [2.0, y, z];
    for front in [true, false] {
        let corners = [at(1.0, 0.0), at(2.0, 0.0), at(2.0, 1.0), at(1.0, 1.0)];
        patches.push(facing("partition", corners, front));
    }
    Scene::try_new(patches).unwrap()
}
