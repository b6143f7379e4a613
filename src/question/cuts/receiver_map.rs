//! The map of what a patch receives, and the gains of cuts across its axes.

use crate::discretize::{DiscontinuityLine, DiscretizeError, OccludedPair, PatchSplit};
use crate::geometry::SplitAxis;
use crate::numeric::{real, try_parallel_map};
use crate::scene::Scene;
use glam::DVec3;

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

/// The gains of cuts across an axis, relative to the best ones.
pub(super) fn curve(
    axis: SplitAxis,
    split: &PatchSplit,
    [best, square_best]: [f64; 2],
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
        gains: shares(0, best),
        square_gains: shares(1, square_best),
        lines: marks,
        positions,
    })
}

/// The form factors from the centres of square cells over the patch.
pub(super) fn map(
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
pub(super) fn share(gain: f64, highest: f64) -> f64 {
    if highest > 0.0 { gain / highest } else { 0.0 }
}
