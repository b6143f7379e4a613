//! The best symmetric grid on the inside of a box, and the evidence for it.
//!
//! Newton's method climbs from several starts: the regular grid, grids graded towards the edges or
//! the middle, `t = ½ (2k/n)^p`, and random ones. Where it converges the Hessian is negative
//! definite: a local maximum, with an *estimate* of the error of its lines, `|H⁻¹|` times the
//! remaining gradient and its rounding. That no other maximum is higher is not proved: only the
//! maxima that the starts reach are compared.
//!
//! **Not covered**: lines that are not symmetric; edges that are divided differently.

use super::{BoxGrid, GridInformation, checked};
use crate::discretize::division::regular_positions;
use crate::discretize::error::DiscretizeError;
use crate::numeric::{Bounded, maximum_by_derivatives, parallel_map};
use nalgebra::{DMatrix, DVector};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The best grid found.
#[derive(Debug, Clone, PartialEq)]
pub struct BestGrid {
    /// The grid.
    pub grid: BoxGrid,
    /// The mutual information of the grid.
    pub information: GridInformation,
    /// The largest remaining derivative, in bits.
    pub slope: f64,
    /// The largest eigenvalue of the Hessian, in bits, with an error estimated from differences of
    /// gradients along its eigenvector; `None` if no line is free.
    pub curvature: Option<Bounded>,
    /// The error of the lines, relative to the edges: an estimate.
    pub line_error: f64,
    /// The starts of the search and their ends.
    pub search: Search,
}

/// The starts of a search for the best grid, and where they ended.
#[derive(Debug, Clone, PartialEq)]
pub struct Search {
    /// The number of starts, 1 of them regular.
    pub starts: usize,
    /// The number of starts that ended at the best maximum.
    pub reached: usize,
    /// The number of starts that did not converge.
    pub lost: usize,
    /// Mutual information of the other maxima found, the highest first.
    pub others: Vec<f64>,
}

/// Exponents of graded starts: below 1 lines lie nearer to the middle, above it nearer to the
/// edges. A choice of starts: it decides which maxima are found, not where they lie.
const GRADINGS: [f64; 6] = [0.5, 0.75, 1.25, 1.5, 2.0, 3.0];

/// Seed of the random starts, a choice as [`GRADINGS`] is.
const SEED: u64 = 1999;

/// Maxima whose lines all agree to this are one: (a) climbing leaves an error of the lines of
/// [`CLIMBING`] over the curvature, far below this, and different maxima are a cell's width apart.
const SAME_MAXIMUM: f64 = 1e-6;

/// Errors of exchange areas while climbing: (a) they move the lines by that over the curvature,
/// which the last step from [`REFINING`] takes back.
const CLIMBING: f64 = 1e-11;

/// Errors of exchange areas at the top: (b) held by `best_grids_agree_with_20_digits`.
const REFINING: f64 = 1e-13;

/// The step of differences of gradients, relative to the least gap between lines: (a) the
/// truncation is the square of it, 1e-8 of the curvature, and the rounding [`CLIMBING`] over it,
/// 1e-7.
const DIFFERENCE_STEP: f64 = 1e-4;

impl BestGrid {
    /// The best grid of `cells` cells an edge.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] as [`BoxGrid::regular`]; [`DiscretizeError::Numeric`] if no
    /// start converges.
    ///
    /// # Examples
    /// ```
    /// use infoscene::discretize::{BestGrid, UNIT_CUBE};
    /// let best = BestGrid::find(UNIT_CUBE, 3)?;
    /// // from a 50-digit evaluation
    /// assert!((best.grid.lines()[0] - 0.302_574_117_550_565_57).abs() < 1e-14);
    /// assert_eq!(best.search.reached, best.search.starts);
    /// # Ok::<(), infoscene::discretize::DiscretizeError>(())
    /// ```
    pub fn find(edges: [f64; 3], cells: u32) -> Result<Self, DiscretizeError> {
        let regular = BoxGrid::regular(edges, cells)?;
        let starts = starts(checked(cells)?);
        if starts.is_empty() {
            return Self::without_free_lines(regular);
        }
        let grid_of = |half: &[f64]| BoxGrid::mirrored(edges, half, cells, &1.0);
        let (highest, search) = highest_maximum(&grid_of, &starts)?;
        Self::refined(&grid_of, &highest, search)
    }

    /// The grid of which no line is free: one or two cells an edge.
    fn without_free_lines(grid: BoxGrid) -> Result<Self, DiscretizeError> {
        Ok(Self {
            information: grid.information()?,
            grid,
            slope: 0.0,
            curvature: None,
            line_error: 0.0,
            search: Search {
                starts: 1,
                reached: 1,
                lost: 0,
                others: Vec::new(),
            },
        })
    }

    /// The maximum next to a grid, by one more Newton step with exchange areas of full accuracy.
    fn refined(
        grid_of: &impl Fn(&[f64]) -> Result<BoxGrid, DiscretizeError>,
        near: &BoxGrid,
        search: Search,
    ) -> Result<Self, DiscretizeError> {
        let derivatives = near.derivatives(REFINING)?;
        let step = derivatives.hessian.lu().solve(&derivatives.gradient);
        let step = step.ok_or(DiscretizeError::NoMaximum)?;
        let moved = half_of(near).into_iter().zip(&step).map(|(t, by)| t - by);
        let half: Vec<f64> = moved.collect();
        let grid = grid_of(&half)?;
        let information = grid.information()?;
        let derivatives = grid.derivatives(REFINING)?;
        let spectrum = (-derivatives.hessian).symmetric_eigen();
        let left = derivatives.gradient.abs() + &derivatives.gradient_error;
        let inverse = &spectrum.eigenvectors
            * DMatrix::from_diagonal(&spectrum.eigenvalues.map(|curvature| 1.0 / curvature))
            * spectrum.eigenvectors.transpose();
        let (flattest, curvature) = spectrum.eigenvalues.argmin();
        let along = spectrum.eigenvectors.column(flattest).into_owned();
        let differences = difference(grid_of, &half, &along)?;
        Ok(Self {
            grid,
            information,
            slope: derivatives.gradient.amax(),
            curvature: Some(Bounded::estimate(
                -curvature,
                (differences + curvature).abs(),
            )),
            line_error: (inverse.abs() * left).amax() + f64::EPSILON,
            search,
        })
    }
}

/// The highest of the maxima that climbing from the starts reaches, and the ends of the starts.
fn highest_maximum(
    grid_of: &(impl Fn(&[f64]) -> Result<BoxGrid, DiscretizeError> + Sync),
    starts: &[Vec<f64>],
) -> Result<(BoxGrid, Search), DiscretizeError> {
    let ends = parallel_map(starts.len(), &|start| climb(grid_of, &starts[start]));
    let mut maxima: Vec<(BoxGrid, GridInformation, usize)> = Vec::new();
    let mut refusal = None;
    let mut lost = 0;
    for end in ends {
        let half = match end {
            Ok(half) => half,
            Err(error) => {
                refusal = Some(error);
                lost += 1;
                continue;
            }
        };
        let found = grid_of(&half)?;
        match maxima.iter_mut().find(|(known, ..)| is_same(known, &found)) {
            Some((.., reached)) => *reached += 1,
            None => {
                let information = found.information()?;
                maxima.push((found, information, 1));
            }
        }
    }
    let information = |found: &(_, GridInformation, _)| found.1.mutual_information.value;
    maxima.sort_by(|a, b| information(b).total_cmp(&information(a)));
    let others = maxima.iter().skip(1).map(information).collect();
    let Some((grid, _, reached)) = maxima.into_iter().next() else {
        return Err(refusal.unwrap_or(DiscretizeError::NoMaximum));
    };
    let search = Search {
        starts: starts.len(),
        reached,
        lost,
        others,
    };
    Ok((grid, search))
}

/// The lines of a grid below 1/2.
fn half_of(grid: &BoxGrid) -> Vec<f64> {
    grid.lines()
        .iter()
        .copied()
        .filter(|line| *line < 0.5)
        .collect()
}

/// The second derivative along a unit vector, from gradients on either side.
fn difference(
    grid: &impl Fn(&[f64]) -> Result<BoxGrid, DiscretizeError>,
    half: &[f64],
    along: &DVector<f64>,
) -> Result<f64, DiscretizeError> {
    let below = std::iter::once(0.0).chain(half.iter().copied());
    let gaps = half.iter().copied().chain([0.5]).zip(below);
    let step =
        DIFFERENCE_STEP * gaps.fold(0.5, |least, (line, below)| f64::min(least, line - below));
    let slope = |step: f64| -> Result<f64, DiscretizeError> {
        let moved = half.iter().zip(along).map(|(t, by)| t + step * by);
        let gradient = grid(&moved.collect::<Vec<f64>>())?
            .derivatives(CLIMBING)?
            .gradient;
        Ok(gradient.dot(along))
    };
    Ok((slope(step)? - slope(-step)?) / (2.0 * step))
}

/// Lines below 1/2 to start from, the regular ones first; none if no line is free.
fn starts(cells: u32) -> Vec<Vec<f64>> {
    let regular: Vec<f64> = regular_positions(cells)
        .into_iter()
        .filter(|line| *line < 0.5)
        .collect();
    if regular.is_empty() {
        return Vec::new();
    }
    // the time of a step grows with the fourth power of the cells
    let (graded, random) = match cells {
        ..=16 => (GRADINGS.as_slice(), 9),
        17..=32 => (&GRADINGS[1..4], 2),
        _ => (&GRADINGS[2..3], 0),
    };
    let mut starts = vec![regular.clone()];
    for power in graded {
        let lines = regular.iter().map(|t| 0.5 * (2.0 * t).powf(*power));
        starts.push(lines.collect());
    }
    let mut source = ChaCha8Rng::seed_from_u64(SEED);
    for _ in 0..random {
        starts.push(random_lines(regular.len(), &mut source));
    }
    starts
}

/// Lines below 1/2 with the gaps of a Poisson process, none of them tiny.
fn random_lines(count: usize, source: &mut ChaCha8Rng) -> Vec<f64> {
    let gaps: Vec<f64> = (0..=count)
        .map(|_| 0.2 - source.random::<f64>().max(1e-3).ln())
        .collect();
    let whole: f64 = gaps.iter().sum();
    let mut line = 0.0;
    let lines = gaps[..count].iter().map(|gap| {
        line += 0.5 * gap / whole;
        line
    });
    lines.collect()
}

/// The lines below 1/2 at which Newton's method ends from `start`.
fn climb(
    grid: &impl Fn(&[f64]) -> Result<BoxGrid, DiscretizeError>,
    start: &[f64],
) -> Result<Vec<f64>, DiscretizeError> {
    let halved = |doubled: &[f64]| doubled.iter().map(|line| 0.5 * line).collect::<Vec<f64>>();
    // a refused grid has no gradient; the optimiser reports where
    let derivatives = |doubled: &[f64]| {
        let found = grid(&halved(doubled)).and_then(|grid| grid.derivatives(CLIMBING));
        match found {
            Ok(found) => (found.gradient * 0.5, found.hessian * 0.25),
            Err(_) => {
                let n = doubled.len();
                (DVector::repeat(n, f64::NAN), DMatrix::zeros(n, n))
            }
        }
    };
    let doubled = start.iter().map(|line| 2.0 * line).collect();
    Ok(halved(&maximum_by_derivatives(derivatives, doubled)?))
}

/// Whether two grids are one maximum, reached twice.
fn is_same(one: &BoxGrid, other: &BoxGrid) -> bool {
    let mut lines = one.lines().iter().zip(other.lines());
    lines.all(|(a, b)| (a - b).abs() <= SAME_MAXIMUM)
}
