//! Values against scenes, which find congruent pairs and choose routes by other code, and against
//! enclosures.

use super::{edges, grid, lines};
use crate::support::intervals::cases;
use crate::support::references::rows;
use crate::support::rooms::polygon;
use glam::DVec3;
use infoscene::discretize::{BoxGrid, UNIT_CUBE};
use infoscene::exchange::{Congruence, ScenePairs};
use infoscene::information::{OpenScene, scene_information};
use infoscene::numeric::Interval;
use infoscene::scene::{NamedPatch, Occlusion, Scene};
use proptest::prelude::*;

/// The inside of a box, each face cut by the same relative lines.
fn scene([x, y, z]: [f64; 3], lines: &[f64]) -> Scene {
    let (x, y, z) = (x * DVec3::X, y * DVec3::Y, z * DVec3::Z);
    let faces = [
        (DVec3::ZERO, x, y),
        (z, y, x),
        (DVec3::ZERO, y, z),
        (x, z, y),
        (DVec3::ZERO, z, x),
        (y, x, z),
    ];
    let ends: Vec<f64> = [&[0.0], lines, &[1.0]].concat();
    let mut patches: Vec<NamedPatch> = Vec::new();
    for (origin, u, v) in faces {
        for s in ends.windows(2) {
            for t in ends.windows(2) {
                let corner = |s: f64, t: f64| (origin + s * u + t * v).to_array();
                let corners = [
                    corner(s[0], t[0]),
                    corner(s[1], t[0]),
                    corner(s[1], t[1]),
                    corner(s[0], t[1]),
                ];
                patches.push(polygon(&format!("{}", patches.len()), &corners));
            }
        }
    }
    Scene::try_new(patches).unwrap()
}

fn assert_agree(grid: &BoxGrid, scene: &Scene, what: &str) {
    let found = grid.information().unwrap().mutual_information;
    let pairs = ScenePairs::try_new(scene, 1e-14, Congruence::Shared, Occlusion::Refuse).unwrap();
    let other = scene_information(&pairs, OpenScene::Refuse)
        .unwrap()
        .mutual_information;
    let difference = found.value - other.value;
    assert!(
        difference.abs() <= found.error + other.error,
        "{what}: {} ± {:e}, {} ± {:e}",
        found.value,
        found.error,
        other.value,
        other.error
    );
    assert!(found.error <= 1e-12, "{what}: {:e}", found.error);
}

proptest! {
    #![proptest_config(cases(16))]

    /// I of the grid is I of the scene of its cells, within both bounds.
    #[test]
    fn grids_agree_with_scenes_of_their_cells(edges in edges(), lines in lines(3)) {
        assert_agree(
            &grid(edges, &lines),
            &scene(edges, &lines),
            &format!("{edges:?} {lines:?}"),
        );
    }

    /// The bound holds against an enclosure by other number types, and is small.
    #[test]
    fn errors_of_grids_are_bounds(edges in edges(), lines in lines(3)) {
        let grid = grid(edges, &lines);
        let found = grid.information().unwrap().mutual_information;
        let exact = grid
            .lifted(&Interval::precise(1.0, 160))
            .unwrap()
            .mutual_information()
            .unwrap();
        let (lower, upper) = exact.to_doubles();
        prop_assert!(upper - lower <= 1e-15, "{lower} {upper}");
        let value = found.value;
        prop_assert!(lower - found.error <= value && value <= upper + found.error);
        prop_assert!(found.error <= 2e-13 * (1.0 + value), "{:e}", found.error);
    }
}

/// Regular grids on boxes long, flat and three ways different, against their faces quartered.
#[test]
fn regular_grids_agree_with_quartered_boxes() {
    for (name, edges) in [
        ("box:1,1,1000", [1.0, 1.0, 1000.0]),
        ("box:1,1,0.001", [1.0, 1.0, 0.001]),
        ("box:1,2,3", [1.0, 2.0, 3.0]),
    ] {
        for times in 0..=2 {
            let (parts, _) = Scene::built_in(name).unwrap().subdivided(times).unwrap();
            let grid = BoxGrid::regular(edges, 1 << times).unwrap();
            assert_agree(&grid, &parts, &format!("{name} {times}"));
        }
    }
}

/// The two engines that count congruent pairs agree: `measure cube:6` looks each pair of the 216
/// patches up (n²), `grid --box 1,1,1 --cells 6` multiplies relations along the axes (n³ classes).
#[test]
fn the_grid_of_six_cells_is_the_scene_cube_6() {
    let grid = BoxGrid::regular(UNIT_CUBE, 6).unwrap();
    assert_agree(&grid, &Scene::built_in("cube:6").unwrap(), "cube:6");
}

/// Every row of cube_grids.csv that is a value: 13 to 29 digits.
#[test]
fn cubes_agree_with_their_references() {
    let mut count = 0;
    for row in rows("cube_grids.csv") {
        let Some(cells) = row.id.strip_prefix("cube_regular_") else {
            continue;
        };
        let found = BoxGrid::regular(UNIT_CUBE, cells.parse().unwrap()).unwrap();
        let found = found.information().unwrap().mutual_information;
        let exact = row.number("value");
        assert!((found.value - exact).abs() <= found.error, "{}", row.id);
        assert!(
            found.error <= 1e-13 * exact,
            "{}: {:e}",
            row.id,
            found.error
        );
        count += 1;
    }
    assert_eq!(count, 5);
}

/// Sharing leaves nothing out and counts nothing twice: lines that are equally spaced give the same
/// value as symmetric ones and as any, which share less.
#[test]
fn sharing_changes_no_value() {
    for edges in [UNIT_CUBE, [1.0, 1.0, 2.0], [1.0, 2.0, 3.0], [2.0, 1.0, 2.0]] {
        let regular = BoxGrid::regular(edges, 5).unwrap().information().unwrap();
        // an ulp away from regular; another away from symmetric
        let mut lines = vec![0.2, 0.4, 0.6, 0.8];
        lines[0] = f64::from_bits(0.2_f64.to_bits() + 1);
        let symmetric = grid(edges, &lines).information().unwrap();
        lines[0] = 0.2 + 1e-15;
        let any = grid(edges, &lines).information().unwrap();
        assert!(regular.classes < symmetric.classes && symmetric.classes < any.classes);
        for other in [symmetric, any] {
            let (other, regular) = (other.mutual_information, regular.mutual_information);
            let difference = other.value - regular.value;
            // lines moved by 1e-15 at a slope of a bit at most
            let allowed = regular.error + other.error + 1e-15;
            assert!(difference.abs() <= allowed, "{edges:?}: {difference:e}");
        }
    }
}
