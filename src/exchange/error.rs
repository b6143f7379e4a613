//! The refusals of an exchange: of pairs that cannot be evaluated, and of rows that do not add up.

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
         1 ± {tolerance:e} is closed"
    )]
    OpenScene {
        /// The row farthest from 1.
        row: usize,
        /// The name of its patch.
        name: String,
        /// The sum of the row.
        sum: f64,
        /// The deviation that would count as closed.
        tolerance: f64,
    },
    /// Every patch faces away from all others.
    #[error("all patches face away from each other: reverse the corners of every face")]
    TurnedAway,
    /// The form factors of a patch sum to more than one.
    #[error(
        "row {row} of the form factors (patch {name}) sums to {sum}, 1 + {tolerance:e} at most is \
         possible: patches overlap, or hide each other"
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
    /// The scene itself was refused.
    #[error(transparent)]
    Scene(#[from] SceneError),
}
