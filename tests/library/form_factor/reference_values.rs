//! Rectangle closed forms against 30-digit values.

use crate::support::references::rows;
use infoscene::form_factor::RectanglePair;
use infoscene::geometry::Rectangle;

/// The promise for pairs at most two sizes apart with aspect ratios within 1e-2 … 1e2; the file's
/// far, sliver and strip rows keep it too.
const RELATIVE_ERROR: f64 = 1e-13;

fn aligned_pairs() -> Vec<(String, RectanglePair, f64)> {
    let mut pairs = Vec::new();
    for row in rows("form_factors.csv") {
        let polygons = row.polygons();
        let rectangles: Result<Vec<_>, _> = polygons.iter().map(Rectangle::try_from).collect();
        let Ok(rectangles) = rectangles else { continue };
        for (first, second) in [(0, 1), (1, 0)] {
            if let Ok(pair) = RectanglePair::try_new(&rectangles[first], &rectangles[second]) {
                pairs.push((row.id.clone(), pair, row.number("exchange_area")));
            }
        }
    }
    pairs
}

/// `|A F − exact| ≤ 1e-13 A F`.
#[test]
fn rectangle_pairs_agree_with_thirty_digits() {
    let pairs = aligned_pairs();
    assert_eq!(
        pairs.len(),
        2 * 18,
        "18 rows of the file are pairs of aligned rectangles"
    );
    for (id, pair, exact) in pairs {
        let value = pair.exchange_area().unwrap().value;
        assert!(
            (value - exact).abs() <= RELATIVE_ERROR * exact,
            "{id}: {value} against {exact}"
        );
    }
}

/// `|A F − exact| ≤ error`, and the bound is worth having.
#[test]
fn rectangle_bounds_hold_on_every_row() {
    for (id, pair, exact) in aligned_pairs() {
        let exchange = pair.exchange_area().unwrap();
        assert!((exchange.value - exact).abs() <= exchange.error, "{id}");
        assert!(
            exchange.error <= 1e-11 * exact,
            "{id}: bound {:e}",
            exchange.error
        );
    }
}

/// Polygons that are no aligned rectangles are refused, not computed wrongly.
#[test]
fn other_polygons_are_refused() {
    let refused = rows("form_factors.csv").into_iter().filter(|row| {
        let polygons = row.polygons();
        let rectangles: Result<Vec<_>, _> = polygons.iter().map(Rectangle::try_from).collect();
        rectangles.map_or(true, |r| RectanglePair::try_new(&r[0], &r[1]).is_err())
    });
    assert_eq!(
        refused.count(),
        8,
        "three inclined pairs, three of triangles, an L, a hexagon"
    );
}
