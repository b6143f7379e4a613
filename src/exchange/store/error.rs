//! Refusals of stores.

use crate::exchange::ExchangeError;
use std::io;
use std::path::{Path, PathBuf};

/// The reason why a matrix is not stored, or a store cannot be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StoreError {
    /// Something is in the folder.
    #[error(
        "{} is not empty: name a new folder, or resume the matrix that is there",
        folder.display()
    )]
    NotEmpty {
        /// The folder.
        folder: PathBuf,
    },
    /// The folder is no store.
    #[error(
        "{} is no store of form factors: it has no form_factors/scene.txt that begins with \"{expected}\"",
        folder.display()
    )]
    NoStore {
        /// The folder.
        folder: PathBuf,
        /// The line with which it would begin.
        expected: &'static str,
    },
    /// The folder has the store of another matrix.
    #[error(
        "{} holds another matrix: line {line} of its form_factors/scene.txt is \"{found}\", and \"{expected}\" \
         is wanted; name a new folder, or ask as before",
        folder.display()
    )]
    OtherMatrix {
        /// The folder.
        folder: PathBuf,
        /// The line, from 1.
        line: usize,
        /// The text of the line.
        found: String,
        /// The text that it would have.
        expected: String,
    },
    /// Some of the matrix is not there.
    #[error("{} lacks {missing} of {chunks} chunks of the matrix: fill it first", folder.display())]
    Incomplete {
        /// The folder.
        folder: PathBuf,
        /// Chunks that are not there, or not whole.
        missing: usize,
        /// Chunks of the whole matrix.
        chunks: usize,
    },
    /// A file cannot be read or written.
    #[error("{}: {source}", path.display())]
    Io {
        /// The file or folder.
        path: PathBuf,
        /// The reason.
        source: io::Error,
    },
    /// Two patches are refused.
    #[error(transparent)]
    Exchange(ExchangeError),
}

/// Names the file of an error.
pub(super) fn at(path: &Path) -> impl FnOnce(io::Error) -> StoreError + '_ {
    |source| StoreError::Io {
        path: path.to_owned(),
        source,
    }
}
