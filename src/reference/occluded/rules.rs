//! Rules over a convex cell, each with the difference to the one before.
//!
//! ```text
//!   triangle (V, M, C): x(r, s) = V + r [(1−s)(M−V) + s(C−V)],   dA = 2 A r dr ds
//! ```
//!
//! V is a corner of the cell, M the middle of a side at it, C the cell's centroid: what is singular
//! at corners and sides of the cell is singular at r = 0 and s = 0.

use crate::numeric::{CompensatedSum, GaussLegendre, real};
use glam::DVec2;
use std::f64::consts::FRAC_PI_2;

/// Points of the Gauss rules in both directions, the first cheap.
const GAUSS: [usize; 3] = [4, 8, 16];
/// Steps of the double-exponential rules.
const STEPS: [f64; 3] = [0.5, 0.25, 0.125];
/// Beyond this the weights are below 1e-17.
const LAST: f64 = 3.2;

/// A part of an integral, with the difference of its last two rules.
#[derive(Debug, Clone, Copy)]
pub(super) struct Part {
    pub value: f64,
    pub error: f64,
}

/// Twice the signed area, halved.
pub(super) fn area(cell: &[DVec2]) -> f64 {
    let next = cell.iter().cycle().skip(1);
    let doubled = cell.iter().zip(next);
    0.5 * doubled
        .map(|(a, b)| (*a - cell[0]).perp_dot(*b - cell[0]))
        .sum::<f64>()
        .abs()
}

/// The integral of a function over a convex cell, until two rules agree or there is none better.
pub(super) fn integral<E>(
    cell: &[DVec2],
    function: &impl Fn(DVec2) -> Result<f64, E>,
    tolerance: f64,
) -> Result<Part, E> {
    let middle = cell.iter().sum::<DVec2>() / real(cell.len());
    let next = cell.iter().cycle().skip(1);
    let (mut value, mut error) = (CompensatedSum::default(), 0.0);
    let share = tolerance / real(2 * cell.len());
    for (a, b) in cell.iter().zip(next) {
        let half = a.midpoint(*b);
        for corner in [a, b] {
            let part = over_triangle([*corner, half, middle], function, share)?;
            value.add(part.value);
            error += part.error;
        }
    }
    Ok(Part {
        value: value.total(),
        error,
    })
}

fn over_triangle<E>(
    triangle: [DVec2; 3],
    function: &impl Fn(DVec2) -> Result<f64, E>,
    tolerance: f64,
) -> Result<Part, E> {
    let mut best = Part {
        value: 0.0,
        error: f64::INFINITY,
    };
    let gauss = GAUSS.iter().map(|points| gauss(*points));
    let graded = STEPS.iter().map(|step| double_exponential(*step));
    let mut before: Option<f64> = None;
    for (place, rule) in gauss.chain(graded).enumerate() {
        let value = product(triangle, &rule, function)?;
        // the first of its kind is compared with none
        if let Some(before) = before.filter(|_| place != GAUSS.len()) {
            let error = (value - before).abs();
            if error <= best.error || place > GAUSS.len() {
                best = Part { value, error };
            }
            if error <= tolerance {
                return Ok(best);
            }
        }
        before = Some(value);
    }
    Ok(best)
}

type Rule = Vec<[f64; 2]>;

fn gauss(points: usize) -> Rule {
    let rule = GaussLegendre::with(points);
    let nodes = rule.nodes.iter().zip(&rule.weights);
    nodes.map(|(x, w)| [0.5 * (1.0 + x), 0.5 * w]).collect()
}

/// `x = 1/(1 + exp(−π sinh t))`, `dx/dt = π cosh t · x (1 − x)`.
fn double_exponential(step: f64) -> Rule {
    let mut rule = Vec::new();
    let mut k = 0.0;
    while k * step <= LAST {
        for t in if k > 0.0 {
            vec![-k * step, k * step]
        } else {
            vec![0.0]
        } {
            let up = (2.0 * FRAC_PI_2 * t.sinh()).exp();
            let (x, rest) = (up / (1.0 + up), 1.0 / (1.0 + up));
            rule.push([x, step * 2.0 * FRAC_PI_2 * t.cosh() * x * rest]);
        }
        k += 1.0;
    }
    rule
}

fn product<E>(
    [corner, side, middle]: [DVec2; 3],
    rule: &Rule,
    function: &impl Fn(DVec2) -> Result<f64, E>,
) -> Result<f64, E> {
    let [along, aside] = [side - corner, middle - corner];
    let mut sum = CompensatedSum::default();
    for [r, weight_r] in rule {
        for [s, weight_s] in rule {
            let at = corner + *r * ((1.0 - s) * along + *s * aside);
            sum.add(weight_r * weight_s * r * function(at)?);
        }
    }
    Ok(sum.total() * along.perp_dot(aside).abs())
}
