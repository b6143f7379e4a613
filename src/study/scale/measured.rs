//! Passes, stores, products and messages, timed on this machine.
//!
//! A cube with a grid on each face has congruent pairs; with every pair computed it is a room
//! without congruence; the Cornell box with blocks has pairs past others.

use super::model::Terms;
use super::timer::Timer;
use super::{ScaleRow, StudyError};
use crate::exchange::{
    Congruence, MatrixStore, ProductFiles, Ranks, ScenePairs, Shard, StoreError, StoredMatrix,
    Tolerance, agreed, gather_texts,
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
/// The cells of a cube of 179,574 patches, in full, which takes minutes: on all threads alone.
const LARGEST: [Option<u32>; 2] = [None, Some(173)];
/// The cells of the room whose pairs are all computed, and whose matrix is held and stored: up to
/// 20,184 patches, of which a store takes 5 GB.
const COMPUTED: [u32; 2] = [8, 16];
const HELD: [u32; 2] = [16, 58];
/// The times that the room past others is subdivided.
const SUBDIVIDED: [u32; 2] = [1, 2];

/// Light that half the room reflects, from one patch.
const REFLECTANCE: f64 = 0.5;

/// Messages that are timed, and the numbers that each rank sends to each other in one of them.
const MESSAGES: usize = 16;
const NUMBERS: usize = 1 << 17;

/// The rows, and the terms of the model that they give.
pub(super) fn measured(
    ranks: &dyn Ranks,
    quick: bool,
) -> Result<(Vec<ScaleRow>, Terms), StudyError> {
    let place = usize::from(!quick);
    let mut timer = Timer::new(ranks);
    let own = std::thread::available_parallelism().map_or(1, usize::from);
    // ranks with fewer threads take part with those that they have
    let all = if timer.largest(real(own)) > 1.0 {
        &[own, 1][..]
    } else {
        &[1]
    };
    let (congruent, patch) = congruent(&mut timer, CELLS[place], all)?;
    if let Some(cells) = LARGEST[place] {
        let case = ("measure", Congruence::Shared);
        pass(&mut timer, case, &cube(cells)?, &all[..1])?;
    }
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
    let network = messages(&mut timer);
    let [entry, stored_entry, products] = products;
    let terms = Terms {
        pair: [congruent, computed, past],
        entry,
        stored_entry,
        products,
        patch,
        network,
    };
    Ok((timer.rows, terms))
}

fn cube(cells: u32) -> Result<Scene, StudyError> {
    Ok(Scene::built_in(&format!("cube:{cells}"))?)
}

/// The seconds of a thread for a pair of the largest cube, and the bytes of a patch.
fn congruent(
    timer: &mut Timer<'_>,
    cells: &[u32],
    all: &[usize],
) -> Result<(f64, f64), StudyError> {
    let (mut last, mut patch) = (0.0, 0.0);
    let before = timer.most_memory();
    for cells in cells {
        let scene = cube(*cells)?;
        last = pass(timer, ("measure", Congruence::Shared), &scene, all)?;
        let grown = timer
            .most_memory()
            .zip(before)
            .map_or(0.0, |(now, before)| now - before);
        patch = grown / real(scene.patches().len());
    }
    Ok((last, patch))
}

/// The seconds of one thread for a pair, of a pass on all threads and then on one of each rank.
fn pass(
    timer: &mut Timer<'_>,
    (case, congruence): (&str, Congruence),
    scene: &Scene,
    all: &[usize],
) -> Result<f64, StudyError> {
    let n = scene.patches().len();
    let ranks = timer.ranks;
    let mut seconds = 0.0;
    for threads in all {
        let measured = timer.time((case, n, *threads), || {
            let (tolerance, occlusion) = (Tolerance::default(), Occlusion::Exact);
            let pairs = ScenePairs::try_new(scene, tolerance, congruence, occlusion)?;
            Ok(scene_information(
                &pairs.among(ranks),
                OpenScene::AddOutsideState,
            )?)
        });
        seconds = measured?.0;
    }
    Ok(seconds * real(ranks.count()) / (real(n) * real(n) / 2.0))
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
fn products(timer: &mut Timer<'_>, scene: &Scene) -> Result<[f64; 3], StudyError> {
    let n = scene.patches().len();
    let ranks = timer.ranks;
    let treatment = (Congruence::Shared, Occlusion::Exact);
    let pairs = ScenePairs::try_new(scene, Tolerance::default(), treatment.0, treatment.1)?;
    let pairs = pairs.among(ranks);
    let mut emittances = vec![0.0; n];
    emittances[0] = 1.0;
    let reflectances = vec![REFLECTANCE; n];
    let (_, held) = timer.time(("matrix, held", n, 1), || Ok(SceneExchange::held(&pairs)?))?;
    let solve = |exchange: &SceneExchange<'_>| {
        let system = exchange.system(reflectances.clone())?;
        Ok::<_, StudyError>(system.radiosity(&emittances)?)
    };
    let (seconds, light) = timer.time(("radiosity, held", n, 1), || solve(&held))?;
    drop(held);
    // the first rank makes the folder that the others find
    let made = (ranks.number() == 0).then(Folder::new).transpose();
    let made = agreed(ranks, made)?;
    let name = made.as_ref().map(|folder| folder.0.to_string_lossy());
    let names = gather_texts(ranks, name.as_deref());
    let folder = names.into_iter().flatten().next().unwrap_or_default();
    let folder = Path::new(&folder);
    timer.time(("store", n, 1), || {
        let store = MatrixStore::open(folder, scene, &pairs, treatment, false)?;
        Ok(store.fill(Shard::default())?)
    })?;
    let stored = StoredMatrix::open(folder, scene, &pairs, treatment)?;
    let files = Arc::new(ProductFiles::open(folder, false)?);
    let (from_store, products) = timer.time(("radiosity, from the store", n, 1), || {
        solve(&SceneExchange::stored(&stored, Some(&files))?)?;
        Ok(products_in(folder))
    })?;
    if ranks.number() == 0 {
        files.clear()?;
    }
    debug_assert!(light.iterations <= products, "each iteration is a product");
    let entries = real(products) * real(n) * real(n) / 2.0 / real(ranks.count());
    // the folder stays until all ranks have done with it
    ranks.gather(Vec::new());
    drop(made);
    Ok([seconds / entries, from_store / entries, real(products)])
}

/// The number of products that a solution has left in a store.
fn products_in(folder: &Path) -> usize {
    let files = fs::read_dir(folder.join("form_factors/products"));
    files.map_or(0, Iterator::count)
}

/// Times messages, if there are several ranks; the bytes a second that a node sends to others, if
/// there are several nodes.
fn messages(timer: &mut Timer<'_>) -> Option<f64> {
    let ranks = timer.ranks;
    let others = ranks.count() - 1;
    if others == 0 {
        return None;
    }
    let timed = |lists: &dyn Fn() -> Vec<Vec<f64>>| {
        ranks.gather(Vec::new());
        let start = Instant::now();
        for _ in 0..MESSAGES {
            ranks.exchange(lists());
        }
        timer.largest(start.elapsed().as_secs_f64() / real(MESSAGES))
    };
    let empty = timed(&|| vec![Vec::new(); ranks.count()]);
    let full = timed(&|| vec![vec![1.0; NUMBERS]; ranks.count()]);
    let sent = 8.0 * real(NUMBERS) * real(others) / full;
    timer.note("a message of nothing", (None, 1), (empty, "s"), None);
    timer.note(
        "sent to other ranks by each",
        (None, 1),
        (sent, "bytes/s"),
        None,
    );
    let by_node = sent * real(ranks.count()) / real(timer.nodes());
    (timer.nodes() > 1).then_some(by_node)
}
