//! Lines that may be lines of discontinuity, with what makes them.

use super::ranges::Ranges;
use super::section::Section;

/// A corner or an edge of the source or of a blocker.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Feature {
    /// The index of the blocker; none for the source.
    pub blocker: Option<usize>,
    /// The index of the corner, or of the corner at which the edge begins.
    pub index: usize,
}

impl Feature {
    pub(super) const fn new(blocker: Option<usize>, index: usize) -> Self {
        Self { blocker, index }
    }
}

/// The corner and edge, or the plane, that makes a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Generator {
    /// A vertex and an edge are seen in one.
    Sight {
        /// The vertex.
        vertex: Feature,
        /// The edge.
        edge: Feature,
    },
    /// A polygon is seen edge-on.
    Plane {
        /// The index of the blocker; none for the source.
        of: Option<usize>,
    },
    /// A blocker stands on the receiver, or pierces it.
    Contact {
        /// The index of the blocker.
        blocker: usize,
    },
}

/// A line of the receiver with the ranges in which something changes there.
pub(super) struct Candidate {
    pub section: Section,
    pub ranges: Ranges,
    pub generator: Generator,
}
