//! The lines of discontinuity of a patch, and what the cuts along them gain.

use super::receiver_map::{ReceiverMap, curve, map, share};
use crate::discretize::{
    CutMeasure, DiscontinuityLine, DiscretizeError, Feature, Generator, OccludedPair, PatchSplit,
    View,
};
use crate::exchange::Progress;
use crate::geometry::SplitAxis;
use crate::numeric::try_parallel_map;
use crate::question::QuestionError;
use crate::question::patch_name::PatchName;
use crate::question::scene::SceneSource;
use crate::scene::{Occlusion, Scene};

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
                curves.push(curve(
                    axis,
                    &split,
                    [record.gain, record.square_gain],
                    &lines,
                )?);
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
