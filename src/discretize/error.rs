//! The error of this room: a cut or a grid that could not be found.

use crate::chain::ChainError;
use crate::exchange::ExchangeError;
use crate::form_factor::FormFactorError;
use crate::geometry::GeometryError;
use crate::numeric::NumericError;
use crate::scene::SceneError;

/// A discretization was refused or not found.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DiscretizeError {
    /// A parameter is outside its range.
    #[error("{parameter} is {value}: it must be {condition}")]
    OutOfRange {
        /// The name of the parameter.
        parameter: &'static str,
        /// The value given.
        value: f64,
        /// The condition that it must meet.
        condition: &'static str,
    },
    /// The named patches exchange nothing with the one to be cut.
    #[error("patch {patch} exchanges nothing with the patches named: every cut gains 0")]
    NothingToGain {
        /// The patch that was to be cut.
        patch: usize,
    },
    /// A patch was to be cut against itself.
    #[error(
        "patch {patch} cannot be cut against itself: it is planar and exchanges nothing with itself"
    )]
    AgainstItself {
        /// The patch.
        patch: usize,
    },
    /// A patch is named twice.
    #[error("patch {patch} is named twice: it would count double")]
    NamedTwice {
        /// The patch.
        patch: usize,
    },
    /// An enclosure was asked for where there is no closed form.
    #[error(
        "enclosures are for rectangles with edges along three common axes that see each other \
         fully, and here is another pair: name only rectangles that are aligned, or do without an \
         enclosure"
    )]
    NotEnclosed,
    /// No start of the search converged.
    #[error("no start of the search ends at a maximum")]
    NoMaximum,
    /// An optimiser refused.
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
    /// A chain was refused.
    #[error(transparent)]
    Chain(#[from] ChainError),
}

impl DiscretizeError {
    /// The refusal of a parameter outside its range.
    pub(super) const fn out_of_range(
        parameter: &'static str,
        value: f64,
        condition: &'static str,
    ) -> Self {
        Self::OutOfRange {
            parameter,
            value,
            condition,
        }
    }
}
