//! Families of random pairs with polygons in the way, each aimed at one difficulty; a case is named
//! by its family and number.
//!
//! `known` has pairs with values from outside, `halfway` pairs that are known exactly,
//! [`stability`] extreme ones; `point_rule` is what engines with the closed form of a point do, for
//! comparison.
//!
//! Coordinates of the families are multiples of 2⁻³⁰ and parallelograms have exact corners, so that
//! polygons are planar exactly, moves along the axes and halves of edges are exact, and what
//! touches touches.

mod draws;
mod extreme;
pub(crate) mod halfway;
pub(crate) mod known;
pub(crate) mod point_rule;
pub mod stability;

use super::families::facing;
use crate::geometry::{GeometryError, Patch};
use draws::drawn;

/// A pair of polygons, and what is in the way.
#[derive(Debug, Clone)]
pub struct OccludedPair {
    /// The pair; the front of each faces the farthest corner of the other.
    pub pair: [Patch; 2],
    /// The polygons in the way.
    pub blockers: Vec<Patch>,
}

/// A family of pairs that share a difficulty.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OccludedFamily {
    /// One blocker anywhere between two polygons anywhere.
    One,
    /// Two blockers that overlap as most points see them.
    TwoOverlapping,
    /// Three to eight blockers.
    Many,
    /// A wall that stands on the first polygon.
    WallOnFirst,
    /// A wall from one polygon to the other.
    WallOnBoth,
    /// A plate 1e-2 to 1e-6 above the first polygon.
    ClosePlate,
    /// A triangle through the first polygon.
    Piercing,
    /// A concave blocker.
    Concave,
    /// A box of six faces.
    Box,
    /// Plates that share edges and corners.
    Patchwork,
    /// A triangle in the corner of two polygons that share an edge.
    Corner,
    /// A box in that corner.
    Cabinet,
    /// Two plates that leave a slit.
    NearlyTotal,
    /// A blocker of 1e-3 to 1e-6.
    Tiny,
    /// Polygons partly behind each other's plane.
    Horizon,
}

impl OccludedFamily {
    /// All, in the order of the tables.
    pub const ALL: [Self; 15] = [
        Self::One,
        Self::TwoOverlapping,
        Self::Many,
        Self::WallOnFirst,
        Self::WallOnBoth,
        Self::ClosePlate,
        Self::Piercing,
        Self::Concave,
        Self::Box,
        Self::Patchwork,
        Self::Corner,
        Self::Cabinet,
        Self::NearlyTotal,
        Self::Tiny,
        Self::Horizon,
    ];

    /// The name that tables and JSON use.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::One => "one blocker",
            Self::TwoOverlapping => "two overlapping blockers",
            Self::Many => "three to eight blockers",
            Self::WallOnFirst => "wall on one",
            Self::WallOnBoth => "wall from one to the other",
            Self::ClosePlate => "close plate",
            Self::Piercing => "piercing",
            Self::Concave => "concave blocker",
            Self::Box => "box",
            Self::Patchwork => "patchwork",
            Self::Corner => "triangle in a corner",
            Self::Cabinet => "box in a corner",
            Self::NearlyTotal => "slit",
            Self::Tiny => "tiny blocker",
            Self::Horizon => "horizon, blocker",
        }
    }

    /// One of its cases, always the same for a number.
    ///
    /// # Errors
    /// [`GeometryError`] if a polygon drawn is not planar and simple, which it is by construction.
    pub fn case(self, number: u64) -> Result<OccludedPair, GeometryError> {
        let ([first, second], blockers) = drawn(self, number);
        let pair = [facing(&first, &second), facing(&second, &first)];
        let [first, second] = pair.map(Patch::try_new);
        let blockers = blockers.into_iter().map(Patch::try_new);
        Ok(OccludedPair {
            pair: [first?, second?],
            blockers: blockers.collect::<Result<_, _>>()?,
        })
    }
}
