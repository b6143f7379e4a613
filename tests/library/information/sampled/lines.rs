//! Lines meet what is visible, in proportion to it.

use super::{exact, pairs, scene, slabs};
use crate::support::rooms::{L, polygon, prism};
use infoscene::exchange::{Congruence, ScenePairs};
use infoscene::information::{LineKind, LineSample, PairCounts};
use infoscene::scene::{GridLines, NamedPatch, Occlusion, Scene, SceneLines};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::collections::BTreeMap;

const KINDS: [LineKind; 2] = [LineKind::Local, LineKind::Global];

/// Counts of cells by the lines themselves.
fn cells(scene: &Scene, kind: LineKind, lines: u32) -> BTreeMap<[usize; 2], f64> {
    let ready = SceneLines::of(scene);
    let mut random = ChaCha8Rng::seed_from_u64(5);
    let mut cells = BTreeMap::new();
    for _ in 0..lines {
        let mut chords = Vec::new();
        match kind {
            LineKind::Local => chords.extend(ready.local(random.random())),
            LineKind::Global => {
                ready.global(random.random(), &mut chords);
            }
        }
        for chord in chords {
            let [i, j] = chord.rows;
            *cells.entry([i.min(j), i.max(j)]).or_insert(0.0) += 1.0;
        }
    }
    cells
}

/// Pearson's `Σ (n − Np)²/(Np)`, of K − 1 degrees of freedom, is below K + 5 √(2K) with probability
/// above 1 − 1e-5 for K ≥ 15, and where p = 0 nothing is met.
fn assert_counts(scene: &Scene, counts: &BTreeMap<[usize; 2], f64>, kind: &str) {
    let total: f64 = counts.values().sum();
    let exchange = ScenePairs::try_new(scene, 1e-9, Congruence::Shared, Occlusion::Refuse).unwrap();
    let area: f64 = exchange.areas().iter().sum();
    let (mut pearson, mut possible) = (0.0, 0.0);
    for i in 0..exchange.rows() {
        for j in i..exchange.rows() {
            let ordered = exchange.row_pair(i, j).unwrap().exchange.value / area;
            let expected = total * ordered * if i == j { 1.0 } else { 2.0 };
            let found = counts.get(&[i, j]).copied().unwrap_or(0.0);
            if expected > 1e-9 {
                pearson += (found - expected).powi(2) / expected;
                possible += 1.0;
            } else {
                assert_eq!(found, 0.0, "{kind:?} {i} {j}");
            }
        }
    }
    let most = possible + 5.0 * f64::sqrt(2.0 * possible);
    assert!(pearson < most, "{kind:?}: {pearson} of {possible}");
}

fn assert_distributed(scene: &Scene, kind: LineKind) {
    assert_counts(scene, &cells(scene, kind, 40_000), kind.name());
}

#[test]
fn lines_meet_pairs_as_often_as_they_exchange() {
    for (name, times) in [("cube:2", 0), ("tetrahedron", 1), ("dodecahedron", 0)] {
        for kind in KINDS {
            assert_distributed(&scene(name, times), kind);
        }
    }
}

/// Lines in a grid on a box find the cells of the same box as a scene, by their numbers; and the
/// same chords.
#[test]
fn grids_find_their_cells_by_bisection() {
    let (edges, inner) = ([1.0, 2.0, 0.5], [0.2, 0.5]);
    let scene = Scene::gridded_box(edges, &inner).unwrap();
    let grid = GridLines::try_new(edges, &inner).unwrap();
    for (one, other) in grid.areas().iter().zip(scene.row_areas()) {
        // the grid's unit is 2
        assert!((4.0 * one - other).abs() < 1e-15);
    }
    let sample = LineSample::draw_in_grid(&grid, 60_000, 2).unwrap();
    let expected = exact(&scene);
    let (found, error) = (sample.counts.corrected(), sample.counts.standard_error());
    assert!(
        (found - expected).abs() < 5.0 * error && error < 0.02,
        "{found} {expected} {error}"
    );
    let continuous = infoscene::information::continuous_information(&scene).unwrap();
    let (found, error) = (
        sample.chords.mutual_information,
        sample.chords.standard_error,
    );
    assert!(
        (found - continuous.mutual_information.value).abs() < 5.0 * error,
        "{found} {error}"
    );
    let mut random = ChaCha8Rng::seed_from_u64(6);
    let mut counts = BTreeMap::new();
    for _ in 0..40_000 {
        let chord = grid.local(random.random()).unwrap();
        let [i, j] = chord.rows;
        *counts.entry([i.min(j), i.max(j)]).or_insert(0.0) += 1.0;
    }
    assert_counts(&scene, &counts, "grid");
    for lines in [&[0.5, 0.2][..], &[0.0], &[f64::NAN], &[1.5]] {
        assert!(GridLines::try_new(edges, lines).is_err(), "{lines:?}");
        assert!(Scene::gridded_box(edges, lines).is_err(), "{lines:?}");
    }
    assert!(GridLines::try_new([1.0, 0.0, 1.0], &[]).is_err());
}

/// A window in a wall, a pane in the window; two faces that are one row.
#[test]
fn parts_and_rows_are_told_apart() {
    let cube = scene("cube:1", 0);
    let inside = |low: f64, high: f64, name: &str| {
        let corners = [[low, low], [high, low], [high, high], [low, high]];
        polygon(name, &corners.map(|[x, y]| [x, y, 0.0]))
    };
    let parts = [inside(0.2, 0.8, "window"), inside(0.3, 0.5, "pane")];
    let patches: Vec<NamedPatch> = cube.patches().iter().cloned().chain(parts).collect();
    assert_eq!(cube.patches()[0].shape().normal().z, 1.0);
    let parts = Scene::try_new(patches).unwrap();
    let parts = parts.with_base(6, 0).unwrap().with_base(7, 6).unwrap();
    let rows = parts
        .clone()
        .with_groups(&[0, 1, 2, 2, 3, 4, 5, 0])
        .unwrap();
    for kind in KINDS {
        assert_distributed(&parts, kind);
        assert_distributed(&rows, kind);
    }
    let areas = rows.row_areas();
    assert!((areas[0] - 0.68).abs() < 1e-15 && (areas[5] - 0.32).abs() < 1e-15);
}

/// Two boxes 1 × 1 × ½ side by side: each chord knows its box, one bit, and the box's own
/// information. Most global lines have two chords.
#[test]
fn a_wall_is_not_seen_through() {
    let expected = exact(&scene("box:1,1,0.5", 0)) + 1.0;
    for kind in KINDS {
        let sample = LineSample::draw(&slabs(2), kind, 40_000, 7).unwrap();
        let (found, error) = (sample.counts.corrected(), sample.counts.standard_error());
        assert!(
            (found - expected).abs() < 5.0 * error,
            "{kind:?}: {found} {error}"
        );
        // 30 cells, of which most lines of a box meet the large one: 1e-3 or so
        assert!(error < 0.01, "{error}");
        let chords = sample.counts.samples() as f64 / 40_000.0;
        match kind {
            LineKind::Local => assert_eq!(chords, 1.0),
            // by Crofton: faces of 8 over those of the hull, 6
            LineKind::Global => assert!((chords - 8.0 / 6.0).abs() < 0.02, "{chords}"),
        }
    }
}

/// Local and global lines of a concave room, discrete and continuous, by two ways that share the
/// tracing only.
#[test]
fn both_kinds_agree_in_a_concave_room() {
    let room = prism(&L)
        .subdivided(1)
        .map_or_else(|_| prism(&L), |(room, _)| room);
    let [local, global] = KINDS.map(|kind| LineSample::draw(&room, kind, 40_000, 3).unwrap());
    let discrete =
        |sample: &LineSample| (sample.counts.corrected(), sample.counts.standard_error());
    let continuous = |sample: &LineSample| {
        (
            sample.chords.mutual_information,
            sample.chords.standard_error,
        )
    };
    for of in [discrete, continuous] {
        let ((one, error), (other, further)) = (of(&local), of(&global));
        assert!(
            (one - other).abs() < 5.0 * error.hypot(further),
            "{one} {other}"
        );
        assert!(error < 0.05 && further < 0.05);
    }
    assert!(global.counts.samples() > 41_000);
}

/// Far from the origin, turned, of any size: the same room.
#[test]
fn rooms_far_away_and_of_any_size_are_served() {
    for (scale, shift) in [(1e150, 0.0), (1e-150, 0.0), (1.0, 1e6)] {
        let cube = scene("cube:2", 0);
        let moved = crate::support::rooms::mapped(&cube, |c| scale * c + shift);
        for kind in KINDS {
            let [one, other] = [&cube, &moved].map(|scene| {
                let sample = LineSample::draw(scene, kind, 5000, 1).unwrap();
                PairCounts::corrected(&sample.counts)
            });
            assert!(
                (one - other).abs() < 1e-3,
                "{kind:?} {scale:e}: {one} {other}"
            );
        }
    }
    assert!(pairs(&scene("cube:2", 0)).rows() == 24);
}
