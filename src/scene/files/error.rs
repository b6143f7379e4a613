//! The refusals of a scene file: the place, the broken condition and its remedy.

use crate::geometry::GeometryError;
use crate::scene::{MaterialError, SceneError};
use std::fmt;
use std::path::{Path, PathBuf};

/// One fault of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct FileError {
    /// The file as it was named.
    pub file: PathBuf,
    /// The line, from 1; of a continued line the first. None if the whole file is at fault.
    pub line: Option<usize>,
    /// Number and name of the patch that the line defines.
    pub patch: Option<String>,
    /// The broken condition.
    pub fault: Fault,
}

impl FileError {
    /// A fault of the whole file.
    #[must_use]
    pub fn of_file(file: &Path, fault: Fault) -> Self {
        Self {
            file: file.to_owned(),
            line: None,
            patch: None,
            fault,
        }
    }
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.file.display())?;
        if let Some(line) = self.line {
            write!(f, ", line {line}")?;
        }
        if let Some(patch) = &self.patch {
            write!(f, ", patch {patch}")?;
        }
        write!(f, ": {}", self.fault)
    }
}

impl std::error::Error for FileError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        Some(&self.fault)
    }
}

/// The faults for which a file was refused, those of the files that it names included.
///
/// The text has a line for each of the first [`MOST_TOLD`](Self::MOST_TOLD), and counts the others.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FileErrors {
    told: Vec<FileError>,
    more: usize,
}

impl FileErrors {
    /// The number of faults that are told.
    pub const MOST_TOLD: usize = 20;

    /// The first faults, in the order in which they were met; one at least.
    #[must_use]
    pub fn told(&self) -> &[FileError] {
        &self.told
    }

    /// The number of faults beyond those.
    #[must_use]
    pub const fn more(&self) -> usize {
        self.more
    }

    /// Adds a fault.
    pub(crate) fn push(&mut self, fault: FileError) {
        if self.told.len() < Self::MOST_TOLD {
            self.told.push(fault);
        } else {
            self.more += 1;
        }
    }

    /// The value, or the fault, which is added.
    pub(crate) fn keep<T>(&mut self, found: Result<T, FileError>) -> Option<T> {
        found.map_err(|fault| self.push(fault)).ok()
    }

    /// Refuses what has a fault.
    pub(crate) fn none_or_refused(self) -> Result<(), Self> {
        if self.told.is_empty() {
            Ok(())
        } else {
            Err(self)
        }
    }
}

impl From<FileError> for FileErrors {
    fn from(fault: FileError) -> Self {
        Self {
            told: vec![fault],
            more: 0,
        }
    }
}

impl fmt::Display for FileErrors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, fault) in self.told.iter().enumerate() {
            let end = if place == 0 { "" } else { "\n" };
            write!(f, "{end}{fault}")?;
        }
        match self.more {
            0 => Ok(()),
            more => write!(f, "\nand {more} more"),
        }
    }
}

impl std::error::Error for FileErrors {}

/// A name was refused: no built-in scene has it, and no file can be read under it.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OpenError {
    /// The name of a built-in scene was refused.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A file is not a scene.
    #[error(transparent)]
    File(#[from] FileErrors),
}

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
}

/// The format has no place for something that the scene has.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{format} cannot say that {what}: {mend}")]
pub struct NotExpressible {
    /// Name of the format.
    pub format: &'static str,
    /// The part of the scene that would be lost.
    pub what: String,
    /// The remedy.
    pub mend: &'static str,
}

impl NotExpressible {
    /// The remedy of a patch with more corners than the format's faces have.
    pub const SPLIT: &'static str = "cut it into triangles";
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

/// The beginning of what a file says, fit for a message.
pub(crate) fn excerpt(text: &str) -> String {
    const LONGEST: usize = 40;
    let mut short: String = text
        .chars()
        .take(LONGEST)
        .flat_map(char::escape_debug)
        .collect();
    if text.chars().nth(LONGEST).is_some() {
        short.push('…');
    }
    short
}
