//! Errors of claims' data and computations.

use crate::chain::ChainError;
use crate::discretize::DiscretizeError;
use crate::exchange::ExchangeError;
use crate::form_factor::FormFactorError;
use crate::geometry::GeometryError;
use crate::hierarchy::HierarchyError;
use crate::numeric::NumericError;
use crate::scene::SceneError;
use crate::transport::TransportError;

/// A claim's data or its computation failed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ClaimError {
    /// No claim has this id.
    #[error(
        "there is no claim \"{id}\"{}",
        nearest.as_ref().map(|n| format!(": the nearest is \"{n}\"")).unwrap_or_default()
    )]
    UnknownClaim {
        /// The id as given.
        id: String,
        /// A claim whose id begins alike.
        nearest: Option<String>,
    },
    /// A file of claims does not follow its format.
    #[error("{file}: {reason}")]
    InvalidData {
        /// Name of the file.
        file: &'static str,
        /// The reason.
        reason: String,
    },
    /// A computation asked for an input that the claim does not have, or has with a useless value.
    #[error("input \"{name}\" {reason}")]
    Input {
        /// Name of the input.
        name: &'static str,
        /// The reason.
        reason: String,
    },
    /// A maximum was found but not proved to be the highest.
    #[error("not certified: {reason}")]
    NotCertified {
        /// The reason.
        reason: String,
    },
    /// A numerical routine refused.
    #[error(transparent)]
    Numeric(#[from] NumericError),
    /// A shape was refused.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
    /// A form factor was refused.
    #[error(transparent)]
    FormFactor(#[from] FormFactorError),
    /// A scene was refused.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The exchange of a scene's rows was refused.
    #[error(transparent)]
    Exchange(#[from] ExchangeError),
    /// A lit scene was refused.
    #[error(transparent)]
    Transport(#[from] TransportError),
    /// A chain was refused.
    #[error(transparent)]
    Chain(#[from] ChainError),
    /// A refinement was refused.
    #[error(transparent)]
    Hierarchy(#[from] HierarchyError),
    /// A discretization was refused.
    #[error(transparent)]
    Discretize(#[from] DiscretizeError),
}
