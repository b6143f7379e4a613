//! Best grids: their references, their neighbours, and what is said of how they were found.

use crate::support::references::{rows, value};
use infoscene::discretize::{BestGrid, BoxGrid, CertifiedGrid, UNIT_CUBE};
use infoscene::numeric::{Certificate, Scalar, tolerance};

/// Lines to 1e-14, values to their bounds, against 20 and 28 digits; the estimated error of the
/// lines is no less than the real one.
#[test]
fn best_grids_of_the_cube_agree_with_their_references() {
    for cells in [3, 4, 6] {
        let best = BestGrid::find(UNIT_CUBE, cells).unwrap();
        let id = format!("cube_optimal_{cells}");
        let exact = value("cube_grids.csv", &id);
        let information = best.information.mutual_information;
        assert!((information.value - exact).abs() <= information.error);
        let lines: Vec<f64> = rows("cube_grids.csv")
            .iter()
            .filter(|row| row.id.starts_with(&format!("{id}_line")))
            .map(|row| row.number("value"))
            .collect();
        assert_eq!(lines.len(), (cells as usize - 1) / 2);
        for (found, exact) in best.grid.lines().iter().zip(lines) {
            assert!(
                (found - exact).abs() <= tolerance::POSITION,
                "{cells}: {found} {exact}"
            );
            assert!(
                (found - exact).abs() <= best.line_error,
                "{cells}: {:e}",
                best.line_error
            );
        }
        assert!(best.line_error <= 1e-9);
    }
}

/// Neighbours with one line moved say less, and so does the regular grid; on cubes, and on long and
/// flat boxes.
#[test]
fn best_grids_beat_their_neighbours() {
    for edges in [
        UNIT_CUBE,
        [1.0, 2.0, 3.0],
        [1.0, 1.0, 30.0],
        [1.0, 1.0, 0.03],
    ] {
        for cells in [3, 6] {
            let best = BestGrid::find(edges, cells).unwrap();
            let most = best.information.mutual_information;
            let regular = BoxGrid::regular(edges, cells)
                .unwrap()
                .information()
                .unwrap()
                .mutual_information;
            let gain = most.value - regular.value;
            assert!(
                gain > most.error + regular.error,
                "{edges:?} {cells}: {gain:e}"
            );
            let half = (cells as usize - 1) / 2;
            for k in 0..half {
                for step in [-1e-4, 1e-4] {
                    let mut lines = best.grid.lines()[..half].to_vec();
                    lines[k] += step;
                    let moved = BoxGrid::mirrored(edges, &lines, cells, &1.0).unwrap();
                    let moved = moved.information().unwrap().mutual_information;
                    let lost = most.value - moved.value;
                    assert!(
                        lost > most.error + moved.error,
                        "{edges:?} {cells} {k}: {lost:e}"
                    );
                }
            }
            let search = &best.search;
            let accounted = search.reached + search.lost + search.others.len();
            assert!(search.reached > 0 && accounted <= search.starts);
            assert!(search.others.iter().all(|other| *other < most.value));
        }
    }
}

/// Every start ends at the same maximum, on every box tried: evidence, not proof, that there is one
/// only.
#[test]
fn all_starts_end_at_one_maximum() {
    for edges in [
        UNIT_CUBE,
        [1.0, 1.0, 1000.0],
        [1.0, 1.0, 0.001],
        [1.0, 10.0, 100.0],
    ] {
        for cells in [3, 6] {
            let search = BestGrid::find(edges, cells).unwrap().search;
            assert_eq!(
                (search.reached, search.starts),
                (16, 16),
                "{edges:?} {cells}"
            );
            assert!(search.others.is_empty() && search.lost == 0);
        }
    }
}

/// One cell or two leave no line free.
#[test]
fn grids_without_free_lines_are_regular() {
    for cells in [1, 2] {
        let best = BestGrid::find([1.0, 2.0, 3.0], cells).unwrap();
        assert_eq!(best.grid, BoxGrid::regular([1.0, 2.0, 3.0], cells).unwrap());
        assert!(best.curvature.is_none());
    }
}

/// Krawczyk's operator encloses the lines, and with one free line they are the highest of all.
fn assert_enclosed(edges: [f64; 3], cells: u32) {
    let enclosed = CertifiedGrid::best(edges, cells, 128).unwrap();
    let best = BestGrid::find(edges, cells).unwrap();
    assert_eq!(enclosed.half.len(), (cells as usize - 1) / 2);
    for (enclosure, line) in enclosed.half.iter().zip(best.grid.lines()) {
        assert!(enclosure.width() < 1e-25);
        assert!((enclosure.to_f64() - line).abs() <= best.line_error);
    }
    let information = enclosed.mutual_information.to_f64();
    let found = best.information.mutual_information;
    assert!((information - found.value).abs() <= found.error);
    let is_global = matches!(enclosed.certificate, Certificate::Unique { .. });
    assert_eq!(is_global, cells == 3);
}

#[test]
fn the_best_grid_of_four_cells_on_a_box_is_enclosed() {
    assert_enclosed([1.0, 2.0, 3.0], 4);
}

#[test]
#[ignore = "a minute unoptimised: \
            cargo test --release --test library discretize::grid -- --ignored"]
fn best_grids_of_three_and_eight_cells_are_enclosed() {
    assert_enclosed([1.0, 2.0, 3.0], 3);
    assert_enclosed(UNIT_CUBE, 8);
}

/// Lines of 32 cells are still known to 1e-9, and both starts agree.
#[test]
#[ignore = "a minute unoptimised: \
            cargo test --release --test library discretize::grid -- --ignored"]
fn fine_best_grids_converge() {
    let best = BestGrid::find(UNIT_CUBE, 32).unwrap();
    assert!(best.line_error <= 1e-9 && best.search.lost == 0 && best.search.others.is_empty());
    let curvature = best.curvature.unwrap();
    assert!(curvature.value < -curvature.error);
}
