//! Bounds that were none: pairs of which something could not be told.

use infoscene::form_factor::{DEFAULT_TOLERANCE, ExchangeArea, Occluders, Polygon};
use infoscene::study::form_factors::occluded::{OccludedFamily, OccludedPair};

/// The exchange area over the points of the first polygon, and over those of the second.
fn both_ways(case: &OccludedPair) -> [ExchangeArea; 2] {
    let pair = case.pair.each_ref().map(Polygon::new);
    let blockers: Vec<Polygon> = case.blockers.iter().map(Polygon::new).collect();
    let polygons: Vec<&Polygon> = blockers.iter().collect();
    let occluders = Occluders {
        polygons: &polygons,
        touching: 0.0,
    };
    [[0, 1], [1, 0]].map(|[from, to]| {
        let answer = pair[from].exchange_area_past_over(&pair[to], &occluders, DEFAULT_TOLERANCE);
        answer.unwrap().exchange
    })
}

/// Two integrals over different edges meet within their bounds, and these are below `most` of the
/// value.
fn assert_told(family: OccludedFamily, numbers: &[u64], most: f64) {
    for number in numbers {
        let found = both_ways(&family.case(*number).unwrap());
        let [one, other] = found;
        let off = (one.value - other.value).abs();
        assert!(
            off <= one.error + other.error,
            "{family:?} {number}: {found:?}"
        );
        for exchange in found {
            let is_known = exchange.error <= most * exchange.value;
            assert!(is_known, "{family:?} {number}: {found:?}");
        }
    }
}

/// An edge of Q in P's plane, where planes that hold it meet P in one line.
#[test]
fn stretches_in_the_plane_of_the_other_polygon_are_told() {
    assert_told(OccludedFamily::Horizon, &[1, 25], 1e-9);
    assert_told(OccludedFamily::One, &[28, 86], 1e-9);
    assert_told(OccludedFamily::Patchwork, &[9], 1e-9);
}

/// An edge of a screen that comes down to P between its sides: corners nearby are seen beside such
/// far away.
#[test]
fn edges_that_pierce_a_polygon_take_few_panels() {
    assert_told(OccludedFamily::Horizon, &[17, 26, 50], 1e-9);
}

/// Faces cut off to a width of 1e-3, whose edges turn the plane of the face by their rounding.
#[test]
fn planes_of_thin_faces_are_one() {
    assert_told(OccludedFamily::Box, &[62, 72], 1e-9);
}
