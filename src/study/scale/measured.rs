//! Passes, stores and products, timed on this machine.
//!
//! A cube with a grid on each face has congruent pairs; with every pair computed it is a room
//! without congruence; the Cornell box with blocks has pairs past others.

use super::model::Terms;
use super::{Basis, ScaleRow, StudyError};
use crate::exchange::{
    Congruence, MatrixStore, ProductFiles, ScenePairs, Shard, StoreError, StoredMatrix, Tolerance,
};
use crate::information::{OpenScene, scene_information};
use crate::numeric::real;
use crate::scene::{Occlusion, Scene};
use crate::transport::SceneExchange;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

/// Cells along the edge of a cube's face, quick and in full: 600 to 2,400 patches, and to 55,296.
const CELLS: [&[u32]; 2] = [&[10, 20], &[10, 20, 32, 64, 96]];
/// The cells of the room whose pairs are all computed, and whose matrix is held and stored.
const COMPUTED: [u32; 2] = [8, 16];
const HELD: [u32; 2] = [16, 32];
/// The times that the room past others is subdivided.
const SUBDIVIDED: [u32; 2] = [1, 2];

/// Light that half the room reflects, from one patch.
const REFLECTANCE: f64 = 0.5;

/// What was timed so far.
struct Timer {
    rows: Vec<ScaleRow>,
}

impl Timer {
    /// Times some work on so many threads, and notes it; its seconds, and its answer.
    fn time<T: Send>(
        &mut self,
        (case, patches, threads): (&str, usize, usize),
        work: impl FnOnce() -> Result<T, StudyError> + Send,
    ) -> Result<(f64, T), StudyError> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let start = Instant::now();
        let answer = match pool {
            Ok(pool) => pool.install(work)?,
            // as many as there are
            Err(_) => work()?,
        };
        let value = start.elapsed().as_secs_f64();
        self.rows.push(ScaleRow {
            case: case.to_owned(),
            basis: Basis::Measured,
            patches: Some(patches),
            nodes: 1,
            threads,
            value,
            unit: "s",
            memory: most_memory(),
        });
        Ok((value, answer))
    }
}

/// The rows, and the terms of the model that they give.
pub(super) fn measured(quick: bool) -> Result<(Vec<ScaleRow>, Terms), StudyError> {
    let place = usize::from(!quick);
    let all = std::thread::available_parallelism().map_or(1, usize::from);
    let mut timer = Timer { rows: Vec::new() };
    let (congruent, patch) = congruent(&mut timer, CELLS[place], all)?;
    let computed = pass(
        &mut timer,
        ("measure, every pair", Congruence::Ignored),
        &cube(COMPUTED[place])?,
        all,
    )?;
    let (blocks, _) = Scene::built_in("cornell-box-blocks")?.subdivided(SUBDIVIDED[place])?;
    let past = pass(
        &mut timer,
        ("measure, past others", Congruence::Shared),
        &blocks,
        all,
    )?;
    let products = products(&mut timer, &cube(HELD[place])?)?;
    let [entry, stored_entry, products] = products;
    let terms = Terms {
        pair: [congruent, computed, past],
        entry,
        stored_entry,
        products,
        patch,
    };
    Ok((timer.rows, terms))
}

fn cube(cells: u32) -> Result<Scene, StudyError> {
    Ok(Scene::built_in(&format!("cube:{cells}"))?)
}

/// The seconds of a thread for a pair of the largest cube, and the bytes of a patch.
fn congruent(timer: &mut Timer, cells: &[u32], all: usize) -> Result<(f64, f64), StudyError> {
    let (mut last, mut patch) = (0.0, 0.0);
    let before = most_memory();
    for cells in cells {
        let scene = cube(*cells)?;
        last = pass(timer, ("measure", Congruence::Shared), &scene, all)?;
        let grown = most_memory()
            .zip(before)
            .map_or(0.0, |(now, before)| now - before);
        patch = grown / real(scene.patches().len());
    }
    Ok((last, patch))
}

/// The seconds of one thread for a pair, of a pass on one thread and on all.
fn pass(
    timer: &mut Timer,
    (case, congruence): (&str, Congruence),
    scene: &Scene,
    all: usize,
) -> Result<f64, StudyError> {
    let n = scene.patches().len();
    let mut seconds = 0.0;
    for threads in [all, 1] {
        let measured = timer.time((case, n, threads), || {
            let (tolerance, occlusion) = (Tolerance::default(), Occlusion::Exact);
            let pairs = ScenePairs::try_new(scene, tolerance, congruence, occlusion)?;
            Ok(scene_information(&pairs, OpenScene::AddOutsideState)?)
        });
        seconds = measured?.0;
        if all == 1 {
            break;
        }
    }
    Ok(seconds / (real(n) * real(n) / 2.0))
}

/// A folder that goes with what is in it.
struct Folder(PathBuf);

impl Folder {
    fn new() -> Result<Self, StoreError> {
        let name = format!("infoscene-scale-{}", std::process::id());
        let path = std::env::temp_dir().join(name);
        match fs::create_dir(&path) {
            Ok(()) => Ok(Self(path)),
            Err(source) => Err(StoreError::Io { path, source }),
        }
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // what cannot be removed is left to whoever looks after the folder of temporary files
        drop(fs::remove_dir_all(&self.0));
    }
}

/// The seconds of one thread for an entry of a product, held and stored, and the products of a
/// solution.
fn products(timer: &mut Timer, scene: &Scene) -> Result<[f64; 3], StudyError> {
    let n = scene.patches().len();
    let treatment = (Congruence::Shared, Occlusion::Exact);
    let pairs = ScenePairs::try_new(scene, Tolerance::default(), treatment.0, treatment.1)?;
    let mut emittances = vec![0.0; n];
    emittances[0] = 1.0;
    let reflectances = vec![REFLECTANCE; n];
    let (_, (held, _)) = timer.time(("matrix, held", n, 1), || Ok(SceneExchange::held(&pairs)?))?;
    let solve = |exchange: &SceneExchange<'_>| {
        let system = exchange.system(reflectances.clone())?;
        Ok::<_, StudyError>(system.radiosity(&emittances)?)
    };
    let (seconds, light) = timer.time(("radiosity, held", n, 1), || solve(&held))?;
    drop(held);
    let folder = Folder::new()?;
    let folder = folder.0.as_path();
    timer.time(("store", n, 1), || {
        let store = MatrixStore::open(folder, scene, &pairs, treatment, false)?;
        Ok(store.fill(Shard::default())?)
    })?;
    let stored = StoredMatrix::open(folder, scene, &pairs, treatment)?;
    let files = Arc::new(ProductFiles::open(folder, false)?);
    let (from_store, made) = timer.time(("radiosity, from the store", n, 1), || {
        solve(&SceneExchange::stored(&stored, &files)?)?;
        Ok(products_in(folder))
    })?;
    files.clear()?;
    debug_assert!(light.iterations <= made, "each iteration is a product");
    let entries = real(made) * real(n) * real(n) / 2.0;
    Ok([seconds / entries, from_store / entries, real(made)])
}

/// The number of products that a solution has left in a store.
fn products_in(folder: &Path) -> usize {
    let files = fs::read_dir(folder.join("form_factors/products"));
    files.map_or(0, Iterator::count)
}

/// The most memory that this process ever had, where the system tells.
fn most_memory() -> Option<f64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kilobytes: f64 = line.trim().trim_end_matches("kB").trim().parse().ok()?;
    Some(kilobytes * 1024.0)
}
