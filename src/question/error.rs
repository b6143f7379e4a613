//! The refusals of questions.

use crate::chain::ChainError;
use crate::claims::ClaimError;
use crate::discretize::DiscretizeError;
use crate::exchange::ExchangeError;
use crate::scene::SceneError;
use crate::transport::TransportError;

/// A question cannot be answered.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum QuestionError {
    /// The scene was refused.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The exchange of the scene's rows was refused.
    #[error(transparent)]
    Exchange(#[from] ExchangeError),
    /// A chain was refused.
    #[error(transparent)]
    Chain(#[from] ChainError),
    /// A radiosity system was refused.
    #[error(transparent)]
    Transport(#[from] TransportError),
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
