//! The exact values past plates half-way, against lines, a sum of parts, and the other slow road.

use crate::support::rooms::level;
use infoscene::form_factor::sampling::quasi_random_lines_past;
use infoscene::geometry::Patch;
use infoscene::reference::{exchange_area_past, past_halfway_plates};

/// Plates on all sides of the middle, across it, and reaching out.
const PLATES: [[[f64; 2]; 2]; 4] = [
    [[0.125, 0.25], [0.25, 0.375]],
    [[0.375, 0.75], [0.125, 0.875]],
    [[0.8125, 0.9375], [0.5, 0.625]],
    [[-0.5, 0.3125], [0.5625, 1.5]],
];

fn squares(height: f64) -> [Patch; 2] {
    let unit = [0.0, 1.0];
    let floor = level("floor", unit, unit, 0.0, true);
    let ceiling = level("ceiling", unit, unit, height, false);
    [floor, ceiling].map(|named| named.shape().clone())
}

fn at(height: f64, plates: &[[[f64; 2]; 2]]) -> Vec<Patch> {
    let plates = plates.iter();
    let plate = |[x, y]: &[[f64; 2]; 2]| level("plate", *x, *y, 0.5 * height, true);
    plates
        .map(|plate_at| plate(plate_at).shape().clone())
        .collect()
}

/// `F = hits / lines`, within five standard errors.
#[test]
fn lines_find_what_plates_half_way_leave() {
    for height in [0.5, 2.0] {
        let exact = past_halfway_plates(height, &PLATES).unwrap().value();
        let [first, second] = squares(height);
        let blockers = at(height, &PLATES);
        let sample = quasi_random_lines_past([&first, &second], &blockers, 100_000, 7).unwrap();
        let off = (sample.value - exact).abs();
        assert!(
            off <= 5.0 * sample.standard_error,
            "{height}: {off:e} {sample:?}"
        );
        assert!(sample.standard_error < 2e-2 * exact, "{sample:?}");
    }
}

/// The rule over the area finds the same for each plate, within its estimate.
#[test]
fn the_rule_over_the_area_finds_what_a_plate_half_way_leaves() {
    for plate in &PLATES {
        let exact = past_halfway_plates(1.0, &[*plate]).unwrap().value();
        let [first, second] = squares(1.0);
        let found = exchange_area_past(&first, &second, &at(1.0, &[*plate]), 1e-11).unwrap();
        let off = (found.value - exact).abs();
        assert!(off <= found.error + 1e-13 * exact, "{off:e} {found:?}");
        assert!(found.error < 1e-9, "{found:?}");
    }
}

/// A plate in four parts hides what it hides whole, plates over all leave nothing, and an enclosure
/// has many digits.
#[test]
fn parts_of_a_plate_hide_what_it_hides() {
    let whole = past_halfway_plates(1.0, &[[[0.125, 0.75], [0.25, 0.9375]]]).unwrap();
    let mut parts = Vec::new();
    for x in [[0.125, 0.4375], [0.4375, 0.75]] {
        parts.extend([[0.25, 0.5], [0.5, 0.9375]].map(|y| [x, y]));
    }
    let parts = past_halfway_plates(1.0, &parts).unwrap();
    assert!(whole.relative_difference(&parts) < 1e-60);
    assert!(whole.uncertainty() < 1e-60 && parts.uncertainty() < 1e-60);
    let nothing = past_halfway_plates(1.0, &[[[-1.0, 2.0], [-1.0, 2.0]]]).unwrap();
    assert!(nothing.value().abs() < 1e-60);
    for height in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(past_halfway_plates(height, &PLATES).is_err(), "{height}");
    }
}
