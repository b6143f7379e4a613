//! Tiles hold each pair that the plan does not leave out, and their sums do not depend on where
//! they are made.

use infoscene::exchange::{Congruence, ScenePairs, Tile, TileSums};
use infoscene::form_factor::Route;
use infoscene::numeric::Symmetric;
use infoscene::scene::{Occlusion, Scene};
use std::collections::BTreeSet;

/// A cube of 96 patches; and one some of whose patches are summed, so that rows see themselves.
fn scenes() -> [Scene; 2] {
    let cube = Scene::built_in("cube:4").unwrap();
    let labels: Vec<usize> = (0..96).map(|patch| patch * patch % 61).collect();
    let summed = cube.clone().with_groups(&labels).unwrap();
    [cube, summed]
}

fn pairs(scene: &Scene) -> ScenePairs<'static> {
    ScenePairs::try_new(scene, 1e-12, Congruence::Shared, Occlusion::Refuse).unwrap()
}

/// The entries of all tiles are those of the matrix, none comes twice, and what is in no tile is 0.
#[test]
fn tiles_hold_each_visible_pair_once() {
    for (scene, side) in scenes()
        .iter()
        .flat_map(|s| [(s, 1), (s, 7), (s, 16), (s, 300)])
    {
        let pairs = pairs(scene);
        let held = pairs.exchange_areas().unwrap();
        let mut seen = BTreeSet::new();
        let mut listed = 0;
        for tile in pairs.tiles(side) {
            let found = pairs.tile(&tile).unwrap();
            assert!(found.rows.len().max(found.columns.len()) <= side);
            listed += tile.pairs();
            let mut places = seen.clone();
            for (r, row) in found.rows.iter().enumerate() {
                for (c, column) in found.columns.iter().enumerate() {
                    let at = r * found.columns.len() + c;
                    let exchange = held.get(*row, *column).exchange;
                    assert_eq!(found.values[at], exchange.value, "{row} {column}");
                    assert_eq!(found.errors[at], exchange.error);
                    assert!(!seen.contains(&(*row.min(column), *row.max(column))));
                    places.insert((*row.min(column), *row.max(column)));
                }
            }
            seen = places;
        }
        let different = seen.iter().filter(|(row, column)| row != column).count();
        assert_eq!(listed, different);
        let n = pairs.rows();
        let in_none = (0..n).flat_map(|j| (0..=j).map(move |i| (i, j)));
        for (i, j) in in_none.filter(|pair| !seen.contains(pair)) {
            assert_eq!(held.get(i, j).exchange.value, 0.0, "{i} {j}");
        }
    }
}

/// Tiles are summed last to first, and the sums added up in order: the bits are those of one pass.
#[test]
fn sums_do_not_depend_on_where_tiles_are_summed() {
    for scene in scenes() {
        let pairs = pairs(&scene);
        let term = |i: usize, j: usize, exchange: &infoscene::form_factor::ExchangeArea| {
            let weight = 1.0 / (1.0 + (i * j) as f64);
            [exchange.value, exchange.value * weight]
        };
        let tiles: Vec<Tile> = pairs.tiles(128).collect();
        let backwards = tiles.iter().rev();
        let mut sums: Vec<TileSums<2>> = backwards
            .map(|tile| pairs.tile_sums(tile, term).unwrap())
            .collect();
        sums.reverse();
        let (found, summary) = pairs.row_sums_of(tiles.into_iter().zip(sums));
        let (expected, of_one_pass) = pairs.row_sums(term).unwrap();
        let bits = |sums: &[[f64; 2]]| -> Vec<[u64; 2]> {
            sums.iter().map(|sums| sums.map(f64::to_bits)).collect()
        };
        assert_eq!(bits(&found), bits(&expected));
        assert_eq!(summary, of_one_pass);
    }
}

/// Row i of a packed matrix has i entries, and blocks of rows share the entries out evenly: each
/// has its part of n²/2, within the two rows at its ends.
#[test]
fn blocks_of_rows_cover_a_packed_matrix_evenly() {
    let n = 1000;
    let mut matrix = Symmetric::filled(n, [0, 0]);
    for (i, row) in matrix.rows_mut().into_iter().enumerate() {
        assert_eq!(row.len(), i);
        for (j, entry) in row.iter_mut().enumerate() {
            *entry = [i, j];
        }
    }
    assert_eq!([matrix.get(17, 4), matrix.get(4, 17)], [&[17, 4]; 2]);
    let mut next = 0;
    for rows in matrix.blocks(16) {
        assert_eq!(rows.start, next);
        let entries = matrix.rows(rows.clone());
        let even = n * n / 2 / 16;
        assert!(entries.len().abs_diff(even) <= 2 * n, "{rows:?}");
        for (i, row) in rows.clone().zip(rows.clone().map(|i| matrix.row(i))) {
            assert!(row.iter().enumerate().all(|(j, entry)| *entry == [i, j]));
        }
        next = rows.end;
    }
    assert_eq!(next, n);
    assert_eq!(Symmetric::from_rows(3, vec![0; 4]), None);
}

/// Counts are kept by place in the list of routes.
#[test]
fn each_route_stands_at_its_place() {
    for (place, route) in Route::ALL.into_iter().enumerate() {
        assert_eq!(route as usize, place, "{}", route.name());
    }
    let names: BTreeSet<&str> = Route::ALL.iter().map(|route| route.name()).collect();
    assert_eq!(names.len(), Route::ALL.len());
}
