//! The double contour integral in double-double arithmetic, for pairs whose terms cancel in `f64`.

use super::coplanar::{Relation, Rounding, coplanar, relation};
use super::edge::{Edge, PairIntegral, Precision};
use super::panels::{Panel, panels};
use crate::form_factor::ExchangeArea;
use crate::geometry::Vector;
use crate::numeric::{DoubleDouble, GaussLegendre, SQUARED_EPSILON, Scalar, vectorised};
use smallvec::SmallVec;
use std::f64::consts::TAU;

/// The contour integral to 106 bits, from corners known that well.
pub(crate) fn precise_contour(
    outlines: [&[Vector<DoubleDouble>]; 2],
    wanted: f64,
) -> Option<ExchangeArea> {
    let mut exchange = None;
    vectorised(
        #[inline(always)]
        || exchange = precise_sum(outlines, wanted),
    );
    exchange
}

/// Panels are this far from what is singular, as a sum of half-axes: potentials cost more than
/// panels.
const PANEL_DISTANCE: f64 = 1.5;

type Edges = SmallVec<[Edge<DoubleDouble>; 4]>;

#[inline(always)]
fn edges(corners: &[Vector<DoubleDouble>]) -> Edges {
    let n = corners.len();
    let mut edges = Edges::with_capacity(n);
    for i in 0..n {
        edges.push(Edge::new(corners[i], corners[(i + 1) % n]));
    }
    edges
}

#[inline(always)]
fn precise_sum([p, q]: [&[Vector<DoubleDouble>]; 2], wanted: f64) -> Option<ExchangeArea> {
    let mut reach = 0.0;
    for x in p {
        for y in q {
            reach = f64::max(reach, x.minus(*y).length().to_f64());
        }
    }
    // functions are within 64 ε², where the double forms count on 2 ε
    let epsilon = 32.0 * SQUARED_EPSILON;
    let precision = Precision::new(0.0, reach, DoubleDouble::from(1.0), epsilon);
    let (a_edges, b_edges) = (edges(p), edges(q));
    let perimeter = |edges: &Edges| edges.iter().map(|e| e.length.to_f64()).sum::<f64>();
    let per_length = wanted * TAU / (perimeter(&a_edges) * perimeter(&b_edges));
    // corners may come from a clip, and edges be short beside their coordinates
    let coordinates = [p, q]
        .into_iter()
        .flatten()
        .flat_map(|corner| corner.0.map(|x| x.to_f64().abs()));
    let rounding = Rounding::new(SQUARED_EPSILON, 1e6, coordinates.fold(reach, f64::max));
    let (mut sum, mut error) = (DoubleDouble::from(0.0), 0.0);
    for a in &a_edges {
        for b in &b_edges {
            let cosine = a.direction.dot(b.direction);
            let potential = |edge: &Edge<_>, point| edge.potential(point, precision.inverse_square);
            let pair = match relation([a, b], rounding) {
                Relation::Skew => skew([a, b], per_length, precision)?,
                Relation::Coplanar(relation) => {
                    let at_a = [potential(b, a.ends[0]), potential(b, a.ends[1])];
                    let at_b = [potential(a, b.ends[0]), potential(a, b.ends[1])];
                    coplanar([a, b], relation, at_a, at_b, precision)
                }
            };
            sum = sum + cosine * pair.value;
            error +=
                cosine.to_f64().abs() * pair.error + precision.epsilon * pair.value.to_f64().abs();
        }
    }
    Some(ExchangeArea {
        value: sum.to_f64() / TAU,
        error: error / TAU + f64::EPSILON * sum.to_f64().abs(),
    })
}

/// Skew edges: Gauss rules on the panels of the shorter one; `None` if they do not settle.
#[inline(always)]
pub(crate) fn skew<S: Scalar + Copy>(
    [a, b]: [&Edge<S>; 2],
    wanted: f64,
    precision: Precision<S>,
) -> Option<PairIntegral<S>> {
    let (outer, inner) = if a.length <= b.length { (a, b) } else { (b, a) };
    let number = |x: f64| a.length.constant(x);
    let (mut value, mut error) = (number(0.0), 0.0);
    panels(
        outer,
        inner,
        wanted,
        precision.epsilon,
        PANEL_DISTANCE,
        #[inline(always)]
        |panel: Panel<S>| {
            let half = number(panel.half);
            let mut sum = number(0.0);
            for [x, weight] in &GaussLegendre::with(panel.points).precise {
                let t = number(x.high()) + number(x.low());
                let weight = number(weight.high()) + number(weight.low());
                let point = outer.at(panel.middle + half * t);
                sum = sum + weight * inner.potential(point, precision.inverse_square);
            }
            value = value + sum * half * outer.length;
            error += panel.error;
        },
    )?;
    let mut reach = 0.0;
    for x in a.ends {
        for y in b.ends {
            reach = f64::max(reach, x.minus(y).length().to_f64());
        }
    }
    let (outer, inner) = (outer.length.to_f64(), inner.length.to_f64());
    let error = outer * (error * inner + precision.of_any_potential(reach, inner));
    Some(PairIntegral { value, error })
}
