//! Bad shapes and bad chains are refused with place, condition and mend.

use glam::DVec3;
use infoscene::chain::{ChainError, ReversibleChain};
use infoscene::form_factor::{FormFactorError, RectanglePair, parallel};
use infoscene::geometry::{GeometryError, Patch, Rectangle, Span, SplitAxis};
use infoscene::scene::{Scene, SceneError};
use nalgebra::{DMatrix, dmatrix};

fn polygon(corners: &[[f64; 3]]) -> Result<Patch, GeometryError> {
    Patch::try_new(
        corners
            .iter()
            .map(|corner| DVec3::from_array(*corner))
            .collect(),
    )
}

#[test]
fn degenerate_polygons_are_refused() {
    let square = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
    ];
    assert!(polygon(&square).is_ok());
    assert_eq!(
        polygon(&square[..2]).unwrap_err(),
        GeometryError::TooFewCorners { corners: 2 }
    );
    let mut bad = square;
    bad[2] = [f64::NAN, 0.0, 0.0];
    assert!(matches!(
        polygon(&bad).unwrap_err(),
        GeometryError::NotFinite { corner: 2, .. }
    ));
    let line = [[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]];
    assert!(matches!(
        polygon(&line).unwrap_err(),
        GeometryError::NoArea { .. }
    ));
    let mut bent = square;
    bent[2][2] = 1e-3;
    assert!(matches!(
        polygon(&bent).unwrap_err(),
        GeometryError::NotPlanar { .. }
    ));
    let bow_tie = [
        [0.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 2.0, 0.0],
    ];
    let crossing = polygon(&bow_tie).unwrap_err();
    assert!(
        matches!(
            crossing,
            GeometryError::NotSimple {
                first: 0,
                second: 2
            }
        ),
        "{crossing}"
    );
}

#[test]
fn concave_polygons_are_accepted() {
    let l = [
        [0.0, 0.0, 0.0],
        [2.0, 0.0, 0.0],
        [2.0, 1.0, 0.0],
        [1.0, 1.0, 0.0],
        [1.0, 2.0, 0.0],
        [0.0, 2.0, 0.0],
    ];
    let patch = polygon(&l).unwrap();
    assert_eq!((patch.area(), patch.normal()), (3.0, DVec3::Z));
    assert!(
        Rectangle::try_from(&patch)
            .unwrap_err()
            .to_string()
            .contains("6 corners")
    );
}

#[test]
fn rectangles_are_checked() {
    let leaning = Rectangle::try_new(DVec3::ZERO, DVec3::X, DVec3::new(0.1, 1.0, 0.0));
    assert!(leaning.unwrap_err().to_string().contains("leans"));
    let square = Rectangle::try_new(DVec3::ZERO, DVec3::X, DVec3::Y).unwrap();
    for position in [0.0, 1.0, -0.1, f64::NAN] {
        assert!(square.split(SplitAxis::U, position).is_err(), "{position}");
    }
    let turned = Rectangle::try_new(
        DVec3::Z,
        DVec3::new(1.0, 1.0, 0.0),
        DVec3::new(1.0, -1.0, 0.0),
    );
    let refusal = RectanglePair::try_new(&square, &turned.unwrap()).unwrap_err();
    assert!(
        matches!(
            refusal,
            FormFactorError::Geometry(GeometryError::NotAligned { .. })
        ),
        "{refusal}"
    );
}

#[test]
fn distances_and_spans_are_checked() {
    let unit = Span::try_new(0.0, 1.0).unwrap();
    for distance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refusal = parallel::exchange_area(&[unit, unit], &[unit, unit], &distance);
        assert!(
            matches!(refusal, Err(FormFactorError::NonPositiveLength { .. })),
            "{distance}"
        );
    }
    for (lower, upper) in [
        (1.0, 1.0),
        (1.0, 0.0),
        (f64::NAN, 1.0),
        (0.0, f64::INFINITY),
    ] {
        assert!(Span::try_new(lower, upper).is_err());
    }
}

#[test]
fn bad_joint_matrices_are_refused_with_the_entry() {
    let refuse = |matrix: DMatrix<f64>| ReversibleChain::try_new(matrix).unwrap_err();
    assert_eq!(refuse(DMatrix::zeros(0, 0)), ChainError::Empty);
    assert_eq!(
        refuse(DMatrix::zeros(1, 2)),
        ChainError::NotSquare {
            rows: 1,
            columns: 2
        }
    );
    assert_eq!(
        refuse(DMatrix::zeros(2, 2)),
        ChainError::NoMass { total: 0.0 }
    );
    let entry = |row, column, value| ChainError::InvalidEntry { row, column, value };
    assert_eq!(refuse(dmatrix![1.0, -1.0; -1.0, 1.0]), entry(0, 1, -1.0));
    assert!(matches!(
        refuse(dmatrix![1.0, 0.0; 0.0, f64::NAN]),
        ChainError::InvalidEntry {
            row: 1,
            column: 1,
            ..
        }
    ));
    let huge = refuse(DMatrix::from_element(2, 2, 1e308));
    assert_eq!(
        huge,
        ChainError::NoMass {
            total: f64::INFINITY
        }
    );
    let even = dmatrix![0.5, 0.5; 0.5, 0.5];
    let from = |weights: [f64; 2]| ReversibleChain::try_from_transitions(&weights, &even);
    let negative = ChainError::InvalidWeight {
        state: 0,
        value: -1.0,
    };
    assert_eq!(from([-1.0, 1.0]).unwrap_err(), negative);
    assert!(matches!(
        from([1e-320, 1e-320]).unwrap_err(),
        ChainError::Underflow { .. }
    ));
    assert!(from([7e307, 7e307]).is_ok());
    let halved = dmatrix![0.5, 0.4; 0.5, 0.5];
    let refusal = ReversibleChain::try_from_transitions(&[1.0, 1.0], &halved).unwrap_err();
    assert!(
        matches!(refusal, ChainError::RowSumNotOne { row: 0, .. }),
        "{refusal}"
    );
}

#[test]
fn unknown_scenes_and_patches_are_refused() {
    for name in [
        "", "sphere", "cube:", "cube:0", "cube:65", "cube:-1", "cube:1.5",
    ] {
        assert!(
            matches!(Scene::built_in(name), Err(SceneError::UnknownName { .. })),
            "{name}"
        );
    }
    let refusal = Scene::built_in("two-squares")
        .unwrap()
        .rectangle(2)
        .unwrap_err();
    assert_eq!(refusal, SceneError::NoSuchPatch { index: 2, last: 1 });
    assert_eq!(Scene::try_new(Vec::new()).unwrap_err(), SceneError::Empty);
}
