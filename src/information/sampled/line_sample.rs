//! Random lines through a closed scene, and the estimates of its information from them.
//!
//! Each chord of a line is a sample of the joint distribution `J_ij = A_i F_ij / A_T`, with
//! occlusion; the pair {i, j} is counted ([`PairCounts`]), and its summand of the continuous mutual
//! information added up ([`ChordInformation`]). A local line has one chord, a global one has
//! several where a room is concave or holds something: these are all counted, and kept together for
//! the standard error.
//!
//! Lines are drawn in chunks. Each has its own stream of the generator, numbered from 0, so that
//! the sample depends on the seed alone and not on the number of threads.
//!
//! **Memory** for the cells that are met and the lines with several chords: bounded by the number
//! of lines.
//!
//! **Not covered**: open scenes, which are refused: a chord has two ends.

use super::chords::{ChordInformation, ChordSums};
use super::pair_counts::PairCounts;
use crate::chain::ChainError;
use crate::exchange::ExchangeError;
use crate::scene::{Chord, GridLines, Passage, Scene, SceneLines};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use std::collections::HashMap;

/// A way to draw lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineKind {
    /// Lines from uniform points of all patches, directions by cosine, to the first front they
    /// meet.
    Local,
    /// Lines uniform among those that meet the scene, with all their chords.
    Global,
}

impl LineKind {
    /// `"local"` or `"global"`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Local => "local",
            Self::Global => "global",
        }
    }
}

/// A sample of random lines through a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct LineSample {
    /// The way the lines were drawn.
    pub kind: LineKind,
    /// The number of lines that met a front.
    pub lines: u32,
    /// The pairs of rows at the ends of their chords.
    pub counts: PairCounts,
    /// The continuous mutual information by their chords.
    pub chords: ChordInformation,
}

/// Lines of a chunk: (a) enough that a stream of its own costs little; a power of two.
const LINES_PER_CHUNK: u32 = 1 << 12;

/// The largest number of global lines through the sphere around a scene that are drawn for each
/// line wanted: a scene that fewer than one in so many meet is refused.
const MOST_DRAWS_PER_LINE: u64 = 10_000;

impl LineSample {
    /// Draws lines through a closed scene, which may be concave and occluded.
    ///
    /// **Arguments** `lines`: the number of lines that meet a front, at least 2; fewer count as 2.
    /// `seed`: one seed always gives the same sample.
    ///
    /// # Errors
    /// [`ChainError::Scene`] with [`SceneError::Overlap`](crate::scene::SceneError::Overlap) if
    /// patches lie on each other; [`ChainError::Exchange`] with [`ExchangeError::TurnedAway`] if
    /// all fronts are outside, with [`ExchangeError::LinesEscape`] if more than a millionth of the
    /// lines leave a front and meet none, and with
    /// [`ExchangeError::LinesMiss`] if fewer than one in ten thousand global lines meet the scene
    /// at all.
    ///
    /// # Examples
    /// ```
    /// use infoscene::information::{LineKind, LineSample};
    /// use infoscene::scene::Scene;
    /// let cube = LineSample::draw(&Scene::built_in("cube:1")?, LineKind::Global, 10_000, 1)?;
    /// let [from, to] = cube.counts.confidence_interval().ok_or("all cells are met often")?;
    /// assert!((from..to).contains(&0.263_034_544_099_120_5)); // from a 50-digit evaluation
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn draw(scene: &Scene, kind: LineKind, lines: u32, seed: u64) -> Result<Self, ChainError> {
        scene.check_overlap()?;
        if scene.is_turned_away() {
            return Err(ExchangeError::TurnedAway.into());
        }
        let ready = SceneLines::of(scene);
        Self::of(
            kind,
            lines,
            seed,
            &scene.row_areas(),
            |random, chords| match kind {
                LineKind::Global => ready.global(random.random(), chords),
                LineKind::Local => met(ready.local(random.random()), chords),
            },
        )
    }

    /// Draws local lines through the inside of a box whose faces all have the same grid.
    ///
    /// A line finds its cells by bisection.
    ///
    /// **Arguments** as those of [`draw`](Self::draw).
    ///
    /// # Errors
    /// None but for rounding: no line escapes from a box or misses it.
    pub fn draw_in_grid(grid: &GridLines, lines: u32, seed: u64) -> Result<Self, ChainError> {
        Self::of(
            LineKind::Local,
            lines,
            seed,
            &grid.areas(),
            |random, chords| met(grid.local(random.random()), chords),
        )
    }

    fn of(
        kind: LineKind,
        lines: u32,
        seed: u64,
        areas: &[f64],
        line: impl Fn(&mut ChaCha8Rng, &mut Vec<Chord>) -> Passage + Sync,
    ) -> Result<Self, ChainError> {
        let lines = lines.max(2);
        let chunks = (0..lines.div_ceil(LINES_PER_CHUNK)).into_par_iter();
        let met = chunks.fold(LinesMet::default, |mut met, chunk| {
            let mut random = ChaCha8Rng::seed_from_u64(seed);
            random.set_stream(chunk.into());
            let quota = LINES_PER_CHUNK.min(lines - chunk * LINES_PER_CHUNK);
            met.draw(chunk, quota, |chords| line(&mut random, chords));
            met
        });
        let mut all = met.reduce(LinesMet::default, LinesMet::merged);
        let LinesMet { lost, missing, .. } = all;
        if lost > lines / 1_000_000 {
            return Err(ExchangeError::LinesEscape { lost, lines }.into());
        }
        if missing > 0 {
            let met = lines - missing;
            return Err(ExchangeError::LinesMiss { met, lines }.into());
        }
        // in an order that does not depend on threads
        all.chords.sort_unstable_by_key(|(chunk, _)| *chunk);
        all.bundles.sort_unstable();
        let mut sums = ChordSums::default();
        for (_, chunk) in &all.chords {
            sums.merge(chunk);
        }
        Ok(Self {
            kind,
            lines,
            counts: PairCounts::of_lines(areas, all.cells, &all.bundles)?,
            chords: sums.mean(lines),
        })
    }
}

/// Estimates the continuous mutual information of a closed scene by random chords.
///
/// The scene may be concave and occluded.
///
/// **Arguments** `lines`: the number of lines, at least 2; fewer count as 2. `seed`: one seed
/// always gives the same estimate.
///
/// # Errors
/// As [`LineSample::draw`].
///
/// # Examples
/// ```
/// use infoscene::information::chord_information;
/// use infoscene::scene::Scene;
/// let cube = chord_information(&Scene::built_in("cube:1")?, 10_000, 1)?;
/// assert!((cube.mutual_information - 1.610_473_346_468_78).abs() < 5.0 * cube.standard_error);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn chord_information(
    scene: &Scene,
    lines: u32,
    seed: u64,
) -> Result<ChordInformation, ChainError> {
    Ok(LineSample::draw(scene, LineKind::Local, lines, seed)?.chords)
}

/// The passage of a local line, and its chord.
fn met(chord: Option<Chord>, chords: &mut Vec<Chord>) -> Passage {
    chords.extend(chord);
    if chord.is_some() {
        Passage::Chords
    } else {
        Passage::Escape
    }
}

/// The cells and chords that the lines of some chunks met.
#[derive(Debug, Default)]
struct LinesMet {
    cells: HashMap<[usize; 2], u64>,
    bundles: Vec<Vec<[usize; 2]>>,
    chords: Vec<(u32, ChordSums)>,
    /// The number of lines that escaped.
    lost: u32,
    /// The number of lines that were wanted and not found.
    missing: u32,
}

impl LinesMet {
    fn draw(&mut self, chunk: u32, quota: u32, mut line: impl FnMut(&mut Vec<Chord>) -> Passage) {
        let (mut chords, mut sums) = (Vec::new(), ChordSums::default());
        let (mut found, mut drawn) = (0, 0);
        while found < quota && drawn < MOST_DRAWS_PER_LINE * u64::from(quota) {
            drawn += 1;
            chords.clear();
            match line(&mut chords) {
                Passage::Nothing => {}
                Passage::Escape => {
                    found += 1;
                    self.lost += 1;
                }
                Passage::Chords => {
                    found += 1;
                    sums.add(&chords);
                    let cells = chords.iter().map(|chord| {
                        let [i, j] = chord.rows;
                        [i.min(j), i.max(j)]
                    });
                    if chords.len() > 1 {
                        self.bundles.push(cells.clone().collect());
                    }
                    for cell in cells {
                        *self.cells.entry(cell).or_default() += 1;
                    }
                }
            }
        }
        self.missing += quota - found;
        self.chords.push((chunk, sums));
    }

    fn merged(self, other: Self) -> Self {
        let (mut most, least) = if self.cells.len() < other.cells.len() {
            (other, self)
        } else {
            (self, other)
        };
        for (cell, count) in least.cells {
            *most.cells.entry(cell).or_default() += count;
        }
        most.bundles.extend(least.bundles);
        most.chords.extend(least.chords);
        most.lost += least.lost;
        most.missing += least.missing;
        most
    }
}
