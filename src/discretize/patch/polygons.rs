//! A split of any polygon, judged by polygons at any angle; numbers in `f64`, no enclosures.
//!
//! Pairs of rectangles with edges along common axes have closed forms. Otherwise the exchange area
//! of a part is that of two polygons ([`Polygon::exchange_area`]), that of a strip
//! [`Polygon::segment_exchange`]; a thin part is the integral of its strips.
//!
//! Where other surfaces stand between, the exchange area of a part is that past all of them
//! ([`Polygon::exchange_area_past`]), and that of a strip a difference quotient of parts,
//!
//! ```text
//!   r(t) ≈ (4 D(h/2) − D(h))/3,    D(h) = G(t − h, t + h)/2h
//! ```
//!
//! which errs by O(h⁴), and by O(h) of a bend of r within h of t: an estimate.
//!
//! **Not covered**: any number type but `f64`; see
//! [`RectangleSplit`](crate::discretize::RectangleSplit).

use super::part_exchange::{PartExchange, SplitWeights};
use super::rectangles::or_dark;
use crate::discretize::error::DiscretizeError;
use crate::form_factor::{
    Answer, DEFAULT_TOLERANCE, FormFactorError, Occluders, Polygon, RectanglePair,
};
use crate::geometry::{CutLines, GeometryError, Patch, Rectangle, SplitAxis, check_part};
use crate::numeric::GaussLegendre;
use glam::DVec3;
use std::sync::Arc;

/// The relative error bounds that the exchange area of a part is asked for, one after the other.
///
/// (b) The first is what `turned_scenes_of_the_paper_have_the_papers_cuts` needs for its digits; of
/// thin parts that touch the other polygon it may be out of reach, and the next one is asked for.
const TOLERANCES: [f64; 3] = [1e-13, 1e-11, 1e-9];

/// Parts thinner than this are summed strip by strip: (a) corners rounded to ε turn the plane of a
/// part by ε over its width, by more than 512 ε where it is thinner than this.
const THIN: f64 = 1.0 / 512.0;

/// Strips in a thin part: (b) held by `thin_parts_exchange_what_the_parts_beside_them_leave`.
const STRIPS: usize = 16;

/// Half the width of the strip that stands for a line across an occluded patch: (a) h⁴ is 4e-15,
/// and corners rounded to ε turn the plane of the strip by 1e-12.
const HALF_STRIP: f64 = 1.0 / 4096.0;

/// The polygons of a split: the patch with lines across it, and each patch that it is judged by.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PolygonSplit {
    pub surface: CutSurface,
    pub pairs: Vec<CutPair>,
    pub weights: SplitWeights<f64>,
}

/// A patch that is cut, with the lines across it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct CutSurface {
    polygon: Polygon,
    rectangle: Option<Rectangle>,
    lines: CutLines,
    axis: SplitAxis,
}

/// A patch that a split is judged by.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum CutPair {
    /// A rectangle with edges along the axes of the patch that is cut: closed forms.
    Aligned(RectanglePair),
    /// Any other polygon, and the exchange area of the whole patch with it.
    Polygon { other: Box<Polygon>, whole: f64 },
    /// Any polygon past others, and the exchange area of the whole patch with it.
    Occluded {
        other: Box<Polygon>,
        past: Past,
        whole: f64,
    },
}

/// The polygons that stand between a pair.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Past {
    pub occluders: Vec<Arc<Polygon>>,
    /// The distance up to which they count as touching.
    pub touching: f64,
}

impl Past {
    fn exchange(
        &self,
        one: &Polygon,
        other: &Polygon,
        tolerance: f64,
    ) -> Result<Answer, FormFactorError> {
        let polygons: Vec<&Polygon> = self.occluders.iter().map(AsRef::as_ref).collect();
        let occluders = Occluders {
            polygons: &polygons,
            touching: self.touching,
        };
        one.exchange_area_past(other, &occluders, tolerance)
    }
}

impl CutSurface {
    /// The patch with lines across `axis`.
    ///
    /// # Errors
    /// [`GeometryError::StraightCorner`] if the edges at its first corner span no plane.
    pub(crate) fn try_new(patch: &Patch, axis: SplitAxis) -> Result<Self, GeometryError> {
        Ok(Self {
            polygon: Polygon::new(patch),
            rectangle: Rectangle::try_from(patch).ok(),
            lines: CutLines::try_new(patch, axis)?,
            axis,
        })
    }

    /// The patch with lines along a direction.
    ///
    /// # Errors
    /// [`GeometryError::StraightCorner`] if the direction is perpendicular to its plane.
    pub(crate) fn parallel_to(patch: &Patch, direction: DVec3) -> Result<Self, GeometryError> {
        Ok(Self {
            polygon: Polygon::new(patch),
            rectangle: None,
            lines: CutLines::parallel_to(patch, direction)?,
            axis: SplitAxis::U,
        })
    }

    pub(crate) const fn lines(&self) -> &CutLines {
        &self.lines
    }

    pub(crate) const fn axis(&self) -> SplitAxis {
        self.axis
    }

    /// The pair with another patch, and their exchange area.
    pub(crate) fn pair(&self, other: &Patch) -> Result<(CutPair, f64), FormFactorError> {
        if let (Some(first), Ok(second)) = (&self.rectangle, Rectangle::try_from(other))
            && let Ok(pair) = RectanglePair::try_new(first, &second)
            && let Ok(exchange) = pair.exchange_area()
        {
            return Ok((CutPair::Aligned(pair), exchange.value));
        }
        let other = Box::new(Polygon::new(other));
        let found = self.polygon.exchange_area(&other, DEFAULT_TOLERANCE)?;
        let whole = certain(&found);
        Ok((CutPair::Polygon { other, whole }, whole))
    }

    /// The pair with another patch past those that stand between, and their exchange area.
    pub(crate) fn pair_past(
        &self,
        other: &Patch,
        past: Past,
    ) -> Result<(CutPair, f64), FormFactorError> {
        let other = Box::new(Polygon::new(other));
        let whole = certain(&past.exchange(&self.polygon, &other, DEFAULT_TOLERANCE)?);
        Ok((CutPair::Occluded { other, past, whole }, whole))
    }

    /// The exchange area of the part between two positions with another polygon past others.
    ///
    /// **Arguments** `value`: what counts of an answer.
    fn part_exchange_past(
        &self,
        other: &Polygon,
        past: &Past,
        [from, to]: [f64; 2],
        value: fn(&Answer) -> f64,
    ) -> Result<f64, FormFactorError> {
        check_part(from, to)?;
        let mut sum = 0.0;
        for part in self.lines.part(from, to)? {
            let part = Polygon::new(&part);
            sum += value(&past.exchange(&part, other, TOLERANCES[0])?);
        }
        Ok(sum)
    }

    /// The exchange area per relative width of the strip at a position, past others; 0 where one
    /// side of the position is dark.
    fn strip_exchange_past(
        &self,
        other: &Polygon,
        past: &Past,
        position: f64,
    ) -> Result<f64, FormFactorError> {
        let exchange = |from: f64, to: f64| {
            let ends = [from.max(0.0), to.min(1.0)];
            let exchange = self.part_exchange_past(other, past, ends, certain)?;
            Ok::<_, FormFactorError>((exchange, ends[1] - ends[0]))
        };
        let half = 0.5 * HALF_STRIP;
        let (before, width) = exchange(position - half, position)?;
        let (after, more) = exchange(position, position + half)?;
        if before <= 0.0 || after <= 0.0 {
            return Ok(0.0);
        }
        let (wide, all) = exchange(position - HALF_STRIP, position + HALF_STRIP)?;
        let narrow = (before + after) / (width + more);
        Ok((4.0 * narrow - wide / all) / 3.0)
    }

    /// The exchange area of the part between two positions with another polygon.
    fn part_exchange(&self, other: &Polygon, from: f64, to: f64) -> Result<f64, FormFactorError> {
        check_part(from, to)?;
        if to - from < THIN {
            return Ok(self.strips_exchange(other, from, to));
        }
        let parts = match self.lines.part(from, to) {
            Ok(parts) => parts,
            Err(GeometryError::NotPlanar { .. } | GeometryError::NoArea { .. }) => {
                return Ok(self.strips_exchange(other, from, to));
            }
            Err(error) => return Err(error.into()),
        };
        let mut sum = 0.0;
        for part in parts {
            let part = Polygon::new(&part);
            let exchange = TOLERANCES
                .iter()
                .find_map(|tolerance| part.exchange_area(other, *tolerance).ok());
            match exchange {
                Some(answer) => sum += answer.exchange.value,
                None => return Ok(self.strips_exchange(other, from, to)),
            }
        }
        Ok(sum)
    }

    /// `∫ r dt`, with `t = from + (to − from) s³(10 − 15 s + 6 s²)`, which flattens logarithms at
    /// the ends.
    fn strips_exchange(&self, other: &Polygon, from: f64, to: f64) -> f64 {
        debug_assert!(0.0 <= from && from < to && to <= 1.0, "{from} to {to}");
        let rule = GaussLegendre::with(STRIPS);
        let nodes = rule.nodes.iter().zip(&rule.weights);
        let width = to - from;
        let terms = nodes.map(|(node, weight)| {
            let (s, rest) = (0.5 + 0.5 * node, 0.5 - 0.5 * node);
            let at = from + width * s.powi(3) * (10.0 - s * (15.0 - 6.0 * s));
            0.5 * weight * 30.0 * (s * rest).powi(2) * self.strip_exchange(other, at)
        });
        width * terms.sum::<f64>()
    }

    fn strip_exchange(&self, other: &Polygon, position: f64) -> f64 {
        let chords = self.lines.chords(position);
        let lit = chords
            .into_iter()
            .map(|chord| self.polygon.segment_exchange(chord, other));
        lit.sum::<f64>() * self.lines.breadth()
    }
}

/// The value of an answer; one that is not positive beyond its error is that of a patch behind the
/// plane.
fn certain(answer: &Answer) -> f64 {
    let exchange = answer.exchange;
    if exchange.value > exchange.error {
        exchange.value
    } else {
        0.0
    }
}

impl PartExchange<f64> for PolygonSplit {
    fn weights(&self) -> &SplitWeights<f64> {
        &self.weights
    }

    fn whole_flux(&self, pair: usize) -> Result<f64, DiscretizeError> {
        match &self.pairs[pair] {
            CutPair::Aligned(pair) => Ok(pair.exchange_value()?),
            CutPair::Polygon { whole, .. } | CutPair::Occluded { whole, .. } => Ok(*whole),
        }
    }

    fn flux(&self, pair: usize, [from, to]: &[f64; 2]) -> Result<f64, DiscretizeError> {
        let surface = &self.surface;
        let exchange = match &self.pairs[pair] {
            CutPair::Aligned(pair) => pair.part(surface.axis, from, to)?.exchange_value(),
            CutPair::Polygon { other, .. } => surface.part_exchange(other, *from, *to),
            CutPair::Occluded { other, past, .. } => {
                let value = |answer: &Answer| answer.exchange.value;
                surface.part_exchange_past(other, past, [*from, *to], value)
            }
        };
        or_dark(exchange, || self.whole_flux(pair), from)
    }

    fn flux_rate(&self, pair: usize, position: &f64) -> Result<f64, DiscretizeError> {
        let surface = &self.surface;
        match &self.pairs[pair] {
            CutPair::Aligned(pair) => Ok(pair.strip_exchange(surface.axis, position)?),
            CutPair::Polygon { other, .. } => Ok(surface.strip_exchange(other, *position)),
            CutPair::Occluded { other, past, .. } => {
                Ok(surface.strip_exchange_past(other, past, *position)?)
            }
        }
    }

    fn share(&self, [from, to]: &[f64; 2]) -> f64 {
        if self.surface.rectangle.is_some() {
            to - from
        } else {
            self.surface.lines.share(*from, *to)
        }
    }

    fn share_rate(&self, position: &f64) -> f64 {
        if self.surface.rectangle.is_some() {
            1.0
        } else {
            self.surface.lines.share_rate(*position)
        }
    }
}
