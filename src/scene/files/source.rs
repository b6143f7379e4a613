//! The text of a file with its name, and its lines with their numbers.

use super::error::{FileError, excerpt};
use super::fault::Fault;
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
    /// The number of bytes that are not UTF-8, and the line of the first.
    latin_1: Option<(usize, usize)>,
}

impl Source {
    /// A text under a name.
    #[must_use]
    pub fn new(file: impl Into<PathBuf>, text: impl Into<String>) -> Self {
        Self {
            file: file.into(),
            text: text.into(),
            latin_1: None,
        }
    }

    /// The text that these bytes are: UTF-8 with or without a byte order mark; bytes that are not
    /// UTF-8 are read as Latin-1.
    ///
    /// # Errors
    /// [`Fault::Utf16`].
    pub fn from_bytes(file: impl Into<PathBuf>, bytes: Vec<u8>) -> Result<Self, FileError> {
        let file = file.into();
        if let [0xff, 0xfe, ..] | [0xfe, 0xff, ..] | [0, _, ..] | [_, 0, ..] = bytes.as_slice() {
            return Err(FileError::of_file(&file, Fault::Utf16));
        }
        let mut latin_1 = None;
        let mut text = String::from_utf8(bytes).unwrap_or_else(|error| {
            let valid = &error.as_bytes()[..error.utf8_error().valid_up_to()];
            let line = 1 + line_ends(&String::from_utf8_lossy(valid));
            let mut count = 0;
            let mut text = String::with_capacity(error.as_bytes().len());
            for chunk in error.as_bytes().utf8_chunks() {
                text.push_str(chunk.valid());
                text.extend(chunk.invalid().iter().map(|byte| char::from(*byte)));
                count += chunk.invalid().len();
            }
            latin_1 = Some((count, line));
            text
        });
        if text.starts_with('\u{feff}') {
            text.drain(..'\u{feff}'.len_utf8());
        }
        Ok(Self {
            file,
            text,
            latin_1,
        })
    }

    /// The text of a file.
    ///
    /// # Errors
    /// [`Fault::CannotRead`], [`Fault::IsFolder`], [`Fault::TooLarge`], [`Fault::Utf16`].
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

    /// The number of bytes that are not UTF-8, and the line of the first, if there are any.
    pub(crate) const fn latin_1(&self) -> Option<(usize, usize)> {
        self.latin_1
    }

    /// The lines, without their ends and numbered from 1; they end in LF, CR or both.
    pub(crate) fn lines(&self) -> impl Iterator<Item = (usize, &str)> {
        let lines = self.text.lines().flat_map(|line| line.split('\r'));
        lines.zip(1..).map(|(text, line)| (line, text))
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

/// The number of line ends in a text.
fn line_ends(text: &str) -> usize {
    let returns = text.matches('\r').count() - text.matches("\r\n").count();
    returns + text.matches('\n').count()
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
