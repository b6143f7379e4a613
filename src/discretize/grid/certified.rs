//! The best tensor grid on the inside of a box, with proof.
//!
//! With one free line (three cells a side) the maximum is global. Away from it the chain rule of
//! information bounds the value: states refined from X to X′ satisfy
//!
//! ```text
//!   I(X′;Y′) ≤ I(X;Y) + H(X′|X) + H(Y′|Y)
//! ```
//!
//! and a grid whose line t is known to lie between a and b is no finer than one with lines a, t, b,
//! which adds at most one bit inside the narrow cells of the grid with a and b. With more lines the
//! enclosure is that of a maximum which is the only stationary point nearby.
//!
//! **Not covered**: the global maximum over several lines.

use super::BoxGrid;
use super::best::BestGrid;
use crate::discretize::error::DiscretizeError;
use crate::numeric::{
    Certificate, CertifiedMaximum, Dual, Interval, Maximand, Scalar, VectorFunction,
    certified_maximum, certified_stationary_point,
};

/// A grid whose lines and mutual information are enclosed.
#[derive(Debug, Clone, PartialEq)]
pub struct CertifiedGrid {
    /// The lines below 1/2, increasing.
    pub half: Vec<Interval>,
    /// The mutual information of the grid, in bits.
    pub mutual_information: Interval,
    /// The proof that the grid is the best one, or the reason why there is none.
    pub certificate: Certificate,
}

impl CertifiedGrid {
    /// The mutual information of the grid of `cells` equal cells a side, enclosed.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] for zero cells.
    pub fn regular(edges: [f64; 3], cells: u32, bits: u32) -> Result<Interval, DiscretizeError> {
        BoxGrid::regular_like(edges, cells, &Interval::precise(1.0, bits))?.mutual_information()
    }

    /// The best grid of `cells` cells a side: the global maximum for three, else the maximum near
    /// the regular grid.
    ///
    /// # Errors
    /// [`DiscretizeError::Numeric`] if it cannot be isolated; [`DiscretizeError::OutOfRange`] for
    /// zero cells.
    pub fn best(edges: [f64; 3], cells: u32, bits: u32) -> Result<Self, DiscretizeError> {
        if cells == 3 {
            let CertifiedMaximum {
                position,
                value,
                certificate,
                ..
            } = certified_maximum(&ThreeCells { edges }, (0.0, 0.5), bits)?;
            return Ok(Self {
                half: vec![position],
                mutual_information: value,
                certificate,
            });
        }
        if cells <= 2 {
            // no line is free
            return Ok(Self {
                half: Vec::new(),
                mutual_information: Self::regular(edges, cells, bits)?,
                certificate: Certificate::Unique {
                    is_only_stationary_point: None,
                },
            });
        }
        let found = BestGrid::find(edges, cells)?.grid;
        let near: Vec<f64> = found
            .lines()
            .iter()
            .copied()
            .filter(|line| *line < 0.5)
            .collect();
        let half = certified_stationary_point(&Gradient { edges, cells }, &near, bits)?;
        let like = Interval::precise(1.0, bits);
        let grid = BoxGrid::mirrored(edges, &half, cells, &like)?;
        Ok(Self {
            mutual_information: grid.mutual_information()?,
            half,
            certificate: Certificate::Unknown {
                reason: "a strict maximum, the only one within 1e-12, not shown to be the highest"
                    .to_owned(),
            },
        })
    }
}

/// The gradient of the mutual information, as a function of the lines below 1/2.
struct Gradient {
    edges: [f64; 3],
    cells: u32,
}

impl VectorFunction for Gradient {
    fn values<S: Scalar>(&self, point: &[S]) -> Option<Vec<S>> {
        let like = point.first()?;
        BoxGrid::mirrored(self.edges, point, self.cells, like)
            .ok()?
            .gradient()
            .ok()
    }
}

/// The mutual information of a grid of three cells a side as a function of its lower line: the
/// other one is its mirror image.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThreeCells {
    /// The edges of the box.
    pub edges: [f64; 3],
}

impl ThreeCells {
    fn grid<S: Scalar>(&self, line: &S) -> Option<BoxGrid<S>> {
        BoxGrid::mirrored(self.edges, std::slice::from_ref(line), 3, line).ok()
    }
}

impl Maximand for ThreeCells {
    fn value<S: Scalar>(&self, x: &S) -> Option<S> {
        self.grid(x)?.mutual_information().ok()
    }

    fn slope<S: Scalar>(&self, x: &S) -> Option<S> {
        self.grid(x)?.gradient().ok()?.pop()
    }

    /// The slope from the Taylor form of each exchange area about the middle m of the box:
    /// `E″(m) + E‴(X)(X − m)` for the second derivative, then the same for the first, and last
    /// `E(m) + E′(X)(X − m)`.
    fn slope_on_box(&self, domain: &Interval<f64>) -> Option<Dual<Interval<f64>>> {
        let middle = Interval::point(domain.midpoint());
        let aside = *domain - middle;
        let on_box = self.grid(&Dual::variable(Dual::variable(Dual::variable(*domain))))?;
        let at_middle = self.grid(&Dual::variable(Dual::variable(middle)))?;
        let (total, _) = BoxGrid::regular_like(self.edges, 1, domain).ok()?.faces();
        let (on_box, at_middle) = (on_box.classes().ok()?, at_middle.classes().ok()?);
        let mut sum = Dual {
            value: domain.zero(),
            slope: domain.zero(),
        };
        for (pair, middle_pair) in on_box.pairs().zip(at_middle.pairs()) {
            let (natural, at_middle) = (pair.exchange().ok()?, middle_pair.exchange().ok()?);
            let second = at_middle.slope.slope + natural.slope.slope.slope * aside;
            let first = at_middle.slope.value + second * aside;
            let value = at_middle.value.value + first * aside;
            let areas = pair.areas().value.value;
            let log = (value * total / areas.value).ln();
            let log_slope = first / value - areas.slope / areas.value;
            let weight = domain.constant(pair.count) / total;
            sum.value = sum.value + weight * first * log;
            sum.slope = sum.slope + weight * (second * log + first * log_slope);
        }
        let ln_2 = domain.constant(2.0).ln();
        Some(Dual {
            value: sum.value / ln_2,
            slope: sum.slope / ln_2,
        })
    }

    /// The bound by the chain rule, with lines a, b for X and a, t, b for X′.
    ///
    /// `H(X′|X)` is at most one bit in the two narrow cells of each axis; next to 1/2 two lines
    /// divide the middle cell in three.
    fn bound_on(&self, domain: &Interval<f64>) -> Option<f64> {
        let (lower, upper) = (*domain.lower(), *domain.upper());
        let one = domain.constant(1.0);
        let (half, bits): (Vec<f64>, _) = if upper < 0.5 {
            (vec![lower, upper], one)
        } else {
            (
                vec![lower],
                domain.constant(3.0).ln() / domain.constant(2.0).ln(),
            )
        };
        let inner = half.into_iter().filter(|line| *line > 0.0);
        let lines: Vec<Interval<f64>> = inner.map(Interval::point).collect();
        let cells = 2 * u32::try_from(lines.len()).ok()? + 1;
        let grid = BoxGrid::mirrored(self.edges, &lines, cells, &one).ok()?;
        // 2 (b − a) on each of two axes, for X and for Y
        let share = (Interval::point(upper) - Interval::point(lower)) * domain.constant(8.0);
        Some(*(grid.mutual_information().ok()? + share * bits).upper())
    }
}
