//! Two cells on opposite or adjacent faces of a box, and their exchange area.

use super::error::DiscretizeError;
use super::grid_axis::{Depth, Relation};
use crate::form_factor::{
    EdgeSlopes, Exchange, ExchangeArea, Sides, exchange_by_rules, parallel, perpendicular,
};
use crate::geometry::{Offsets, Span};
use crate::numeric::{DoubleDouble, SQUARED_EPSILON, Scalar, tolerance};

/// A pair of cells that stands for all that exchange the same.
#[derive(Debug, Clone, Copy)]
pub(super) struct CellPair<'g, S> {
    pub faces: Faces<'g, S>,
    /// The number of such ordered pairs in the whole box.
    pub count: f64,
}

/// The faces that two cells lie on.
#[derive(Debug, Clone, Copy)]
pub(super) enum Faces<'g, S> {
    /// Opposite faces, with two common axes.
    Opposite {
        along: [&'g Relation<S>; 2],
        distance: &'g S,
    },
    /// Adjacent faces: each cell has a depth over the plane of the other, and one axis is common.
    Adjacent {
        depths: [&'g Depth<S>; 2],
        along: &'g Relation<S>,
    },
}

impl<S: Scalar> CellPair<'_, S> {
    /// The product of both areas.
    pub(super) fn areas(&self) -> S {
        let product = |relation: &Relation<S>| {
            relation.spans[0].length().clone() * relation.spans[1].length()
        };
        match &self.faces {
            Faces::Opposite { along, .. } => product(along[0]) * &product(along[1]),
            Faces::Adjacent { depths, along } => {
                let [first, second] = depths.map(|depth| depth.span.length());
                product(along) * first * second
            }
        }
    }

    /// The exchange area in closed form.
    pub(super) fn exchange(&self) -> Result<S, DiscretizeError> {
        Ok(self.closed_form()?.certain()?)
    }

    fn closed_form(&self) -> Result<Exchange<S>, DiscretizeError> {
        Ok(match &self.faces {
            Faces::Opposite { along, distance } => {
                let [first, second] = [0, 1].map(|cell| along.map(|r| r.spans[cell].clone()));
                parallel::exchange_area(&first, &second, distance)?
            }
            Faces::Adjacent { depths, along } => {
                let spans = depths.map(|depth| &depth.span);
                perpendicular::exchange_area_at(spans, &along.offsets)
            }
        })
    }

    /// The derivatives of the exchange area by the places of the edges.
    pub(super) fn slopes(&self) -> EdgeSlopes<S> {
        match &self.faces {
            Faces::Opposite { along, distance } => {
                EdgeSlopes::parallel(along.map(|relation| &relation.offsets), distance)
            }
            Faces::Adjacent { depths, along } => {
                let ends = depths.map(|depth| [depth.span.lower(), depth.span.upper()]);
                EdgeSlopes::perpendicular(ends, &along.offsets)
            }
        }
    }

    /// The rates at which these places move with the free lines.
    pub(super) fn moves(&self) -> [&[(usize, S)]; 8] {
        let all: [&Vec<(usize, S)>; 8] = match &self.faces {
            Faces::Opposite { along: [u, v], .. } => {
                let [a, b, c, d] = u.moves.each_ref();
                let [e, f, g, h] = v.moves.each_ref();
                [a, b, c, d, e, f, g, h]
            }
            Faces::Adjacent {
                depths: [x, z],
                along,
            } => {
                let ([a, b], [c, d]) = (x.moves.each_ref(), z.moves.each_ref());
                let [e, f, g, h] = along.moves.each_ref();
                [a, b, c, d, e, f, g, h]
            }
        };
        all.map(Vec::as_slice)
    }
}

impl CellPair<'_, f64> {
    /// The exchange area by the cheapest route whose bound is within `allowed` of it and `product`,
    /// that of independent cells, else by the one with the least bound.
    ///
    /// The routes are rules along the sides of far cells, the closed form, and the closed form in
    /// double-double.
    pub(super) fn exchange_area(
        &self,
        product: f64,
        allowed: f64,
    ) -> Result<ExchangeArea, DiscretizeError> {
        let by_rules = if self.is_far() {
            exchange_by_rules(&self.sides(), allowed)
        } else {
            None
        };
        let found = match by_rules {
            Some(found) => found,
            None => self.closed_form()?.in_range(1.0)?,
        };
        if found.error_bound <= allowed * (found.value.abs() + product) {
            return Ok(found);
        }
        let precise = self.precise()?;
        Ok(if precise.error_bound < found.error_bound {
            precise
        } else {
            found
        })
    }

    /// Whether the cells are farther apart than long: nearer ones would take too many points.
    fn is_far(&self) -> bool {
        let gap = |spans: &[Span; 2]| {
            let [a, b] = spans;
            let gap = (b.lower() - a.upper()).max(a.lower() - b.upper()).max(0.0);
            (gap * gap, a.length().max(*b.length()))
        };
        let (square, longest) = match &self.faces {
            Faces::Opposite { along, distance } => {
                let [(u, a), (v, b)] = along.map(|relation| gap(&relation.spans));
                (u + v + *distance * *distance, a.max(b))
            }
            Faces::Adjacent { depths, along } => {
                let (v, longest) = gap(&along.spans);
                let [x, z] = depths.map(|depth| &depth.span);
                let square = v + x.lower() * x.lower() + z.lower() * z.lower();
                (square, longest.max(*x.length()).max(*z.length()))
            }
        };
        square > longest * longest
    }

    fn sides(&self) -> Sides<'_> {
        match &self.faces {
            Faces::Opposite { along, distance } => Sides::Parallel {
                sides: along.map(|relation| relation.spans.each_ref()),
                distance: **distance,
            },
            Faces::Adjacent { depths, along } => Sides::Perpendicular {
                depths: depths.map(|depth| &depth.span),
                widths: along.spans.each_ref(),
            },
        }
    }

    fn precise(&self) -> Result<ExchangeArea, DiscretizeError> {
        let lifted = |span: &Span| span.lifted(&DoubleDouble::from(0.0));
        let exchange = match &self.faces {
            Faces::Opposite { along, distance } => {
                let [first, second] = [0, 1].map(|cell| along.map(|r| lifted(&r.spans[cell])));
                parallel::exchange_area(&first, &second, &DoubleDouble::from(**distance))?
            }
            Faces::Adjacent { depths, along } => {
                let [x, z] = depths.map(|depth| lifted(&depth.span));
                let [first, second] = along.spans.each_ref().map(lifted);
                perpendicular::exchange_area_at([&x, &z], &Offsets::between(&first, &second))
            }
        };
        let cancelled = DOUBLE_DOUBLE_TERMS * SQUARED_EPSILON * exchange.magnitude.to_f64();
        let value = exchange.value.to_f64();
        Ok(ExchangeArea {
            value,
            error_bound: cancelled + f64::EPSILON * value.abs(),
        })
    }
}

/// The factor of ε² in the bound of a closed form in double-double: (a) an operation is within 64
/// ε² where one of `f64` is within ε, and each term takes as many as
/// [`RECTANGLE_TERMS`](tolerance::RECTANGLE_TERMS) counts.
const DOUBLE_DOUBLE_TERMS: f64 = 64.0 * tolerance::RECTANGLE_TERMS;
