//! Mutual information of grids on a cube against 13- to 29-digit values.

use crate::support::references::{rows, value};
use infoscene::chain::visibility_chain;
use infoscene::discretize::{BestGrid, BoxGrid, UNIT_CUBE};
use infoscene::information::mutual_information;
use infoscene::numeric::tolerance;
use infoscene::scene::Scene;

fn grids(id: &str) -> f64 {
    value("cube_grids.csv", id)
}

/// Regular grids of 1, 2, 3, 4, 6 cells a side, from the shared face pairs.
#[test]
fn regular_grids_agree_with_29_digits() {
    for cells in [1, 2, 3, 4, 6] {
        let information = BoxGrid::regular(UNIT_CUBE, cells)
            .unwrap()
            .mutual_information()
            .unwrap();
        let exact = grids(&format!("cube_regular_{cells}"));
        assert!(
            (information / exact - 1.0).abs() <= tolerance::GRID_INFORMATION,
            "{cells}: {information} {exact}"
        );
    }
}

/// The mutual information of the scene's patches, from one form factor after the other.
#[test]
fn chains_of_cube_scenes_agree_with_29_digits() {
    for cells in [1, 2, 3, 4] {
        let chain = visibility_chain(&Scene::built_in(&format!("cube:{cells}")).unwrap()).unwrap();
        let exact = grids(&format!("cube_regular_{cells}"));
        assert!(
            (mutual_information(&chain) / exact - 1.0).abs() <= tolerance::GRID_INFORMATION,
            "{cells}"
        );
    }
}

/// The best symmetric grids of 3, 4 and 6 cells: their value, and a vanishing derivative.
#[test]
fn best_grids_agree_with_20_digits() {
    let rows = rows("cube_grids.csv");
    let lines = |id: &str| -> Vec<f64> {
        let ids = [format!("{id}_line1"), format!("{id}_line2")];
        rows.iter()
            .filter(|row| ids.contains(&row.id))
            .map(|row| row.number("value"))
            .collect()
    };
    for (cells, has_middle) in [(3, false), (4, true), (6, true)] {
        let id = format!("cube_optimal_{cells}");
        let half = lines(&id);
        let mirrored = half.iter().rev().map(|line| 1.0 - line);
        let all: Vec<f64> = half
            .iter()
            .copied()
            .chain(has_middle.then_some(0.5))
            .chain(mirrored)
            .collect();
        let grid = BoxGrid::try_new(UNIT_CUBE, &all).unwrap();
        let information = grid.mutual_information().unwrap();
        assert!(
            (information / grids(&id) - 1.0).abs() <= tolerance::GRID_INFORMATION,
            "{cells}: {information}"
        );
        for (k, slope) in grid.gradient().unwrap().into_iter().enumerate() {
            assert!(slope.abs() < 1e-12, "{cells}: slope {slope:e} in line {k}");
        }
        let found = BestGrid::find(UNIT_CUBE, cells)
            .unwrap()
            .grid
            .lines()
            .to_vec();
        for (found, exact) in found.into_iter().zip(all) {
            assert!(
                (found - exact).abs() <= tolerance::POSITION,
                "{cells}: {found} {exact}"
            );
        }
    }
}

/// Fig. 4: lines t and 1 − t with t = x/20.
#[test]
fn figure_4_agrees_with_13_digits() {
    for (x, id) in [
        (2.0, "fig4_x2"),
        (6.0, "fig4_x6"),
        (20.0 / 3.0, "fig4_x6.666667 (regular)"),
    ] {
        let t = x / 20.0;
        let information = BoxGrid::try_new(UNIT_CUBE, &[t, 1.0 - t])
            .unwrap()
            .mutual_information()
            .unwrap();
        assert!(
            (information / grids(id) - 1.0).abs() <= tolerance::GRID_INFORMATION,
            "{id}: {information}"
        );
    }
}
