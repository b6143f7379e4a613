//! Exchange areas of rows that are summed of several patches.

use super::bases::square;
use glam::DVec3;
use infoscene::chain::{ReversibleChain, open_visibility_chain, visibility_chain};
use infoscene::exchange::{
    Closure, Congruence, ExchangeAreas, ExchangeError, ScenePairs, Selection,
};
use infoscene::geometry::Patch;
use infoscene::information::{OpenScene, mutual_information, scene_information};
use infoscene::numeric::tolerance;
use infoscene::scene::{Material, NamedPatch, Occlusion, Scene, SceneError};
use nalgebra::DMatrix;
use std::sync::atomic::{AtomicUsize, Ordering};

const TOLERANCE: f64 = 1e-12;

/// Opposite faces of a cube, `(2/π)(ln(2/√3) + 2√2 arctan(1/√2) − π/2)`: Howell, C-11 with X = Y =
/// 1.
fn opposite() -> f64 {
    let arc = 2.0 * 2f64.sqrt() * (0.5f64.sqrt()).atan();
    2.0 / std::f64::consts::PI * ((2.0 / 3f64.sqrt()).ln() + arc - std::f64::consts::FRAC_PI_2)
}

fn pairs(scene: &Scene) -> ScenePairs<'static> {
    ScenePairs::try_new(scene, TOLERANCE, Congruence::Shared, Occlusion::Refuse).unwrap()
}

pub fn held(scene: &Scene) -> ExchangeAreas {
    pairs(scene).exchange_areas().unwrap()
}

/// A_g F_gh = Σ Σ A_i F_ij, and twice each pair within the row on the diagonal.
#[test]
fn rows_are_sums() {
    let cube = Scene::built_in("cube:2").unwrap();
    let labels: Vec<usize> = (0..24).map(|patch| (patch * patch) % 7).collect();
    let summed = cube.clone().with_groups(&labels).unwrap();
    let (fine, coarse) = (held(&cube), held(&summed));
    let n = summed.group_count();
    assert_eq!((coarse.rows(), n), (n, 4));
    for g in 0..n {
        for h in 0..n {
            let patches = |row: usize| summed.patches_of_group(row);
            let terms = patches(g).flat_map(|i| patches(h).map(move |j| (i, j)));
            let terms: Vec<f64> = terms.map(|(i, j)| fine.get(i, j).exchange.value).collect();
            let sum: f64 = terms.iter().sum();
            let found = coarse.get(g, h).exchange;
            assert!((found.value - sum).abs() <= found.error, "{g} {h}");
            assert!(found.error <= 1e-12 * sum, "{g} {h}");
            assert_eq!(coarse.get(h, g), coarse.get(g, h));
        }
        assert!(coarse.sees_itself(g));
    }
    // the four sides of a cube see each other, and all of it sees nothing but itself
    let sides = Scene::built_in("cube:1").unwrap();
    let ring = held(&sides.clone().with_groups(&[0, 1, 2, 2, 2, 2]).unwrap());
    let adjacent = 0.25 * (1.0 - opposite());
    // View3D manual, §6.1
    assert!((opposite() - 0.199_824_896).abs() < 5e-10);
    let own = ring.get(2, 2).exchange.value / ring.areas()[2];
    assert!((own - (1.0 - 2.0 * adjacent)).abs() < 1e-14, "{own}");
    let all = sides.with_groups(&[0; 6]).unwrap();
    let measured = scene_information(&pairs(&all), OpenScene::Refuse).unwrap();
    let information = measured.mutual_information;
    assert!(information.value.abs() <= information.error && information.error < 1e-12);
    assert!((measured.closure.worst().sum - 1.0).abs() < 1e-14);
}

/// A cube with a mat, a window with a pane in it, and rows across walls.
fn furnished(labels: bool) -> Scene {
    let mut patches = Scene::built_in("cube:1").unwrap().patches().to_vec();
    patches.push(square("mat", 0.125, 0.5, 0.0));
    for (name, low) in [("window", 0.25), ("pane", 0.375)] {
        let corners = [
            (low, low),
            (1.0 - low, low),
            (1.0 - low, 1.0 - low),
            (low, 1.0 - low),
        ];
        let corners = corners.map(|(y, z)| DVec3::new(0.0, y, z));
        patches.push(NamedPatch::new(
            name.to_owned(),
            Patch::try_new(corners.to_vec()).unwrap(),
        ));
    }
    let left = patches
        .iter()
        .position(|patch| patch.name().starts_with("left"))
        .unwrap();
    let scene = Scene::try_new(patches).unwrap();
    let scene = scene.with_base(6, 0).unwrap();
    let scene = scene.with_base(7, left).unwrap().with_base(8, 7).unwrap();
    // the pane counts with the ceiling, the window with the wall that it is in, the back with the
    // mat
    let labels = if labels {
        vec![0, 1, 2, 3, 4, 6, 6, 2, 1]
    } else {
        (0..9).collect()
    };
    scene.with_groups(&labels).unwrap()
}

#[test]
fn rows_of_a_closed_room_sum_to_one() {
    for labels in [false, true] {
        let scene = furnished(labels);
        assert_eq!((scene.overlap(), scene.blocker()), (None, None));
        let pairs = pairs(&scene);
        let closure = Closure::of(&pairs).unwrap();
        for row in closure.rows() {
            assert!((row.sum - 1.0).abs() <= 1e-13, "{row:?}");
            assert!(row.error <= 1e-12, "{row:?}");
        }
        assert!(closure.is_closed());
        let total: f64 = pairs.areas().iter().sum();
        assert!((total - 6.0).abs() <= 1e-14);
    }
}

/// A joint matrix whose rows and columns are summed is the chain of the summed scene.
#[test]
fn a_summed_scene_is_the_coarser_chain() {
    let cube = Scene::built_in("cube:3").unwrap();
    let labels: Vec<usize> = (0..54).map(|patch| (patch * 7) % 13).collect();
    let fine = cube.exchange_areas().unwrap().into_values();
    let summed = cube.with_groups(&labels).unwrap();
    let n = summed.group_count();
    let mut coarse = DMatrix::zeros(n, n);
    for i in 0..54 {
        for j in 0..54 {
            coarse[(summed.group_of(i), summed.group_of(j))] += fine[(i, j)];
        }
    }
    let coarse = ReversibleChain::try_new(0.5 * (&coarse + coarse.transpose())).unwrap();
    let bits = mutual_information(&coarse);
    let chain = visibility_chain(&summed).unwrap();
    assert!((mutual_information(&chain) - bits).abs() <= tolerance::IDENTITY);
    let measured = scene_information(&pairs(&summed), OpenScene::Refuse)
        .unwrap()
        .mutual_information;
    let off = (measured.value - bits).abs();
    assert!(off <= measured.error && measured.error <= 1e-10, "{off}");
}

/// Pairs as they come, held, by rows and by entries have the same values, sums, counts and
/// information; on any number of threads.
#[test]
fn all_ways_to_the_rows_agree() {
    // a roof over the room that is summed with its floor, and a mast: open, with planes behind each
    // other
    let mut patches = furnished(true).patches().to_vec();
    patches.push(square("roof", 0.0, 1.0, 1.5));
    patches.push(square("mast", 0.0, 0.5, 3.0));
    let left = 2;
    let open = Scene::try_new(patches).unwrap().with_base(6, 0).unwrap();
    let open = open.with_base(7, left).unwrap().with_base(8, 7).unwrap();
    let open = open
        .with_groups(&[0, 1, 2, 3, 4, 6, 6, 2, 1, 0, 7])
        .unwrap();
    for scene in [furnished(false), furnished(true), open] {
        let pairs = pairs(&scene);
        let held = pairs.exchange_areas().unwrap();
        let (sums, account) = pairs.row_sums(|_, _, exchange| [exchange.value]).unwrap();
        assert_eq!(&account, held.summary());
        for (i, [sum]) in sums.iter().enumerate() {
            let row = (0..held.rows()).map(|j| held.get(i, j).exchange.value);
            assert!((sum - row.sum::<f64>()).abs() <= 1e-15);
        }
        let by_rows = pairs.for_each_row(|i, row| -> Result<(), ExchangeError> {
            for (j, answer) in row.iter().enumerate() {
                assert_eq!(answer, &held.get(i, j));
            }
            Ok(())
        });
        assert_eq!(&by_rows.unwrap(), held.summary());
        let (entries, account) = pairs.entries(&Selection::default()).unwrap();
        assert_eq!(&account, held.summary());
        for entry in &entries {
            assert_eq!(entry.answer, held.get(entry.from, entry.to));
        }
        let plan = account.plan;
        let parts = plan.untouched + plan.congruent + plan.computed;
        assert_eq!(parts, plan.pairs);
        assert_eq!(plan.routes.values().sum::<usize>(), plan.pairs);
        let chain = open_visibility_chain(&scene).unwrap();
        let measured = scene_information(&pairs, OpenScene::AddOutsideState).unwrap();
        let off = (measured.mutual_information.value - mutual_information(&chain)).abs();
        assert!(off <= tolerance::IDENTITY, "{off}");
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(5)
            .build()
            .unwrap();
        let again = pool.install(|| scene_information(&pairs, OpenScene::AddOutsideState).unwrap());
        assert_eq!(again, measured);
    }
    // nine patches, the window is summed with its wall and is in no pair
    let counted = |labels| held(&furnished(labels)).summary().plan.pairs;
    assert_eq!((counted(false), counted(true)), (36, 28));
}

#[test]
fn a_row_has_a_reflectance_if_its_patches_agree() {
    let mut patches = Scene::built_in("cube:1").unwrap().patches()[1..].to_vec();
    let paint = Material::try_new(0.5, 1.0).unwrap();
    patches[0] = patches[0].clone().with_material(paint);
    patches[3] = patches[3].clone().with_material(paint);
    let scene = Scene::try_new(patches).unwrap();
    let same = scene.clone().with_groups(&[0, 1, 1, 0, 2]).unwrap();
    assert_eq!(
        [0, 1, 2].map(|row| same.group_reflectance(row).unwrap().g),
        [0.5, 0.0, 0.0]
    );
    assert_eq!(same.group_emittance(0).unwrap().b, 1.0);
    assert_eq!(same.group_names(), ["ceiling 0,0", "left 0,0", "back 0,0"]);
    let none = SceneError::NoSuchPatch { index: 3, last: 2 };
    assert_eq!(same.group_reflectance(3).unwrap_err(), none);
    let mixed = scene.with_groups(&[0, 1, 0, 2, 3]).unwrap();
    for (what, refused) in [
        ("reflectance", mixed.group_reflectance(0)),
        ("emittance", mixed.group_emittance(0)),
    ] {
        let refusal = refused.unwrap_err().to_string();
        for part in ["(ceiling 0,0)", "(right 0,0)", what] {
            assert!(refusal.contains(part), "{refusal}");
        }
    }
}

/// Every pass tells of each pair once, whether it is left out or not.
#[test]
fn progress_ends_with_all_pairs() {
    for scene in [furnished(true), Scene::built_in("cube:6").unwrap()] {
        let done = AtomicUsize::new(0);
        let listener = |more| {
            done.fetch_add(more, Ordering::Relaxed);
        };
        let pairs = pairs(&scene).with_progress(&listener);
        let n = pairs.rows();
        assert_eq!(pairs.pairs(), n * (n - 1) / 2);
        let all = || assert_eq!(done.swap(0, Ordering::Relaxed), pairs.pairs());
        pairs.exchange_areas().unwrap();
        all();
        pairs.row_sums(|_, _, exchange| [exchange.value]).unwrap();
        all();
        let visited = pairs.for_each_row(|_, _| Ok::<(), ExchangeError>(()));
        visited.unwrap();
        all();
    }
}
