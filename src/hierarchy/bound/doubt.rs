//! Leaves that are seen in part: somewhere in their range, but with their means over a piece.
//!
//! ```text
//!   0 ≤ F ≤ M       on a part of a piece, for a part of a leaf before which a plate may stand
//!   ∫ F = A F(piece → leaf)                                   the exchange area past the plates
//! ```
//!
//! F counts as M/2 ± M/2 there, and a constant over the piece is added so that the integral over it
//! is the exchange area. With the mean P ρ of a function over the piece, ρ what is left of the
//! leaves that are mended, and σ that of the others,
//!
//! ```text
//!   ‖ρ − P ρ + σ‖² = ‖(1 − P)(ρ + σ)‖² + ‖P σ‖² ≤ ‖ρ + σ‖² + (∫ |σ|)²/A
//! ```
//!
//! A mended leaf adds to the fluctuations of the residual alone, which are damped well; means over
//! cells spread, and cost most where little is absorbed.
//!
//! **Not covered**: rounding, as of [`edge`](super::edge).

use super::jet::Jet;
use super::piece::Piece;
use super::seen::Seen;
use super::sight::End;
use super::task::{Doubtful, FUNCTIONS, Item, Open, Sums, Task};
use crate::form_factor::Polygon;
use crate::geometry::Patch;
use crate::hierarchy::Visibility;
use glam::DVec3;
use std::array::from_fn;

/// The number of times that a piece is cut for leaves that are seen in part.
const CUTS: usize = 2;
/// The doubt in remainders that are allowed, up to which a leaf is not mended.
const LITTLE: f64 = 0.1;
/// The same, up to which a leaf is not looked at in parts.
const FAINT: f64 = 0.02;

impl Task<'_> {
    /// Finds out which leaves are seen from all of a piece, and which from nowhere.
    pub(super) fn unveil(&self, piece: &Piece, open: &mut Open, sums: &mut Sums) {
        if open.veiled.is_empty() {
            return;
        }
        let corners = self.lifted(piece);
        let items = &mut open.items;
        open.veiled.retain_mut(|doubtful| {
            let veiled = &self.view.veiled[doubtful.veiled];
            let plates = &doubtful.plates;
            let leaf = &self.views.leaves[veiled.leaf];
            let there = End::of(leaf.patch, &leaf.shape);
            match self.views.narrowed(self.view, &corners, there, plates) {
                Visibility::Hidden => false,
                Visibility::Past(plates) => {
                    let whole = &mut sums.counted[doubtful.veiled].plates;
                    if whole.is_empty() {
                        whole.clone_from(&plates);
                    }
                    doubtful.plates = plates;
                    true
                }
                Visibility::Clear => {
                    let sources = veiled.sources.iter();
                    items.extend(sources.map(|&(source, sides)| Item { source, sides }));
                    let seen = veiled.seen.expanded(piece, self.noise);
                    let [integrals] = piece.integrals(&[seen.jet]);
                    let counted = &mut sums.counted[doubtful.veiled];
                    counted.first += integrals.first;
                    counted.error += seen.cubic * piece.radius * piece.inertia;
                    counted.error += seen.flat * piece.area;
                    false
                }
            }
        });
        open.merge();
    }

    /// Adds leaves that are seen in part, unless the piece is cut for them.
    pub(super) fn doubt(
        &self,
        piece: &Piece,
        functions: &mut [Jet; FUNCTIONS],
        veiled: &mut Vec<Doubtful>,
        depth: usize,
        sums: &mut Sums,
    ) {
        if veiled.is_empty() || depth < CUTS {
            return;
        }
        let corners = self.lifted(piece);
        let mut halves = [0.0; FUNCTIONS];
        for doubtful in veiled.drain(..) {
            let (jet, half) = self.in_part(piece, &corners, &doubtful);
            for (k, weight) in self.leaf_weights(doubtful.veiled).into_iter().enumerate() {
                functions[k].add(weight, &jet);
                halves[k] += weight.abs() * half;
            }
            let [integrals] = piece.integrals(&[jet]);
            let counted = &mut sums.counted[doubtful.veiled];
            counted.first += integrals.first;
            counted.half += half * piece.area;
        }
        for (k, half) in halves.into_iter().enumerate() {
            sums.doubts[k].first += half * piece.area;
            sums.doubts[k].second += half * half * piece.area;
        }
    }

    /// A leaf that is seen in part, as a function on a piece and a bound on the rest: by its parts,
    /// if much depends on it.
    fn in_part(&self, piece: &Piece, corners: &[DVec3], doubtful: &Doubtful) -> (Jet, f64) {
        let at = &self.view.veiled[doubtful.veiled];
        let half = 0.5 * at.seen.most(piece);
        if half * self.share(doubtful.veiled) <= FAINT {
            return (Jet::constant(half), half);
        }
        let leaf = &self.views.leaves[at.leaf];
        let (mut jet, mut rest) = (Jet::default(), 0.0);
        for part in &leaf.parts {
            let there = End::of(leaf.patch, part);
            let plates = &doubtful.plates;
            let between = self.views.narrowed(self.view, corners, there, plates);
            if between == Visibility::Hidden {
                continue;
            }
            let frame = &self.view.frame;
            let Some(seen) = Seen::of(part, part.corners(), frame, self.noise) else {
                continue;
            };
            if between == Visibility::Clear {
                let seen = seen.expanded(piece, self.noise);
                jet.add(1.0, &seen.jet);
                rest += seen.cubic * piece.radius.powi(3) + seen.flat;
            } else {
                let half = 0.5 * seen.most(piece);
                jet.value += half;
                rest += half;
            }
        }
        (jet, rest)
    }

    /// Mends the means of leaves that were in doubt on parts of a piece.
    pub(super) fn mend(&self, piece: &Piece, sums: &mut Sums) {
        let mut polygon = None;
        let mut shifts = [0.0; FUNCTIONS];
        for veiled in 0..sums.counted.len() {
            let counted = &sums.counted[veiled];
            if counted.half * self.share(veiled) <= LITTLE * piece.area {
                continue;
            }
            let polygon = polygon.get_or_insert_with(|| {
                let shape = Patch::try_new(self.lifted(piece)).ok();
                shape.map(|shape| Polygon::new(&shape))
            });
            let leaf = &self.views.leaves[self.view.veiled[veiled].leaf];
            let exchange = polygon.as_ref().and_then(|polygon| {
                let pair = [polygon, &leaf.polygon];
                self.views.sight.exchange_area(pair, &counted.plates).ok()
            });
            let Some(exchange) = exchange else { continue };
            let error = exchange.error + counted.error;
            if error < counted.half {
                let (shift, less) = (exchange.value - counted.first, error - counted.half);
                for (k, weight) in self.leaf_weights(veiled).into_iter().enumerate() {
                    shifts[k] += weight * shift / piece.area;
                    sums.doubts[k].first += weight.abs() * less;
                }
            }
        }
        for (k, shift) in shifts.into_iter().enumerate() {
            sums.known[k].raise(shift, piece);
        }
    }

    /// The values of a leaf that may be hidden, less the references.
    fn leaf_weights(&self, veiled: usize) -> [f64; FUNCTIONS] {
        let leaf = self.view.veiled[veiled].leaf;
        from_fn(|k| self.values[k][leaf] - self.references[k])
    }

    /// The weight of a leaf that may be hidden, in remainders that are allowed.
    fn share(&self, veiled: usize) -> f64 {
        let weights = self.leaf_weights(veiled).into_iter().zip(self.allowed);
        weights
            .map(|(weight, allowed)| weight.abs() / allowed)
            .sum()
    }

    fn lifted(&self, piece: &Piece) -> Vec<DVec3> {
        let corners = piece.corners.iter();
        corners.map(|c| self.view.frame.lifted(*c)).collect()
    }
}
