//! §4.1: figures 1 to 5.

use super::figure_5::reading;
use crate::claims::{Case, ClaimError, Finding};
use crate::discretize::{BoxGrid, CertifiedGrid, ContactShadow, PatchSplit, UNIT_CUBE};
use crate::geometry::SplitAxis;
use crate::numeric::{Certificate, CertifiedMaximum, Interval, Scalar, larger, real, tolerance};
use crate::scene::Scene;

/// Points of a curve, ends left out.
fn points(count: u32) -> impl Iterator<Item = f64> {
    (1..count).map(move |k| f64::from(k) / f64::from(count))
}

/// Cuts beyond the line leave a totally dark part; `candidate` is the cut said to be best.
pub(crate) fn discontinuity_beats_darker_cuts(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let line = case.number("line")?;
    let shadow = ContactShadow::try_new(line)?;
    let at_candidate = shadow.gain(&case.number("candidate")?)?;
    let mut curve = Vec::new();
    let mut largest: f64 = 0.0;
    for t in points(200) {
        let gain = shadow.gain(&t)?;
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

/// Cuts through the lit part, with a constant point-to-point form factor (`uniform`) or the true
/// one.
pub(crate) fn discontinuity_beats_lit_cuts(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let line = case.number("line")?;
    let shadow = ContactShadow::try_new(line)?;
    let uniform = case.switch("uniform")?;
    let gain = |t: f64| {
        if uniform {
            Ok(shadow.uniform_gain(t))
        } else {
            shadow.gain(&t)
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

pub(crate) fn two_squares(axis: SplitAxis) -> Result<PatchSplit, ClaimError> {
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

/// The proved maximum of the gain of one cut.
fn certified(split: &PatchSplit, case: &Case<'_>) -> Result<CertifiedMaximum, ClaimError> {
    let best = split.certified_best(case.bits())?;
    match &best.certificate {
        Certificate::Unknown { reason } => Err(ClaimError::NotCertified {
            reason: reason.clone(),
        }),
        Certificate::Unique { .. } | Certificate::Several { .. } => Ok(best),
    }
}

/// The proved place of the maximum: of several that are equally high as far as enclosed, any may be
/// it.
fn certified_place(split: &PatchSplit, case: &Case<'_>) -> Result<CertifiedMaximum, ClaimError> {
    let best = certified(split, case)?;
    only_place(&best.certificate)?;
    Ok(best)
}

fn only_place(certificate: &Certificate) -> Result<(), ClaimError> {
    if matches!(certificate, Certificate::Unique { .. }) {
        return Ok(());
    }
    let reason = certificate.to_string();
    Err(ClaimError::NotCertified { reason })
}

pub(crate) fn orthogonal_cut_gains_little(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let scene = Scene::floor_and_wall(case.number("depth")?)?;
    let along = |axis| PatchSplit::try_new(&scene, 0, &[1], axis);
    let orthogonal = along(SplitAxis::V)?;
    let best = certified(&orthogonal, case)?;
    let parallel = certified(&along(SplitAxis::U)?, case)?;
    let note = format!(
        "best orthogonal cut {:.4} from a side edge, gain {:.6} bit; best parallel cut gains \
         {:.5} bit; little: below {} of it",
        best.position.to_f64(),
        best.value.to_f64(),
        parallel.value.to_f64(),
        case.number("small")?
    );
    let ratio = best.value / &parallel.value;
    let small = case.interval("small")?;
    let finding = Finding::decided(ratio < small, ratio > small, ratio);
    Ok(finding.noting(note).with_curve(curve(&orthogonal)?))
}

/// The gain of two equal fluxes is enclosed about 0; that it is 0 is the theorem named in the
/// claim's data.
pub(crate) fn orthogonal_middle_gains_nothing(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let position = case.interval("position")?;
    let gain = two_squares(SplitAxis::V)?
        .rectangles()?
        .lifted(&position)
        .gain(std::slice::from_ref(&position))?;
    let nothing = position.constant(tolerance::VANISHING_GAIN);
    Ok(Finding::decided(gain < nothing, gain > nothing, gain))
}

pub(crate) fn best_parallel_cut(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let scene = Scene::floor_and_wall(case.number("depth")?)?;
    let split = PatchSplit::try_new(&scene, 0, &[1], SplitAxis::U)?;
    let best = certified_place(&split, case)?;
    let note = format!(
        "gain {:.7} bit, {:.7} in the middle",
        best.value.to_f64(),
        split.gain(&[0.5])?
    );
    Ok(Finding::enclosed(best.position).noting(note))
}

/// The stationary points in the open interval, all of them found, with the gain near both ends.
pub(crate) fn curve_has_one_maximum(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let split = match (case.switch("orthogonal")?, case.count("neighbours")?) {
        (true, _) => two_squares(SplitAxis::V)?,
        (false, 1) => two_squares(SplitAxis::U)?,
        (false, neighbours) => corner(neighbours)?,
    };
    let best = certified(&split, case)?;
    let maxima = match best.certificate {
        Certificate::Several { maximisers } => maximisers,
        _ => 1,
    };
    let like = &best.position;
    let rises_and_falls = best.certificate
        == Certificate::Unique {
            is_only_stationary_point: Some(true),
        };
    let near = like.constant(2f64.powi(-20));
    let split_here = split.rectangles()?.lifted(like);
    let level = like.constant(1e-5);
    let starts_low = split_here.gain(std::slice::from_ref(&near))? < level;
    let ends_low = split_here.gain(&[like.constant(1.0) - &near])? < level;
    let count = like.constant(real(maxima));
    let holds = rises_and_falls && starts_low && ends_low;
    // a second stationary point, all of them being simple, is a second turn of the curve
    let fails = match best.certificate {
        Certificate::Unique {
            is_only_stationary_point,
        } => is_only_stationary_point == Some(false),
        Certificate::Several { .. } => true,
        Certificate::Unknown { .. } => false,
    };
    Ok(Finding::decided(holds, fails, count).with_curve(curve(&split)?))
}

pub(crate) fn best_corner_cut(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let best = certified_place(&corner(case.count("neighbours")?)?, case)?;
    let note = format!("gain {:.7} bit", best.value.to_f64());
    Ok(Finding::enclosed(best.position).noting(note))
}

/// Checks that the slope of the orthogonal gain is negative at `fraction` of the two-square
/// optimum: the gain grows towards the edge.
pub(crate) fn orthogonal_slope_explains_the_shift(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let pair = certified_place(&two_squares(SplitAxis::U)?, case)?.position;
    let three = certified_place(&corner(2)?, case)?.position;
    let at = case.interval("fraction")? * &pair;
    let slope = two_squares(SplitAxis::V)?
        .rectangles()?
        .lifted(&at)
        .gain_derivative(std::slice::from_ref(&at), 0)?;
    let note = format!(
        "the cut moves from {:.5} to {:.5}",
        pair.to_f64(),
        three.to_f64()
    );
    let zero = slope.zero();
    let holds = slope < zero && three < pair;
    let fails = slope > zero || three > pair;
    Ok(Finding::decided(holds, fails, slope).noting(note))
}

/// Lines at t and 1 − t of both axes of every face, the only reading of fig. 4 found that fits all
/// it says: one number, "the displacement of a nearest subdivision to a common edge", from 0 to 10,
/// places all lines, so they are mirror images of each other and 10 is where they meet, in the
/// middle: t = x/20. With four lines or more one number would leave some open, with one line none
/// would move. Then the maximum is at 6.05, "near to 6", "a bit displaced towards the edges" from
/// the regular grid at 20/3 = 6.67, and 2 and 8 lie on either side of it. With t = x/10 it would be
/// at 3.03.
fn three_cells<S: Scalar>(t: &S) -> Result<S, ClaimError> {
    let grid = BoxGrid::mirrored(UNIT_CUBE, std::slice::from_ref(t), 3, t)?;
    Ok(grid.mutual_information()?)
}

pub(crate) fn best_three_cell_grid(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let grid = case.best_grid(3)?;
    only_place(&grid.certificate)?;
    let units = case.interval("units_per_edge")?;
    let line = grid.half[0].clone();
    let note = format!(
        "lines at {:.6} and {:.6} of the edge, {:.7} bit; the axis is read as 0 at an edge, 10 in \
         the middle, on which the regular grid stands at {:.2}",
        line.to_f64(),
        1.0 - line.to_f64(),
        grid.mutual_information.to_f64(),
        units.to_f64() / 3.0
    );
    Ok(Finding::enclosed(units * &line).noting(note))
}

pub(crate) fn best_grid_lies_nearer_to_the_edges(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let cells = case.count("cells")?;
    let best = case.best_grid(cells)?;
    only_place(&best.certificate)?;
    let like = &best.mutual_information;
    let gain = like.clone() - &CertifiedGrid::regular(UNIT_CUBE, cells, case.bits())?;
    let regular = like.constant(1.0) / &like.constant(f64::from(cells));
    let displacement = match best.half.first() {
        Some(line) => (regular - line) * &like.constant(20.0),
        None => like.zero(),
    };
    let note = format!("it gains {:.5} bit over the regular grid", gain.to_f64());
    let zero = like.zero();
    let holds = displacement > zero && gain > zero;
    let fails = displacement <= zero || gain < zero;
    Ok(Finding::decided(holds, fails, displacement).noting(note))
}

pub(crate) fn figure_4_cases_lose(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let units = case.interval("axis")?;
    let at = |name| three_cells(&(case.interval(name)? / &units));
    let [lower, best, upper] = [at("lower")?, at("best")?, at("upper")?];
    let curve = (1..100)
        .map(|tenth| f64::from(tenth) / 10.0)
        .map(|x| Ok([x, three_cells(&(x / 20.0))?]))
        .collect::<Result<Vec<_>, ClaimError>>()?;
    let highest = case.best_grid(3)?;
    // "near": as far as the axis is read, to half a unit
    let distance = (units * &highest.half[0] - &case.interval("best")?).abs();
    let is_near = distance < distance.constant(0.5);
    let is_unique = matches!(highest.certificate, Certificate::Unique { .. });
    let note = format!(
        "{:.5} bit at 2, {:.5} near 6, {:.5} at 8",
        lower.to_f64(),
        best.to_f64(),
        upper.to_f64()
    );
    let lost = best - &lower.larger_of(&upper);
    let zero = lost.zero();
    let finding = Finding::decided(lost > zero && is_unique && is_near, lost < zero, lost);
    Ok(finding.noting(note).with_curve(curve))
}

pub(crate) fn best_grid_information(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let grid = case.best_grid(case.count("cells")?)?;
    let lines: Vec<String> = grid
        .half
        .iter()
        .map(|line| format!("{:.4}", line.to_f64()))
        .collect();
    let all = BoxGrid::mirrored(
        UNIT_CUBE,
        &grid.half,
        case.count("cells")?,
        &grid.mutual_information,
    )?;
    let all: Vec<f64> = all.lines().iter().map(Interval::to_f64).collect();
    let note = format!(
        "lines at {} from either end, a strict local maximum, not shown to be the highest of all; \
         the figure states neither cells nor lines; {}",
        lines.join(", "),
        reading(case, &all)?
    );
    Ok(Finding::enclosed(grid.mutual_information).noting(note))
}

/// The best grid against the regular one, and a grid whose lines move as far the other way.
pub(crate) fn best_grid_beats_regular_grid(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let cells = case.count("cells")?;
    let best = case.best_grid(cells)?;
    let regular = CertifiedGrid::regular(UNIT_CUBE, cells, case.bits())?;
    let like = &regular;
    let moved: Vec<Interval> = (1..)
        .zip(&best.half)
        .map(|(k, line)| {
            let twice = like.constant(2.0 * f64::from(k)) / &like.constant(f64::from(cells));
            twice - line
        })
        .collect();
    let other = BoxGrid::mirrored(UNIT_CUBE, &moved, cells, like)?.mutual_information()?;
    let note = format!(
        "lines moved as far the other way: {:.5} bit against {:.5}",
        other.to_f64(),
        regular.to_f64()
    );
    let advantage = best.mutual_information - &regular;
    let zero = advantage.zero();
    let holds = advantage > zero && regular > other;
    let fails = advantage <= zero || regular < other || moved.is_empty();
    Ok(Finding::decided(holds, fails, advantage).noting(note))
}
