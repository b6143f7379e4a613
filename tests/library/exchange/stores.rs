//! Matrices in folders: their bytes, resumed, shared out, cut short, of another scene.

use infoscene::exchange::{
    Congruence, MatrixStore, ScenePairs, Shard, StoreError, StoreFilled, check_store,
};
use infoscene::scene::{Occlusion, Scene};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

const TREATMENT: (Congruence, Occlusion) = (Congruence::Shared, Occlusion::Exact);

fn pairs(scene: &Scene) -> ScenePairs<'_> {
    ScenePairs::try_new(scene, 1e-12, TREATMENT.0, TREATMENT.1).unwrap()
}

pub(super) fn filled(scene: &Scene, folder: &Path, shard: Shard, resume: bool) -> StoreFilled {
    let pairs = pairs(scene);
    let store = MatrixStore::open(folder, scene, &pairs, TREATMENT, resume).unwrap();
    store.fill(shard).unwrap()
}

/// All files of a folder with their bytes, but for what is unfinished.
pub(super) fn bytes(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut open = vec![folder.to_owned()];
    while let Some(next) = open.pop() {
        for entry in fs::read_dir(next).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
            } else {
                let name = path.strip_prefix(folder).unwrap().to_owned();
                found.insert(name, fs::read(&path).unwrap());
            }
        }
    }
    found
}

/// Chunks read by hand: 216 rows in chunks of 64 are the held matrix to the last bit, bounds are
/// rounded up to f32, and what lies beyond the last row is NaN.
#[test]
fn chunks_are_the_matrix() {
    let scene = Scene::built_in("cube:6").unwrap();
    let folder = tempfile::tempdir().unwrap();
    let outcome = filled(&scene, folder.path(), Shard::default(), false);
    assert_eq!((outcome.tiles, outcome.found, outcome.written), (10, 0, 10));
    let held = pairs(&scene).exchange_areas().unwrap();
    let (n, side) = (216, 64);
    for (i, j) in (0..4).flat_map(|i| (0..4).map(move |j| (i, j))) {
        let chunk = |array| fs::read(folder.path().join(format!("{array}/c/{i}/{j}"))).unwrap();
        let (factors, bounds) = (chunk("form_factors"), chunk("bounds"));
        assert_eq!(
            (factors.len(), bounds.len()),
            (side * side * 8, side * side * 4)
        );
        for at in 0..side * side {
            let [row, column] = [i * side + at / side, j * side + at % side];
            let factor = f64::from_le_bytes(factors[8 * at..8 * at + 8].try_into().unwrap());
            let bound = f32::from_le_bytes(bounds[4 * at..4 * at + 4].try_into().unwrap());
            if row >= n || column >= n {
                assert!(factor.is_nan() && bound.is_nan());
                continue;
            }
            let exchange = held.get(row, column).exchange;
            let area = held.areas()[row];
            assert_eq!(factor, exchange.value / area, "{row} {column}");
            // 1e-6: the rounding of f32; the bound on an area's own rounding comes on top
            let least = exchange.error / area;
            let most = least + held.area_bounds()[row] / area * factor;
            assert!(f64::from(bound) >= least && f64::from(bound) <= most * (1.0 + 1e-6));
        }
    }
    let state = check_store(folder.path()).unwrap();
    assert!(state.is_whole(), "{state:?}");
    let [least, most] = [state.least_sum, state.largest_sum].map(Option::unwrap);
    assert!(
        (least - 1.0).abs() < 1e-13 && (most - 1.0).abs() < 1e-13,
        "{state:?}"
    );
}

/// A run that is cut short, shares in any order, and another number of threads make the same files.
/// A chunk that is missing, or was cut short itself, is computed again.
#[test]
fn any_way_of_filling_gives_the_same_bytes() {
    for name in ["cube:6", "cornell-box-blocks"] {
        let scene = Scene::built_in(name).unwrap();
        let (scene, _) = scene.subdivided(u32::from(name != "cube:6")).unwrap();
        let whole = tempfile::tempdir().unwrap();
        filled(&scene, whole.path(), Shard::default(), false);
        let expected = bytes(whole.path());

        let shared = tempfile::tempdir().unwrap();
        for number in [2, 0, 1] {
            let one = rayon::ThreadPoolBuilder::new()
                .num_threads(1)
                .build()
                .unwrap();
            one.install(|| filled(&scene, shared.path(), Shard { number, of: 3 }, true));
        }
        assert_eq!(bytes(shared.path()), expected, "{name}");

        let cut = tempfile::tempdir().unwrap();
        filled(&scene, cut.path(), Shard { number: 0, of: 2 }, true);
        fs::remove_file(cut.path().join("bounds/c/0/0")).unwrap();
        fs::write(cut.path().join("form_factors/c/0/0"), [0; 100]).unwrap();
        assert!(check_store(cut.path()).unwrap().missing > 0);
        let outcome = filled(&scene, cut.path(), Shard::default(), true);
        assert!(outcome.written > outcome.tiles / 2, "{outcome:?}");
        assert_eq!(bytes(cut.path()), expected, "{name}");
        let again = filled(&scene, cut.path(), Shard::default(), true);
        assert_eq!((again.found, again.written), (again.tiles, 0));
    }
}

/// A number that is off by more than its bound is found, in either chunk.
#[test]
fn what_breaks_a_law_is_found() {
    let scene = Scene::built_in("cube:4").unwrap();
    let folder = tempfile::tempdir().unwrap();
    filled(&scene, folder.path(), Shard::default(), false);
    assert!(check_store(folder.path()).unwrap().is_whole());
    for (chunk, row) in [("form_factors/c/0/1", 0), ("form_factors/c/1/0", 64)] {
        let path = folder.path().join(chunk);
        let whole = fs::read(&path).unwrap();
        let mut changed = whole.clone();
        // the last entries of the first row see the wall across
        let at = 8 * 20;
        let value = f64::from_le_bytes(changed[at..at + 8].try_into().unwrap());
        assert!(value > 0.0);
        changed[at..at + 8].copy_from_slice(&(value * (1.0 - 1e-9)).to_le_bytes());
        fs::write(&path, &changed).unwrap();
        let state = check_store(folder.path()).unwrap();
        let [i, j] = state.first_broken.unwrap();
        assert!(state.broken == 1 && (i == row || j == row), "{state:?}");
        fs::write(&path, &whole).unwrap();
    }
    assert!(check_store(folder.path()).unwrap().is_whole());
}

/// A folder that is not empty, the store of another scene or another tolerance, and what is no
/// store are refused, and stay as they are.
#[test]
fn other_folders_are_refused() {
    let scene = Scene::built_in("two-squares").unwrap();
    let pairs_of = pairs(&scene);
    let open = |folder: &Path, resume| {
        MatrixStore::open(folder, &scene, &pairs_of, TREATMENT, resume).map(|_| ())
    };
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("notes"), "mine").unwrap();
    let refused = [false, true].map(|resume| open(folder.path(), resume));
    assert!(
        matches!(
            refused,
            [
                Err(StoreError::NotEmpty { .. }),
                Err(StoreError::NoStore { .. })
            ]
        ),
        "{refused:?}"
    );
    assert!(matches!(
        check_store(folder.path()),
        Err(StoreError::NoStore { .. })
    ));
    assert_eq!(bytes(folder.path()).len(), 1);

    let store = tempfile::tempdir().unwrap();
    filled(
        &Scene::built_in("three-squares").unwrap(),
        store.path(),
        Shard::default(),
        false,
    );
    let before = bytes(store.path());
    assert!(matches!(
        open(store.path(), false),
        Err(StoreError::NotEmpty { .. })
    ));
    let refused = open(store.path(), true).unwrap_err().to_string();
    assert!(
        refused.contains("line 3") && refused.contains("\"rows 3\""),
        "{refused}"
    );
    assert_eq!(bytes(store.path()), before);

    let loose = ScenePairs::try_new(&scene, 1e-6, TREATMENT.0, TREATMENT.1).unwrap();
    let same = tempfile::tempdir().unwrap();
    filled(&scene, same.path(), Shard::default(), false);
    let refused = MatrixStore::open(same.path(), &scene, &loose, TREATMENT, true).map(|_| ());
    let text = refused.unwrap_err().to_string();
    assert!(text.contains("\"tolerance 1e-12\""), "{text}");
}

/// Files that a writer who was killed has left are removed after an hour; those of writers at work
/// stay.
#[test]
fn what_the_killed_have_left_is_removed() {
    let folder = tempfile::tempdir().unwrap();
    let scene = Scene::built_in("cube:2").unwrap();
    filled(&scene, folder.path(), Shard::default(), false);
    let aside = folder.path().join("form_factors/unfinished");
    let [old, new] = ["old", "new"].map(|name| aside.join(name));
    for file in [&old, &new] {
        fs::write(file, b"half a chunk").unwrap();
    }
    let earlier = SystemTime::now() - Duration::from_secs(4000);
    let file = fs::File::options().write(true).open(&old).unwrap();
    file.set_modified(earlier).unwrap();
    filled(&scene, folder.path(), Shard::default(), true);
    assert!(!old.exists() && new.exists());
}
