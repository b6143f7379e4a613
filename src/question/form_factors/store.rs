//! A scene's form factors in a folder, tile by tile, and the state of such a folder.

use crate::exchange::{
    Alone, Congruence, MatrixStore, PlanSummary, Progress, Ranks, ScenePairs, Shard, StoreState,
    StoredMatrix, Tolerance, Unheard, check_store,
};
use crate::question::QuestionError;
use crate::question::scene::{SceneSource, ignored_note};
use crate::question::unreached::Unreached;
use crate::scene::Scene;
use std::path::{Path, PathBuf};

/// The wish for a scene's form factors in a folder: a group of Zarr arrays, larger than memory.
///
/// Memory is that of the scene and 40 MB a thread; a run that is stopped is resumed.
#[derive(Debug, Clone, PartialEq)]
pub struct StoreFormFactors {
    /// The scene.
    pub scene: SceneSource,
    /// The error that is accepted of every form factor.
    pub tolerance: Tolerance,
    /// The treatment of congruent pairs.
    pub congruence: Congruence,
    /// The folder.
    pub folder: PathBuf,
    /// May the folder hold tiles of this matrix already?
    pub resume: bool,
    /// The share of the tiles that is to be computed.
    pub shard: Shard,
}

/// The outcome of filling a store, as a record.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[non_exhaustive]
pub struct StoreAnswer {
    /// The folder.
    pub folder: PathBuf,
    /// The rows of the matrix.
    pub rows: usize,
    /// The tiles of the whole matrix.
    pub tiles: usize,
    /// The tiles of the share that were there before.
    pub found: usize,
    /// The tiles that were computed.
    pub written: usize,
    /// The pairs that were left out, shared and computed; of the tiles computed now alone.
    pub plan: PlanSummary,
    /// The pairs computed now that miss the tolerance, if some do.
    #[serde(skip)]
    pub unreached: Option<Unreached>,
    /// Remarks of the scene's reader.
    #[serde(skip)]
    pub notes: Vec<String>,
}

impl StoreFormFactors {
    /// Computes the tiles of the share that are not there yet.
    ///
    /// # Errors
    /// [`QuestionError::Store`] for a folder that cannot be used; the errors of the scene and of
    /// its pairs.
    pub fn ask(&self, progress: &dyn Progress) -> Result<StoreAnswer, QuestionError> {
        self.ask_among(&Alone, progress)
    }

    /// Computes them as one of the ranks that share them out: each asks the same, and has the same
    /// answer.
    ///
    /// # Errors
    /// As [`ask`](Self::ask); [`ExchangeError::Rank`](crate::exchange::ExchangeError::Rank) of
    /// another rank's.
    pub fn ask_among(
        &self,
        ranks: &dyn Ranks,
        progress: &dyn Progress,
    ) -> Result<StoreAnswer, QuestionError> {
        let loaded = self.scene.open()?;
        let scene = loaded.scene;
        let asked = (self.tolerance, self.congruence);
        let pairs = self.scene.pairs(&scene, asked, progress)?.among(ranks);
        let treatment = (self.congruence, self.scene.occlusion);
        // shares are of one folder, whichever begins first
        let resume = self.resume || self.shard.of > 1;
        let store = MatrixStore::open(&self.folder, &scene, &pairs, treatment, resume)?;
        let filled = store.fill(self.shard)?;
        let mut notes = loaded.notes;
        notes.extend(ignored_note(filled.summary.plan.ignored));
        Ok(StoreAnswer {
            folder: self.folder.clone(),
            rows: pairs.rows(),
            tiles: filled.tiles,
            found: filled.found,
            written: filled.written,
            unreached: Unreached::pairs(pairs.names(), &filled.summary, pairs.tolerance()),
            plan: filled.summary.plan,
            notes,
        })
    }
}

/// A store that a question is answered from.
pub(in crate::question) struct StoreToRead<'q> {
    source: &'q SceneSource,
    tolerance: Tolerance,
    congruence: Congruence,
    pub(in crate::question) folder: &'q Path,
}

impl<'q> StoreToRead<'q> {
    /// The store of a scene in a folder, asked for as it was stored.
    pub(in crate::question) const fn of(
        source: &'q SceneSource,
        (tolerance, congruence): (Tolerance, Congruence),
        folder: &'q Path,
    ) -> Self {
        Self {
            source,
            tolerance,
            congruence,
            folder,
        }
    }

    /// The pairs of the scene, none of which is evaluated.
    pub(in crate::question) fn pairs<'p>(
        &self,
        scene: &Scene,
        ranks: &'p dyn Ranks,
    ) -> Result<ScenePairs<'p>, QuestionError> {
        let asked = (self.tolerance, Congruence::Ignored);
        Ok(self.source.pairs(scene, asked, &Unheard)?.among(ranks))
    }

    /// The matrix.
    pub(in crate::question) fn open<'p>(
        &self,
        scene: &Scene,
        pairs: &'p ScenePairs<'_>,
    ) -> Result<StoredMatrix<'p>, QuestionError> {
        let treatment = (self.congruence, self.source.occlusion);
        Ok(StoredMatrix::open(self.folder, scene, pairs, treatment)?)
    }
}

/// The question for the state of a store.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CheckStore {
    /// The folder.
    pub folder: PathBuf,
}

impl CheckStore {
    /// Reads the store through.
    ///
    /// # Errors
    /// [`QuestionError::Store`].
    pub fn ask(&self) -> Result<StoreState, QuestionError> {
        Ok(check_store(&self.folder)?)
    }
}
