//! The conditions that a scene file may break, each with its remedy.

use crate::geometry::GeometryError;
use crate::scene::{MaterialError, SceneError};
use std::path::PathBuf;

/// The condition that a file breaks; the message says what would mend it.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Fault {
    /// The operating system gives no content.
    #[error("it cannot be read ({reason}): name a file that is there and may be read")]
    CannotRead {
        /// The reason that the system gives.
        reason: String,
    },
    /// A folder.
    #[error("it is a folder: name a file in it")]
    IsFolder,
    /// Larger than any scene that could be computed.
    #[error("it is larger than {limit} bytes: split the scene")]
    TooLarge {
        /// Most bytes that are read.
        limit: u64,
    },
    /// None of the formats, to judge by its name.
    #[error(
        "its name does not say what it is: a scene is a Wavefront .obj, a View3D .vs3 or an .stl \
         file, so rename or export it"
    )]
    UnknownFormat,
    /// Two bytes for each letter.
    #[error("it is UTF-16: save the file as UTF-8 text")]
    Utf16,
    /// No patch in the file.
    #[error("it has no patch: {mend}")]
    NoPatch {
        /// The statement that defines a patch.
        mend: &'static str,
    },
    /// A line begins with something that the format does not know.
    #[error(
        "{format} has no \"{keyword}\": remove the line, or check that this is {format} at all"
    )]
    UnknownKeyword {
        /// Name of the format.
        format: &'static str,
        /// The text as given, shortened.
        keyword: String,
    },
    /// Something that the format knows and we do not.
    #[error("{what}: {mend}")]
    NotSupported {
        /// The name of the feature, and that it is not supported.
        what: String,
        /// The remedy.
        mend: &'static str,
    },
    /// A value is not there.
    #[error("{what} is missing: write {form}")]
    Missing {
        /// The name of the value.
        what: &'static str,
        /// The form of a correct line.
        form: &'static str,
    },
    /// There is more on the line than belongs there.
    #[error("\"{given}\" is one value too many: write {form}")]
    TooMany {
        /// The first of them, shortened.
        given: String,
        /// The form of a correct line.
        form: &'static str,
    },
    /// A number was expected.
    #[error("{what} is \"{given}\": write a number, as in {form}")]
    NotANumber {
        /// The name of the value.
        what: &'static str,
        /// The text as given, shortened.
        given: String,
        /// The form of a correct line.
        form: &'static str,
    },
    /// A number that is NaN, infinite or beyond `f64`.
    #[error("{what} is \"{given}\": write a finite number")]
    NotFinite {
        /// The name of the value.
        what: &'static str,
        /// The text as given, shortened.
        given: String,
    },
    /// A vertex that is not there.
    #[error(
        "there is no vertex {index}: {defined} are defined before this line, so write 1 to \
         {defined}, or -1 for the last"
    )]
    NoSuchVertex {
        /// The index as given.
        index: String,
        /// Vertices defined so far.
        defined: usize,
    },
    /// A number that was given before.
    #[error("{what} {number} is defined already, in line {line}: give it another number")]
    DefinedTwice {
        /// Vertex or surface.
        what: &'static str,
        /// The number that occurs twice.
        number: usize,
        /// The line of the first definition.
        line: usize,
    },
    /// A number or name that nothing in the file has.
    #[error("there is no {what} {given}: define it, or name one that is there")]
    Undefined {
        /// Vertex, surface or material.
        what: &'static str,
        /// The text as given, shortened.
        given: String,
    },
    /// A name that files have in several letter cases.
    #[error("\"{}\" and \"{}\" both fit: write one of them as it is", names[0], names[1])]
    Ambiguous {
        /// The names of two of them.
        names: [String; 2],
    },
    /// A material file that cannot be used.
    #[error("the material file {}: {source}", file.display())]
    Library {
        /// The file.
        file: PathBuf,
        /// Why.
        source: Box<Fault>,
    },
    /// A shape that is no patch.
    #[error("{source}{}", mend(source))]
    Geometry {
        /// Why.
        source: GeometryError,
    },
    /// A material that cannot be.
    #[error("{source}")]
    Material {
        /// Why.
        source: MaterialError,
    },
    /// Patches that do not belong together.
    #[error("{source}")]
    Scene {
        /// Why.
        source: Box<SceneError>,
    },
    /// The last line is not there.
    #[error("the line \"{last}\" is missing: add it, unless the file was cut short")]
    NoEnd {
        /// The beginning of that line.
        last: &'static str,
    },
    /// A statement stands where it cannot.
    #[error("\"{keyword}\" belongs {place}: move it there")]
    Misplaced {
        /// The statement.
        keyword: String,
        /// The place for it.
        place: &'static str,
    },
    /// Too few bytes for the head of a binary STL file.
    #[error(
        "it has {bytes} bytes and does not begin with \"solid\": an STL file is such a text, or \
         begins with a head of 84 bytes, so export the shape again"
    )]
    NoStlHead {
        /// Bytes of the file.
        bytes: usize,
    },
    /// The head of a binary STL file counts more facets than there are.
    #[error(
        "its head counts {counted} facets and {held} are there: it was cut short, or its head is \
         wrong, so export the shape again"
    )]
    FacetsMissing {
        /// Facets that the head counts.
        counted: usize,
        /// Whole facets in the file.
        held: usize,
    },
    /// A face of a mesh in arrays names a vertex that is not there.
    #[error(
        "corner {corner} is vertex {vertex}, and there are {vertices}: count them from 0, up to {}",
        vertices.saturating_sub(1)
    )]
    NotAVertex {
        /// The corner of the face, from 0.
        corner: usize,
        /// The vertex as given.
        vertex: i64,
        /// The number of vertices.
        vertices: usize,
    },
    /// The offsets of a mesh in arrays do not divide the corners into faces.
    #[error(
        "offset {place} is {offset}: offsets begin with 0, do not decrease, and end with the \
         number of corners, {corners}"
    )]
    NotAnOffset {
        /// The place of the offset, from 0.
        place: usize,
        /// The offset as given.
        offset: i64,
        /// The number of corners of all faces.
        corners: usize,
    },
}

/// The remedy of a shape, as far as the geometry does not name it itself.
const fn mend(error: &GeometryError) -> &'static str {
    match error {
        GeometryError::TooFewCorners { .. } => ": add corners or remove the face",
        GeometryError::NotFinite { .. } => ": mend the vertex",
        GeometryError::NoArea { .. } => {
            ": move its corners apart, off one line and into their order, or remove the face"
        }
        GeometryError::NotPlanar { .. } => ", or let its reader do so",
        GeometryError::NotSimple { .. } => ", so reorder or split the face",
        _ => "",
    }
}
