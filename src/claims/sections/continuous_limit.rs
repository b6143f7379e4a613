//! §2 and Corollary 1: the continuous mutual information (4), and what discretizing loses against
//! it.

use crate::claims::{Case, ClaimError, Finding};
use crate::discretize::{BoxGrid, UNIT_CUBE};
use crate::exchange::{Congruence, ScenePairs};
use crate::form_factor::DEFAULT_TOLERANCE;
use crate::information::{OpenScene, continuous_information, scene_information};
use crate::numeric::{Interval, integral, larger, largest, smaller, tolerance, x_log2_x};
use crate::scene::{Occlusion, Scene};
use std::f64::consts::PI;

/// Gaps between the mutual information of a scene's refinements, each of patches half as large, and
/// the continuous one, with their error.
struct Gaps {
    gaps: Vec<f64>,
    error: f64,
}

impl Gaps {
    /// Computes the gaps of a scene whose patches are quartered up to `times` times. The control
    /// takes `limit_factor` times the limit.
    fn of(scene: &str, times: u32, case: &Case<'_>) -> Result<Self, ClaimError> {
        let whole = Scene::built_in(scene)?;
        let continuous = continuous_information(&whole)?.mutual_information;
        let limit = case.number("limit_factor")? * continuous.value;
        let mut error = continuous.error;
        let mut gaps = Vec::new();
        for times in 0..=times {
            let (parts, _) = whole.subdivided(times)?;
            let pairs = ScenePairs::try_new(
                &parts,
                DEFAULT_TOLERANCE,
                Congruence::Shared,
                Occlusion::Refuse,
            )?;
            let discrete = scene_information(&pairs, OpenScene::Refuse)?.mutual_information;
            error = larger(error, continuous.error + discrete.error);
            gaps.push(limit - discrete.value);
        }
        Ok(Self { gaps, error })
    }

    fn last(&self) -> f64 {
        self.gaps.last().copied().unwrap_or(f64::NAN)
    }
}

fn cube_and_tetrahedron(case: &Case<'_>) -> Result<[Gaps; 2], ClaimError> {
    Ok([
        Gaps::of("cube:1", case.count("cube_times")?, case)?,
        Gaps::of("tetrahedron", case.count("tetrahedron_times")?, case)?,
    ])
}

/// Every refinement has more mutual information than the one before, and none as much as the limit;
/// the number is the smallest gap.
pub(crate) fn discretizing_loses(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let scenes = cube_and_tetrahedron(case)?;
    let mut holds = true;
    let (mut smallest, mut error) = (f64::INFINITY, 0.0);
    for scene in &scenes {
        holds &= scene
            .gaps
            .windows(2)
            .all(|pair| pair[1] < pair[0] - 2.0 * scene.error);
        holds &= scene.last() > scene.error;
        smallest = smaller(smallest, scene.last());
        error = larger(error, scene.error);
    }
    Ok(Finding::statement(holds, smallest, error))
}

/// Halving the patches reduces the gap to at most `share` of itself, each time; the number is the
/// largest share.
pub(crate) fn continuous_limit_is_approached(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let (mut largest, mut error) = (f64::NEG_INFINITY, 0.0);
    for scene in cube_and_tetrahedron(case)? {
        for pair in scene.gaps.windows(2) {
            largest = larger(largest, pair[1] / pair[0]);
        }
        error = larger(error, 2.0 * scene.error / scene.last().abs());
    }
    let holds = largest <= case.number("share")?;
    Ok(Finding::statement(holds, largest, error))
}

/// No grid of the cube exceeds the limit, and regular ones come arbitrarily near: for a gap
/// proportional to the size of the patches `2 I(h/2) − I(h)` is the limit, and may miss it by
/// `share` of the gap.
pub(crate) fn continuous_is_least_upper_bound(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let continuous = continuous_information(&Scene::built_in("cube:1")?)?.mutual_information;
    let limit = case.number("limit_factor")? * continuous.value;
    let mut smallest = f64::INFINITY;
    let scanned = case.count("scanned")?;
    for step in 1..=scanned {
        // three cells a side, then five, lopsided and not
        let t = 0.5 * f64::from(step) / f64::from(scanned + 1);
        for lines in [vec![t, 1.0 - t], vec![0.3 * t, t, 1.0 - t, 1.0 - 0.3 * t]] {
            smallest = smaller(
                smallest,
                limit
                    - BoxGrid::try_new(UNIT_CUBE, &lines)?
                        .information()?
                        .mutual_information
                        .value,
            );
        }
    }
    let mut regular = Vec::new();
    for doublings in 0..=case.count("cube_times")?.min(6) {
        let gap = limit
            - BoxGrid::regular(UNIT_CUBE, 1 << doublings)?
                .information()?
                .mutual_information
                .value;
        smallest = smaller(smallest, gap);
        regular.push(gap);
    }
    let is_least = match regular.as_slice() {
        [.., before, last] => (2.0 * last - before).abs() <= case.number("share")? * last.abs(),
        _ => false,
    };
    let holds = smallest > continuous.error && is_least;
    Ok(Finding::statement(holds, smallest, continuous.error).sampled())
}

/// `log2 A_T − H` against `∫ F log2(A_T F)` at points of a unit cube's floor, `H = −∫ F log2 F`,
/// both by quadrature over the other faces; integrated over the floor they are H_p − H_s and (4).
/// The control takes `total_factor` times A_T in the first.
pub(crate) fn continuous_information_is_a_difference(
    case: &Case<'_>,
) -> Result<Finding, ClaimError> {
    let total: f64 = 6.0;
    let taken = case.number("total_factor")? * total;
    let mut deviations = Vec::new();
    for [x, y] in [[0.5, 0.5], [0.3, 0.4], [0.2, 0.75]] {
        // the ceiling, and four walls at these distances, each from 0 to 1 across and in height
        let ceiling = |u: f64, v: f64| 1.0 / (1.0 + (u - x).powi(2) + (v - y).powi(2)).powi(2);
        let wall = |distance: f64, along: f64| {
            move |u: f64, z: f64| {
                distance * z / (distance * distance + (u - along).powi(2) + z * z).powi(2)
            }
        };
        let walls = [(x, y), (1.0 - x, y), (y, x), (1.0 - y, x)].map(|(d, a)| wall(d, a));
        let over = |f: &dyn Fn(f64) -> f64| -> Result<f64, ClaimError> {
            let mut sum = double_integral(&|u, v| f(ceiling(u, v) / PI))?;
            for wall in &walls {
                sum += double_integral(&|u, z| f(wall(u, z) / PI))?;
            }
            Ok(sum)
        };
        let information = over(&|kernel| {
            kernel
                * if kernel > 0.0 {
                    (total * kernel).log2()
                } else {
                    0.0
                }
        })?;
        let entropy = -over(&x_log2_x)?;
        deviations.push((information - (taken.log2() - entropy)).abs());
    }
    Ok(Finding::residual(largest(deviations), tolerance::CLOSURE).sampled())
}

/// The integral over the unit square.
fn double_integral(f: &dyn Fn(f64, f64) -> f64) -> Result<f64, ClaimError> {
    let inner = |u: f64| integral(|v| f(u, v), (0.0, 1.0), 1e-14).map_or(f64::NAN, |i| i.value);
    Ok(integral(inner, (0.0, 1.0), 1e-13)?.value)
}

/// Regular grids of the cube from one cell a side up to `most`: each has more mutual information
/// than the one before it, and the continuous one, which no division exceeds, is above them all.
/// The number is that of the steps that rise; with `backwards` they are counted downwards.
pub(crate) fn finer_regular_grids_know_more(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let most = case.count("most")?;
    // one grid more, whose information the continuous one has at least
    let mut levels = (1..=most + 1)
        .map(enclosed_regular_grid)
        .collect::<Result<Vec<_>, _>>()?;
    if case.switch("backwards")? {
        levels.reverse();
    }
    let rise = levels.windows(2).filter(|pair| pair[0] < pair[1]).count();
    let fall = levels.windows(2).filter(|pair| pair[0] > pair[1]).count();
    let count = Interval::precise(f64::from(most), case.bits());
    let note = format!(
        "the continuous one is at least that of {} cells a side",
        most + 1
    );
    let rises = Finding::decided(rise + 1 == levels.len(), fall > 0, count);
    Ok(rises.noting(note))
}

/// The mutual information of the cube's regular grid, between doubles.
pub(crate) fn enclosed_regular_grid(cells: u32) -> Result<Interval<f64>, ClaimError> {
    let grid = BoxGrid::regular_like(UNIT_CUBE, cells, &Interval::point(1.0))?;
    Ok(grid.mutual_information()?)
}
