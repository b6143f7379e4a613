//! The division of an element: into quarters, or in two at the best place across it.
//!
//! ```text
//!   marginal along an axis     B(t) = E + R H(t),  H(t) the mean irradiance of the chord at t
//!   axis                       of larger variance of its marginal
//!   mean square                max  a (1−a) (B₂ − B₁)²              a: share of the area before t
//!   information (§4.2)         max  G log2(G/W) + (1−G) log2((1−G)/(1−W))
//!                              G, W: shares of ∫ B and of ∫ B H before t
//! ```
//!
//! The marginal is constant on strips for the variance, and linear between their middles for the
//! place. The axis goes by variances, not by what the best cut gains: where the light is symmetric,
//! no single cut gains anything, and the second does.
//!
//! **Not covered**: cuts that follow the light at another angle than the element's edges.

use super::HierarchyError;
use super::view::View;
use crate::geometry::{CutLines, GeometryError, SplitAxis};
use crate::information::divergence;
use crate::numeric::real;

/// Strips of an element along each axis, and points on the middle of each.
const STRIPS: u32 = 6;
const POINTS: u32 = 3;

/// Positions that are tried; the first and the last leave slivers no thinner than these.
const TRIED: u32 = 64;
const THINNEST: u32 = 6;

/// The division of elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Division {
    /// Into parts of its kind; elongated ones into halves.
    #[default]
    Quarters,
    /// In two, where the criterion is highest.
    Bisection(CutCriterion),
}

/// A criterion of the place of a cut (§4.2).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CutCriterion {
    /// The least mean square error.
    MeanSquare,
    /// The highest mutual information.
    Information,
}

/// A cut across an element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bisection {
    /// The axis that it is across.
    pub axis: SplitAxis,
    /// The relative position along it.
    pub position: f64,
}

/// The radiosity along an axis of an element.
struct Marginal {
    /// Length of the chord, radiosity and irradiance in the middle of each strip.
    strips: Vec<[f64; 3]>,
}

impl CutCriterion {
    /// The best cut of an element.
    ///
    /// # Errors
    /// [`HierarchyError::Element`] if the element has no axes; [`HierarchyError::FormFactor`].
    pub fn cut(self, view: &View<'_>, element: usize) -> Result<Bisection, HierarchyError> {
        let mut best: Option<(f64, SplitAxis, Marginal)> = None;
        for axis in SplitAxis::ALL {
            let marginal = Marginal::of(view, element, axis)?;
            let variance = marginal.variance();
            if best.as_ref().is_none_or(|(most, ..)| variance > *most) {
                best = Some((variance, axis, marginal));
            }
        }
        let (_, axis, marginal) = best.unwrap_or_else(|| unreachable!("there are two axes"));
        Ok(Bisection {
            axis,
            position: self.position(&marginal),
        })
    }

    /// The position of highest value; the middle, if none has any.
    fn position(self, marginal: &Marginal) -> f64 {
        let positions = (THINNEST..=TRIED - THINNEST).map(|k| f64::from(k) / f64::from(TRIED));
        let mut best = (0.0, 0.5);
        for position in positions {
            let value = self.value(marginal, position);
            if value > best.0 {
                best = (value, position);
            }
        }
        best.1
    }

    fn value(self, marginal: &Marginal, position: f64) -> f64 {
        let sides = [marginal.sums(0.0, position), marginal.sums(position, 1.0)];
        let [fluxes, weights, areas] = [1, 2, 0].map(|k| sides.map(|side| side[k]));
        match self {
            Self::MeanSquare => {
                let [before, after] = [0, 1].map(|k| fluxes[k] / areas[k]);
                areas[0] * areas[1] * (after - before).powi(2)
            }
            Self::Information => divergence(&fluxes, &weights),
        }
    }
}

impl Marginal {
    fn of(view: &View<'_>, element: usize, axis: SplitAxis) -> Result<Self, HierarchyError> {
        let refused = |source: GeometryError| HierarchyError::Element { element, source };
        let shape = view.element(element).shape();
        let lines = CutLines::try_new(shape, axis).map_err(refused)?;
        let (emitted, reflectance) = (view.emittance(element), view.reflectance(element));
        let mut strips = Vec::new();
        for strip in 0..STRIPS {
            let chords = lines.chords(middle(strip, STRIPS));
            let (mut length, mut received) = (0.0, 0.0);
            for [from, to] in chords {
                let part = from.distance(to) / f64::from(POINTS);
                for point in 0..POINTS {
                    let point = from.lerp(to, middle(point, POINTS));
                    received += part * view.received_at(element, point)?;
                    length += part;
                }
            }
            let mean = received / length;
            strips.push([length, emitted + reflectance * mean, mean]);
        }
        Ok(Self { strips })
    }

    /// The variance of the radiosity between strips.
    fn variance(&self) -> f64 {
        let sum = |value: &dyn Fn(f64) -> f64| {
            let strips = self.strips.iter();
            strips.map(|[length, b, _]| length * value(*b)).sum::<f64>()
        };
        let length = sum(&|_| 1.0);
        let mean = sum(&|b| b) / length;
        sum(&|b| (b - mean).powi(2)) / length
    }

    /// `∫ 1`, `∫ B` and `∫ B H` between two positions, by the middles of pieces as narrow as the
    /// positions that are tried.
    fn sums(&self, from: f64, to: f64) -> [f64; 3] {
        let mut sums = [0.0; 3];
        for piece in 0..TRIED {
            let position = middle(piece, TRIED);
            if from < position && position < to {
                let [length, b, h] = self.at(position);
                let terms = [length, length * b, length * b * h];
                sums.iter_mut()
                    .zip(terms)
                    .for_each(|(sum, term)| *sum += term);
            }
        }
        sums
    }

    /// The values at a position, linear between the middles of strips and beyond the outermost.
    fn at(&self, position: f64) -> [f64; 3] {
        let last = self.strips.len() - 2;
        let place = position * f64::from(STRIPS) - 0.5;
        let before = (0..=last)
            .rev()
            .find(|k| real(*k) <= place)
            .unwrap_or_default();
        let share = place - real(before);
        let [from, to] = [self.strips[before], self.strips[before + 1]];
        std::array::from_fn(|k| (from[k] + share * (to[k] - from[k])).max(0.0))
    }
}

/// The middle of one of so many equal pieces of `[0, 1]`.
fn middle(piece: u32, pieces: u32) -> f64 {
    (f64::from(piece) + 0.5) / f64::from(pieces)
}
