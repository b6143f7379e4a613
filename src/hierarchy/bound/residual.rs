//! The residual of piecewise constant functions, bounded in the mean square over each piece.
//!
//! ```text
//!   f = e/R − b/R + K b = e/R − b/R + b₀ + Σ_j (b_j − b₀) F_xj      (closed; b₀ = 0 otherwise)
//!   Σ_j (b_j − b₀) F_xj = Σ_sources w φ(x)
//! ```
//!
//! On a piece each source is a quadratic function with a remainder
//! ([`Source::expanded`](super::sources::Source::expanded)). Those whose remainders together are
//! small are added up. For the others the piece is cut, and its parts begin anew with them. Where
//! that ends, they are somewhere in their range. So is at once, if that is small enough, a polygon
//! through whose plane the piece reaches: it is seen edge-on there.
//!
//! **Not covered**: rounding, as in [`edge`](super::edge).

use super::edge::Expanded;
use super::jet::Jet;
use super::piece::{Integrals, Piece};
use super::task::{Counted, DEEPEST, Doubtful, FUNCTIONS, Item, Measured, Open, Sums, Task};
use crate::numeric::real;
use std::array::from_fn;

impl Task<'_> {
    fn weights(&self, item: Item) -> [f64; FUNCTIONS] {
        let source = &self.view.sources[item.source];
        from_fn(|k| source.weight(self.values[k], self.references[k], item.sides))
    }

    /// The functions on a piece, where they are `constants` beside what is seen.
    pub(super) fn measured(
        &self,
        piece: &Piece,
        constants: [f64; FUNCTIONS],
    ) -> [Measured; FUNCTIONS] {
        let mut shares = vec![1.0; self.values[0].len()];
        for veiled in &self.view.veiled {
            shares[veiled.leaf] = 0.0;
        }
        let items = self.view.sources.iter().enumerate();
        let items = items.map(|(source, at)| Item {
            source,
            sides: at.sides(&shares),
        });
        let open = Open {
            items: items
                .filter(|item| item.sides.iter().any(|side| side.abs() > 0.0))
                .collect(),
            veiled: Doubtful::all(self.view),
        };
        let mut sums = Sums {
            counted: vec![Counted::default(); self.view.veiled.len()],
            ..Sums::default()
        };
        self.descend(piece, constants.map(Jet::constant), open, 0, &mut sums);
        self.mend(piece, &mut sums);
        from_fn(|k| {
            let doubt = &sums.doubts[k];
            // rounding may leave less than nothing
            let doubted = doubt.first.max(0.0);
            let doubts = doubt.second + doubted * doubted / piece.area;
            let squares = sums.squares[k].iter().chain([&doubts]);
            Measured {
                known: sums.known[k],
                rest: Integrals {
                    first: sums.magnitudes[k] + doubted,
                    second: squares.map(|square| square.sqrt()).sum::<f64>().powi(2),
                    ..Integrals::default()
                },
            }
        })
    }

    fn descend(
        &self,
        piece: &Piece,
        mut functions: [Jet; FUNCTIONS],
        mut open: Open,
        depth: usize,
        sums: &mut Sums,
    ) {
        self.unveil(piece, &mut open, sums);
        self.doubt(piece, &mut functions, &mut open.veiled, depth, sums);
        if depth > DEEPEST {
            self.end(piece, functions, &open.items, sums);
            return;
        }
        open.items = self.accept(piece, &mut functions, &open.items, depth, sums);
        if open.is_empty() {
            sums.add_known(piece, functions);
            return;
        }
        for part in piece.parts() {
            let moved = functions.map(|jet| jet.moved(part.centre - piece.centre));
            self.descend(&part, moved, open.clone(), depth + 1, sums);
        }
    }

    /// Adds the sources with small remainders to the functions, and gives back the others.
    fn accept(
        &self,
        piece: &Piece,
        functions: &mut [Jet; FUNCTIONS],
        items: &[Item],
        depth: usize,
        sums: &mut Sums,
    ) -> Vec<Item> {
        let mut rest = Vec::new();
        let mut large: Vec<(f64, Item, Expanded)> = Vec::new();
        let root_mean = (piece.inertia / piece.area).sqrt() * piece.radius * piece.radius;
        let allowed = 0.5f64.powi(i32::try_from(depth).unwrap_or(i32::MAX) + 1);
        let small = 0.5 * allowed / real(items.len());
        let (mut used, mut cubic, mut flat) = (0.0, [0.0; FUNCTIONS], [0.0; FUNCTIONS]);
        let mut add = |weights: [f64; FUNCTIONS], expanded: &Expanded| {
            for k in 0..FUNCTIONS {
                functions[k].add(weights[k], &expanded.jet);
                cubic[k] += weights[k].abs() * expanded.cubic;
                flat[k] += weights[k].abs() * expanded.flat;
            }
        };
        for item in items {
            let source = &self.view.sources[item.source];
            let Some(expanded) = source.expanded(piece, self.noise) else {
                rest.push(*item);
                continue;
            };
            let weights = self.weights(*item);
            let shares = weights.iter().zip(&self.allowed);
            let share: f64 = shares.map(|(weight, allowed)| weight.abs() / allowed).sum();
            let size = share * (expanded.cubic * root_mean + expanded.flat);
            if size <= small {
                used += size;
                add(weights, &expanded);
            } else {
                large.push((size, *item, expanded));
            }
        }
        large.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        for (size, item, expanded) in large {
            used += size;
            if used > allowed {
                rest.push(item);
            } else {
                add(self.weights(item), &expanded);
            }
        }
        for (k, (cubic, flat)) in cubic.into_iter().zip(flat).enumerate() {
            let largest = cubic * piece.radius * piece.radius;
            sums.magnitudes[k] += cubic * piece.radius * piece.inertia + flat * piece.area;
            sums.squares[k][depth] +=
                (largest * piece.inertia.sqrt() + flat * piece.area.sqrt()).powi(2);
        }
        rest
    }

    /// Adds a piece that is not cut any more, with the ranges of the sources that are left.
    fn end(&self, piece: &Piece, mut functions: [Jet; FUNCTIONS], items: &[Item], sums: &mut Sums) {
        let mut halves = [0.0; FUNCTIONS];
        for item in items {
            let [low, high] = self.view.sources[item.source].range(piece);
            for (k, weight) in self.weights(*item).into_iter().enumerate() {
                functions[k].value += 0.5 * (low + high) * weight;
                halves[k] += 0.5 * (high - low) * weight.abs();
            }
        }
        for (k, half) in halves.into_iter().enumerate() {
            sums.magnitudes[k] += half * piece.area;
            sums.squares[k][DEEPEST + 1] += half * half * piece.area;
        }
        sums.add_known(piece, functions);
    }
}
