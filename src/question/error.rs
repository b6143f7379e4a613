//! The refusals of questions.

use super::patch_name::PatchNameError;
use super::patch_values::PatchValueError;
use super::point_file::PointFileError;
use crate::chain::ChainError;
use crate::claims::ClaimError;
use crate::discretize::DiscretizeError;
use crate::exchange::{ExchangeError, StoreError};
use crate::hierarchy::HierarchyError;
use crate::scene::files::{NotExpressible, OpenError};
use crate::scene::{Channel, SceneError};
use crate::transport::TransportError;

/// A question cannot be answered.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum QuestionError {
    /// The scene is open, and no state was asked for that takes what escapes.
    #[error(transparent)]
    OpenScene(ExchangeError),
    /// Light was described for the visibility chain.
    #[error("the visibility chain has no light")]
    NoLightMeant,
    /// A chain of coloured light was asked for, and no channel was named.
    #[error(
        "patch {row} ({name}) is coloured, and each channel of its light is computed by itself: \
         name one"
    )]
    ChannelNotNamed {
        /// The first row that is coloured.
        row: usize,
        /// The name of the patch.
        name: String,
    },
    /// The light of one channel was refused.
    #[error("channel {}: {source}", channel.name())]
    InChannel {
        /// The channel.
        channel: Channel,
        /// The reason.
        source: TransportError,
    },
    /// Lines at random were to pass through what is in the way.
    #[error("lines at random end at what they first meet")]
    OccludedLines,
    /// All pairs were asked for, and there are too many to list.
    #[error("{patches} patches have too many pairs to list, {largest} are possible")]
    TooManyPairs {
        /// The number of patches.
        patches: usize,
        /// The largest number whose pairs are listed.
        largest: usize,
    },
    /// An enclosure was asked for of several cuts.
    #[error("an enclosure is of one cut, into two parts, and here are {parts}")]
    SeveralCutsEnclosed {
        /// The number of parts.
        parts: u32,
    },
    /// A format has no words for the scene.
    #[error(transparent)]
    NotExpressible(#[from] NotExpressible),
    /// A name for patches was refused.
    #[error(transparent)]
    PatchName(#[from] PatchNameError),
    /// A value for some patches was refused.
    #[error(transparent)]
    PatchValue(#[from] PatchValueError),
    /// Points, or a file of them, were refused.
    #[error(transparent)]
    Points(#[from] PointFileError),
    /// The scene could not be opened.
    #[error(transparent)]
    Open(#[from] OpenError),
    /// The scene was refused.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The exchange of the scene's rows was refused.
    #[error(transparent)]
    Exchange(#[from] ExchangeError),
    /// A folder cannot take or show a matrix.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// A chain was refused.
    #[error(transparent)]
    Chain(#[from] ChainError),
    /// A radiosity system was refused.
    #[error(transparent)]
    Transport(#[from] TransportError),
    /// A refinement was refused.
    #[error(transparent)]
    Hierarchy(#[from] HierarchyError),
    /// An error that no refinement reaches was asked for.
    #[error("no refinement reaches an error of {error}: it must be > 0")]
    GoalOutOfRange {
        /// The error.
        error: f64,
    },
    /// The error of a linear solution was to be reached.
    #[error("the error of a linear solution is not estimated: ask for elements or links")]
    NoLinearEstimate,
    /// A cut or a grid was refused.
    #[error(transparent)]
    Discretize(#[from] DiscretizeError),
    /// A claim was refused.
    #[error(transparent)]
    Claim(#[from] ClaimError),
    /// The claim has no curve.
    #[error("claim \"{id}\" has no curve; these have one: {}", with_curve.join(", "))]
    NoCurve {
        /// The id of the claim.
        id: String,
        /// The ids of the claims that have one.
        with_curve: Vec<String>,
    },
    /// Only claims that print a number were asked for, and none of those named does.
    #[error("none of the claims named prints a number")]
    NonePrinted {
        /// The ids as given.
        ids: Vec<String>,
    },
    /// More cuts were asked for than anybody reads.
    #[error("{pairs} pairs of exponents are more than {most}")]
    TooManyPairsOfExponents {
        /// The number of pairs asked for.
        pairs: usize,
        /// The most pairs that are answered.
        most: usize,
    },
    /// An enclosure was asked for of a grid with so many cells that it would take too long.
    #[error("an enclosure of {bits} bits is for up to {most} cells an edge, and here are {cells}")]
    TooManyCellsToEnclose {
        /// Bits asked for.
        bits: u32,
        /// Cells an edge of the grid.
        cells: u32,
        /// The most cells an edge that are enclosed.
        most: u32,
    },
    /// Refinements of chains with so many states are not drawn.
    #[error("chains of {states} states are not drawn: it must be {least} to {most}")]
    StatesOutOfRange {
        /// The most states asked for.
        states: usize,
        /// The fewest that may be asked for.
        least: usize,
        /// The most that may be asked for.
        most: usize,
    },
    /// A study was refused.
    #[cfg(feature = "report")]
    #[error(transparent)]
    Study(#[from] crate::study::StudyError),
}
