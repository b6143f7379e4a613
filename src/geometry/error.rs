//! Reasons why a shape is unusable.

/// A shape was refused; the message names the condition and the offending numbers.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GeometryError {
    /// Fewer than three corners.
    #[error("a polygon needs at least 3 corners, this one has {corners}")]
    TooFewCorners {
        /// Corners given.
        corners: usize,
    },
    /// A corner has a coordinate that is NaN or infinite.
    #[error("corner {corner} is ({x}, {y}, {z}): every coordinate must be finite")]
    NotFinite {
        /// Index of the corner, from 0.
        corner: usize,
        /// The coordinate x as given.
        x: f64,
        /// The coordinate y as given.
        y: f64,
        /// The coordinate z as given.
        z: f64,
    },
    /// The polygon encloses no area.
    #[error("the polygon has no area that f64 can hold: {area:e} at a diameter of {diameter:e}")]
    NoArea {
        /// Area found.
        area: f64,
        /// Largest distance of a corner from the first.
        diameter: f64,
    },
    /// A corner lies off the plane of the others.
    #[error(
        "corner {corner} lies {deviation:e} off the plane, {relative:e} of the diameter; \
         at most {allowed:e} of it is accepted{}, so split the polygon into triangles",
        resolved(*resolution)
    )]
    NotPlanar {
        /// The corner farthest from the plane.
        corner: usize,
        /// The corner's distance from the plane.
        deviation: f64,
        /// The distance over the diameter.
        relative: f64,
        /// The largest deviation accepted.
        allowed: f64,
        /// The resolution that would explain the deviation, if one would.
        resolution: Option<f64>,
    },
    /// Two edges of the outline meet where they should not.
    #[error("edges {first} and {second} of the outline cross or touch: a simple polygon is needed")]
    NotSimple {
        /// Index of the first edge.
        first: usize,
        /// Index of the second edge.
        second: usize,
    },
    /// Four right-angled corners were needed.
    #[error("the polygon is not a rectangle: {reason}")]
    NotARectangle {
        /// The property that fails, with its number.
        reason: String,
    },
    /// Two rectangles do not have their edges along three common axes.
    #[error(
        "the rectangles' edges do not run along three common axes \
         (a corner is off by {deviation:e}, {allowed:e} is accepted)"
    )]
    NotAligned {
        /// Largest deviation.
        deviation: f64,
        /// The largest deviation accepted.
        allowed: f64,
    },
    /// The edges at the first corner span no plane, so no axes are defined.
    #[error(
        "corner 0 is straight (the sine of its angle is {sine:e}), so that no axes start there: \
         begin the polygon at another corner"
    )]
    StraightCorner {
        /// Sine of the angle at the corner.
        sine: f64,
    },
    /// The ends of a span are not finite and increasing.
    #[error("[{lower}, {upper}] is not a span of positive finite length")]
    EmptySpan {
        /// Lower end.
        lower: f64,
        /// Upper end.
        upper: f64,
    },
    /// A relative position outside its range.
    #[error("relative position {position} is not inside {lower} … {upper}")]
    PositionOutOfRange {
        /// The position as given.
        position: f64,
        /// Smallest position allowed.
        lower: f64,
        /// Largest position allowed.
        upper: f64,
    },
}

/// The words on a resolution that would explain a bend.
fn resolved(resolution: Option<f64>) -> String {
    let words = |length| format!(" unless coordinates are ± {length:.1e} or more");
    resolution.map_or_else(String::new, words)
}
