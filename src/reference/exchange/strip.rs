//! The inner integral over a strip, at one place of the outer.
//!
//! ```text
//!   u = foot + h (w − 1/w)/2,   c = h (w + 1/w)/2,   du = c dw/w
//! ```
//!
//! makes c² = (u − foot)² + h² a square, and spreads the peak at the foot however near the polygons
//! are.

use super::panels::{Fineness, panels};
use super::section::{Section, Slab};
use super::singularities::{Singularity, meeting, nodes, seen_from};
use crate::reference::fixed_float::FixedFloat;
use std::f64::consts::PI;

/// The demands on a pass.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pass {
    /// Absolute error that is of no account, in the units of the pair.
    pub allowed: f64,
    pub fineness: Fineness,
}

/// The inner integral at one v.
pub(super) struct Strip<'s, const N: usize> {
    pub(super) section: &'s Section<N>,
    pub(super) slab: &'s Slab<N>,
    pub(super) foot: FixedFloat<N>,
    pub(super) height: FixedFloat<N>,
    /// The t of the outer lines, and whether each is an upper end.
    pub(super) ends: Vec<(FixedFloat<N>, bool)>,
    pub(super) extent: f64,
}

impl<const N: usize> Strip<'_, N> {
    /// The integral by rules in u or in w, whichever is smoother.
    pub(super) fn integral(&self, pass: &Pass) -> FixedFloat<N> {
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
