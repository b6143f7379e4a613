//! Matrices that are read from their stores: exchange areas, radiosities, information; by ranks,
//! and gone on with.

use super::stores::filled;
use crate::support::breadth::some_of;
use crate::support::ranks::among;
use infoscene::exchange::{
    Alone, Congruence, LowerBlocks, MatrixStore, Ranks, ScenePairs, Shard, StoreError,
    StoredMatrix, Unheard,
};
use infoscene::question::{MaterialChanges, Measure, MeasureAnswer, Radiosity};
use infoscene::question::{SceneSource, StoreFormFactors};
use infoscene::scene::{Occlusion, Scene};
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

const TREATMENT: (Congruence, Occlusion) = (Congruence::Shared, Occlusion::Exact);

fn pairs(scene: &Scene) -> ScenePairs<'_> {
    ScenePairs::try_new(scene, 1e-12, TREATMENT.0, TREATMENT.1).unwrap()
}

/// A cube of 216 patches with a row that is summed of patches on two walls, so that it sees itself;
/// and a room in which blocks stand.
fn scenes() -> [Scene; 2] {
    let labels: Vec<usize> = (0..216).map(|patch| patch.max(1) % 215).collect();
    let cube = Scene::built_in("cube:6").unwrap();
    let blocks = Scene::built_in("cornell-box-blocks").unwrap();
    [
        cube.with_groups(&labels).unwrap(),
        blocks.subdivided(1).unwrap().0,
    ]
}

/// A question whose scene is in memory, with half of all light reflected, and a light.
fn lit(scene: &Scene, store: Option<&Path>, resume: bool) -> Radiosity {
    Radiosity {
        scene: SceneSource::from(scene.clone()),
        materials: MaterialChanges {
            reflectance: vec!["all=0.5".parse().unwrap()],
            emittance: vec!["all=0".parse().unwrap(), "3=1".parse().unwrap()],
        },
        store: store.map(Path::to_owned),
        resume,
        ..Radiosity::default()
    }
}

fn measured(scene: &Scene, store: Option<&Path>, ranks: &dyn Ranks) -> MeasureAnswer {
    let question = Measure {
        scene: SceneSource::from(scene.clone()),
        store: store.map(Path::to_owned),
        ..Measure::default()
    };
    question.ask_among(ranks, &Unheard).unwrap()
}

/// Exchange areas are read back within 2 ε of those that were stored, and each bound is at least
/// the stored one and that difference together: F is rounded once, and so is the product.
#[test]
fn exchange_areas_are_read_within_their_bounds() {
    for scene in scenes() {
        let folder = tempfile::tempdir().unwrap();
        filled(&scene, folder.path(), Shard::default(), false);
        let pairs = pairs(&scene);
        let held = pairs.exchange_areas().unwrap();
        let stored = StoredMatrix::open(folder.path(), &scene, &pairs, TREATMENT).unwrap();
        let (values, bounds) = (stored.values(), stored.error_bounds());
        let mut seen = 0;
        for (index, rows) in values.blocks().into_iter().enumerate() {
            let read =
                |matrix: &dyn LowerBlocks| matrix.block(index, rows.clone()).unwrap().into_owned();
            let (values, bounds) = (read(&values), read(&bounds));
            let entries = rows.flat_map(|row| (0..row).map(move |column| (row, column)));
            for ((row, column), (value, bound)) in entries.zip(values.iter().zip(&bounds)) {
                let exact = held.get(row, column).exchange;
                let off = (value - exact.value).abs();
                assert!(off <= 2.0 * f64::EPSILON * exact.value, "{row} {column}");
                assert!(*bound >= exact.error + off, "{row} {column}: {bound}");
                seen += 1;
            }
        }
        assert_eq!(seen, pairs.pairs());
        for (row, own) in stored.own().unwrap().into_iter().enumerate() {
            let exact = held.get(row, row).exchange;
            assert!((own.value - exact.value).abs() <= 2.0 * f64::EPSILON * exact.value);
            assert!(own.error >= exact.error);
        }
    }
}

/// A furnace of R = 0.75 glows with B = 4 E; and elsewhere the answers from a store and from memory
/// meet: J is read within 2 ε, and so are the areas that are sums of it, so that form factors are
/// within 4 ε and light that bounced k times within 4 k ε; of R = 1/2, 2⁻¹⁰⁰ bounces more than 100
/// times.
#[test]
fn radiosities_over_a_store_are_those_of_the_scene() {
    let cube = Scene::built_in("cube:6").unwrap();
    let folder = tempfile::tempdir().unwrap();
    filled(&cube, folder.path(), Shard::default(), false);
    let furnace = Radiosity {
        scene: SceneSource::from(cube),
        materials: MaterialChanges {
            reflectance: vec!["all=0.75".parse().unwrap()],
            emittance: vec!["all=1".parse().unwrap()],
        },
        store: Some(folder.path().to_owned()),
        ..Radiosity::default()
    };
    let answer = furnace.ask(&Unheard).unwrap();
    assert_eq!(
        answer.plan.stored,
        answer.plan.pairs - answer.plan.untouched
    );
    for patch in answer.patches {
        let bound = 4.0 * answer.relative_error + patch.form_factor_error.unwrap();
        assert!(
            (patch.radiosity - 4.0).abs() <= bound && bound < 1e-10,
            "{bound}"
        );
    }
    for scene in scenes() {
        let folder = tempfile::tempdir().unwrap();
        filled(&scene, folder.path(), Shard::default(), false);
        let over = lit(&scene, Some(folder.path()), false)
            .ask(&Unheard)
            .unwrap();
        let held = lit(&scene, None, false).ask(&Unheard).unwrap();
        assert_eq!(over.closed, held.closed);
        for (one, other) in over.patches.iter().zip(&held.patches) {
            let solutions = over.relative_error + held.relative_error;
            assert!(solutions < 1e-14, "{solutions}");
            let bound = (solutions + 400.0 * f64::EPSILON) * one.radiosity;
            let off = (one.radiosity - other.radiosity).abs();
            assert!(off <= bound, "{off} {bound}");
        }
        // nothing is left of the solution
        assert!(!folder.path().join("form_factors/products").exists());
    }
}

/// The information of a cube's chain from a store is that from memory within both bounds, and that
/// of one patch a face is known: 0.263034544099120 bits, from an evaluation with 50 digits.
#[test]
fn information_over_a_store_is_that_of_the_scene() {
    let [summed, blocks] = scenes();
    let scenes = [Scene::built_in("cube:1").unwrap(), summed, blocks];
    for (index, scene) in scenes.into_iter().enumerate() {
        let folder = tempfile::tempdir().unwrap();
        filled(&scene, folder.path(), Shard::default(), false);
        let over = measured(&scene, Some(folder.path()), &Alone);
        let held = measured(&scene, None, &Alone);
        let bound = over.mutual_information_error + held.mutual_information_error;
        let off = (over.mutual_information - held.mutual_information).abs();
        // pairs past the blocks have larger bounds
        assert!(
            off <= bound && bound < [1e-11, 1e-11, 1e-4][index],
            "{off} {bound}"
        );
        if index == 0 {
            let known = 0.263_034_544_099_120_5;
            let off = (over.mutual_information - known).abs();
            assert!(off <= over.mutual_information_error, "{off}");
        }
    }
}

/// One to three ranks, one and two threads each, fill a store with the same files, and answer with
/// the same numbers, held and from the store.
#[test]
fn any_number_of_ranks_and_threads_gives_the_same_answers() {
    let all = [(2, 1), (1, 1), (1, 2), (3, 2)];
    for (scene, runs) in scenes().into_iter().zip([&all[..], &all[3..]]) {
        let folder = tempfile::tempdir().unwrap();
        filled(&scene, folder.path(), Shard::default(), false);
        let store = Some(folder.path());
        let answers = |ranks: &dyn Ranks| {
            [None, store].map(|store| {
                let light = lit(&scene, store, false)
                    .ask_among(ranks, &Unheard)
                    .unwrap();
                format!("{light:?} {:?}", measured(&scene, store, ranks))
            })
        };
        let expected = answers(&Alone);
        let files = super::stores::bytes(folder.path());
        for &(count, threads) in some_of(runs) {
            let other = tempfile::tempdir().unwrap();
            let found = among(count, |ranks| {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
                let question = StoreFormFactors {
                    scene: SceneSource::from(scene.clone()),
                    tolerance: 1e-12.into(),
                    congruence: TREATMENT.0,
                    folder: other.path().to_owned(),
                    resume: false,
                    shard: Shard::default(),
                };
                pool.build().unwrap().install(|| {
                    let stored = question.ask_among(ranks, &Unheard).unwrap();
                    assert_eq!((stored.found, stored.written), (0, stored.tiles));
                    answers(ranks)
                })
            });
            for found in found {
                assert!(found == expected, "{count} ranks of {threads} threads");
            }
            assert!(super::stores::bytes(other.path()) == files, "{count} ranks");
        }
    }
}

/// A process that dies after so many products.
struct Mortal {
    left: AtomicUsize,
}

impl Ranks for Mortal {
    fn number(&self) -> usize {
        0
    }

    fn count(&self) -> usize {
        1
    }

    fn exchange(&self, lists: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
        lists
    }

    fn gather(&self, list: Vec<f64>) -> Vec<Vec<f64>> {
        assert!(self.left.fetch_sub(1, Ordering::Relaxed) > 0, "dead");
        vec![list]
    }
}

/// A solution over a store that dies after any number of products, and is gone on with, answers
/// with the same numbers; a product file that is damaged, or another's, is made again.
#[test]
fn a_solution_goes_on_where_it_was_stopped() {
    let scene = Scene::built_in("cube:6").unwrap();
    let folder = tempfile::tempdir().unwrap();
    filled(&scene, folder.path(), Shard::default(), false);
    let products = folder.path().join("form_factors/products");
    let ask = |resume, ranks: &dyn Ranks| {
        let answer = lit(&scene, Some(folder.path()), resume).ask_among(ranks, &Unheard);
        format!("{:?}", answer.unwrap())
    };
    let expected = ask(false, &Alone);
    let kept = || fs::read_dir(&products).map_or(0, Iterator::count);
    let mut most = 0;
    for lives in [1, 2, 7, 12] {
        let mortal = Mortal {
            left: AtomicUsize::new(lives),
        };
        let died = catch_unwind(AssertUnwindSafe(|| ask(true, &mortal)));
        assert!(died.is_err() && kept() >= most, "after {lives}");
        most = kept();
    }
    assert!(most >= 8, "{most} products");
    // a kind of damage each: cut short, of another x, empty
    let files: Vec<_> = fs::read_dir(&products)
        .unwrap()
        .map(|file| file.unwrap().path())
        .collect();
    let whole = fs::read(&files[0]).unwrap();
    fs::write(&files[0], &whole[..whole.len() - 5]).unwrap();
    fs::copy(&files[2], &files[1]).unwrap();
    fs::write(&files[3], []).unwrap();
    assert!(ask(true, &Alone) == expected);
    assert_eq!(kept(), 0);
    // what is left of a solution is not taken unless that is asked for, and other light is another
    let mortal = Mortal {
        left: AtomicUsize::new(9),
    };
    drop(catch_unwind(AssertUnwindSafe(|| ask(false, &mortal))));
    assert!(kept() > 0);
    let other = |resume| {
        let mut other = lit(&scene, Some(folder.path()), resume);
        other.materials.emittance[1] = "3=1.5".parse().unwrap();
        format!("{:?}", other.ask(&Unheard).unwrap())
    };
    assert!(other(true) == other(false));
}

/// A store that lacks a chunk, one of another scene, and an entry that is no number are refused.
#[test]
fn stores_that_cannot_answer_are_refused() {
    let scene = Scene::built_in("cube:6").unwrap();
    let folder = tempfile::tempdir().unwrap();
    let refusal = |scene: &Scene| {
        let answer = lit(scene, Some(folder.path()), false).ask(&Unheard);
        answer.map(|_| ()).unwrap_err().to_string()
    };
    assert!(refusal(&scene).contains("is no store of form factors"));
    filled(&scene, folder.path(), Shard { number: 0, of: 2 }, true);
    let text = refusal(&scene);
    assert!(
        text.contains("lacks 8 of 16 chunks") && text.contains("fill it first"),
        "{text}"
    );
    filled(&scene, folder.path(), Shard::default(), true);
    let other = Scene::built_in("cube:5").unwrap();
    assert!(refusal(&other).contains("\"rows 216\", and \"rows 150\" is wanted"));
    let pairs = pairs(&scene);
    let treatment = (Congruence::Ignored, Occlusion::Exact);
    let opened = StoredMatrix::open(folder.path(), &scene, &pairs, treatment);
    assert!(matches!(opened, Err(StoreError::OtherMatrix { .. })));
    let chunk = folder.path().join("form_factors/c/2/1");
    let mut bytes = fs::read(&chunk).unwrap();
    bytes[64 * 8..65 * 8].copy_from_slice(&f64::NAN.to_le_bytes());
    fs::write(&chunk, bytes).unwrap();
    assert!(refusal(&scene).contains("row 129 of the store has a form factor of NaN"));
    let kept = MatrixStore::open(folder.path(), &scene, &pairs, TREATMENT, true);
    assert!(kept.is_ok());
}
