//! The lines of discontinuity of a patch, and what the cuts along them gain.

use super::QuestionError;
use super::patch_name::PatchName;
use super::scene::SceneSource;
use crate::discretize::{
    CutMeasure, DiscontinuityLine, DiscretizeError, Feature, Generator, OccludedPair, PatchSplit,
    View,
};
use crate::exchange::Progress;
use crate::geometry::SplitAxis;
use crate::numeric::{real, try_parallel_map};
use crate::scene::{Occlusion, Scene};
use glam::DVec3;

/// The question for the lines of discontinuity of a patch that sees another past blockers.
///
/// # Examples
/// ```
/// use infoscene::exchange::Unheard;
/// use infoscene::question::Discontinuities;
/// // two squares and a half-plane between them, at height 0.2: data/scenes/half-plane.vs3
/// let question = Discontinuities {
///     scene: "data/scenes/half-plane.vs3".into(),
///     from: 1.into(),
///     ..Discontinuities::default()
/// };
/// let answer = question.ask(&Unheard)?;
/// let kinds: Vec<&str> = answer.lines.iter().map(|line| line.kind).collect();
/// assert_eq!(kinds, ["umbra", "lit"]);
/// // of the best cut's gain, in whole percents, as an independent program printed it
/// assert_eq!((100.0 * answer.lines[0].kept).round(), 92.0);
/// # Ok::<(), infoscene::question::QuestionError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Discontinuities {
    /// The scene.
    pub scene: SceneSource,
    /// The patch with the lines.
    pub patch: PatchName,
    /// The patch that it sees.
    pub from: PatchName,
    /// Is a map of the form factors from the patch's points wanted, and curves of the gain?
    pub with_map: bool,
}

impl Default for Discontinuities {
    /// The lines of the first patch that sees itself: name another.
    fn default() -> Self {
        Self {
            scene: SceneSource::default(),
            patch: 0.into(),
            from: 0.into(),
            with_map: false,
        }
    }
}

/// The lines of discontinuity of a patch, as a record whose keys are relied on by scripts.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[non_exhaustive]
pub struct DiscontinuitiesAnswer {
    /// The row of the patch with the lines.
    pub patch: usize,
    /// The row that it sees.
    pub from: usize,
    /// Whether two blockers or more may have curves of discontinuity, too, which are not given.
    pub may_have_curves: bool,
    /// The lines, those that gain the most first.
    pub lines: Vec<DiscontinuityRecord>,
    /// The best cuts across each axis.
    pub best: Vec<BestCutRecord>,
    /// The map, if one was asked for.
    #[serde(skip)]
    pub map: Option<ReceiverMap>,
    /// Remarks of the scene's reader, and on what is left out.
    #[serde(skip)]
    pub notes: Vec<String>,
}

/// A line of discontinuity with what the cut along it gains, as a record.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct DiscontinuityRecord {
    /// The kind: `umbra`, `lit`, `sharp` or `penumbra`.
    pub kind: &'static str,
    /// The light seen on either side: `dark`, `partial` or `lit`.
    pub sides: [&'static str; 2],
    /// The ends.
    pub ends: [[f64; 3]; 2],
    /// The edges and corners that make the line.
    pub made_by: Vec<String>,
    /// The gain of the cut of the whole patch along the line, in bits.
    pub gain: f64,
    /// The share that it is of the highest gain of a cut parallel to the line.
    pub kept: f64,
    /// The part of the mean square of the form factor from points that this cut explains.
    pub square_gain: f64,
    /// The share that it is of the highest of a cut parallel to the line.
    pub square_kept: f64,
}

/// The best cuts across an axis, as a record.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct BestCutRecord {
    /// The axis, `"u"` or `"v"`.
    pub axis: &'static str,
    /// The relative position of the cut that gains the most.
    pub position: f64,
    /// The gain of this cut, in bits.
    pub gain: f64,
    /// The relative position of the cut that explains the most of the mean square.
    pub square_position: f64,
    /// The part that this cut explains.
    pub square_gain: f64,
}

/// The form factors from points of a patch, with curves of the gain.
#[derive(Debug, Clone, PartialEq)]
pub struct ReceiverMap {
    /// The corners of the patch in its plane.
    pub outline: Vec<[f64; 2]>,
    /// The ends of each line, in order of the records.
    pub lines: Vec<[[f64; 2]; 2]>,
    /// The lower corner of the map, and the side of a cell.
    pub corner: [f64; 2],
    /// The side of a cell.
    pub cell: f64,
    /// The form factors at the centres of cells, row by row from below; none outside of the patch.
    pub form_factors: Vec<Vec<Option<f64>>>,
    /// The gain as a function of the cut across each axis.
    pub curves: Vec<GainCurve>,
}

/// The gain of cuts across an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct GainCurve {
    /// The axis.
    pub axis: &'static str,
    /// The relative positions of cuts.
    pub positions: Vec<f64>,
    /// The gain of each by mutual information, as a share of the highest.
    pub gains: Vec<f64>,
    /// The part of the mean square that each explains, as a share of the highest.
    pub square_gains: Vec<f64>,
    /// The relative positions of lines parallel to the cuts, with their kinds.
    pub lines: Vec<(f64, &'static str)>,
}

/// Cells of a map along its longer side, and cuts of a curve.
const CELLS: usize = 64;
const CUTS: usize = 120;

/// The sine below which a line is parallel to cuts.
const PARALLEL: f64 = 1e-9;

impl Discontinuities {
    /// Finds the lines and judges them.
    ///
    /// # Errors
    /// The errors of the scene, of [`OccludedPair`] and of [`PatchSplit`].
    pub fn ask(&self, progress: &dyn Progress) -> Result<DiscontinuitiesAnswer, QuestionError> {
        let loaded = self.scene.open()?;
        let scene = loaded.scene;
        let patch = scene.patch_of_row(self.patch.row(&scene)?)?;
        let from = scene.patch_of_row(self.from.row(&scene)?)?;
        let occlusion = self.scene.occlusion;
        let pair = OccludedPair::of(&scene, [patch, from], occlusion)?;
        let lines = pair.lines()?;
        progress.begin(lines.len() as u64, "lines");
        let mut records = try_parallel_map(lines.len(), &|index| {
            let record = judged(&scene, [patch, from], &pair, &lines[index], occlusion);
            progress.advance(1);
            record
        })?;
        let mut order: Vec<usize> = (0..lines.len()).collect();
        order.sort_by(|a, b| {
            let [a, b] = [a, b].map(|index| (records[*index].gain, *index));
            b.0.total_cmp(&a.0).then(a.1.cmp(&b.1))
        });
        let lines: Vec<DiscontinuityLine> = order.iter().map(|k| lines[*k].clone()).collect();
        records = order.iter().map(|k| records[*k].clone()).collect();
        let splits = SplitAxis::ALL
            .map(|axis| PatchSplit::with_occlusion(&scene, patch, &[from], axis, occlusion));
        let mut best = Vec::new();
        let mut curves = Vec::new();
        for (axis, split) in SplitAxis::ALL.into_iter().zip(splits) {
            let split = split?;
            let record = best_cuts(axis, &split)?;
            if self.with_map {
                curves.push(curve(axis, &split, &record, &lines)?);
            }
            best.push(record);
        }
        let map = self
            .with_map
            .then(|| map(&scene, patch, &pair, &lines, curves));
        let mut notes = loaded.notes;
        if pair.may_have_curves() {
            notes.push(CURVES.to_owned());
        }
        Ok(DiscontinuitiesAnswer {
            patch: scene.group_of(patch),
            from: scene.group_of(from),
            may_have_curves: pair.may_have_curves(),
            lines: records,
            best,
            map: map.transpose()?,
            notes,
        })
    }
}

/// The remark on what is left out where several polygons stand between.
const CURVES: &str = "several surfaces stand between: curves along which edges of two of them are \
                      seen in one with a third edge are not among the lines";

/// The record of a line.
fn judged(
    scene: &Scene,
    [patch, from]: [usize; 2],
    pair: &OccludedPair,
    line: &DiscontinuityLine,
    occlusion: Occlusion,
) -> Result<DiscontinuityRecord, DiscretizeError> {
    let [start, end] = line.ends;
    let split = PatchSplit::parallel_to(scene, patch, &[from], end - start, occlusion)?;
    let position = split.position_of(0.5 * (start + end));
    let [gain, square_gain] = split.gains(position)?;
    let [highest, square_highest] = split.highest_gains()?;
    let kept = share(gain, highest.max(gain));
    let square_kept = share(square_gain, square_highest.max(square_gain));
    Ok(DiscontinuityRecord {
        kind: line.kind().name(),
        sides: line.sides.map(view_name),
        ends: line.ends.map(|end| end.to_array()),
        made_by: line
            .generators
            .iter()
            .map(|made| told(pair, made))
            .collect(),
        gain,
        kept,
        square_gain,
        square_kept,
    })
}

const fn view_name(view: View) -> &'static str {
    match view {
        View::Dark => "dark",
        View::Partial => "partial",
        View::Lit => "lit",
    }
}

/// A generator in words.
fn told(pair: &OccludedPair, generator: &Generator) -> String {
    let owner = |blocker: Option<usize>| match blocker {
        None => "the source".to_owned(),
        Some(index) => pair.blocker_name(index).unwrap_or("a blocker").to_owned(),
    };
    let feature = |feature: &Feature| (feature.index, owner(feature.blocker));
    match generator {
        Generator::Sight { vertex, edge } => {
            let ((corner, of), (side, other)) = (feature(vertex), feature(edge));
            format!("corner {corner} of {of} and edge {side} of {other}")
        }
        Generator::Plane { of } => format!("the plane of {}", owner(*of)),
        Generator::Contact { blocker } => format!("the contact of {}", owner(Some(*blocker))),
    }
}

fn best_cuts(axis: SplitAxis, split: &PatchSplit) -> Result<BestCutRecord, DiscretizeError> {
    let [information, square] = CutMeasure::ALL;
    let position = split.best_cut(information)?;
    let square_position = split.best_cut(square)?;
    Ok(BestCutRecord {
        axis: axis.name(),
        position,
        gain: split.gain(&[position])?,
        square_position,
        square_gain: split.gain_by(square, &[square_position])?,
    })
}

/// The gains of cuts across an axis, relative to the best ones.
fn curve(
    axis: SplitAxis,
    split: &PatchSplit,
    best: &BestCutRecord,
    lines: &[DiscontinuityLine],
) -> Result<GainCurve, DiscretizeError> {
    let mut marks: Vec<(f64, &'static str)> = lines
        .iter()
        .filter_map(|line| {
            let ends = line.ends.map(|end| split.position_of(end));
            let is_parallel = (ends[0] - ends[1]).abs() <= PARALLEL;
            is_parallel.then(|| (ends[0], line.kind().name()))
        })
        .collect();
    marks.sort_by(|a, b| a.0.total_cmp(&b.0));
    marks.dedup_by(|a, b| (a.0 - b.0).abs() <= PARALLEL && a.1 == b.1);
    let regular = (1..CUTS).map(|k| real(k) / real(CUTS));
    let mut positions: Vec<f64> = regular.collect();
    positions.extend(marks.iter().map(|(at, _)| *at));
    positions.sort_by(f64::total_cmp);
    let gains = positions.iter().map(|at| split.gains(*at));
    let gains = gains.collect::<Result<Vec<_>, DiscretizeError>>()?;
    let shares =
        |index: usize, highest: f64| gains.iter().map(|g| share(g[index], highest)).collect();
    Ok(GainCurve {
        axis: axis.name(),
        gains: shares(0, best.gain),
        square_gains: shares(1, best.square_gain),
        lines: marks,
        positions,
    })
}

/// The form factors from the centres of square cells over the patch.
fn map(
    scene: &Scene,
    patch: usize,
    pair: &OccludedPair,
    lines: &[DiscontinuityLine],
    curves: Vec<GainCurve>,
) -> Result<ReceiverMap, DiscretizeError> {
    let shape = scene.whole_patch(patch)?.shape();
    let origin = shape.corners()[0];
    let across = (shape.corners()[1] - origin).normalize();
    let up = shape.normal().cross(across);
    let flat = |point: DVec3| [(point - origin).dot(across), (point - origin).dot(up)];
    let outline: Vec<[f64; 2]> = shape.corners().iter().map(|c| flat(*c)).collect();
    let extent = |k: usize| {
        let places = || outline.iter().map(|corner| corner[k]);
        [
            places().fold(f64::INFINITY, f64::min),
            places().fold(f64::NEG_INFINITY, f64::max),
        ]
    };
    let [x, y] = [extent(0), extent(1)];
    let cell = (x[1] - x[0]).max(y[1] - y[0]) / real(CELLS);
    let centres = |[from, to]: [f64; 2]| {
        let places = (0..CELLS).map(move |k| from + (real(k) + 0.5) * cell);
        places
            .take_while(move |place| *place < to)
            .collect::<Vec<f64>>()
    };
    let (columns, rows) = (centres(x), centres(y));
    let form_factors = try_parallel_map(rows.len(), &|row| {
        let value = |column: &f64| {
            let point = origin + *column * across + rows[row] * up;
            let is_inside = pair.is_on_receiver(point);
            is_inside
                .then(|| Ok(pair.seen_from(point)?.value))
                .transpose()
        };
        columns
            .iter()
            .map(value)
            .collect::<Result<Vec<_>, DiscretizeError>>()
    })?;
    Ok(ReceiverMap {
        lines: lines.iter().map(|line| line.ends.map(flat)).collect(),
        corner: [x[0], y[0]],
        cell,
        form_factors,
        curves,
        outline,
    })
}

/// The share of a gain in the highest one; where nothing is gained it is none.
fn share(gain: f64, highest: f64) -> f64 {
    if highest > 0.0 { gain / highest } else { 0.0 }
}
