//! §4.1: figures 1 to 5.

use super::extremes::larger;
use super::finding::Computation;
use super::{ClaimError, Finding, Inputs};
use crate::discretize::{ContactShadow, CubeGrid, PatchSplit};
use crate::geometry::SplitAxis;
use crate::numeric::{maximum, tolerance};
use crate::scene::Scene;

pub(super) const COMPUTATIONS: &[(&str, Computation)] = &[
    (
        "discontinuity_beats_darker_cuts",
        discontinuity_beats_darker_cuts,
    ),
    ("discontinuity_beats_lit_cuts", discontinuity_beats_lit_cuts),
    ("orthogonal_cut_gains_little", orthogonal_cut_gains_little),
    (
        "orthogonal_middle_gains_nothing",
        orthogonal_middle_gains_nothing,
    ),
    ("best_parallel_cut", best_parallel_cut),
    ("curve_has_one_maximum", curve_has_one_maximum),
    ("best_corner_cut", best_corner_cut),
    (
        "orthogonal_slope_explains_the_shift",
        orthogonal_slope_explains_the_shift,
    ),
    ("best_three_cell_grid", best_three_cell_grid),
    (
        "best_grid_lies_nearer_to_the_edges",
        best_grid_lies_nearer_to_the_edges,
    ),
    ("figure_4_cases_lose", figure_4_cases_lose),
    ("best_grid_information", best_grid_information),
    ("regular_grid_information", regular_grid_information),
    ("best_grid_beats_regular_grid", best_grid_beats_regular_grid),
];

/// Points of a curve, ends left out.
fn points(count: u32) -> impl Iterator<Item = f64> {
    (1..count).map(move |k| f64::from(k) / f64::from(count))
}

/// Cuts beyond the line leave a totally dark part; `candidate` is the cut said to be best.
fn discontinuity_beats_darker_cuts(input: &Inputs) -> Result<Finding, ClaimError> {
    let line = input.number("line")?;
    let shadow = ContactShadow::try_new(line)?;
    let at_candidate = shadow.gain(input.number("candidate")?)?;
    let mut curve = Vec::new();
    let mut largest: f64 = 0.0;
    for t in points(200) {
        let gain = shadow.gain(t)?;
        curve.push([t, gain]);
        if t > line {
            largest = larger(largest, gain / at_candidate);
        }
    }
    let holds = largest < 1.0;
    Ok(Finding::statement(holds, largest, tolerance::GAIN)
        .sampled()
        .with_curve(curve))
}

/// Cuts through the lit part, with a constant point-to-point form factor (`uniform`) or the true one.
fn discontinuity_beats_lit_cuts(input: &Inputs) -> Result<Finding, ClaimError> {
    let line = input.number("line")?;
    let shadow = ContactShadow::try_new(line)?;
    let uniform = input.switch("uniform")?;
    let gain = |t: f64| {
        if uniform {
            Ok(shadow.uniform_gain(t))
        } else {
            shadow.gain(t)
        }
    };
    let at_line = gain(line)?;
    let mut curve = Vec::new();
    let mut largest: f64 = 0.0;
    for t in points(200) {
        let gain = gain(t)?;
        curve.push([t, gain]);
        if t < line {
            largest = larger(largest, gain / at_line);
        }
    }
    let holds = largest < 1.0;
    Ok(Finding::statement(holds, largest, tolerance::GAIN)
        .sampled()
        .with_curve(curve))
}

pub(super) fn two_squares(axis: SplitAxis) -> Result<PatchSplit, ClaimError> {
    Ok(PatchSplit::try_new(
        &Scene::built_in("two-squares")?,
        0,
        &[1],
        axis,
    )?)
}

fn corner(neighbours: u32) -> Result<PatchSplit, ClaimError> {
    let against: Vec<usize> = (1..=neighbours as usize).collect();
    Ok(PatchSplit::try_new(
        &Scene::built_in("three-squares")?,
        0,
        &against,
        SplitAxis::U,
    )?)
}

fn curve(split: &PatchSplit) -> Result<Vec<[f64; 2]>, ClaimError> {
    points(100).map(|t| Ok([t, split.gain(&[t])?])).collect()
}

fn orthogonal_cut_gains_little(input: &Inputs) -> Result<Finding, ClaimError> {
    let scene = Scene::floor_and_wall(input.number("depth")?)?;
    let orthogonal = PatchSplit::try_new(&scene, 0, &[1], SplitAxis::V)?;
    let best = orthogonal.best(2)?;
    let parallel = PatchSplit::try_new(&scene, 0, &[1], SplitAxis::U)?.best(2)?;
    let ratio = best.gain / parallel.gain;
    let note = format!(
        "best orthogonal cut {:.4} from a side edge, gain {:.6} bit; best parallel cut gains {:.5} bit; \
         little: below {} of it",
        best.positions[0],
        best.gain,
        parallel.gain,
        input.number("small")?
    );
    let finding = Finding::statement(ratio < input.number("small")?, ratio, tolerance::GAIN);
    Ok(finding.noting(note).with_curve(curve(&orthogonal)?))
}

fn orthogonal_middle_gains_nothing(input: &Inputs) -> Result<Finding, ClaimError> {
    let gain = two_squares(SplitAxis::V)?.gain(&[input.number("position")?])?;
    Ok(Finding::residual(gain, tolerance::VANISHING_GAIN))
}

fn best_parallel_cut(input: &Inputs) -> Result<Finding, ClaimError> {
    let scene = Scene::floor_and_wall(input.number("depth")?)?;
    let split = PatchSplit::try_new(&scene, 0, &[1], SplitAxis::U)?;
    let best = split.best(2)?;
    let note = format!(
        "gain {:.7} bit, {:.7} in the middle",
        best.gain,
        split.gain(&[0.5])?
    );
    Ok(Finding::value(best.positions[0], tolerance::POSITION).noting(note))
}

/// Sign changes of the derivative, with the gain near both ends.
fn curve_has_one_maximum(input: &Inputs) -> Result<Finding, ClaimError> {
    let split = match (input.switch("orthogonal")?, input.count("neighbours")?) {
        (true, _) => two_squares(SplitAxis::V)?,
        (false, 1) => two_squares(SplitAxis::U)?,
        (false, neighbours) => corner(neighbours)?,
    };
    let mut maxima = 0;
    let mut rising = true;
    for t in points(400) {
        let rises = split.gain_derivative(&[t], 0)? > 0.0;
        maxima += u32::from(rising && !rises);
        rising = rises;
    }
    let (near, far) = (split.gain(&[1e-6])?, split.gain(&[1.0 - 1e-6])?);
    let holds = maxima == 1 && near.max(far) < 1e-5;
    let finding = Finding::statement(holds, f64::from(maxima), 0.0).sampled();
    Ok(finding.with_curve(curve(&split)?))
}

fn best_corner_cut(input: &Inputs) -> Result<Finding, ClaimError> {
    let best = corner(input.count("neighbours")?)?.best(2)?;
    let note = format!("gain {:.7} bit", best.gain);
    Ok(Finding::value(best.positions[0], tolerance::POSITION).noting(note))
}

/// At `fraction` of the two-square optimum the slope of the orthogonal gain must be negative: it grows
/// towards the edge.
fn orthogonal_slope_explains_the_shift(input: &Inputs) -> Result<Finding, ClaimError> {
    let pair = two_squares(SplitAxis::U)?.best(2)?.positions[0];
    let three = corner(2)?.best(2)?.positions[0];
    let at = input.number("fraction")? * pair;
    let slope = two_squares(SplitAxis::V)?.gain_derivative(&[at], 0)?;
    let note = format!("the cut moves from {pair:.5} to {three:.5}");
    Ok(Finding::statement(slope < 0.0 && three < pair, slope, tolerance::GAIN).noting(note))
}

/// Lines at t and 1 − t.
fn three_cells(t: f64) -> Result<CubeGrid, ClaimError> {
    Ok(CubeGrid::try_new(&[t, 1.0 - t])?)
}

fn best_three_cell_line() -> Result<f64, ClaimError> {
    let information = |t: f64| {
        three_cells(t)
            .and_then(|grid| Ok(grid.mutual_information()?))
            .unwrap_or(f64::NAN)
    };
    let slope = |t: f64| {
        three_cells(t)
            .and_then(|grid| Ok(grid.gradient()?[0]))
            .unwrap_or(f64::NAN)
    };
    // cells narrower than a twentieth of an edge are none of the figure's
    Ok(maximum(information, slope, (0.05, 0.45), 16)?.position)
}

fn best_three_cell_grid(input: &Inputs) -> Result<Finding, ClaimError> {
    let units = input.number("units_per_edge")?;
    let line = best_three_cell_line()?;
    let grid = three_cells(line)?;
    let note = format!(
        "lines at {line:.6} and {:.6} of the edge, {:.7} bit; the axis is read as 0 at an edge, 10 in \
         the middle, on which the regular grid stands at {:.2}",
        1.0 - line,
        grid.mutual_information()?,
        units / 3.0
    );
    Ok(Finding::value(units * line, units * tolerance::POSITION).noting(note))
}

fn best_grid_lies_nearer_to_the_edges(input: &Inputs) -> Result<Finding, ClaimError> {
    let cells = input.count("cells")?;
    let (best, regular) = (CubeGrid::best(cells)?, CubeGrid::regular(cells)?);
    let displacement = regular
        .lines()
        .first()
        .zip(best.lines().first())
        .map_or(0.0, |(a, b)| a - b);
    let gain = best.mutual_information()? - regular.mutual_information()?;
    let note = format!("it gains {gain:.5} bit over the regular grid");
    let holds = displacement > tolerance::POSITION && gain > tolerance::GRID_INFORMATION;
    Ok(Finding::statement(holds, 20.0 * displacement, 20.0 * tolerance::POSITION).noting(note))
}

fn figure_4_cases_lose(input: &Inputs) -> Result<Finding, ClaimError> {
    let at =
        |x: f64| -> Result<f64, ClaimError> { Ok(three_cells(x / 20.0)?.mutual_information()?) };
    let [lower, best, upper] = [
        at(input.number("lower")?)?,
        at(input.number("best")?)?,
        at(input.number("upper")?)?,
    ];
    let curve = (1..100)
        .map(|tenth| f64::from(tenth) / 10.0)
        .map(|x| Ok([x, at(x)?]))
        .collect::<Result<Vec<_>, ClaimError>>()?;
    let turns = curve
        .windows(3)
        .filter(|w| w[1][1] > w[0][1] && w[1][1] >= w[2][1])
        .count();
    let lost = best - lower.max(upper);
    let note = format!("{lower:.5} bit at 2, {best:.5} near 6, {upper:.5} at 8");
    let finding = Finding::statement(lost > 0.0 && turns == 1, lost, tolerance::GRID_INFORMATION);
    Ok(finding.noting(note).with_curve(curve))
}

fn best_grid_information(input: &Inputs) -> Result<Finding, ClaimError> {
    let grid = CubeGrid::best(input.count("cells")?)?;
    let lines: Vec<String> = grid
        .lines()
        .into_iter()
        .filter(|line| *line < 0.5)
        .map(|line| format!("{line:.4}"))
        .collect();
    let note = format!(
        "lines at {} from either end; the figure states neither cells nor lines, and the difference to \
         the regular grid agrees better than the level",
        lines.join(", ")
    );
    let information = grid.mutual_information()?;
    Ok(Finding::value(information, tolerance::GRID_INFORMATION * information).noting(note))
}

fn regular_grid_information(input: &Inputs) -> Result<Finding, ClaimError> {
    let at = |cells: u32| -> Result<f64, ClaimError> {
        Ok(CubeGrid::regular(cells)?.mutual_information()?)
    };
    let information = at(input.count("cells")?)?;
    let levels = (1..=12).map(at).collect::<Result<Vec<f64>, _>>()?;
    let interval = input.number("printed_from")?..=input.number("printed_to")?;
    let found = levels
        .iter()
        .filter(|level| interval.contains(*level))
        .count();
    let note = format!(
        "of the regular grids with up to 12 cells a side {found} have the printed value: 7 cells give {:.4}, 8 \
         give {:.4}; the printed numbers look like sampled estimates, whose bias is positive",
        levels[6], levels[7]
    );
    Ok(Finding::value(information, tolerance::GRID_INFORMATION * information).noting(note))
}

/// The best grid against the regular one, and a grid whose lines move the other way.
fn best_grid_beats_regular_grid(input: &Inputs) -> Result<Finding, ClaimError> {
    let cells = input.count("cells")?;
    let (best, regular) = (CubeGrid::best(cells)?, CubeGrid::regular(cells)?);
    let moved: Vec<f64> = regular
        .lines()
        .iter()
        .zip(best.lines())
        .map(|(line, best)| 2.0 * line - best)
        .collect();
    let levels = [best.mutual_information()?, regular.mutual_information()?];
    let mirrored = CubeGrid::try_new(&moved)?.mutual_information()?;
    let advantage = levels[0] - levels[1];
    let holds = advantage > tolerance::IDENTITY && levels[1] > mirrored;
    let note = format!(
        "lines moved as far the other way: {mirrored:.5} bit against {:.5}",
        levels[1]
    );
    Ok(Finding::statement(holds, advantage, 2.0 * tolerance::GRID_INFORMATION).noting(note))
}
