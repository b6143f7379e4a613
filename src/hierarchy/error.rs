//! Refusals of hierarchical solutions.

use crate::exchange::ExchangeError;
use crate::form_factor::FormFactorError;
use crate::geometry::GeometryError;
use crate::scene::SceneError;
use crate::transport::TransportError;
use glam::DVec3;

/// The reason why a scene has no hierarchical solution.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum HierarchyError {
    /// The scene cannot be used.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The materials cannot be used.
    #[error(transparent)]
    Transport(#[from] TransportError),
    /// The form factors of patches are refused.
    #[error(transparent)]
    Exchange(#[from] ExchangeError),
    /// A form factor is refused.
    #[error(transparent)]
    FormFactor(#[from] FormFactorError),
    /// A patch absorbs nothing.
    #[error(
        "patch {patch} reflects all light (R = 1): hierarchical solutions need a reflectance below \
         1, as their error is bounded by what is absorbed"
    )]
    Mirror {
        /// The patch, from 0.
        patch: usize,
    },
    /// A patch lies in another one.
    #[error(
        "patch {patch} lies in patch {base}, which counts without it: cut patch {base} into faces \
         around it, as elements are pieces of whole faces"
    )]
    PatchInPatch {
        /// The patch that lies in the other.
        patch: usize,
        /// The patch around it.
        base: usize,
    },
    /// The mesh that is asked for is coarser than the scene.
    #[error("{elements} elements are fewer than the {patches} patches: ask for {patches} at least")]
    FewerThanPatches {
        /// The number that was asked for.
        elements: usize,
        /// The number of patches.
        patches: usize,
    },
    /// The goal takes a mesh that memory does not hold.
    #[error(
        "this takes a mesh of more than {most} elements, which is the most there can be: accept a \
         larger error, or ask for fewer elements or links"
    )]
    TooManyElements {
        /// The most elements.
        most: usize,
    },
    /// The iteration towards the equilibrium stopped early.
    #[error(
        "the equilibrium of light was not reached in {iterations} products: the residual is still \
         {residual:e} of the light"
    )]
    NotConverged {
        /// The products that were made.
        iterations: usize,
        /// The norm of the residual over that of the sources.
        residual: f64,
    },
    /// No oracle has this name.
    #[error("there is no oracle {name:?}; there are {}", known.join(", "))]
    UnknownOracle {
        /// The name.
        name: String,
        /// The names of all oracles.
        known: Vec<&'static str>,
    },
    /// An element cannot be cut.
    #[error("element {element}: {source}")]
    Element {
        /// The element.
        element: usize,
        /// The reason.
        source: GeometryError,
    },
    /// The oracle of the true error has nothing to compare with.
    #[error(
        "the oracle `true` compares with a reference: solve the scene on a finer mesh first, and \
         give that"
    )]
    NoReference,
    /// Two elements exchange nothing that can be computed.
    #[error("elements {first} and {second}: {source}")]
    Pair {
        /// The first.
        first: usize,
        /// The second.
        second: usize,
        /// The reason.
        source: FormFactorError,
    },
    /// A point has no bound on its radiosity.
    #[error(
        "there is no bound on the radiosity at {point} of patch {patch}: take a point inside of \
         the patch, and off the edges of others"
    )]
    NoBoundAt {
        /// The patch.
        patch: usize,
        /// The point.
        point: DVec3,
    },
    /// A list has too many or too few entries.
    #[error("there are {found} {what}, {expected} are needed")]
    WrongCount {
        /// What the list holds.
        what: &'static str,
        /// The entries that it has.
        found: usize,
        /// The entries that it must have.
        expected: usize,
    },
    /// A radiosity is not a number, or on a patch that reflects nothing not what the patch emits.
    #[error("the radiosity of leaf {leaf} is {value}{}", expected.map_or(String::new(), |e| {
        format!(": its patch reflects nothing, and emits {e}")
    }))]
    WrongRadiosity {
        /// The leaf, counted among leaves.
        leaf: usize,
        /// Its radiosity.
        value: f64,
        /// The only radiosity that it can have, if it is known.
        expected: Option<f64>,
    },
    /// A gradient of a radiosity is not a number.
    #[error("the gradient of the radiosity on leaf {leaf} is {gradient}")]
    WrongGradient {
        /// The leaf, counted among leaves.
        leaf: usize,
        /// The gradient.
        gradient: DVec3,
    },
    /// Light does not surely come to an end: too little is absorbed, or escapes.
    #[error(
        "no bound: the error of some brightness is not surely damped, as too little is absorbed; \
         lower reflectances of 1"
    )]
    NotDamped,
}
