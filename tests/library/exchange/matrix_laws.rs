//! The laws of form factors: a sound matrix breaks none, and each fault breaks its own.

use infoscene::Scene;
use infoscene::exchange::{MatrixLaws, MatrixLawsError};

/// Howell, C-14 and C-11 at unit squares: the faces of a cube, to 13 digits.
const SIDE: f64 = 0.200_043_776_075_4;
const OPPOSITE: f64 = 0.199_824_895_698_4;
const DIGITS: f64 = 1e-13;

/// The form factors inside of a cube: faces 2k and 2k + 1 are opposite.
fn cube() -> Vec<f64> {
    let entry = |place: usize| match (place / 6, place % 6) {
        (i, j) if i == j => 0.0,
        (i, j) if i / 2 == j / 2 => OPPOSITE,
        _ => SIDE,
    };
    (0..36).map(entry).collect()
}

fn laws(values: &[f64], bound: f64) -> MatrixLaws {
    MatrixLaws::of(values, &[1.0; 6], &[bound; 36]).unwrap()
}

#[test]
fn values_of_the_catalog_break_no_law() {
    let found = laws(&cube(), DIGITS);
    assert!(
        found.broken.is_empty() && found.closed && !found.transposed,
        "{found:?}"
    );
    // an open scene breaks none by what escapes
    let open: Vec<f64> = cube().iter().map(|value| 0.5 * value).collect();
    let found = laws(&open, DIGITS);
    assert!(found.broken.is_empty() && !found.closed, "{found:?}");
    assert!((found.row_sums[3] - 0.5).abs() < 6.0 * DIGITS);
}

#[test]
fn each_fault_breaks_its_own_law() {
    for (place, change, law, worst) in [
        (0, -1e-3, "range", vec![0, 0]),
        (7, 1e-3, "row sum", vec![1]),
        (14, -1e-3, "range", vec![2, 2]),
        (4, -1e-3, "reciprocity", vec![0, 4]),
    ] {
        let mut values = cube();
        values[place] += change;
        let found = laws(&values, DIGITS);
        assert_eq!(found.broken.len(), 1, "{found:?}");
        let broken = &found.broken[0];
        assert_eq!((broken.law, broken.cases, &broken.worst), (law, 1, &worst));
        // ten entries of a row are allowed their digits
        assert!((broken.excess - 1e-3).abs() < 1e-11, "{broken:?}");
        // a bound that explains the change allows it
        assert!(laws(&values, 1e-3).broken.is_empty());
    }
}

#[test]
fn exchange_areas_of_a_scene_obey_all_laws() {
    let exchange = Scene::built_in("cornell-box")
        .unwrap()
        .exchange_areas()
        .unwrap();
    let areas = exchange.areas();
    let rows = areas.len();
    let places = || (0..rows * rows).map(|place| (place / rows, place % rows));
    let values: Vec<f64> = places()
        .map(|(i, j)| exchange.get(i, j).exchange.value / areas[i])
        .collect();
    let bounds: Vec<f64> = places()
        .map(|(i, j)| exchange.get(i, j).exchange.error / areas[i] + 4.0 * f64::EPSILON)
        .collect();
    let found = MatrixLaws::of(&values, areas, &bounds).unwrap();
    assert!(found.broken.is_empty(), "{:?}", found.broken);
    let turned: Vec<f64> = places().map(|(i, j)| values[j * rows + i]).collect();
    let found = MatrixLaws::of(&turned, areas, &bounds).unwrap();
    assert!(found.transposed);
}

#[test]
fn what_is_no_matrix_is_refused() {
    let of = |values: &[f64], areas: &[f64], bound: f64| {
        MatrixLaws::of(values, areas, &vec![bound; values.len()]).unwrap_err()
    };
    let mut values = cube();
    values[8] = f64::NAN;
    let found = of(&values, &[1.0; 6], 0.0);
    assert!(matches!(
        found,
        MatrixLawsError::NotFinite {
            row: 1,
            column: 2,
            ..
        }
    ));
    let found = of(&cube(), &[1.0; 5], 0.0);
    assert!(matches!(
        found,
        MatrixLawsError::Shape {
            areas: 5,
            entries: 36,
            ..
        }
    ));
    let found = of(&cube(), &[1.0, 1.0, -1.0, 1.0, 1.0, 1.0], 0.0);
    assert!(matches!(found, MatrixLawsError::NotAnArea { row: 2, .. }));
    let found = of(&cube(), &[1.0; 6], -1.0);
    assert!(matches!(
        found,
        MatrixLawsError::NegativeBound {
            row: 0,
            column: 0,
            ..
        }
    ));
}
