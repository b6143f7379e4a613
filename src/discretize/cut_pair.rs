//! A patch to be cut and another one: what parts and strips of the first exchange with the second.
//!
//! ```text
//!   G(a, b) = A F of the part between positions a and b,     r(t) = ∂G(0, t)/∂t
//! ```
//!
//! Rectangles with edges along common axes have both in closed form, in any number type. Of other polygons each part is
//! computed by [`Polygon::exchange_area`], a strip by [`Polygon::segment_exchange`], in `f64` only; a thin part is the
//! integral of its strips.

use super::DiscretizeError;
use crate::form_factor::{DEFAULT_TOLERANCE, FormFactorError, Polygon, RectanglePair};
use crate::geometry::{CutLines, GeometryError, Patch, Rectangle, SplitAxis};
use crate::numeric::{GaussLegendre, Scalar};

/// The relative error bounds that the exchange area of a part is asked for, one after the other: of thin parts that touch
/// the other polygon the first may be out of reach, and no digit is shown.
const TOLERANCES: [f64; 3] = [1e-13, 1e-11, 1e-9];

/// A part whose rounding is below this share of the whole may be called dark.
const DARK: f64 = 1e-12;

/// Parts thinner than this are summed strip by strip: their corners' rounding turns a polygon's plane.
const THIN: f64 = 1.0 / 512.0;

/// Strips in such a part.
const STRIPS: usize = 16;

/// How two patches are computed together.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum CutPair<S> {
    /// In closed form.
    Aligned(RectanglePair<S>),
    /// In `f64`, numerically.
    Polygons(Box<PolygonPair>),
    /// The second kind, where an enclosure was wanted.
    NotEnclosed,
}

/// Any two polygons, the first with lines across it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PolygonPair {
    surface: Polygon,
    other: Polygon,
    lines: CutLines,
    whole: f64,
}

impl CutPair<f64> {
    /// The pair, and what it exchanges.
    pub(super) fn try_new(
        lines: &CutLines,
        [patch, other]: [&Patch; 2],
    ) -> Result<(Self, f64), FormFactorError> {
        let rectangles = [patch, other].map(|patch| Rectangle::try_from(patch).ok());
        if let [Some(first), Some(second)] = &rectangles
            && let Ok(pair) = RectanglePair::try_new(first, second)
            && let Ok(exchange) = pair.exchange_area()
        {
            return Ok((Self::Aligned(pair), exchange.value));
        }
        let (surface, other) = (Polygon::new(patch), Polygon::new(other));
        let whole = surface.exchange_area(&other, DEFAULT_TOLERANCE)?.exchange;
        // what is not positive beyond its error is a patch behind a plane, up to rounding
        let whole = if whole.value > whole.error_bound {
            whole.value
        } else {
            0.0
        };
        let pair = PolygonPair {
            surface,
            other,
            lines: lines.clone(),
            whole,
        };
        Ok((Self::Polygons(Box::new(pair)), whole))
    }

    /// The same in numbers of the type of `like`, where there is a closed form.
    pub(super) fn lifted<S: Scalar>(&self, like: &S) -> CutPair<S> {
        match self {
            Self::Aligned(pair) => CutPair::Aligned(pair.lifted(like)),
            Self::Polygons(_) | Self::NotEnclosed => CutPair::NotEnclosed,
        }
    }
}

impl<S: Scalar> CutPair<S> {
    pub(super) const fn is_aligned(&self) -> bool {
        matches!(self, Self::Aligned(_))
    }

    /// What the whole patch exchanges.
    pub(super) fn whole(&self, like: &S) -> Result<S, DiscretizeError> {
        match self {
            Self::Aligned(pair) => Ok(pair.exchange_value()?),
            Self::Polygons(pair) => Ok(like.constant(pair.whole)),
            Self::NotEnclosed => Err(DiscretizeError::NotEnclosed),
        }
    }

    /// What the part between two positions exchanges.
    pub(super) fn part(&self, axis: SplitAxis, [from, to]: &[S; 2]) -> Result<S, DiscretizeError> {
        let exchange = match self {
            Self::Aligned(pair) => pair.part(axis, from, to)?.exchange_value(),
            // this variant exists in f64 only
            Self::Polygons(pair) => pair
                .part(from.to_f64(), to.to_f64())
                .map(|value| from.constant(value)),
            Self::NotEnclosed => return Err(DiscretizeError::NotEnclosed),
        };
        match exchange {
            // a part that ends at the other's plane is dark up to rounding
            Err(FormFactorError::NotResolved { error_bound, .. })
                if error_bound <= DARK * self.whole(from)?.to_f64() =>
            {
                Ok(from.zero())
            }
            exchange => Ok(exchange?),
        }
    }

    /// What a strip exchanges, per relative width.
    pub(super) fn strip(&self, axis: SplitAxis, position: &S) -> Result<S, DiscretizeError> {
        match self {
            Self::Aligned(pair) => Ok(pair.strip_exchange(axis, position)?),
            Self::Polygons(pair) => Ok(position.constant(pair.strip(position.to_f64()))),
            Self::NotEnclosed => Err(DiscretizeError::NotEnclosed),
        }
    }
}

impl PolygonPair {
    fn part(&self, from: f64, to: f64) -> Result<f64, FormFactorError> {
        CutLines::check(from, to)?;
        if to - from < THIN {
            return Ok(self.strips(from, to));
        }
        let parts = match self.lines.part(from, to) {
            Ok(parts) => parts,
            Err(GeometryError::NotPlanar { .. } | GeometryError::NoArea { .. }) => {
                return Ok(self.strips(from, to));
            }
            Err(error) => return Err(error.into()),
        };
        let mut sum = 0.0;
        for part in parts {
            let part = Polygon::new(&part);
            let exchange = TOLERANCES
                .iter()
                .find_map(|tolerance| part.exchange_area(&self.other, *tolerance).ok());
            match exchange {
                Some(answer) => sum += answer.exchange.value,
                None => return Ok(self.strips(from, to)),
            }
        }
        Ok(sum)
    }

    /// `∫ r dt`, with `t = from + (to − from) s³(10 − 15 s + 6 s²)`, which flattens logarithms at the ends.
    fn strips(&self, from: f64, to: f64) -> f64 {
        let rule = GaussLegendre::with(STRIPS);
        let nodes = rule.nodes.iter().zip(&rule.weights);
        let width = to - from;
        let terms = nodes.map(|(node, weight)| {
            let (s, rest) = (0.5 + 0.5 * node, 0.5 - 0.5 * node);
            let at = from + width * s.powi(3) * (10.0 - s * (15.0 - 6.0 * s));
            0.5 * weight * 30.0 * (s * rest).powi(2) * self.strip(at)
        });
        width * terms.sum::<f64>()
    }

    fn strip(&self, position: f64) -> f64 {
        let chords = self.lines.chords(position);
        let lit = chords
            .into_iter()
            .map(|chord| self.surface.segment_exchange(chord, &self.other));
        lit.sum::<f64>() * self.lines.breadth()
    }
}
