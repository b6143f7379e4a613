//! Patches that lie on each other are found, and neighbours are not.

use crate::support::rooms::{L, facing, level, mapped, mapped_patch, placing, polygon, prism};
use glam::DVec3;
use infoscene::scene::{NamedPatch, Scene, SceneError};
use proptest::prelude::*;

fn found(patches: &[NamedPatch]) -> Option<(usize, usize)> {
    Scene::try_new(patches.to_vec()).unwrap().overlap()
}

fn square(x: f64, y: f64) -> NamedPatch {
    level("square", [x, x + 1.0], [y, y + 1.0], 0.0, true)
}

#[test]
fn overlapping_patches_are_refused_by_name() {
    let scene = Scene::try_new(vec![
        level("wall", [5.0, 6.0], [0.0, 1.0], 3.0, true),
        square(0.0, 0.0),
        level("rug", [0.5, 1.5], [0.5, 1.5], 0.0, true),
    ]);
    let scene = scene.unwrap();
    assert_eq!(scene.overlap(), Some((1, 2)));
    let refusal = scene.check_overlap().unwrap_err();
    assert!(matches!(
        refusal,
        SceneError::Overlap {
            first: 1,
            second: 2,
            ..
        }
    ));
    let text = refusal.to_string();
    assert!(
        text.contains("1 (square)") && text.contains("2 (rug)"),
        "{text}"
    );
    assert_eq!(Scene::built_in("cube:8").unwrap().check_overlap(), Ok(()));
}

/// Equal, contained, crossing without a corner inside, by a billionth; and the same as neighbours.
#[test]
fn every_way_to_overlap_is_found() {
    let own = square(0.0, 0.0);
    let on = [
        square(0.0, 0.0),
        level("inside", [0.2, 0.3], [0.2, 0.3], 0.0, true),
        level("around", [-1.0, 2.0], [-1.0, 2.0], 0.0, true),
        level("across", [-1.0, 2.0], [0.4, 0.6], 0.0, true),
        level("billionth", [1.0 - 1e-9, 2.0], [0.0, 1.0], 0.0, true),
        polygon(
            "corner",
            &[[0.9, 0.9, 0.0], [2.0, 0.9, 0.0], [0.9, 2.0, 0.0]],
        ),
    ];
    for other in on {
        assert_eq!(
            found(&[own.clone(), other.clone()]),
            Some((0, 1)),
            "{}",
            other.name()
        );
        assert_eq!(
            found(&[other.clone(), own.clone()]),
            Some((0, 1)),
            "{}",
            other.name()
        );
    }
    let off = [
        square(1.0, 0.0),
        square(1.0, 1.0),
        square(1.0, 0.3),
        level("gap", [1.0 + 1e-9, 2.0], [0.0, 1.0], 0.0, true),
        level("other side", [0.0, 1.0], [0.0, 1.0], 0.0, false),
        level("above", [0.0, 1.0], [0.0, 1.0], 1e-9, true),
        polygon(
            "corner",
            &[[1.0, 1.0, 0.0], [2.0, 1.0, 0.0], [1.0, 2.0, 0.0]],
        ),
        polygon(
            "box's corner",
            &[[0.95, 1.9, 0.0], [1.9, 0.95, 0.0], [1.9, 1.9, 0.0]],
        ),
        polygon(
            "tilted",
            &[
                [0.2, 0.2, -0.5],
                [0.8, 0.2, 0.5],
                [0.8, 0.8, 0.5],
                [0.2, 0.8, -0.5],
            ],
        ),
        facing(
            "upright",
            [[0.5, 0.0, 0.0], [0.5, 1.0, 0.0], [0.5, 1.0, 1.0]],
            true,
        ),
    ];
    for other in off {
        assert_eq!(
            found(&[own.clone(), other.clone()]),
            None,
            "{}",
            other.name()
        );
    }
}

/// A square in the notch of an L touches it along two edges; the L's convex hull would overlap.
#[test]
fn a_notch_can_be_filled() {
    let l = polygon("l", &L.map(|[x, y]| [x, y, 0.0]));
    assert_eq!(found(&[l.clone(), square(1.0, 1.0)]), None);
    let into = level("into", [1.0 - 1e-9, 2.0], [1.0, 2.0], 0.0, true);
    assert_eq!(found(&[l, into]), Some((0, 1)));
    assert_eq!(prism(&L).overlap(), None);
}

proptest! {
    /// Neighbours of a turned wall share their edges up to the noise of the corners; one that
    /// reaches further is found.
    #[test]
    fn neighbours_in_a_rotated_wall_do_not_overlap(
        (turn, size, shift) in placing(),
        cells in 1..8u32,
        extra in -6.0..0.0f64,
    ) {
        let place = |corner: DVec3| turn * corner * size + shift;
        let cube = mapped(&Scene::built_in(&format!("cube:{cells}")).unwrap(), place);
        prop_assert_eq!(cube.overlap(), None);
        let mut patches = cube.patches().to_vec();
        let reach = 10f64.powf(extra);
        let rug = level("rug", [-1.0, reach], [0.0, 0.1], 0.0, true);
        patches.push(mapped_patch(&rug, place));
        let last = patches.len() - 1;
        prop_assert_eq!(found(&patches), Some((0, last)));
    }

    /// Rectangles on integer lines overlap if and only if their sides do, in the plane, turned and
    /// in any unit.
    #[test]
    fn integer_rectangles_overlap_as_their_sides_do(
        sides in proptest::collection::vec((0..9i32, 1..4i32, 0..9i32, 1..4i32), 2..6),
        (turn, size, shift) in placing(),
        power in -400..400i32,
    ) {
        let flat: Vec<NamedPatch> = sides
            .iter()
            .map(|(x, w, y, h)| {
                level(
                    "r",
                    [*x, x + w].map(f64::from),
                    [*y, y + h].map(f64::from),
                    0.0,
                    true,
                )
            })
            .collect();
        let pairs = (0..sides.len()).flat_map(|i| (i + 1..sides.len()).map(move |j| (i, j)));
        let expected = pairs.into_iter().find(|(i, j)| {
            let ((x, w, y, h), (a, b, c, d)) = (sides[*i], sides[*j]);
            x < a + b && a < x + w && y < c + d && c < y + h
        });
        prop_assert_eq!(found(&flat), expected);
        let scale = 2f64.powi(power);
        for map in [
            &(|p: DVec3| turn * p * size + shift) as &dyn Fn(DVec3) -> DVec3,
            &|p| p * scale,
        ] {
            let moved: Vec<NamedPatch> =
                flat.iter().map(|patch| mapped_patch(patch, map)).collect();
            prop_assert_eq!(found(&moved), expected);
        }
    }
}
