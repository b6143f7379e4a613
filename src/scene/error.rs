//! What is wrong with a scene.

use super::Obstacle;
use crate::form_factor::FormFactorError;
use crate::geometry::GeometryError;

/// A scene was refused.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SceneError {
    /// No patches.
    #[error("a scene needs at least one patch")]
    Empty,
    /// The name is not one of the built-in scenes.
    #[error(
        "there is no built-in scene \"{name}\": use two-squares, three-squares or cube:N (N from 1 to {largest})"
    )]
    UnknownName {
        /// As given.
        name: String,
        /// Largest N.
        largest: usize,
    },
    /// A patch index is out of range.
    #[error("there is no patch {index}: the scene has patches 0 to {last}")]
    NoSuchPatch {
        /// As given.
        index: usize,
        /// Largest index.
        last: usize,
    },
    /// A patch has the wrong shape for what is asked.
    #[error("patch {index} ({name}): {source}")]
    Patch {
        /// Its index.
        index: usize,
        /// Its name.
        name: String,
        /// Why.
        source: GeometryError,
    },
    /// Two patches cannot be computed together.
    #[error("patches {first} and {second}: {source}")]
    Pair {
        /// Index of the first.
        first: usize,
        /// Index of the second.
        second: usize,
        /// Why.
        source: FormFactorError,
    },
    /// Something may stand between two patches.
    #[error(
        "patches {first} and {second} may not see each other fully: {obstacle} ({name}) stands between parts of them, and \
         occlusion is not computed; --unoccluded computes as if nothing were in the way"
    )]
    MayBeBlocked {
        /// Index of the first.
        first: usize,
        /// Index of the second.
        second: usize,
        /// What stands between.
        obstacle: Obstacle,
        /// Its name.
        name: String,
    },
    /// Two patches in one plane that face the same way lie on each other.
    #[error(
        "patches {first} ({}) and {second} ({}) lie in one plane, face the same way and overlap: \
         cut or remove one of them", names[0], names[1]
    )]
    Overlap {
        /// Index of the first.
        first: usize,
        /// Index of the second.
        second: usize,
        /// Their names.
        names: [String; 2],
    },
}
