//! The laws of form factors, checked on a matrix from anywhere.
//!
//! ```text
//!   range         0 ≤ F_ij ≤ 1
//!   row sum       Σ_j F_ij ≤ 1                 = 1 in a closed scene
//!   reciprocity   A_i F_ij = A_j F_ji
//! ```
//!
//! With bounds `b_ij` on the errors of the entries, a law is broken by what these cannot explain:
//!
//! ```text
//!   F_ij < −b_ij ,  F_ij > 1 + b_ij
//!   Σ_j F_ij > 1 + Σ_j b_ij + n ε
//!   |A_i F_ij − A_j F_ji| > A_i b_ij + A_j b_ji + 8 ε (A_i |F_ij| + A_j |F_ji|)
//! ```
//!
//! The last terms are for the rounding of sums and products, and of the areas. So a matrix within
//! its bounds breaks no law; one that breaks none may still be wrong.
//!
//! A matrix whose entry `(i, j)` is from j to i, as some programs write it, breaks reciprocity by
//! the ratio of the areas, and its transpose does not. Equal areas tell nothing.

use crate::numeric::{compensated_sum, real};

/// The transpose is meant if its reciprocity errors are so much smaller.
const CLEARLY: f64 = 1e-2;

/// A matrix cannot be checked.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MatrixLawsError {
    /// An entry, or its bound, is not a number.
    #[error("{what} ({row}, {column}) is {value}: every number must be finite")]
    NotFinite {
        /// Entry or bound.
        what: &'static str,
        /// The row.
        row: usize,
        /// The column.
        column: usize,
        /// The number as given.
        value: f64,
    },
    /// A bound is negative.
    #[error("the bound ({row}, {column}) is {bound}: it must be at least 0")]
    NegativeBound {
        /// The row.
        row: usize,
        /// The column.
        column: usize,
        /// The bound as given.
        bound: f64,
    },
    /// An area is no area.
    #[error("the area of face {row} is {area}: it must be finite and at least 0")]
    NotAnArea {
        /// The row.
        row: usize,
        /// The area as given.
        area: f64,
    },
    /// The numbers are not those of a square matrix.
    #[error(
        "{areas} areas need {areas} × {areas} entries and bounds: here are {entries} and {bounds}"
    )]
    Shape {
        /// Areas given.
        areas: usize,
        /// Entries given.
        entries: usize,
        /// Bounds given.
        bounds: usize,
    },
}

/// A law that a matrix breaks.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct BrokenLaw {
    /// The name of the law: `"range"`, `"row sum"` or `"reciprocity"`.
    pub law: &'static str,
    /// Entries, rows or pairs that break it.
    pub cases: usize,
    /// The worst of them: a row, or a row and a column.
    pub worst: Vec<usize>,
    /// The excess of the worst over what is allowed, in the unit of a form factor.
    pub excess: f64,
    /// The worst one in words.
    pub told: String,
}

/// The laws that a matrix of form factors obeys or breaks.
///
/// # Examples
/// ```
/// use infoscene::exchange::MatrixLaws;
/// // a face of area 2 sends half of its power to one of area 1, which sends all to it
/// let areas = [2.0, 1.0];
/// let sound = MatrixLaws::of(&[0.5, 0.5, 1.0, 0.0], &areas, &[1e-15; 4])?;
/// assert!(sound.broken.is_empty() && sound.closed);
/// let transposed = MatrixLaws::of(&[0.5, 1.0, 0.5, 0.0], &areas, &[1e-15; 4])?;
/// assert!(transposed.transposed);
/// assert_eq!(transposed.broken.iter().map(|one| one.law).collect::<Vec<_>>(), [
///     "row sum", "reciprocity",
/// ]);
/// # Ok::<(), infoscene::exchange::MatrixLawsError>(())
/// ```
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[non_exhaustive]
pub struct MatrixLaws {
    /// The laws that are broken.
    pub broken: Vec<BrokenLaw>,
    /// Do all rows sum to one, within the bounds? An open scene breaks no law by that.
    pub closed: bool,
    /// Does the matrix break reciprocity, and its transpose by far less?
    pub transposed: bool,
    /// The sums of the rows.
    pub row_sums: Vec<f64>,
    /// The row whose sum is farthest from one.
    pub worst_row: usize,
    /// The largest `|A_i F_ij − A_j F_ji| / min(A_i, A_j)`, allowed or not.
    pub largest_reciprocity_error: f64,
}

/// The cases that break a law, of which the worst is told.
struct Cases {
    count: usize,
    excess: f64,
    worst: Vec<usize>,
    told: String,
}

impl Cases {
    const fn none() -> Self {
        Self {
            count: 0,
            excess: 0.0,
            worst: Vec::new(),
            told: String::new(),
        }
    }

    /// Counts a case if it exceeds what is allowed.
    fn look(&mut self, excess: f64, place: &[usize], told: impl Fn() -> String) {
        if excess <= 0.0 {
            return;
        }
        self.count += 1;
        if excess > self.excess {
            (self.excess, self.worst, self.told) = (excess, place.to_vec(), told());
        }
    }

    fn broken(self, law: &'static str) -> Option<BrokenLaw> {
        (self.count > 0).then_some(BrokenLaw {
            law,
            cases: self.count,
            worst: self.worst,
            excess: self.excess,
            told: self.told,
        })
    }
}

/// A square matrix, row after row.
#[derive(Clone, Copy)]
struct Matrix<'m> {
    values: &'m [f64],
    areas: &'m [f64],
    bounds: &'m [f64],
}

impl MatrixLaws {
    /// The laws of the matrix with these entries, row after row, `F_ij` from i to j.
    ///
    /// **Arguments** `areas`: that of each row, ≥ 0; `bounds`: those on the absolute errors of the
    /// entries, ≥ 0.
    ///
    /// # Errors
    /// [`MatrixLawsError`] if a number is not finite or out of range, or their counts do not fit.
    pub fn of(values: &[f64], areas: &[f64], bounds: &[f64]) -> Result<Self, MatrixLawsError> {
        let matrix = Matrix {
            values,
            areas,
            bounds,
        };
        matrix.check()?;
        let sums: Vec<[f64; 2]> = (0..areas.len()).map(|row| matrix.sums(row)).collect();
        let slack = real(areas.len()) * f64::EPSILON;
        let far = |[sum, allowed]: [f64; 2]| (sum - 1.0).abs() > allowed + slack;
        let (reciprocity, largest, of_transpose) = matrix.reciprocity();
        let is_broken = reciprocity.count > 0;
        let broken = [
            matrix.range().broken("range"),
            row_sums(&sums, slack).broken("row sum"),
            reciprocity.broken("reciprocity"),
        ];
        let distance = |row: &usize| (sums[*row][0] - 1.0).abs();
        let rows = 0..areas.len();
        let worst = rows.max_by(|one, other| {
            let order = distance(one).total_cmp(&distance(other));
            order.then(other.cmp(one))
        });
        Ok(Self {
            broken: broken.into_iter().flatten().collect(),
            closed: !sums.iter().any(|sum| far(*sum)),
            transposed: is_broken && of_transpose < CLEARLY * largest,
            worst_row: worst.unwrap_or(0),
            largest_reciprocity_error: largest,
            row_sums: sums.into_iter().map(|[sum, _]| sum).collect(),
        })
    }
}

/// The rows that sum to more than one.
fn row_sums(sums: &[[f64; 2]], slack: f64) -> Cases {
    let mut cases = Cases::none();
    for (row, [sum, bound]) in sums.iter().enumerate() {
        let allowed = bound + slack;
        cases.look(sum - 1.0 - allowed, &[row], || {
            format!("row {row} sums to {sum}, and 1 + {allowed:.1e} is allowed")
        });
    }
    cases
}

impl Matrix<'_> {
    fn check(self) -> Result<(), MatrixLawsError> {
        let areas = self.areas.len();
        let (entries, bounds) = (self.values.len(), self.bounds.len());
        if areas.checked_mul(areas) != Some(entries) || bounds != entries {
            return Err(MatrixLawsError::Shape {
                areas,
                entries,
                bounds,
            });
        }
        for (row, area) in self.areas.iter().copied().enumerate() {
            if !(area >= 0.0 && area.is_finite()) {
                return Err(MatrixLawsError::NotAnArea { row, area });
            }
        }
        for (what, numbers) in [("entry", self.values), ("the bound", self.bounds)] {
            if let Some(place) = numbers.iter().position(|number| !number.is_finite()) {
                return Err(MatrixLawsError::NotFinite {
                    what,
                    row: place / areas,
                    column: place % areas,
                    value: numbers[place],
                });
            }
        }
        if let Some(place) = self.bounds.iter().position(|bound| *bound < 0.0) {
            return Err(MatrixLawsError::NegativeBound {
                row: place / areas,
                column: place % areas,
                bound: self.bounds[place],
            });
        }
        Ok(())
    }

    /// The sums of a row's entries and of their bounds.
    fn sums(self, row: usize) -> [f64; 2] {
        let entries = row * self.areas.len()..(row + 1) * self.areas.len();
        [self.values, self.bounds].map(|all| compensated_sum(all[entries.clone()].iter().copied()))
    }

    /// The entries below 0 or above 1.
    fn range(self) -> Cases {
        let mut cases = Cases::none();
        let entries = self.values.iter().zip(self.bounds).enumerate();
        for (place, (value, bound)) in entries {
            let (row, column) = (place / self.areas.len(), place % self.areas.len());
            let excess = (-value).max(value - 1.0) - bound;
            cases.look(excess, &[row, column], || {
                format!("F = {value} from {row} to {column} is not from 0 to 1")
            });
        }
        cases
    }

    /// The pairs whose two exchange areas differ, their largest difference in the unit of a form
    /// factor, and that of the transpose.
    fn reciprocity(self) -> (Cases, f64, f64) {
        let (areas, count) = (self.areas, self.areas.len());
        let mut cases = Cases::none();
        let (mut largest, mut of_transpose) = (0.0_f64, 0.0_f64);
        for i in 0..count {
            for j in i + 1..count {
                let smaller = areas[i].min(areas[j]);
                if smaller <= 0.0 {
                    continue;
                }
                let [there, back] = [i * count + j, j * count + i];
                let sent = areas[i] * self.values[there];
                let returned = areas[j] * self.values[back];
                let apart = (sent - returned).abs();
                let turned = areas[i] * self.values[back] - areas[j] * self.values[there];
                largest = largest.max(apart / smaller);
                of_transpose = of_transpose.max(turned.abs() / smaller);
                let rounding = 8.0 * f64::EPSILON * (sent.abs() + returned.abs());
                let bounds = areas[i] * self.bounds[there] + areas[j] * self.bounds[back];
                cases.look((apart - bounds - rounding) / smaller, &[i, j], || {
                    format!("A F is {sent:.9e} from {i} to {j}, and {returned:.9e} from {j} to {i}")
                });
            }
        }
        (cases, largest, of_transpose)
    }
}
