//! What is measured on a piece, and what it adds up to.

use super::jet::Jet;
use super::piece::{Integrals, Piece};
use super::views::{Veiled, View, Views};
use smallvec::SmallVec;
use std::array::from_fn;

/// The number of times that a piece is cut.
pub(super) const DEEPEST: usize = 8;

/// The number of functions that are measured together.
pub(super) const FUNCTIONS: usize = 4;

/// A function on one piece: a polynomial part, and a bound on the rest.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Measured {
    /// The integrals of the polynomial part.
    pub(super) known: Integrals,
    /// Bounds on `|∫ ρ|` and `∫ ρ²` of the rest.
    pub(super) rest: Integrals,
}

/// The functions on one piece: what the recursion needs of them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Task<'t> {
    pub(super) views: &'t Views,
    /// The plane of the piece.
    pub(super) view: &'t View,
    /// The values of the functions on the leaves.
    pub(super) values: [&'t [f64]; FUNCTIONS],
    /// The values that are taken off: b₀.
    pub(super) references: [f64; FUNCTIONS],
    /// The remainders that are allowed, in the root mean square.
    pub(super) allowed: [f64; FUNCTIONS],
    /// The height up to which a point counts as in a plane.
    pub(super) noise: f64,
}

/// A source, and how much counts on either side of it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Item {
    pub(super) source: usize,
    pub(super) sides: [f64; 2],
}

/// The work left on a piece: sources, and leaves before which something may stand.
#[derive(Debug, Clone, Default)]
pub(super) struct Open {
    pub(super) items: Vec<Item>,
    pub(super) veiled: Vec<Doubtful>,
}

impl Open {
    pub(super) const fn is_empty(&self) -> bool {
        self.items.is_empty() && self.veiled.is_empty()
    }

    /// Makes one item of those of the same source.
    pub(super) fn merge(&mut self) {
        self.items.sort_by_key(|item| item.source);
        self.items.dedup_by(|next, kept| {
            let is_same = next.source == kept.source;
            if is_same {
                kept.sides = from_fn(|side| kept.sides[side] + next.sides[side]);
            }
            is_same
        });
    }
}

impl Measured {
    /// Adds what was measured on another piece.
    pub(super) fn add(&mut self, other: &Self) {
        self.known.add(&other.known);
        self.rest.add(&other.rest);
    }
}

/// A leaf before which these plates may stand.
#[derive(Debug, Clone)]
pub(super) struct Doubtful {
    /// Among what is veiled in the view.
    pub(super) veiled: usize,
    pub(super) plates: SmallVec<[u32; 4]>,
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

/// The integrals of the form factor to a leaf that are counted on the parts of a piece.
#[derive(Debug, Clone, Default)]
pub(super) struct Counted {
    /// The integral of the form factor.
    pub(super) first: f64,
    /// A bound on the error of that where the leaf is seen.
    pub(super) error: f64,
    /// The integral of half the range of it where the leaf may be hidden.
    pub(super) half: f64,
    /// What may stand before it on the whole piece.
    pub(super) plates: SmallVec<[u32; 4]>,
}

/// What the parts of a piece add up to.
#[derive(Debug, Default)]
pub(super) struct Sums {
    pub(super) known: [Integrals; FUNCTIONS],
    pub(super) magnitudes: [f64; FUNCTIONS],
    /// By depth, each a function on the whole piece.
    pub(super) squares: [[f64; DEEPEST + 2]; FUNCTIONS],
    /// Bounds on the integral, and on that of the square, of what leaves seen in part leave open.
    pub(super) doubts: [Integrals; FUNCTIONS],
    /// By what is veiled in the view.
    pub(super) counted: Vec<Counted>,
}

impl Sums {
    pub(super) fn add_known(&mut self, piece: &Piece, functions: [Jet; FUNCTIONS]) {
        for (sum, part) in self.known.iter_mut().zip(piece.integrals(&functions)) {
            sum.add(&part);
        }
    }
}
