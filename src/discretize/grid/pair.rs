//! Two cells on opposite or adjacent faces of a box, and their exchange area.

use super::axis::{Depth, Relation};
use crate::discretize::error::DiscretizeError;
use crate::form_factor::{EdgeSlopes, ExchangeArea, Layout};
use crate::numeric::Scalar;

/// A pair of cells that stands for all that exchange the same.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CellPair<'g, S> {
    pub faces: Faces<'g, S>,
    /// The number of such ordered pairs in the whole box.
    pub count: f64,
}

/// The faces that two cells lie on.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Faces<'g, S> {
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
    pub(crate) fn areas(&self) -> S {
        self.layout().areas()
    }

    /// The exchange area in closed form.
    pub(crate) fn exchange(&self) -> Result<S, DiscretizeError> {
        Ok(self.layout().closed_form()?.certain()?)
    }

    fn layout(&self) -> Layout<'_, S> {
        match &self.faces {
            Faces::Opposite { along, distance } => Layout::Parallel {
                spans: along.map(|relation| relation.spans.each_ref()),
                distance,
            },
            Faces::Adjacent { depths, along } => Layout::Perpendicular {
                depths: depths.map(|depth| &depth.span),
                widths: along.spans.each_ref(),
                offsets: &along.offsets,
            },
        }
    }

    /// The derivatives of the exchange area by the places of the edges.
    pub(crate) fn slopes(&self) -> EdgeSlopes<S> {
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
    pub(crate) fn moves(&self) -> [&[(usize, S)]; 8] {
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
    pub(crate) fn exchange_area(
        &self,
        product: f64,
        allowed: f64,
    ) -> Result<ExchangeArea, DiscretizeError> {
        Ok(self.layout().exchange_area(product, allowed)?)
    }
}
