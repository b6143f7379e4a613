//! Singular points beside a range of integration, and rules on its parts.

use crate::reference::fixed_float::FixedFloat;
use crate::reference::fixed_float::gauss::gauss_rule;

/// A singular point: along the range, and off it.
pub(super) type Singularity<const N: usize> = [FixedFloat<N>; 2];

/// The zeros of `(p + kU)² + (U + q)² + h²`.
pub(super) fn meeting<const N: usize>(
    p: FixedFloat<N>,
    k: FixedFloat<N>,
    q: FixedFloat<N>,
    h: FixedFloat<N>,
) -> Singularity<N> {
    let norm = FixedFloat::new(1.0) + k.square();
    let off = ((p - k * q).square() + norm * h.square()).sqrt();
    [-(p * k + q) / norm, off / norm]
}

/// A singularity from the start of a range, in units of its signed length.
pub(super) fn seen_from<const N: usize>(
    [at, off]: &Singularity<N>,
    start: FixedFloat<N>,
    length: FixedFloat<N>,
) -> (f64, f64) {
    let scale = -length.exponent();
    let step = length.scaled(scale).to_f64();
    (
        (*at - start).scaled(scale).to_f64() / step,
        off.scaled(scale).to_f64() / step.abs(),
    )
}

/// Nodes and weights of a rule on a part of `start + [0, length]`, weights positive.
pub(super) fn nodes<const N: usize>(
    start: FixedFloat<N>,
    length: FixedFloat<N>,
    ends: [f64; 2],
    order: usize,
) -> Vec<(FixedFloat<N>, FixedFloat<N>)> {
    let half = (FixedFloat::new(ends[1]) - FixedFloat::new(ends[0])).scaled(-1) * length;
    let middle = start + (FixedFloat::new(ends[0]) + FixedFloat::new(ends[1])).scaled(-1) * length;
    let rule = gauss_rule::<N>(order);
    let scale = half.abs();
    rule.iter()
        .map(|(x, weight)| (middle + half * *x, *weight * scale))
        .collect()
}
