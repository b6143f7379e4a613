//! Boxes and lines that are refused, and extreme ones that are not.

use infoscene::discretize::{
    BestGrid, BoxGrid, CertifiedGrid, LARGEST_ASPECT, MOST_CELLS, UNIT_CUBE,
};

#[test]
fn edges_are_checked() {
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-310] {
        for place in 0..3 {
            let mut edges = [1.0; 3];
            edges[place] = bad;
            assert!(BoxGrid::regular(edges, 2).is_err(), "{edges:?}");
        }
    }
    let longest = |edge: f64| BoxGrid::regular([1.0, 1.0, edge], 2);
    assert!(longest(LARGEST_ASPECT).is_ok() && longest(1.0 / LARGEST_ASPECT).is_ok());
    assert!(longest(1.01 * LARGEST_ASPECT).is_err() && longest(0.99 / LARGEST_ASPECT).is_err());
}

#[test]
fn lines_are_checked() {
    for bad in [
        &[0.5, 0.5][..],
        &[0.7, 0.3],
        &[0.0, 0.5],
        &[0.5, 1.0],
        &[-0.1],
        &[1.5],
        &[f64::NAN],
        &[1e-300],
        &[0.5, 0.5 + 1e-13],
        &[0.3, f64::NAN],
        &[0.5; MOST_CELLS as usize],
    ] {
        assert!(BoxGrid::try_new(UNIT_CUBE, bad).is_err(), "{bad:?}");
    }
    assert_eq!(BoxGrid::try_new(UNIT_CUBE, &[]).unwrap().cells(), 1);
    for cells in [0, MOST_CELLS + 1, u32::MAX] {
        assert!(BoxGrid::regular(UNIT_CUBE, cells).is_err());
        assert!(BestGrid::find(UNIT_CUBE, cells).is_err());
    }
    // only symmetric lines move in pairs
    assert!(
        BoxGrid::try_new(UNIT_CUBE, &[0.3])
            .unwrap()
            .gradient()
            .is_err()
    );
}

/// A millionth of an edge, and edges a million times longer than others: still 1e-12.
#[test]
fn extreme_grids_keep_their_digits() {
    for edges in [
        UNIT_CUBE,
        [1.0, 1.0, 1e6],
        [1.0, 1.0, 1e-6],
        [1.0, 1e3, 1e6],
    ] {
        for lines in [
            &[0.5][..],
            &[1e-6, 0.5, 1.0 - 1e-6],
            &[1e-6, 2e-6],
            &[1e-12],
        ] {
            let found = BoxGrid::try_new(edges, lines).unwrap().information();
            let found = found.unwrap();
            assert!(found.mutual_information.value > 0.0, "{edges:?} {lines:?}");
            assert!(
                found.mutual_information.error <= 1e-12,
                "{edges:?} {lines:?}: {:e}",
                found.mutual_information.error
            );
        }
    }
}

/// No grid has zero cells.
#[test]
fn a_grid_without_cells_is_refused() {
    assert!(CertifiedGrid::regular(UNIT_CUBE, 0, 128).is_err());
    assert!(CertifiedGrid::best(UNIT_CUBE, 0, 128).is_err());
}
