//! The refusals of an exchange: of pairs that cannot be evaluated, and of rows that do not add up.

use super::ranks::RankFailed;
use crate::form_factor::FormFactorError;
use crate::scene::SceneError;

/// The exchange of a scene's rows was refused.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ExchangeError {
    /// Two patches cannot be computed together.
    #[error("patches {first} and {second}: {source}")]
    Pair {
        /// Index of the first.
        first: usize,
        /// Index of the second.
        second: usize,
        /// The reason.
        source: FormFactorError,
    },
    /// A point, a direction or a patch that is seen from it cannot be computed with.
    #[error("point {index}: {source}")]
    Point {
        /// Index of the point.
        index: usize,
        /// The reason.
        source: FormFactorError,
    },
    /// A pair is not one of the selection that pairs were made ready for.
    #[error("patches {first} and {second} are not of the selection: select them, too")]
    NotSelected {
        /// Index of the first.
        first: usize,
        /// Index of the second.
        second: usize,
    },
    /// The patches do not enclose their surroundings.
    #[error(
        "the scene is open: row {row} of the form factors (patch {name}) sums to {sum}, \
         1 ± {tolerance:e} is closed{}", also(*resolution_error)
    )]
    OpenScene {
        /// The row farthest from 1.
        row: usize,
        /// The name of its patch.
        name: String,
        /// The sum of the row.
        sum: f64,
        /// The bound on the error of the sum.
        tolerance: f64,
        /// The deviation that the resolution of the coordinates explains beside it.
        resolution_error: f64,
    },
    /// Every patch faces away from all others.
    #[error("all patches face away from each other: reverse the corners of every face")]
    TurnedAway,
    /// The form factors of a patch sum to more than one.
    #[error(
        "row {row} of the form factors (patch {name}) sums to {sum}, 1 + {tolerance:e} at most is \
         possible{}: patches overlap, or hide each other{}",
        also(*resolution_error),
        unless_rounded(*sum - 1.0, *tolerance)
    )]
    RowAboveOne {
        /// The row farthest above 1.
        row: usize,
        /// The name of its patch.
        name: String,
        /// The sum of the row.
        sum: f64,
        /// The bound on the error of the sum.
        tolerance: f64,
        /// The excess that the resolution of the coordinates explains beside it.
        resolution_error: f64,
    },
    /// Random lines left the scene.
    #[error(
        "the scene is open: {lost} of {lines} lines meet no front of a patch, and a chord has two \
         ends"
    )]
    LinesEscape {
        /// Lines that escape, or meet a back or an obstruction.
        lost: u32,
        /// Lines drawn.
        lines: u32,
    },
    /// The scene is too thin for uniform lines.
    #[error(
        "of ten thousand times {lines} lines through the sphere around the scene {met} meet it: \
         take local lines"
    )]
    LinesMiss {
        /// Lines that meet a front.
        met: u32,
        /// Lines asked for.
        lines: u32,
    },
    /// A matrix that is stored cannot be read.
    #[error("{reason}")]
    Unread {
        /// The file and the reason.
        reason: String,
    },
    /// A rank that shares the work has failed.
    #[error(transparent)]
    Rank(#[from] RankFailed),
    /// The scene itself was refused.
    #[error(transparent)]
    Scene(#[from] SceneError),
}

/// The words on what a resolution explains, beside the error of a computation.
fn also(resolution_error: f64) -> String {
    if resolution_error > 0.0 {
        format!(" (and {resolution_error:.1e} more for the resolution of the coordinates)")
    } else {
        String::new()
    }
}

/// The words on an excess so small that rounded coordinates may explain it.
fn unless_rounded(excess: f64, tolerance: f64) -> &'static str {
    if tolerance < excess && excess < LARGEST_ROUNDING {
        ", or their coordinates are rounded to more than the resolution that they are taken to have"
    } else {
        ""
    }
}

/// An excess that is not taken for rounding any more.
const LARGEST_ROUNDING: f64 = 0.01;
