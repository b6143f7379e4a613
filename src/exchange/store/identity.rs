//! All that the numbers of a store depend on, as lines of text.
//!
//! Two stores with the same text hold the same bytes. Numbers are written so that they read back to
//! the same `f64`; a row is told with its name, and each of its polygons with a sign and its
//! corners.

use super::StoreError;
use super::chunk::FORM_FACTORS;
use super::error::at;
use crate::exchange::{Congruence, Tolerance};
use crate::scene::{NamedPatch, Occlusion, Scene};
use std::fmt::Write as _;
use std::fs;
use std::hash::{BuildHasher, RandomState};
use std::io;
use std::path::Path;

/// The first line.
const FIRST: &str = "infoscene form factors, layout 1";
/// The name of the file, beside the chunks: in the group itself readers of Zarr would wonder at it.
const FILE: &str = "scene.txt";
/// The words before the numbers of rows, and of rows along a chunk.
const ROWS: &str = "rows ";
const SIDE: &str = "side ";

/// The text that tells one matrix from others.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Identity(String);

impl Identity {
    /// That of a scene's matrix, with so many rows in all and along a chunk.
    pub(super) fn of(
        scene: &Scene,
        (rows, side): (usize, usize),
        tolerance: Tolerance,
        (congruence, occlusion): (Congruence, Occlusion),
    ) -> Self {
        let mut text = format!(
            "{FIRST}\nversion {}\n{ROWS}{rows}\n{SIDE}{side}\n",
            env!("CARGO_PKG_VERSION")
        );
        let mut line = |words: std::fmt::Arguments<'_>| {
            // a String takes whatever is written
            let _: std::fmt::Result = writeln!(text, "{words}");
        };
        let relative = tolerance.relative;
        match tolerance.absolute {
            Some(absolute) => line(format_args!("tolerance {relative:?} or {absolute:?}")),
            None => line(format_args!("tolerance {relative:?}")),
        }
        line(format_args!("congruent pairs {congruence:?}"));
        line(format_args!("occlusion {occlusion:?}"));
        line(format_args!("resolution {:?}", scene.resolution()));
        for (index, patch) in scene.patches().iter().enumerate() {
            let base = scene.base_of(index).map(|base| format!(" in {base}"));
            let base = base.unwrap_or_default();
            let row = scene.group_of(index);
            line(format_args!("row {row}{base}:{}", corners(patch)));
        }
        for patch in scene.obstructions() {
            line(format_args!("obstruction:{}", corners(patch)));
        }
        for (row, name) in scene.group_names().iter().enumerate() {
            line(format_args!("name {row} {name:?}"));
        }
        Self(text)
    }

    /// Makes a folder the store of this matrix, or sees that it is.
    pub(super) fn settle(&self, folder: &Path, resume: bool) -> Result<(), StoreError> {
        let not_empty = || match resume {
            true => no_store(folder),
            false => StoreError::NotEmpty {
                folder: folder.to_owned(),
            },
        };
        let own = folder.join(FORM_FACTORS);
        let path = own.join(FILE);
        match fs::read_to_string(&path) {
            Ok(found) if resume => self.compare(folder, &found),
            Ok(_) => Err(not_empty()),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                // of several that begin at once, any may be the last: they write the same
                let begun = |name: &str| resume && name.starts_with(FILE);
                let others = names(folder)?.into_iter().any(|name| name != FORM_FACTORS);
                if others || !names(&own)?.iter().all(|name| begun(name)) {
                    return Err(not_empty());
                }
                fs::create_dir_all(&own).map_err(at(&own))?;
                let token = RandomState::new().hash_one(std::process::id());
                let aside = own.join(format!("{FILE}-{token:016x}"));
                fs::write(&aside, &self.0).map_err(at(&aside))?;
                fs::rename(&aside, &path).map_err(at(&path))
            }
            Err(error) => Err(at(&path)(error)),
        }
    }

    /// Sees that a folder is the store of this matrix.
    pub(super) fn require(&self, folder: &Path) -> Result<(), StoreError> {
        let path = folder.join(FORM_FACTORS).join(FILE);
        let found = fs::read_to_string(&path).map_err(|error| match error.kind() {
            io::ErrorKind::NotFound | io::ErrorKind::NotADirectory => no_store(folder),
            _ => at(&path)(error),
        })?;
        self.compare(folder, &found)
    }

    fn compare(&self, folder: &Path, found: &str) -> Result<(), StoreError> {
        if found == self.0 {
            return Ok(());
        }
        let end = "the end";
        let (mut theirs, mut ours) = (found.lines(), self.0.lines());
        for line in 1.. {
            let [one, other] = [theirs.next(), ours.next()];
            if one != other || one.is_none() {
                let words = |line: Option<&str>| line.unwrap_or(end).to_owned();
                return Err(StoreError::OtherMatrix {
                    folder: folder.to_owned(),
                    line,
                    found: words(one),
                    expected: words(other),
                });
            }
        }
        Ok(())
    }
}

/// The refusal of a folder that is no store.
pub(super) fn no_store(folder: &Path) -> StoreError {
    StoreError::NoStore {
        folder: folder.to_owned(),
        expected: FIRST,
    }
}

/// The numbers of rows in all and along a chunk, of a store that is there.
pub(super) fn layout(folder: &Path) -> Result<[usize; 2], StoreError> {
    let no_store = || no_store(folder);
    let text = fs::read_to_string(folder.join(FORM_FACTORS).join(FILE)).map_err(|_| no_store())?;
    let mut lines = text.lines();
    if lines.next() != Some(FIRST) {
        return Err(no_store());
    }
    let mut number = |name: &str| {
        let line = lines.find_map(|line| line.strip_prefix(name));
        line.and_then(|text| text.parse().ok()).ok_or_else(no_store)
    };
    Ok([number(ROWS)?, number(SIDE)?])
}

/// The names in a folder; none if there is no such folder.
fn names(folder: &Path) -> Result<Vec<String>, StoreError> {
    match fs::read_dir(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Vec::new()),
        entries => entries
            .map_err(at(folder))?
            .map(|entry| {
                Ok(entry
                    .map_err(at(folder))?
                    .file_name()
                    .to_string_lossy()
                    .into_owned())
            })
            .collect(),
    }
}

fn corners(patch: &NamedPatch) -> String {
    let corners = patch.shape().corners().iter();
    corners
        .map(|c| format!(" {:?} {:?} {:?};", c.x, c.y, c.z))
        .collect()
}
