//! Centroids of polygons.

use glam::DVec3;
use infoscene::geometry::{Patch, centroid};

/// An L of three unit squares, whose fan leaves it: the mean of the middles of the squares.
#[test]
fn the_centroid_of_an_l_is_that_of_its_squares() {
    let outline = [[0, 1], [0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]];
    let corners = outline.map(|[x, y]| DVec3::new(x.into(), y.into(), 5.0));
    // also from the corner at the far end, where the fan leaves the L
    for first in 0..corners.len() {
        let mut corners = corners.to_vec();
        corners.rotate_left(first);
        let found = centroid(&Patch::try_new(corners).unwrap());
        let exact = DVec3::new(2.5 / 3.0, 2.5 / 3.0, 5.0);
        // a few ε of the coordinates
        assert!((found - exact).length() <= 1e-14, "{first}: {found}");
    }
}
