//! Best cuts of perpendicular rectangles against 25-digit values.

use crate::support::references::value;
use infoscene::discretize::PatchSplit;
use infoscene::geometry::SplitAxis;
use infoscene::numeric::tolerance;
use infoscene::scene::Scene;

fn splits(id: &str) -> f64 {
    value("splits.csv", id)
}

/// The file's U is `½ A_T ΔI`.
fn assert_gain(split: &PatchSplit, scene: &Scene, positions: &[f64], id: &str) {
    let u = 0.5 * scene.total_area() * split.gain(positions).unwrap();
    let exact = splits(id);
    assert!(
        (u - exact).abs() <= tolerance::GAIN * exact,
        "{id}: {u} against {exact}"
    );
}

fn assert_best(scene: &Scene, against: &[usize], axis: SplitAxis, id: &str) {
    let split = PatchSplit::try_new(scene, 0, against, axis).unwrap();
    let best = split.best(2).unwrap();
    let exact = splits(&format!("{id}_t"));
    assert!(
        (best.positions[0] - exact).abs() <= tolerance::POSITION,
        "{id}: {:?} against {exact}",
        best
    );
    assert_gain(&split, scene, &best.positions, &format!("{id}_U"));
}

/// Fig. 2(c): 40 % from the common edge, and the same for a floor twice as deep.
#[test]
fn parallel_cuts_of_two_rectangles_agree_with_25_digits() {
    assert_best(
        &Scene::floor_and_wall(1.0).unwrap(),
        &[1],
        SplitAxis::U,
        "split_perp_par_bothdepth1",
    );
    assert_best(
        &Scene::floor_and_wall(2.0).unwrap(),
        &[1],
        SplitAxis::U,
        "split_perp_par_splitdepth2",
    );
}

/// Fig. 2(b): the best orthogonal cut lies 12 % from a side edge.
#[test]
fn orthogonal_cut_of_two_squares_agrees_with_25_digits() {
    assert_best(
        &Scene::floor_and_wall(1.0).unwrap(),
        &[1],
        SplitAxis::V,
        "split_perp_orth_bothdepth1",
    );
}

/// Fig. 3: 39 % from the common edge.
#[test]
fn cut_in_a_corner_agrees_with_25_digits() {
    let corner = Scene::built_in("three-squares").unwrap();
    let split = PatchSplit::try_new(&corner, 0, &[1, 2], SplitAxis::U).unwrap();
    let best = split.best(2).unwrap();
    assert!((best.positions[0] - splits("three_squares_t")).abs() <= tolerance::POSITION);
    assert_gain(&split, &corner, &best.positions, "three_squares_U");
}

/// The curves of figs. 2(c) and 3(b), point by point.
#[test]
fn curves_agree_with_28_digits() {
    let squares = Scene::built_in("two-squares").unwrap();
    let corner = Scene::built_in("three-squares").unwrap();
    let parallel = PatchSplit::try_new(&squares, 0, &[1], SplitAxis::U).unwrap();
    let orthogonal = PatchSplit::try_new(&squares, 0, &[1], SplitAxis::V).unwrap();
    let three = PatchSplit::try_new(&corner, 0, &[1, 2], SplitAxis::U).unwrap();
    for (tenths, t) in [(2, 0.2), (4, 0.4), (6, 0.6), (8, 0.8)] {
        assert_gain(
            &parallel,
            &squares,
            &[t],
            &format!("curve_perp_par_t{tenths}"),
        );
        assert_gain(&three, &corner, &[t], &format!("curve_three_t{tenths}"));
    }
    for (tenths, t) in [(2, 0.2), (4, 0.4)] {
        assert_gain(
            &orthogonal,
            &squares,
            &[t],
            &format!("curve_perp_orth_t{tenths}"),
        );
    }
}
