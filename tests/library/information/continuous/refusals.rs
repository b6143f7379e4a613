//! Rooms that are open or not convex inside are refused, with the patch.

use crate::support::rooms::{L, prism};
use infoscene::chain::ChainError;
use infoscene::exchange::ExchangeError;
use infoscene::form_factor::{FormFactorError, LogMeans};
use infoscene::information::continuous_information;
use infoscene::scene::{Scene, SceneError};

fn refusal(scene: &Scene) -> SceneError {
    match continuous_information(scene) {
        Err(ChainError::Scene(refusal)) => refusal,
        other => panic!("{other:?}"),
    }
}

#[test]
fn concave_rooms_are_refused() {
    let refused = refusal(&prism(&L));
    assert!(
        matches!(refused, SceneError::NotConvex { depth, .. } if depth > 0.9),
        "{refused}"
    );
}

#[test]
fn open_rooms_are_refused() {
    let squares = Scene::built_in("two-squares").unwrap();
    let Err(ChainError::Exchange(refused)) = continuous_information(&squares) else {
        panic!("it is open");
    };
    assert!(
        matches!(refused, ExchangeError::OpenScene { .. }),
        "{refused}"
    );
    // a hole in a wall
    let cube = Scene::built_in("cube:3").unwrap();
    let mut patches = cube.patches().to_vec();
    patches.remove(4);
    let refused = refusal(&Scene::try_new(patches).unwrap());
    assert!(
        matches!(
            refused,
            SceneError::FaceNotCovered { index: 0, relative, .. }
                if (relative - 1.0 / 9.0).abs() < 1e-12
        ),
        "{refused}"
    );
}

/// A box whose patches look outward has everything behind them.
#[test]
fn outsides_are_refused() {
    let cube = Scene::built_in("cube:1").unwrap();
    let mirrored = crate::support::rooms::mapped(&cube, |corner| {
        glam::DVec3::new(corner.y, corner.x, corner.z)
    });
    assert!(matches!(refusal(&mirrored), SceneError::NotConvex { .. }));
}

#[test]
fn polygons_behind_each_other_are_refused() {
    let cube = Scene::built_in("cube:1").unwrap();
    let floor = cube.patches()[0].shape();
    let across = crate::support::rooms::polygon(
        "across",
        &[[0.5, 0.0, -0.5], [0.5, 1.0, -0.5], [0.5, 1.0, 0.5]],
    );
    let refused = LogMeans::of(floor, across.shape()).unwrap_err();
    assert!(
        matches!(refused, FormFactorError::BehindPlane { .. }),
        "{refused}"
    );
}
