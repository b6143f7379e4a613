//! Fig. 5(b), read as exact: the mutual information of every regular grid of the cube, n × n
//! squares on each face, against the printed value, by a finite computation.
//!
//! ```text
//!   n ≤ 16        enclosed
//!   d divides n   I(n) ≥ I(d)                                   Theorem 1
//!   other n       I(n) ≥ I of nine cells a side between lines of the grid
//!   n large       I(16) ≤ I(n) + 4 · 15/n
//! ```
//!
//! The last is the chain rule, `I(X′;Y′) ≤ I(X;Y) + H(X′|X) + H(Y′|Y)`: cutting the cells of the
//! grid by the 15 lines of the regular one of 16 divides, along each axis of a face, at most 15 of
//! n strips in two, which makes at most 15/n bit for each axis and end. So once I(16) − 60/n is
//! above the print, so is every I(n) from there on. The third line takes most of the time: the
//! claim asks it up to a number of cells beyond what a printed figure shows, a test for all that
//! are left.
//!
//! **Not covered**: grids that are not regular; faces that are divided differently.

use super::continuous_limit::enclosed_regular_grid;
use super::figure_5::reading;
use crate::claims::{Case, ClaimError, Finding};
use crate::discretize::{BoxGrid, CertifiedGrid, UNIT_CUBE, regular_positions};
use crate::numeric::{Interval, try_parallel_map};

/// Grids of up to so many cells a side are enclosed as they are.
const ENCLOSED: u32 = 16;
/// Cells a side that the lines of other grids are thinned to.
const THINNED: u32 = 9;

/// The cells a side from which the chain rule with the grid of 16 cells suffices: the least n with
/// `I(16) − 60/n > above`. `None` if there is none up to a thousand.
fn chain_rule_suffices_from(finest: &Interval<f64>, above: &Interval<f64>) -> Option<u32> {
    let crossings = f64::from(4 * (ENCLOSED - 1));
    (ENCLOSED + 1..=1000).find(|n| {
        let straddling = Interval::point(crossings) / Interval::point(f64::from(*n));
        *finest - straddling > *above
    })
}

/// The mutual information of nine cells a side, an odd number, whose lines are lines of the grid of
/// `cells`, the nearest to those of the regular one.
fn thinned(cells: u32) -> Result<Interval<f64>, ClaimError> {
    let like = Interval::point(1.0);
    let half: Vec<Interval<f64>> = (1..=THINNED / 2)
        .map(|k| (2 * k * cells + THINNED) / (2 * THINNED))
        .map(|line| Interval::point(f64::from(line)) / Interval::point(f64::from(cells)))
        .collect();
    let grid = BoxGrid::mirrored(UNIT_CUBE, &half, THINNED, &like)?;
    Ok(grid.mutual_information()?)
}

/// The printed value against every regular grid; the number is the value of those above it that is
/// nearest to it, that of `nearest` cells a side.
pub(crate) fn regular_grid_information(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let lower = Interval::point(case.number("printed_from")?);
    let upper = Interval::point(case.number("printed_to")?);
    let nearest = case.count("nearest")?;
    let enclosed = (1..=ENCLOSED)
        .map(enclosed_regular_grid)
        .collect::<Result<Vec<_>, _>>()?;
    let misses = |level: &Interval<f64>| *level < lower || *level > upper;
    let is_above = |n: u32| enclosed.get(n as usize - 1).is_some_and(|i| *i > upper);
    let information = CertifiedGrid::regular(UNIT_CUBE, nearest, case.bits())?;
    let shown = case.count("thinned_up_to")?;
    let note = format!(
        "no regular grid has it: 7 cells a side give {:.4}, 8 give {:.4}, fewer give less than the \
         print and more give more, for up to {shown} cells a side; {}",
        enclosed[6].midpoint(),
        enclosed[7].midpoint(),
        reading(case, &regular_positions(case.count("cells")?))?
    );
    if !enclosed.iter().all(misses) {
        // one has the printed value, or cannot be told from it
        return Ok(Finding::enclosed(information).noting(note));
    }
    let undecided = |n: u32| {
        let reason = format!("whether {n} cells a side have the printed value");
        ClaimError::NotCertified { reason }
    };
    let all = chain_rule_suffices_from(&enclosed[ENCLOSED as usize - 1], &upper);
    let all = all.ok_or_else(|| undecided(ENCLOSED + 1))?;
    // others have a divisor that is enclosed and above the print, or thinned
    let has_divisor = |n: u32| (2..=ENCLOSED).any(|d| n.is_multiple_of(d) && is_above(d));
    let others: Vec<u32> = (ENCLOSED + 1..all.min(shown + 1))
        .filter(|n| !has_divisor(*n))
        .filter(|n| !(ENCLOSED + 1..*n).any(|d| n.is_multiple_of(d)))
        .collect();
    let thinned = try_parallel_map(others.len(), &|k| thinned(others[k]))?;
    for (n, level) in others.iter().zip(&thinned) {
        // those with an odd number of cells have no line in the middle, as nine have none
        if n.is_multiple_of(2) || *level <= upper {
            return Err(undecided(*n));
        }
    }
    Ok(Finding::decided(false, true, information).noting(note))
}
