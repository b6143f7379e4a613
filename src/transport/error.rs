//! Reasons why there is no equilibrium of light.

use super::sinks::Sinkless;
use crate::exchange::ExchangeError;

/// A scene has no radiosity or importance; the message names the patch.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TransportError {
    /// A list has not one number for each patch.
    #[error("{found} {what} for {expected} patches: one for each is needed")]
    WrongCount {
        /// The name of the list.
        what: &'static str,
        /// The number of values given.
        found: usize,
        /// Number of patches.
        expected: usize,
    },
    /// A reflectance outside `[0, 1]`.
    #[error("the reflectance of patch {patch} is {value}: it must be at least 0 and at most 1")]
    ReflectanceOutOfRange {
        /// The patch, from 0.
        patch: usize,
        /// The value that was given.
        value: f64,
    },
    /// A positive reflectance whose inverse is beyond what can be computed with.
    #[error(
        "the reflectance of patch {patch} is {value:e}: it must be 0, or {SMALLEST_REFLECTANCE:e} \
         at least"
    )]
    ReflectanceTooSmall {
        /// The patch, from 0.
        patch: usize,
        /// The value that was given.
        value: f64,
    },
    /// A source that is negative or not a number.
    #[error("the {what} of patch {patch} is {value}: it must be finite and at least 0")]
    SourceOutOfRange {
        /// Emittance, or a camera's direct importance.
        what: &'static str,
        /// The patch, from 0.
        patch: usize,
        /// The value that was given.
        value: f64,
    },
    /// The sources are all 0.
    #[error("no patch has a positive {what}: give one to a patch at least")]
    NoSource {
        /// Emittance or importance.
        what: &'static str,
    },
    /// A patch index is out of range.
    #[error("there is no patch {patch}: the scene has patches 0 to {last}")]
    NoSuchPatch {
        /// The value that was given.
        patch: usize,
        /// Largest index.
        last: usize,
    },
    /// Patches reflect all light, and none of it goes where it would end.
    #[error(
        "{group}: all light is reflected (R = 1), and none certainly escapes or comes to a patch \
         that absorbs some, so that nothing determines how bright it gets: let one reflect less \
         than 1, or let light out"
    )]
    NoSink {
        /// The patches, each of which comes to all others.
        group: Sinkless,
    },
    /// The error of a solution is not bounded.
    #[error(
        "no bound was found on the error of the solution: give reflectances farther from 1, or \
         larger exchange areas"
    )]
    NoBound,
    /// An estimate was asked of no walks at all.
    #[error("no walks give no estimate: ask for one at least")]
    NoWalks,
    /// A walk was not at its end after so many steps that its estimate would be too low.
    #[error(
        "a walk has not ended after {steps} steps, as hardly any light is absorbed or escapes: \
         solve for the radiosities instead"
    )]
    EndlessWalk {
        /// The steps that were made.
        steps: u32,
    },
    /// An exchange matrix was refused.
    #[error(
        "entry ({row}, {column}) of the exchange areas is {value}: it must be finite, ≥ 0 and \
         equal to its mirror image"
    )]
    InvalidExchange {
        /// Row, from 0.
        row: usize,
        /// Column, from 0.
        column: usize,
        /// The value that was given.
        value: f64,
    },
    /// The scene's form factors were refused.
    #[error(transparent)]
    Exchange(#[from] ExchangeError),
}

/// The smallest reflectance that is not 0.
pub(super) const SMALLEST_REFLECTANCE: f64 = 1e-200;
