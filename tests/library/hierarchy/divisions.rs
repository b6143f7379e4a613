//! Elements cut in two at the best place.

use super::lit_rooms::{lighting, reference, refined_by, start};
use glam::DVec3;
use infoscene::geometry::{Patch, SplitAxis};
use infoscene::hierarchy::{CutCriterion, Division, OracleName, Tree};
use infoscene::scene::Scene;

const SQUARE: Division = Division::Bisection(CutCriterion::MeanSquare);
const INFORMATION: Division = Division::Bisection(CutCriterion::Information);

/// A third of a square along u lies before 1/3, and a triangle is cut into a trapezium and a
/// triangle.
#[test]
fn parts_of_a_cut_make_up_the_whole() {
    let square = Patch::try_new(vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y]);
    let triangle = Patch::try_new(vec![DVec3::ZERO, DVec3::X, DVec3::Y]);
    let mut tree = Tree::new([&square.unwrap(), &triangle.unwrap()]);
    // of the triangle 1 − (2/3)² lies before
    for (patch, before) in [(0, 1.0 / 3.0), (1, 0.5 * 5.0 / 9.0)] {
        let parts = tree.bisect(patch, SplitAxis::U, 1.0 / 3.0).unwrap();
        let areas: Vec<f64> = parts
            .map(|part| tree.elements()[part].shape().area())
            .collect();
        assert!((areas[0] - before).abs() < 1e-15);
        let whole = tree.elements()[patch].shape().area();
        assert!((areas.iter().sum::<f64>() - whole).abs() < 1e-15);
    }
    assert_eq!(tree.leaf_count(), 4);
    assert_eq!(tree.leaf_at(0, DVec3::new(0.2, 0.5, 0.0)), Some(2));
    assert_eq!(tree.leaf_at(0, DVec3::new(0.4, 0.5, 0.0)), Some(3));
    assert_eq!(tree.leaf_at(0, DVec3::new(1.4, 0.5, 0.0)), None);
    assert!(tree.bisect(2, SplitAxis::V, 1.0).is_err());
}

/// §4.2's hope: the cut of highest information is as good as that of least square error, and cuts
/// at the best place do better than quarters.
#[test]
fn cuts_at_the_best_place_beat_quarters() {
    let scene = Scene::built_in("lit-cube").unwrap();
    let materials = lighting(&scene);
    let reference = reference(&scene, &materials, 2000);
    let oracle = OracleName::True.oracle(Some(&reference)).unwrap();
    let error = |division| {
        let room = start(&scene, &materials).with_division(division);
        let room = refined_by(&*oracle, room, 100);
        reference.projection_error_of(room.tree())
    };
    let quarters = error(Division::Quarters);
    let [square, information] = [SQUARE, INFORMATION].map(error);
    assert!(square < quarters / 1.4, "{square} {quarters}");
    assert!(
        (information / square - 1.0).abs() < 0.02,
        "{information} {square}"
    );
}
