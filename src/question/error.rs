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
    /// A study was refused.
    #[cfg(feature = "report")]
    #[error(transparent)]
    Study(#[from] crate::study::StudyError),
}
