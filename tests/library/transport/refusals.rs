//! Systems without equilibrium, and input that is no scene, are refused by name.

use infoscene::scene::{Material, Scene};
use infoscene::transport::{DenseExchange, RadiositySystem, TransportError};
use nalgebra::{DMatrix, dmatrix};

fn pair(reflectances: Vec<f64>) -> Result<RadiositySystem<DenseExchange<'static>>, TransportError> {
    RadiositySystem::of_matrix(&dmatrix![0.0, 1.0; 1.0, 0.0], reflectances)
}

#[test]
fn reflectances_are_shares() {
    for value in [1.0 + f64::EPSILON, 1.5, -0.1, f64::NAN, f64::INFINITY] {
        let refusal = pair(vec![0.5, value]).unwrap_err();
        assert!(
            matches!(
                refusal,
                TransportError::ReflectanceOutOfRange { patch: 1, .. }
            ),
            "{refusal}"
        );
    }
    let refusal = pair(vec![1e-300, 0.5]).unwrap_err();
    assert!(matches!(
        refusal,
        TransportError::ReflectanceTooSmall { patch: 0, .. }
    ));
}

#[test]
fn scenes_without_light_are_refused() {
    let room = pair(vec![0.5, 0.5]).unwrap();
    let refusal = room.radiosity(&[0.0, 0.0]).unwrap_err();
    assert_eq!(
        refusal.to_string(),
        "no patch has a positive emittance: give one to a patch at least"
    );
    assert!(matches!(
        room.importance(&[0.0, 0.0]),
        Err(TransportError::NoSource { .. })
    ));
}

#[test]
fn sources_are_numbers_one_for_each_patch() {
    let room = pair(vec![0.5, 0.5]).unwrap();
    for value in [-1.0, f64::NAN, f64::INFINITY] {
        let refusal = room.radiosity(&[1.0, value]).unwrap_err();
        assert!(matches!(
            refusal,
            TransportError::SourceOutOfRange { patch: 1, .. }
        ));
    }
    let refusal = room.radiosity(&[1.0]).unwrap_err();
    assert!(matches!(
        refusal,
        TransportError::WrongCount {
            found: 1,
            expected: 2,
            ..
        }
    ));
    let cube = Scene::built_in("cube:1").unwrap().exchange_areas().unwrap();
    let refusal = RadiositySystem::of(&cube, &[Material::BLACK; 5]).unwrap_err();
    assert!(matches!(
        refusal,
        TransportError::WrongCount {
            found: 5,
            expected: 6,
            ..
        }
    ));
}

#[test]
fn a_matrix_is_symmetric_and_not_negative() {
    let refused = |matrix: &DMatrix<f64>| RadiositySystem::of_matrix(matrix, vec![0.5; 2]).is_err();
    assert!(refused(&dmatrix![0.0, 1.0; 2.0, 0.0]));
    assert!(refused(&dmatrix![0.0, -1.0; -1.0, 0.0]));
    assert!(refused(&dmatrix![f64::NAN, 1.0; 1.0, 0.0]));
    assert!(refused(&dmatrix![0.0, 1.0]));
    assert!(refused(&dmatrix![1.0]));
    assert!(!refused(&dmatrix![0.0, 1.0; 1.0, 0.0]));
}

/// Patches that see nothing, light that reaches none, and rooms beyond the range of products: no
/// panic, no NaN.
#[test]
fn extreme_rooms_are_answered() {
    // alone: B = E
    let alone = RadiositySystem::of_matrix(&dmatrix![0.0], vec![0.5]).unwrap();
    assert_eq!(alone.radiosity(&[2.0]).unwrap().values, [2.0]);
    // the second room is dark
    let apart = dmatrix![
        0.0, 1.0, 0.0, 0.0;
        1.0, 0.0, 0.0, 0.0;
        0.0, 0.0, 0.0, 1.0;
        0.0, 0.0, 1.0, 0.0
    ];
    let rooms = RadiositySystem::of_matrix(&apart, vec![0.5; 4]).unwrap();
    let found = rooms.radiosity(&[3.0, 0.0, 0.0, 0.0]).unwrap();
    assert_eq!(found.values, [4.0, 2.0, 0.0, 0.0]);
    for unit in [1e-300, 1e300] {
        let room = dmatrix![0.0, unit; unit, 0.0];
        let room = RadiositySystem::of_matrix(&room, vec![0.5; 2]).unwrap();
        assert_eq!(room.radiosity(&[3.0, 0.0]).unwrap().values, [4.0, 2.0]);
    }
    let black = pair(vec![0.0, 0.0]).unwrap();
    let found = black.radiosity(&[3.0, 0.0]).unwrap();
    assert_eq!(
        (found.values, found.received),
        (vec![3.0, 0.0], vec![0.0, 3.0])
    );
    let looked_at = black.importance(&[1.0, 0.0]).unwrap();
    assert_eq!(looked_at.values, [1.0, 0.0]);
}
