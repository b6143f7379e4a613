//! The refusals of a scene: of what is there, whatever is asked of it.

use super::Obstacle;
use super::material::MaterialFault;
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
        "there is no built-in scene \"{name}\": use cornell-box, cornell-box-blocks, two-squares, \
         three-squares, cube:N (N from 1 to {largest}), box:X,Y,Z, tetrahedron, octahedron, \
         dodecahedron, icosahedron, lit-cube, lit-cube-edge, lit-hall, lit-wings, shaded-cube, \
         shaded-cube-low, shaded-cube-sharp or lit-table, or the path of a file that ends in .obj, \
         .vs3 or .stl"
    )]
    UnknownName {
        /// The name as given.
        name: String,
        /// Largest N.
        largest: usize,
    },
    /// A patch index is out of range.
    #[error("there is no patch {index}: the scene has patches 0 to {last}")]
    NoSuchPatch {
        /// The index as given.
        index: usize,
        /// Largest index.
        last: usize,
    },
    /// A patch has the wrong shape for what is asked.
    #[error("patch {index} ({name}): {source}")]
    Patch {
        /// The index of the patch.
        index: usize,
        /// The name of the patch.
        name: String,
        /// The geometric reason.
        source: GeometryError,
    },
    /// The file of a built-in scene cannot be read.
    #[error("the built-in scene {name} cannot be read: {reason}")]
    BuiltIn {
        /// The name of the scene.
        name: &'static str,
        /// The refusal of its reader.
        reason: String,
    },
    /// A patch lies, in the end, in itself.
    #[error("patch {part} cannot lie in patch {base}, which lies in it: name a base outside")]
    BaseCycle {
        /// Index of the part.
        part: usize,
        /// Index of its base.
        base: usize,
    },
    /// A part is not in the plane of its base.
    #[error(
        "patch {part} lies {deviation:e} off the plane of its base, patch {base}, and {allowed:e} \
         is accepted: move it into the plane"
    )]
    PartOffPlane {
        /// Index of the part.
        part: usize,
        /// Index of its base.
        base: usize,
        /// Largest distance of a corner from the plane.
        deviation: f64,
        /// The deviation that would be accepted.
        allowed: f64,
    },
    /// A part has its front at the back of its base.
    #[error(
        "patch {part} faces away from the front of its base, patch {base}: reverse its corners"
    )]
    PartFacesAway {
        /// Index of the part.
        part: usize,
        /// Index of its base.
        base: usize,
    },
    /// A part is not inside its base.
    #[error("patch {part} reaches out of its base, patch {base}: cut off what is outside")]
    PartOutside {
        /// Index of the part.
        part: usize,
        /// Index of its base.
        base: usize,
    },
    /// Parts cover all of their base.
    #[error(
        "the parts of patch {base} leave an area of {left:e} to it: leave the patch out, or its \
         parts"
    )]
    NothingLeft {
        /// Index of the base.
        base: usize,
        /// Area less that of the parts.
        left: f64,
    },
    /// Light was asked for, and a patch has no known reflectance or emittance.
    #[error("patch {index} ({name}) has no {what}: {fault}")]
    MaterialUnknown {
        /// The index of the patch.
        index: usize,
        /// The name of the patch.
        name: String,
        /// Reflectance or emittance.
        what: &'static str,
        /// The reason.
        fault: MaterialFault,
    },
    /// The patches of a row have not the same reflectance or emittance.
    #[error(
        "patches {first} ({}) and {second} ({}) are summed into one row and differ in {what}: give \
         both the same, or a row each", names[0], names[1]
    )]
    MixedRow {
        /// Index of the first.
        first: usize,
        /// Index of the second.
        second: usize,
        /// Reflectance or emittance.
        what: &'static str,
        /// The names of the two.
        names: [String; 2],
    },
    /// The resolution is no length below that of the surfaces.
    #[error(
        "a resolution of {resolution:e} does not tell the surfaces of this scene apart: it must be \
         0 or more, and less than {largest:.1e}"
    )]
    Resolution {
        /// The resolution as given.
        resolution: f64,
        /// The length that it must be below.
        largest: f64,
    },
    /// A row without a patch is not where rows can be.
    #[error(
        "row {row} without a patch is out of order: such rows come upwards, none beyond {last}"
    )]
    EmptyRowOutOfOrder {
        /// The row.
        row: usize,
        /// The largest row possible.
        last: usize,
    },
    /// A row has no patch, and one was needed.
    #[error("patch {row} ({name}) has no area and exchanges nothing: name one that has")]
    RowWithoutPatch {
        /// The row.
        row: usize,
        /// The name of the row.
        name: String,
    },
    /// A label for each patch was needed.
    #[error("{labels} labels for {patches} patches: one for each is needed")]
    LabelCount {
        /// Labels given.
        labels: usize,
        /// Patches of the scene.
        patches: usize,
    },
    /// A patch to be cut has others lying in it.
    #[error(
        "patch {base} cannot be cut, as patch {part} lies in it: cut patch {part} or leave it out"
    )]
    CutThroughPart {
        /// Index of the patch.
        base: usize,
        /// Index of one that lies in it.
        part: usize,
    },
    /// A question about whole patches has met one that counts without others.
    #[error("patch {index} {what}, and this takes whole patches: leave it out")]
    NotAPatchOfItsOwn {
        /// Index of the patch.
        index: usize,
        /// The reason, as a predicate.
        what: &'static str,
    },
    /// A wall has something behind it.
    #[error(
        "the room is not convex inside: a corner lies {depth:e} behind the plane of patch {index} \
         ({name})"
    )]
    NotConvex {
        /// Index of the patch.
        index: usize,
        /// The name of the patch.
        name: String,
        /// The depth of the deepest corner.
        depth: f64,
    },
    /// The patches of a plane do not cover a convex face.
    #[error(
        "the patches in the plane of patch {index} ({name}) leave {relative:e} of the face between \
         their corners open: a closed convex room is needed"
    )]
    FaceNotCovered {
        /// Index of the first patch in the plane.
        index: usize,
        /// The name of the patch.
        name: String,
        /// The part of the face that is open; negative where patches overlap.
        relative: f64,
    },
    /// The lines of a grid do not increase from 0 to 1.
    #[error("grid line {index} is at {position}: lines must increase between 0 and 1")]
    GridLine {
        /// Index of the line.
        index: usize,
        /// The position as given.
        position: f64,
    },
    /// Something may stand between two patches.
    #[error(
        "patches {first} and {second} may not see each other fully: {obstacle} ({name}) stands \
         between parts of them{}, and this needs patches that see each other fully: take it away, \
         or ask for unoccluded values",
        unless_rounded(*resolution)
    )]
    MayBeBlocked {
        /// Index of the first.
        first: usize,
        /// Index of the second.
        second: usize,
        /// The surface that stands between.
        obstacle: Obstacle,
        /// The name of that surface.
        name: String,
        /// A resolution of the coordinates at which nothing would stand between.
        resolution: Option<f64>,
    },
    /// Two patches in one plane that face the same way lie on each other.
    #[error(
        "patches {first} ({}) and {second} ({}) lie in one plane, face the same way and overlap{}: \
         cut or remove one of them", names[0], names[1], unless_rounded(*resolution)
    )]
    Overlap {
        /// Index of the first.
        first: usize,
        /// Index of the second.
        second: usize,
        /// The names of the two.
        names: [String; 2],
        /// A resolution of the coordinates at which nothing would overlap.
        resolution: Option<f64>,
    },
}

/// The words on a resolution at which a condition would hold.
fn unless_rounded(resolution: Option<f64>) -> String {
    let words = |length| format!(" unless coordinates are ± {length:.1e} or more");
    resolution.map_or_else(String::new, words)
}
