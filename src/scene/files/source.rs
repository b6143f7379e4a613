//! The text of a file with its name, and its lines with their numbers.

use super::error::{Fault, FileError, excerpt};
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

/// No scene that could be computed needs more bytes.
const LARGEST: u64 = 1 << 28;

/// A text and where it is from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    file: PathBuf,
    text: String,
}

impl Source {
    /// A text under a name.
    #[must_use]
    pub fn new(file: impl Into<PathBuf>, text: impl Into<String>) -> Self {
        Self {
            file: file.into(),
            text: text.into(),
        }
    }

    /// The text that these bytes are, in UTF-8 with or without a byte order mark.
    ///
    /// # Errors
    /// [`Fault::NotUtf8`] with the line.
    pub fn from_bytes(file: impl Into<PathBuf>, bytes: Vec<u8>) -> Result<Self, FileError> {
        let file = file.into();
        match String::from_utf8(bytes) {
            Ok(mut text) => {
                if text.starts_with('\u{feff}') {
                    text.drain(..'\u{feff}'.len_utf8());
                }
                Ok(Self { file, text })
            }
            Err(error) => {
                let valid = &error.as_bytes()[..error.utf8_error().valid_up_to()];
                let lines = valid.split(|byte| *byte == b'\n');
                let column = 1 + lines.clone().next_back().map_or(0, <[u8]>::len);
                let line = Some(lines.count());
                let fault = Fault::NotUtf8 { column };
                Err(FileError {
                    line,
                    ..FileError::of_file(&file, fault)
                })
            }
        }
    }

    /// The text of a file.
    ///
    /// # Errors
    /// [`Fault::CannotRead`], [`Fault::IsFolder`], [`Fault::TooLarge`], [`Fault::NotUtf8`].
    pub fn read(path: &Path) -> Result<Self, FileError> {
        Self::from_bytes(path, Self::bytes(path)?)
    }

    /// The bytes of a file.
    ///
    /// # Errors
    /// [`Fault::CannotRead`], [`Fault::IsFolder`], [`Fault::TooLarge`].
    pub(crate) fn bytes(path: &Path) -> Result<Vec<u8>, FileError> {
        Self::check(path)?;
        let mut bytes = Vec::new();
        fs::File::open(path)
            .and_then(|file| file.take(LARGEST + 1).read_to_end(&mut bytes))
            .map_err(|error| cannot_read(path, &error))?;
        if bytes.len() as u64 > LARGEST {
            return Err(FileError::of_file(path, Fault::TooLarge { limit: LARGEST }));
        }
        Ok(bytes)
    }

    /// Checks that there is a file that could be read.
    pub(crate) fn check(path: &Path) -> Result<(), FileError> {
        match fs::metadata(path) {
            Err(error) => Err(cannot_read(path, &error)),
            Ok(found) if found.is_dir() => Err(FileError::of_file(path, Fault::IsFolder)),
            Ok(found) if found.len() > LARGEST => {
                Err(FileError::of_file(path, Fault::TooLarge { limit: LARGEST }))
            }
            Ok(_) => Ok(()),
        }
    }

    /// The name of the file.
    #[must_use]
    pub fn file(&self) -> &Path {
        &self.file
    }

    /// The lines, without their ends and numbered from 1.
    pub(crate) fn lines(&self) -> impl Iterator<Item = (usize, &str)> {
        self.text.lines().zip(1..).map(|(text, line)| (line, text))
    }

    /// A fault in a line of this file.
    pub(crate) fn fault(&self, line: usize, fault: Fault) -> FileError {
        FileError {
            line: Some(line),
            ..FileError::of_file(&self.file, fault)
        }
    }

    /// A fault of a patch that a line of this file defines.
    pub(crate) fn patch_fault(&self, line: usize, patch: String, fault: Fault) -> FileError {
        FileError {
            patch: Some(patch),
            ..self.fault(line, fault)
        }
    }
}

fn cannot_read(path: &Path, error: &std::io::Error) -> FileError {
    let reason = error.to_string();
    FileError::of_file(path, Fault::CannotRead { reason })
}

/// A finite number; `what` and `form` name the value and the line it belongs to.
pub(crate) fn number(
    given: Option<&str>,
    what: &'static str,
    form: &'static str,
) -> Result<f64, Fault> {
    let given = given.ok_or(Fault::Missing { what, form })?;
    match given.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err(Fault::NotFinite {
            what,
            given: excerpt(given),
        }),
        Err(_) => Err(Fault::NotANumber {
            what,
            given: excerpt(given),
            form,
        }),
    }
}
