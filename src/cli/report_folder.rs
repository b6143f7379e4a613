//! A folder of files that is written aside and moved into place when it is complete.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// A file that every report has: a folder without it is somebody else's.
const SIGN: &str = "report.schema.json";

/// A folder cannot be written.
#[derive(Debug, thiserror::Error)]
pub(super) enum FolderError {
    /// The folder holds something else.
    #[error(
        "{} is no earlier report, as it has no {SIGN}: name an empty or a new folder; nothing was \
         written", place.display()
    )]
    NotOurs { place: PathBuf },
    /// The system refuses.
    #[error("cannot write {}: {source}; nothing was written", place.display())]
    CannotWrite { place: PathBuf, source: io::Error },
}

/// A folder that is being written; it is removed unless it is moved into place.
#[derive(Debug)]
pub(super) struct NewFolder {
    place: PathBuf,
    aside: PathBuf,
}

impl NewFolder {
    /// A new folder beside the place where it belongs.
    ///
    /// # Errors
    /// [`FolderError::NotOurs`] if something else is there; [`FolderError::CannotWrite`].
    pub(super) fn beside(place: &Path) -> Result<Self, FolderError> {
        let refused = |source| FolderError::CannotWrite {
            place: place.to_owned(),
            source,
        };
        if place.exists() {
            let mut entries = fs::read_dir(place).map_err(refused)?;
            if !place.join(SIGN).is_file() && entries.next().is_some() {
                let place = place.to_owned();
                return Err(FolderError::NotOurs { place });
            }
        }
        // a folder is replaced where it is, however it is named
        let place = place.canonicalize().unwrap_or_else(|_| place.to_owned());
        let name = place
            .file_name()
            .map(|name| name.to_string_lossy().into_owned());
        let name = name.unwrap_or_default();
        let aside = place.with_file_name(format!(".{name}-{}", std::process::id()));
        fs::create_dir(&aside).map_err(refused)?;
        Ok(Self { place, aside })
    }

    /// Writes a file into it, and the folders on its path.
    ///
    /// # Errors
    /// [`FolderError::CannotWrite`].
    pub(super) fn write(&self, path: &str, content: &[u8]) -> Result<(), FolderError> {
        let file = self.aside.join(path);
        let folder = file.parent().unwrap_or(&self.aside);
        let written = fs::create_dir_all(folder).and_then(|()| fs::write(&file, content));
        written.map_err(|source| self.refused(source))
    }

    /// Puts it where it belongs, in place of an earlier one.
    ///
    /// # Errors
    /// [`FolderError::CannotWrite`]; then the earlier one is back.
    pub(super) fn move_into_place(self) -> Result<(), FolderError> {
        let earlier = self.aside.with_extension("earlier");
        let has_earlier = self.place.exists();
        if has_earlier {
            fs::rename(&self.place, &earlier).map_err(|source| self.refused(source))?;
        }
        if let Err(source) = fs::rename(&self.aside, &self.place) {
            if has_earlier {
                // what went wrong first is reported
                _ = fs::rename(&earlier, &self.place);
            }
            return Err(self.refused(source));
        }
        if has_earlier {
            fs::remove_dir_all(&earlier).map_err(|source| self.refused(source))?;
        }
        Ok(())
    }

    fn refused(&self, source: io::Error) -> FolderError {
        FolderError::CannotWrite {
            place: self.place.clone(),
            source,
        }
    }
}

impl Drop for NewFolder {
    fn drop(&mut self) {
        // gone if it was moved; what stopped the report is reported, not this
        _ = fs::remove_dir_all(&self.aside);
    }
}
