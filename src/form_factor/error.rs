//! Reasons why a form factor cannot be computed.

use crate::geometry::GeometryError;

/// A pair of patches was refused.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FormFactorError {
    /// A shape, or the placement of two, was refused.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
    /// A length that must be positive is not.
    #[error("{quantity} is {value}: it must be finite and > 0")]
    NonPositiveLength {
        /// The name of the length.
        quantity: &'static str,
        /// The length as given.
        value: f64,
    },
    /// A plate reaches behind the plane of the other.
    #[error(
        "a depth starts at {lower}: the part behind the other plate's plane must be clipped first"
    )]
    BehindPlane {
        /// The start of the depth, < 0.
        lower: f64,
    },
    /// An interval reaches from one side of the other rectangle's plane to the other side.
    #[error("it is not certain on which side of the other plane a depth of {depth} is")]
    Astride {
        /// About the middle of it.
        depth: f64,
    },
    /// The value over- or underflows `f64`.
    #[error("the exchange area leaves the range of f64: {value:e}")]
    OutOfRange {
        /// The value computed.
        value: f64,
    },
    /// The closed form cancels down to its rounding error.
    #[error(
        "what is computed is {value:e} with an error up to {error:e}, so no digit is certain: \
         the patches are too small for their distance, or too thin; merge them with neighbours"
    )]
    NotResolved {
        /// The value computed.
        value: f64,
        /// Bound on its error.
        error: f64,
    },
    /// A direction that should have length 1.
    #[error("a normal of length {length} is not a direction: divide it by its length")]
    NotAUnitNormal {
        /// The length of the vector.
        length: f64,
    },
    /// Coordinates that are no point to compute with.
    #[error(
        "({x}, {y}, {z}) is no point to compute with: its coordinates must be finite, below 1e60"
    )]
    NotAPoint {
        /// The coordinates.
        x: f64,
        /// The second one.
        y: f64,
        /// The third one.
        z: f64,
    },
    /// Two points that should be apart are not.
    #[error("two points {distance} apart: they must be apart, and not infinitely far")]
    SamePoint {
        /// The distance of the points.
        distance: f64,
    },
}
