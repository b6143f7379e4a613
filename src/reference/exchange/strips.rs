//! The twofold integral over pairs of strips.
//!
//! ```text
//!   A F = 1/π ∫ dv h(v) ∫ du k(u) ∫∫ ds dt / (c² + (s − t)²)²,   c² = (u − foot(v))² + h(v)²
//!   ∫∫ ds dt / (c² + (s−t)²)² = Σ ± G(s_i − t_j),                G(z) = z·atan(z/c)/(2c³)
//! ```
//!
//! with h and k the heights over the other's plane. For the inner integral c² is made a square:
//!
//! ```text
//!   u = foot + h (w − 1/w)/2,   c = h (w + 1/w)/2,   du = c dw/w
//! ```
//!
//! which spreads the peak at the foot however near the polygons are.

use super::panels::{Fineness, panels};
use super::section::{Line, Section, Slab};
use crate::reference::fixed_float::FixedFloat;
use crate::reference::fixed_float::gauss::gauss_rule;
use std::f64::consts::PI;

/// The demands on a pass.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pass {
    /// Absolute error that is of no account, in the units of the pair.
    pub allowed: f64,
    pub fineness: Fineness,
}

/// A singular point: along the range, and off it.
type Singularity<const N: usize> = [FixedFloat<N>; 2];

/// The zeros of `(p + kU)² + (U + q)² + h²`.
fn meeting<const N: usize>(
    p: FixedFloat<N>,
    k: FixedFloat<N>,
    q: FixedFloat<N>,
    h: FixedFloat<N>,
) -> Singularity<N> {
    let norm = FixedFloat::new(1.0) + k.square();
    let off = ((p - k * q).square() + norm * h.square()).sqrt();
    [-(p * k + q) / norm, off / norm]
}

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

/// The inner integral at one v.
struct Strip<'s, const N: usize> {
    section: &'s Section<N>,
    slab: &'s Slab<N>,
    foot: FixedFloat<N>,
    height: FixedFloat<N>,
    /// The t of the outer lines, and whether each is an upper end.
    ends: Vec<(FixedFloat<N>, bool)>,
    extent: f64,
}

impl<const N: usize> Strip<'_, N> {
    fn integral(&self, pass: &Pass) -> FixedFloat<N> {
        let [lower, upper] = self.slab.ends.map(|u| (u - self.foot) / self.height);
        let near = lower.abs().to_f64().min(upper.abs().to_f64());
        let has_foot = lower.is_negative() && upper.is_positive();
        let near = if has_foot { 0.0 } else { near };
        let width = (upper - lower).to_f64();
        if width < 0.5 * near.hypot(1.0) {
            self.plain(pass)
        } else {
            self.spread([lower, upper], pass)
        }
    }

    fn singularities(&self) -> Vec<Singularity<N>> {
        let mut found = vec![[self.foot, self.height]];
        for line in &self.slab.lines {
            for (t, _) in &self.ends {
                let q = line.from - self.foot;
                let [along, off] = meeting(line.at - *t, line.slope, q, self.height);
                found.push([line.from + along, off]);
            }
        }
        found
    }

    /// Gauss rules in u, where c hardly changes.
    fn plain(&self, pass: &Pass) -> FixedFloat<N> {
        let singular = self.singularities();
        let [start, end] = self.slab.ends;
        let half = (end - start).scaled(-1);
        let mut sum = FixedFloat::ZERO;
        for (start, length) in [(start, half), (end, -half)] {
            let seen: Vec<_> = singular
                .iter()
                .map(|z| seen_from(z, start, length))
                .collect();
            let (offset, step) = ((start - self.foot).to_f64(), length.to_f64());
            let size = |a: f64, b: f64| self.size(offset + step * a, offset + step * b);
            for panel in panels(&seen, size, pass.allowed, pass.fineness) {
                for (u, weight) in nodes::<N>(start, length, panel.ends, panel.order) {
                    let c = ((u - self.foot).square() + self.height.square()).sqrt();
                    sum = sum + weight * self.integrand(u, c) / (c.square() * c);
                }
            }
        }
        (sum * self.height).scaled(-1)
    }

    /// Gauss rules in w, between the values of (u − foot)/h.
    fn spread(&self, ends: [FixedFloat<N>; 2], pass: &Pass) -> FixedFloat<N> {
        let one = FixedFloat::new(1.0);
        let to_w = |x: FixedFloat<N>| {
            let root = (x.square() + one).sqrt();
            if x.is_negative() {
                (root - x).reciprocal()
            } else {
                x + root
            }
        };
        let exact = ends.map(to_w);
        let [first, last] = exact.map(|w| w.to_f64());
        let h = self.height.to_f64();
        let singular: Vec<_> = self
            .singularities()
            .iter()
            .map(|z| spread_out((z[0] - self.foot).to_f64() / h, z[1].to_f64() / h))
            .chain([(0.0, 0.0)])
            .collect();
        // breaks at the foot, below singularities and by powers of 4
        let mut breaks: Vec<f64> = singular.iter().map(|z| z.0).chain([1.0]).collect();
        let mut power = first.max(last.recip()).max(1e-40) * 4.0;
        while power < last {
            breaks.push(power);
            power *= 4.0;
        }
        breaks.retain(|w| first * (1.0 + 1e-3) < *w && *w < last * (1.0 - 1e-3));
        breaks.sort_by(f64::total_cmp);
        breaks.dedup_by(|a, b| *a <= *b * (1.0 + 1e-6));
        let mut edges = vec![exact[0]];
        edges.extend(breaks.into_iter().map(FixedFloat::new));
        edges.push(exact[1]);
        let mut sum = FixedFloat::ZERO;
        for ends in edges.windows(2) {
            sum = sum + self.spread_part(ends[0], ends[1] - ends[0], &singular, pass);
        }
        (sum * self.height).scaled(-1)
    }

    /// The inner integral from w = `start` on.
    fn spread_part(
        &self,
        start: FixedFloat<N>,
        length: FixedFloat<N>,
        singular: &[(f64, f64)],
        pass: &Pass,
    ) -> FixedFloat<N> {
        let (offset, step) = (start.to_f64(), length.to_f64());
        let h = self.height.to_f64();
        let seen: Vec<_> = singular
            .iter()
            .map(|(at, off)| ((at - offset) / step, off / step))
            .collect();
        let distance = |x: f64| {
            let w = offset + step * x;
            0.5 * h * (w - w.recip())
        };
        let size = |a: f64, b: f64| self.size(distance(a), distance(b));
        let mut sum = FixedFloat::ZERO;
        for panel in panels(&seen, size, pass.allowed, pass.fineness) {
            for (w, weight) in nodes::<N>(start, length, panel.ends, panel.order) {
                let inverse = w.reciprocal();
                let u = self.foot + (self.height * (w - inverse)).scaled(-1);
                let c = (self.height * (w + inverse)).scaled(-1);
                sum = sum + weight * inverse * self.integrand(u, c) / c.square();
            }
        }
        sum
    }

    /// `k(u) Σ ± z·atan(z/c)`.
    fn integrand(&self, u: FixedFloat<N>, c: FixedFloat<N>) -> FixedFloat<N> {
        let mut sum = FixedFloat::ZERO;
        for line in &self.slab.lines {
            let s = line.value(u);
            for (t, is_upper) in &self.ends {
                let z = s - *t;
                let term = z * FixedFloat::atan_of_ratio(z, c);
                sum = if line.is_upper == *is_upper {
                    sum - term
                } else {
                    sum + term
                };
            }
        }
        sum * self.section.facing.at(u)
    }

    /// An upper bound on what the part between two distances from the foot adds.
    fn size(&self, from: f64, to: f64) -> f64 {
        let (from, to) = if from < to { (from, to) } else { (to, from) };
        let gap = from.max(-to).max(0.0);
        let h = self.height.to_f64();
        let c = gap.hypot(h);
        let u = [from, to].map(|x| self.foot + FixedFloat::new(x));
        let extent = u.map(|u| self.slab.extent(u).to_f64().abs());
        let extent = extent[0].max(extent[1]);
        let facing = u.map(|u| self.section.facing.at(u).to_f64().abs());
        let facing = facing[0].max(facing[1]);
        let (short, long) = (extent.min(self.extent), extent.max(self.extent));
        (to - from) * h * facing * short / c.powi(3) * (long / c).min(0.5 * PI)
    }
}

/// A singularity from the start of a range, in units of its signed length.
fn seen_from<const N: usize>(
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

/// `w = x + √(x² + 1)` of a complex x, as real and imaginary part.
fn spread_out(re: f64, im: f64) -> (f64, f64) {
    // √(x² + 1), real part ≥ 0
    let (a, b) = (re * re - im * im + 1.0, 2.0 * re * im);
    let size = a.hypot(b);
    let (root_re, root_im) = if a >= 0.0 {
        let r = (0.5 * (size + a)).sqrt();
        (r, if r > 0.0 { 0.5 * b / r } else { 0.0 })
    } else {
        let i = (0.5 * (size - a)).sqrt();
        (0.5 * b.abs() / i, i.copysign(b))
    };
    if re >= 0.0 {
        (re + root_re, (im + root_im).abs())
    } else {
        let (x, y) = (root_re - re, root_im - im);
        let norm = x * x + y * y;
        (x / norm, (y / norm).abs())
    }
}

/// Nodes and weights of a rule on a part of `start + [0, length]`, weights positive.
fn nodes<const N: usize>(
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
