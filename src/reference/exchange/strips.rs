//! The twofold integral over pairs of strips.
//!
//! ```text
//!   A F = 1/π ∫ dv h(v) ∫ du k(u) ∫∫ ds dt / (c² + (s − t)²)²,   c² = (u − foot(v))² + h(v)²
//!   ∫∫ ds dt / (c² + (s−t)²)² = Σ ± G(s_i − t_j),                G(z) = z·atan(z/c)/(2c³)
//! ```
//!
//! with h and k the heights over the other's plane. Here is the outer integral, over v; `strip` has
//! the inner one.

use super::panels::panels;
use super::section::{Line, Section, Slab};
use super::singularities::{Singularity, meeting, nodes, seen_from};
use super::strip::{Pass, Strip};
use crate::reference::fixed_float::FixedFloat;
use std::f64::consts::PI;

impl<const N: usize> Section<N> {
    /// The exchange area by one pass.
    pub(crate) fn integral(&self, pass: &Pass) -> FixedFloat<N> {
        let mut sum = FixedFloat::ZERO;
        for outer in &self.outer {
            for inner in &self.inner {
                sum = sum + self.slab_pair(inner, outer, pass);
            }
        }
        sum / FixedFloat::pi()
    }

    fn slab_pair(&self, inner: &Slab<N>, outer: &Slab<N>, pass: &Pass) -> FixedFloat<N> {
        let singular = self.outer_singularities(inner, outer);
        let mut breaks = vec![outer.ends[0], outer.ends[1]];
        let inside = singular.iter().map(|z| z[0]);
        breaks.extend(inside.filter(|at| outer.ends[0] < *at && *at < outer.ends[1]));
        breaks.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
        let least = (outer.ends[1] - outer.ends[0]).scaled(-60);
        breaks.dedup_by(|a, b| *a - *b < least);
        let last = breaks.len() - 1;
        breaks[last] = outer.ends[1];
        let mut sum = FixedFloat::ZERO;
        for pair in breaks.windows(2) {
            let half = (pair[1] - pair[0]).scaled(-1);
            for (start, length) in [(pair[0], half), (pair[1], -half)] {
                sum = sum + self.outer_half(inner, outer, [start, length], &singular, pass);
            }
        }
        sum
    }

    /// The outer integral from `start` on for a signed `length`.
    fn outer_half(
        &self,
        inner: &Slab<N>,
        outer: &Slab<N>,
        [start, length]: [FixedFloat<N>; 2],
        singular: &[Singularity<N>],
        pass: &Pass,
    ) -> FixedFloat<N> {
        let seen: Vec<_> = singular
            .iter()
            .map(|z| seen_from(z, start, length))
            .collect();
        let size = self.outer_size(inner, outer, start, length);
        let mut sum = FixedFloat::ZERO;
        for panel in panels(&seen, &size, pass.allowed, pass.fineness) {
            let width = length.abs().to_f64() * (panel.ends[1] - panel.ends[0]);
            let inner_pass = Pass {
                allowed: PI * pass.allowed / width,
                ..*pass
            };
            for (v, weight) in nodes::<N>(start, length, panel.ends, panel.order) {
                sum = sum + weight * self.inner(inner, outer, v, &inner_pass);
            }
        }
        sum
    }

    /// An upper bound on what a part of the outer range adds to the exchange area.
    fn outer_size(
        &self,
        inner: &Slab<N>,
        outer: &Slab<N>,
        start: FixedFloat<N>,
        length: FixedFloat<N>,
    ) -> impl Fn(f64, f64) -> f64 {
        let ends = [start, start + length];
        let extents = ends.map(|v| outer.extent(v).to_f64().abs());
        let heights = ends.map(|v| self.height.at(v).to_f64().max(0.0));
        let facing = inner.ends.map(|u| self.facing.at(u).to_f64().max(0.0));
        let facing = facing[0].max(facing[1]);
        let feet = ends.map(|v| self.foot.at(v));
        // distance of the foot from the range of u, at both ends
        let beside = feet.map(|foot| {
            let [below, above] = [inner.ends[0] - foot, foot - inner.ends[1]].map(|x| x.to_f64());
            below.max(above)
        });
        let inner_extents = inner.ends.map(|u| inner.extent(u).to_f64().abs());
        let width = (inner.ends[1] - inner.ends[0]).to_f64();
        let inner_area = width * inner_extents[0].max(inner_extents[1]);
        let full = length.abs().to_f64();
        let mix = |pair: [f64; 2], x: f64| pair[0] * (1.0 - x) + pair[1] * x;
        move |lower, upper| {
            let extent = mix(extents, lower).max(mix(extents, upper));
            let [low, high] = [mix(heights, lower), mix(heights, upper)];
            let gap = mix(beside, lower).min(mix(beside, upper)).max(0.0);
            let distance = gap.hypot(low.min(high));
            let kernel = low.max(high) * facing * inner_area / (PI * distance.powi(4));
            let seen = if kernel < 1.0 { kernel } else { 1.0 };
            full * (upper - lower) * extent * seen
        }
    }

    /// The places where the inner integral is singular as a function of v.
    fn outer_singularities(&self, inner: &Slab<N>, outer: &Slab<N>) -> Vec<Singularity<N>> {
        let mut found = Vec::new();
        for u in inner.ends {
            // the outer line in the plane across d: foot and height of v against (u, 0)
            let x = self.foot.at_zero - u;
            let y = self.height.at_zero;
            let at = -(x * self.foot.slope + y * self.height.slope);
            let off = (x * self.height.slope - y * self.foot.slope).abs();
            found.push([at, off]);
            for line in &outer.lines {
                for end in &inner.lines {
                    let p = line.at - end.value(u);
                    let [along, off] = meeting(p, line.slope, line.from - at, off);
                    found.push([line.from + along, off]);
                }
            }
        }
        for line in &outer.lines {
            for end in &inner.lines {
                found.extend(self.crossing(inner, end, line));
            }
        }
        found
    }

    /// The place where the lines of two edges come closest, if that is beside the inner edge.
    fn crossing(&self, inner: &Slab<N>, end: &Line<N>, line: &Line<N>) -> Option<Singularity<N>> {
        let one = FixedFloat::new(1.0);
        // coordinates (along d, u, height over the inner plane)
        let e = [end.slope, one, FixedFloat::ZERO];
        let f = [line.slope, self.foot.slope, self.height.slope];
        let w = [
            line.at - end.at,
            self.foot.at(line.from) - end.from,
            self.height.at(line.from),
        ];
        let cross = |a: &[FixedFloat<N>; 3], b: &[FixedFloat<N>; 3]| -> [FixedFloat<N>; 3] {
            std::array::from_fn(|k| {
                let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                a[i] * b[j] - a[j] * b[i]
            })
        };
        let dot = |a: &[FixedFloat<N>; 3], b: &[FixedFloat<N>; 3]| {
            a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
        };
        let (fe, we) = (cross(&f, &e), cross(&w, &e));
        let (a, b, c) = (dot(&fe, &fe), dot(&fe, &we), dot(&we, &we));
        let scale = dot(&e, &e) * dot(&f, &f);
        if a < scale.scaled(-160) {
            return None;
        }
        let along = -b / a;
        let off = (a * c - b.square()).sqrt() / a;
        let meeting: [FixedFloat<N>; 3] = std::array::from_fn(|k| w[k] + f[k] * along);
        let u = end.from + dot(&meeting, &e) / dot(&e, &e);
        let margin = (inner.ends[1] - inner.ends[0]).scaled(-2) + off;
        let is_beside = inner.ends[0] - margin < u && u < inner.ends[1] + margin;
        is_beside.then_some([line.from + along, off])
    }

    /// `h ∫ du k(u) Σ ± G` at v.
    fn inner(
        &self,
        inner: &Slab<N>,
        outer: &Slab<N>,
        v: FixedFloat<N>,
        pass: &Pass,
    ) -> FixedFloat<N> {
        let strip = Strip {
            section: self,
            slab: inner,
            foot: self.foot.at(v),
            height: self.height.at(v),
            ends: outer
                .lines
                .iter()
                .map(|line| (line.value(v), line.is_upper))
                .collect(),
            extent: outer.extent(v).to_f64().abs(),
        };
        if !strip.height.is_positive() {
            return FixedFloat::ZERO;
        }
        strip.integral(pass)
    }
}
