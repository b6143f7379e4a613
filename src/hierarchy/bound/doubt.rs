//! Leaves that are seen in part: somewhere in their range, but with their means over a piece.
//!
//! ```text
//!   0 ≤ F ≤ M on a part of a piece where a plate may stand before the leaf: M/2 ± M/2
//!   ∫ F dx = A F(piece → leaf)                                the exchange area past the plates
//! ```
//!
//! A constant over the piece is added so that the integral is the exchange area. With the mean P ρ
//! of a function, the rest ρ of the leaves that are mended and σ of those that are not,
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
use super::residual::{FUNCTIONS, Item, Open, Sums, Task};
use super::views::{Veiled, View};
use crate::form_factor::Polygon;
use crate::geometry::Patch;
use crate::hierarchy::Visibility;
use glam::DVec3;
use smallvec::SmallVec;
use std::array::from_fn;

/// The number of times that a piece is cut for leaves that are seen in part.
const CUTS: usize = 2;
/// The doubt in remainders that are allowed, up to which a leaf is not mended.
const LITTLE: f64 = 0.1;

/// A leaf before which these plates may stand.
#[derive(Debug, Clone)]
pub(super) struct Doubtful {
    /// Among what is veiled in the view.
    veiled: usize,
    plates: SmallVec<[u32; 4]>,
}

impl Doubtful {
    /// The leaves before which something may stand in a view.
    pub(super) fn all(view: &View) -> Vec<Self> {
        let of = |(veiled, at): (usize, &Veiled)| Self {
            veiled,
            plates: at.plates.clone(),
        };
        view.veiled.iter().enumerate().map(of).collect()
    }
}

/// What is counted of a leaf on the parts of a piece.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Counted {
    /// Its integral.
    first: f64,
    /// A bound on the error of that where the leaf is seen.
    error: f64,
    /// The same where it may be hidden.
    half: f64,
}

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
            match self.views.narrowed(self.view, &corners, veiled, plates) {
                Visibility::Hidden => false,
                Visibility::Past(plates) => {
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
        let most = |doubtful: &Doubtful| self.view.veiled[doubtful.veiled].seen.most(piece);
        let mut halves = [0.0; FUNCTIONS];
        for doubtful in veiled.drain(..) {
            let half = 0.5 * most(&doubtful);
            for (k, weight) in self.leaf_weights(doubtful.veiled).into_iter().enumerate() {
                functions[k].value += weight * half;
                halves[k] += weight.abs() * half;
            }
            let counted = &mut sums.counted[doubtful.veiled];
            counted.first += half * piece.area;
            counted.half += half * piece.area;
        }
        for (k, half) in halves.into_iter().enumerate() {
            sums.doubts[k].first += half * piece.area;
            sums.doubts[k].second += half * half * piece.area;
        }
    }

    /// Mends the means of leaves that were in doubt on parts of a piece.
    pub(super) fn mend(&self, piece: &Piece, sums: &mut Sums) {
        let mut polygon = None;
        let mut shifts = [0.0; FUNCTIONS];
        for veiled in 0..sums.counted.len() {
            let counted = sums.counted[veiled];
            if counted.half * self.share(veiled) <= LITTLE * piece.area {
                continue;
            }
            let polygon = polygon.get_or_insert_with(|| {
                let shape = Patch::try_new(self.lifted(piece)).ok();
                shape.map(|shape| Polygon::new(&shape))
            });
            let at = &self.view.veiled[veiled];
            let leaf = &self.views.leaves[at.leaf];
            let exchange = polygon.as_ref().and_then(|polygon| {
                let pair = [polygon, &leaf.polygon];
                self.views.sight.exchange_area(pair, &at.plates).ok()
            });
            let Some(exchange) = exchange else { continue };
            let error = exchange.error + counted.error;
            if error < counted.half {
                for (k, weight) in self.leaf_weights(veiled).into_iter().enumerate() {
                    shifts[k] += weight * (exchange.value - counted.first) / piece.area;
                    sums.doubts[k].first += weight.abs() * (error - counted.half);
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

    /// What a leaf that may be hidden counts, in remainders that are allowed.
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
