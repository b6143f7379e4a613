//! Nets: the walls of a scene in their size and shape, none on another one.

use infoscene::exchange::Unheard;
use infoscene::hierarchy::Goal;
use infoscene::question::{MaterialChanges, MeshNet, NetWish, Refine};

const SCENES: [&str; 6] = [
    "lit-cube",
    "lit-wings",
    "shaded-cube",
    "two-squares",
    "dodecahedron",
    "icosahedron",
];

fn net(scene: &str, linear: bool) -> (MeshNet, f64) {
    let question = Refine {
        scene: scene.into(),
        goal: Goal::Elements(40),
        linear,
        materials: MaterialChanges {
            reflectance: vec!["all=0.5".parse().unwrap()],
            emittance: vec!["all=0".parse().unwrap(), "0".parse().unwrap()],
        },
        net: Some(NetWish::default()),
        ..Refine::default()
    };
    let answer = question.ask(&Unheard).unwrap();
    let area = answer.patches.iter().map(|patch| patch.area).sum();
    (answer.net.unwrap(), area)
}

fn area(corners: &[[f64; 2]]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    let doubled = corners
        .iter()
        .zip(next)
        .map(|(a, b)| a[0] * b[1] - a[1] * b[0]);
    0.5 * doubled.sum::<f64>()
}

/// Does a point lie inside of a convex polygon, farther from its edges than this?
fn is_deep_inside(point: [f64; 2], corners: &[[f64; 2]], depth: f64) -> bool {
    let mut edges = corners.iter().zip(corners.iter().cycle().skip(1));
    edges.all(|(a, b)| {
        let edge = [b[0] - a[0], b[1] - a[1]];
        let height = edge[0] * (point[1] - a[1]) - edge[1] * (point[0] - a[0]);
        height > depth * edge[0].hypot(edge[1])
    })
}

/// Fronts are towards the reader, so that corners turn left, and all walls have one scale.
#[test]
fn walls_keep_their_area_and_their_sense() {
    for scene in SCENES {
        let (net, whole) = net(scene, false);
        assert!(net.leaves.iter().all(|leaf| area(leaf) > 0.0), "{scene}");
        let sum: f64 = net.leaves.iter().map(|leaf| area(leaf)).sum();
        // coordinates of some units, to some ε
        assert!((sum / whole - 1.0).abs() < 1e-12, "{scene}: {sum} {whole}");
    }
}

#[test]
fn no_leaf_lies_on_another_one() {
    for scene in SCENES {
        let (net, whole) = net(scene, false);
        let side = 0.01 * whole.sqrt();
        for (index, leaf) in net.leaves.iter().enumerate() {
            let count = leaf.len() as f64;
            let middle = [0, 1].map(|k| leaf.iter().map(|corner| corner[k]).sum::<f64>() / count);
            for point in leaf.iter().chain([&middle]) {
                // walls that share an edge miss each other by rounding
                let others = net
                    .leaves
                    .iter()
                    .enumerate()
                    .filter(|(other, _)| *other != index);
                let on = others.filter(|(_, other)| is_deep_inside(*point, other, 1e-9 * side));
                assert_eq!(on.count(), 0, "{scene}: {point:?}");
            }
        }
    }
}

#[test]
fn cells_cover_the_walls_and_lights_have_no_value() {
    for linear in [false, true] {
        let (net, whole) = net("lit-cube", linear);
        let sum: f64 = net.cells.iter().map(|cell| area(&cell.corners)).sum();
        assert!((sum / whole - 1.0).abs() < 1e-12);
        let lights = net.cells.iter().filter(|cell| cell.value.is_none());
        // the floor
        assert!((lights.map(|cell| area(&cell.corners)).sum::<f64>() - 1.0).abs() < 1e-12);
        assert_eq!(net.cells.len() > net.leaves.len(), linear);
    }
}
