//! The form factors of a scene: all, those of a row or a column, or one; and the whole matrix.
//!
//! **Memory** All pairs are held up to [`FormFactors::MOST_HELD`] rows; beyond that one row at a
//! time.

use super::matrix::{FormFactorMatrix, areas};
use crate::exchange::{
    Closure, Congruence, Entry, ExchangeAreas, ExchangeError, PlanSummary, Progress, RowSum,
    ScenePairs, Selection, Tolerance,
};
use crate::form_factor::Answer;
use crate::question::scene::{SceneSource, ignored_note};
use crate::question::unreached::Unreached;
use crate::question::{PatchName, QuestionError};
use crate::scene::Scene;
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};
use std::rc::Rc;

/// The question for the form factors of a scene.
///
/// # Examples
/// ```
/// use infoscene::exchange::Unheard;
/// use infoscene::question::FormFactors;
/// let squares = FormFactors {
///     scene: "two-squares".into(),
///     from: Some("floor".into()),
///     to: Some("wall".into()),
///     ..FormFactors::default()
/// };
/// // Howell, C-14: unit squares with a common edge
/// let answer = squares.ask(&Unheard)?;
/// let one = answer.records().next().map_or(f64::NAN, |record| record.value);
/// assert!((one - 0.200_043_776_075_4).abs() < 1e-13);
/// # Ok::<(), infoscene::question::QuestionError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct FormFactors {
    /// The scene.
    pub scene: SceneSource,
    /// The error that is accepted of every form factor.
    pub tolerance: Tolerance,
    /// The treatment of congruent pairs.
    pub congruence: Congruence,
    /// The rows that send; all if there is no name.
    pub from: Option<PatchName>,
    /// The rows that receive; all if there is no name.
    pub to: Option<PatchName>,
    /// Whether the whole matrix is asked for, too.
    pub matrix: bool,
}

impl Default for FormFactors {
    /// All pairs, to the default tolerance.
    fn default() -> Self {
        Self {
            scene: SceneSource::default(),
            tolerance: Tolerance::default(),
            congruence: Congruence::Shared,
            from: None,
            to: None,
            matrix: false,
        }
    }
}

/// A form factor as a record: the keys are relied on by scripts.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FormFactorRecord {
    /// The patch that sends.
    pub from: usize,
    /// The patch that receives.
    pub to: usize,
    /// `F`, from 0 to 1.
    pub value: f64,
    /// A bound on its absolute error, for the coordinates as they are.
    pub error: f64,
    /// A bound on what the resolution of the coordinates can change beside it.
    pub resolution_error: f64,
    /// The name of the route by which it was found.
    pub route: &'static str,
}

impl FormFactorRecord {
    /// The form factor from a patch of this area, with the bound on its rounding and the
    /// quotient's.
    ///
    /// **Arguments** `changes`: the bounds on what the resolution can change of the exchange area
    /// and of the area.
    fn new(
        [from, to]: [usize; 2],
        area: [f64; 2],
        answer: &Answer,
        [of_exchange, of_area]: [f64; 2],
    ) -> Self {
        let [value, error] = answer.quotient(area);
        let change = (of_exchange + value * of_area) / (area[0] - of_area).max(0.0);
        let most = value.max(1.0 - value);
        Self {
            from,
            to,
            value,
            error,
            // 0/0 is of an area that says nothing
            resolution_error: if of_exchange + of_area > 0.0 {
                if change < most { change } else { most }
            } else {
                0.0
            },
            route: answer.route.name(),
        }
    }
}

/// A patch, or several that are summed, as a record.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PatchRecord {
    /// The number of the row, from 0.
    pub index: usize,
    /// The name of the patch, or of the first.
    pub name: String,
    /// The area, less that of the parts in it.
    pub area: f64,
    /// The sum of its form factors, if all of them were computed.
    pub row_sum: Option<f64>,
    /// A bound on the error of the sum.
    pub row_sum_error: Option<f64>,
}

/// The form factors of a scene. The records are made as they are read: there may be very many.
#[derive(Debug)]
#[non_exhaustive]
pub struct FormFactorsAnswer<'p> {
    /// The rows.
    pub patches: Vec<PatchRecord>,
    /// The length by which each coordinate may be off.
    pub resolution: f64,
    /// The pairs that were left out, shared and computed.
    pub plan: PlanSummary,
    /// The pairs that miss the tolerance, if some do; those of the matrix's pass come with it.
    pub unreached: Option<Unreached>,
    /// Remarks of the scene's reader.
    pub notes: Vec<String>,
    pairs: ScenePairs<'p>,
    /// All pairs, if they are held.
    held: Option<ExchangeAreas>,
    scene: Scene,
    /// The pairs of a row or a column, if only these are asked for.
    part: Option<Vec<Entry>>,
    has_matrix: bool,
}

impl FormFactors {
    /// The number of rows up to which all pairs are held: 2.3 GB.
    pub const MOST_HELD: usize = 16_384;

    /// The number of rows up to which a pair has the same value in every listing. In larger scenes
    /// some pairs cost no plan of all: each is computed on its own, and may differ from that of the
    /// whole listing by what their bounds allow.
    pub const MOST_SHARED: usize = 2048;

    /// Computes the form factors.
    ///
    /// # Errors
    /// [`QuestionError::TooManyPairs`] if all pairs are asked for of more than
    /// [`MOST_HELD`](Self::MOST_HELD) rows; the errors of the scene and of its pairs.
    pub fn ask<'p>(
        &self,
        progress: &'p dyn Progress,
    ) -> Result<FormFactorsAnswer<'p>, QuestionError> {
        let loaded = self.scene.open()?;
        let scene = loaded.scene;
        let rows = scene.group_count();
        let selection = self.selection(&scene)?;
        let is_part = !selection.is_all();
        if !is_part && rows > Self::MOST_HELD {
            return Err(QuestionError::TooManyPairs {
                patches: rows,
                largest: Self::MOST_HELD,
            });
        }
        let pairs = self.pairs(&scene, &selection, progress)?;
        let held = if rows <= Self::MOST_HELD && (!is_part || self.matrix) {
            Some(pairs.exchange_areas()?)
        } else {
            None
        };
        let part = if is_part {
            Some(pairs.entries(&selection)?)
        } else {
            None
        };
        let names = scene.group_names();
        // the pass over more pairs has seen the worst of them
        let passes = [
            held.as_ref().map(ExchangeAreas::summary),
            part.as_ref().map(|(_, summary)| summary),
        ];
        let widest = passes.into_iter().flatten();
        let widest = widest.max_by_key(|summary| summary.plan.pairs);
        let unreached =
            widest.and_then(|summary| Unreached::pairs(&names, summary, pairs.tolerance()));
        let listed = passes.into_iter().flatten().next_back();
        let plan = listed
            .map(|summary| summary.plan.clone())
            .unwrap_or_default();
        let mut notes = loaded.notes;
        notes.extend(ignored_note(plan.ignored));
        let sums = match (&held, &part) {
            (Some(held), _) => Closure::of_held(held).rows().to_vec(),
            (None, Some((entries, _))) => pairs.complete_sums(&selection, entries),
            (None, None) => Vec::new(),
        };
        let patches = patch_records(&names, pairs.areas(), &sums);
        Ok(FormFactorsAnswer {
            patches,
            resolution: scene.resolution(),
            plan,
            unreached,
            notes,
            held,
            part: part.map(|(entries, _)| entries),
            scene,
            has_matrix: self.matrix,
            pairs,
        })
    }

    /// The pairs that are asked for.
    fn selection(&self, scene: &Scene) -> Result<Selection, QuestionError> {
        let rows = |name: &Option<PatchName>| match name {
            Some(name) => name.rows(scene).map(Some),
            None => Ok(None),
        };
        Ok(Selection {
            from: rows(&self.from)?,
            to: rows(&self.to)?,
        })
    }

    /// The pairs of the scene; what does not concern a part of them matters only to the matrix.
    fn pairs<'p>(
        &self,
        scene: &Scene,
        selection: &Selection,
        progress: &'p dyn Progress,
    ) -> Result<ScenePairs<'p>, ExchangeError> {
        if selection.is_all() || self.matrix {
            let asked = (self.tolerance, self.congruence);
            return self.scene.pairs(scene, asked, progress);
        }
        let congruence = if scene.group_count() <= Self::MOST_SHARED {
            self.congruence
        } else {
            Congruence::Ignored
        };
        let (tolerance, occlusion) = (self.tolerance, self.scene.occlusion);
        let pairs = ScenePairs::of_selection(scene, tolerance, congruence, occlusion, selection)?;
        progress.begin(selection.pairs(pairs.rows()).count() as u64, "pairs");
        Ok(pairs.with_progress(progress))
    }
}

impl FormFactorsAnswer<'_> {
    /// The form factors that were asked for, each made as it is read.
    pub fn records(&self) -> impl Iterator<Item = FormFactorRecord> + '_ {
        let areas = areas(&self.pairs);
        let part = self.part.iter().flatten();
        let moved = self.pairs.area_resolution_errors();
        let part = part.map({
            let (areas, moved) = (areas.clone(), moved.clone());
            move |Entry { from, to, answer }| {
                let change = self.pairs.resolution_error(*from, *to);
                let changes = [change, moved[*from]];
                FormFactorRecord::new([*from, *to], areas[*from], answer, changes)
            }
        });
        let all = 0..self.patches.len();
        let held = self.held.iter().filter(|_| self.part.is_none());
        let held = held.flat_map(move |held| {
            let (areas, others, moved) = (areas.clone(), all.clone(), moved.clone());
            let record = move |from: usize, to: usize| {
                let change = held.resolution_error(from, to);
                let changes = [change, moved[from]];
                FormFactorRecord::new([from, to], areas[from], &held.get(from, to), changes)
            };
            let record = Rc::new(record);
            all.clone().flat_map(move |from| {
                let record = Rc::clone(&record);
                others
                    .clone()
                    .filter(move |to| *to != from || held.sees_itself(from))
                    .map(move |to| record(from, to))
            })
        });
        part.chain(held)
    }

    /// The whole matrix, if it was asked for.
    #[must_use]
    pub fn matrix(&self) -> Option<FormFactorMatrix<'_>> {
        self.has_matrix.then_some(FormFactorMatrix {
            scene: &self.scene,
            pairs: &self.pairs,
            held: self.held.as_ref(),
            unreached: self.unreached.as_ref(),
        })
    }
}

impl Serialize for FormFactorsAnswer<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        struct Records<'a>(&'a FormFactorsAnswer<'a>);
        impl Serialize for Records<'_> {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.collect_seq(self.0.records())
            }
        }
        let mut record = serializer.serialize_struct("FormFactorsAnswer", 4)?;
        record.serialize_field("patches", &self.patches)?;
        record.serialize_field("form_factors", &Records(self))?;
        record.serialize_field("resolution", &self.resolution)?;
        record.serialize_field("plan", &self.plan)?;
        record.end()
    }
}

/// The records of all patches, with the sums of the rows that are known.
fn patch_records(names: &[&str], areas: &[f64], sums: &[RowSum]) -> Vec<PatchRecord> {
    let mut sum_of = vec![None; names.len()];
    for sum in sums {
        sum_of[sum.row] = Some(sum);
    }
    let patches = names.iter().zip(areas).enumerate();
    let patches = patches.map(|(index, (name, area))| PatchRecord {
        index,
        name: (*name).to_owned(),
        area: *area,
        row_sum: sum_of[index].map(|sum| sum.sum),
        row_sum_error: sum_of[index].map(|sum| sum.error),
    });
    patches.collect()
}
