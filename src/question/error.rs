//! The refusals of questions.

use super::patch_values::PatchValueError;
use crate::chain::ChainError;
use crate::claims::ClaimError;
use crate::discretize::DiscretizeError;
use crate::exchange::ExchangeError;
use crate::scene::SceneError;
use crate::scene::files::NotExpressible;
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
    /// A value for some patches was refused.
    #[error(transparent)]
    PatchValue(#[from] PatchValueError),
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
    /// A study was refused.
    #[cfg(feature = "report")]
    #[error(transparent)]
    Study(#[from] crate::study::StudyError),
}
