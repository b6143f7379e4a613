//! The refusals of a scene file: the place, the broken condition and its remedy.

use super::fault::Fault;
use crate::scene::SceneError;
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
