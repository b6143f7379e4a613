//! Parts of bases: the patches that may lie in others, and the remainders.

use glam::DVec3;
use infoscene::geometry::{Patch, SplitAxis};
use infoscene::scene::{Material, NamedPatch, Scene, SceneError};

fn polygon(corners: &[(f64, f64)]) -> Patch {
    let corners = corners.iter().map(|(x, y)| DVec3::new(*x, *y, 0.0));
    Patch::try_new(corners.collect()).unwrap()
}

fn scene(patches: &[Patch]) -> Scene {
    let named = patches
        .iter()
        .map(|shape| NamedPatch::new("a".to_owned(), shape.clone()));
    Scene::try_new(named.collect()).unwrap()
}

/// An L of area 3 with its notch at (1, 1).
fn outer() -> Patch {
    polygon(&[
        (0.0, 0.0),
        (2.0, 0.0),
        (2.0, 1.0),
        (1.0, 1.0),
        (1.0, 2.0),
        (0.0, 2.0),
    ])
}

#[test]
fn a_part_may_touch_the_outline_of_its_base() {
    for part in [
        polygon(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]),
        polygon(&[(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0)]),
        polygon(&[(0.2, 0.2), (0.4, 0.2), (0.4, 0.4)]),
        polygon(&[(0.0, 2.0), (0.0, 0.0), (2.0, 0.0), (1.0, 1.0)]),
    ] {
        let area = part.area();
        let both = scene(&[outer(), part]).with_base(1, 0).unwrap();
        assert_eq!((both.net_area(0), both.total_area()), (3.0 - area, 3.0));
    }
}

#[test]
fn a_part_outside_its_base_is_refused() {
    for part in [
        // in the notch, across the notch, over an edge, all around, only touching
        polygon(&[(1.5, 1.5), (1.9, 1.5), (1.9, 1.9)]),
        polygon(&[(0.0, 2.0), (0.0, 1.9), (2.0, 0.9), (2.0, 1.0)]),
        polygon(&[(-0.5, 0.2), (0.5, 0.2), (0.5, 0.4)]),
        polygon(&[(-1.0, -1.0), (3.0, -1.0), (3.0, 3.0), (-1.0, 3.0)]),
        polygon(&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]),
        polygon(&[(2.0, 0.0), (3.0, 0.0), (3.0, 1.0), (2.0, 1.0)]),
    ] {
        let refusal = scene(&[outer(), part.clone()]).with_base(1, 0).unwrap_err();
        assert_eq!(
            refusal,
            SceneError::PartOutside { part: 1, base: 0 },
            "{part:?}"
        );
    }
}

/// Parts are accepted and refused alike in any unit of length.
#[test]
fn inside_and_outside_do_not_depend_on_the_scale() {
    for exponent in [-150, 150] {
        let scale = 10f64.powi(exponent);
        let square = |from: f64, to: f64| {
            let corners = [(from, from), (to, from), (to, to), (from, to)];
            polygon(&corners.map(|(x, y)| (scale * x, scale * y)))
        };
        let with_part = |part| scene(&[square(0.0, 1.0), part]).with_base(1, 0);
        assert!(with_part(square(0.25, 0.5)).is_ok());
        let refusal = with_part(square(0.5, 1.5)).unwrap_err();
        assert_eq!(refusal, SceneError::PartOutside { part: 1, base: 0 });
    }
}

#[test]
fn a_part_is_in_the_plane_of_its_base_and_faces_the_same_way() {
    let part = [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y];
    let reversed = Patch::try_new(part.into_iter().rev().collect()).unwrap();
    let refusal = scene(&[outer(), reversed]).with_base(1, 0).unwrap_err();
    assert_eq!(refusal, SceneError::PartFacesAway { part: 1, base: 0 });
    let lifted = Patch::try_new(part.map(|corner| corner + 1e-9 * DVec3::Z).to_vec()).unwrap();
    let refusal = scene(&[outer(), lifted]).with_base(1, 0).unwrap_err();
    assert!(
        matches!(refusal, SceneError::PartOffPlane { .. }),
        "{refusal}"
    );
}

#[test]
fn bases_do_not_run_in_circles_and_keep_some_area() {
    let square = polygon(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
    let small = polygon(&[(0.0, 0.0), (0.5, 0.0), (0.5, 0.5), (0.0, 0.5)]);
    let nested = scene(&[outer(), square.clone(), small]);
    let nested = nested.with_base(2, 1).unwrap().with_base(1, 0).unwrap();
    assert_eq!([0, 1, 2].map(|i| nested.net_area(i)), [2.0, 0.75, 0.25]);
    assert_eq!(nested.total_area(), 3.0);
    let refusal = nested.with_base(0, 2).unwrap_err();
    assert_eq!(refusal, SceneError::BaseCycle { part: 0, base: 2 });
    let refusal = scene(&[square.clone(), square])
        .with_base(1, 0)
        .unwrap_err();
    assert!(
        matches!(refusal, SceneError::NothingLeft { base: 0, .. }),
        "{refusal}"
    );
    let refusal = scene(&[outer()]).with_base(0, 1).unwrap_err();
    assert_eq!(refusal, SceneError::NoSuchPatch { index: 1, last: 0 });
}

/// A base is no rectangle any more, and cannot be cut; a part can, and stays in its base.
#[test]
fn cutting_keeps_base_row_and_material() {
    let square = polygon(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
    let small = polygon(&[(0.0, 0.0), (0.5, 0.0), (0.5, 0.5), (0.0, 0.5)]);
    let paint = Material::try_new(0.5, 0.0).unwrap();
    let patches =
        [square, small].map(|shape| NamedPatch::new("a".to_owned(), shape).with_material(paint));
    let whole = Scene::try_new(patches.to_vec())
        .unwrap()
        .with_base(1, 0)
        .unwrap();
    let refusal = whole.rectangle(0).unwrap_err();
    assert!(
        refusal.to_string().contains("patch 1 lies in it"),
        "{refusal}"
    );
    let refusal = whole.with_patch_split(0, SplitAxis::U, 0.5).unwrap_err();
    assert_eq!(refusal, SceneError::CutThroughPart { base: 0, part: 1 });
    let cut = whole.with_patch_split(1, SplitAxis::U, 0.5).unwrap();
    assert_eq!(
        (cut.base_of(2), cut.net_area(0), cut.group_count()),
        (Some(0), 0.75, 3)
    );
    assert!(
        cut.patches()
            .iter()
            .all(|patch| patch.material().grey() == Some(paint))
    );
    let one_row = whole.clone().with_groups(&["row", "row"]).unwrap();
    let cut = one_row.with_patch_split(1, SplitAxis::U, 0.5).unwrap();
    assert_eq!((cut.group_of(2), cut.group_count()), (0, 1));
    let refusal = whole.with_groups(&[0]).unwrap_err();
    assert_eq!(
        refusal,
        SceneError::LabelCount {
            labels: 1,
            patches: 2
        }
    );
}
