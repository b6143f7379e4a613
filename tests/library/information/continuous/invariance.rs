//! Continuous mutual information is a number of the shape: not of its size, its place, or its
//! division.

use super::{SOLIDS, information};
use crate::support::rooms::mapped;
use glam::{DQuat, DVec3};
use infoscene::information::continuous_information;
use infoscene::scene::Scene;
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig { cases: 6, ..ProptestConfig::default() })]

    /// Corners that are turned and scaled are rounded by ε of their size, which the value feels by
    /// some ε.
    #[test]
    fn scale_and_rotation_change_nothing(
        solid in 0usize..4,
        edges in [0.2..5.0f64, 0.2..5.0],
        axis in [-1.0..1.0f64, -1.0..1.0, 0.1..1.0],
        angle in 0.0..3.0f64,
        decade in -6.0..6.0f64,
    ) {
        let scene = match solid {
            0 => Scene::built_in("tetrahedron").unwrap(),
            1 => Scene::built_in("octahedron").unwrap(),
            _ => Scene::inside_of_box(1.0, edges[0], edges[1]).unwrap(),
        };
        let turn = DQuat::from_axis_angle(DVec3::from_array(axis).normalize(), angle);
        let scale = 10f64.powf(decade);
        let expected = match solid {
            0 => information("tetrahedron"),
            1 => information("octahedron"),
            _ => continuous_information(&scene).unwrap(),
        };
        let expected = expected.mutual_information.value;
        let turned = mapped(&scene, |corner| scale * (turn * corner));
        let found = continuous_information(&turned).unwrap();
        let found = found.mutual_information.value;
        let off = (found - expected).abs();
        prop_assert!(off <= 1e-12 * expected.max(1.0), "{found} {expected}");
    }
}

#[test]
fn division_changes_nothing() {
    for name in &SOLIDS[..3] {
        let whole = Scene::built_in(name).unwrap();
        let (parts, _) = whole.subdivided(1).unwrap();
        let found = continuous_information(&parts).unwrap();
        let expected = information(name).mutual_information.value;
        assert_eq!(found.faces, whole.patches().len());
        assert!(
            (found.mutual_information.value - expected).abs() < 1e-13,
            "{name}: {} {expected}",
            found.mutual_information.value
        );
    }
}
