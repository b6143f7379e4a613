//! Chunks as files: written aside, renamed into place.

use super::StoreError;
use super::error::at;
use std::fs;
use std::hash::{BuildHasher, RandomState};
use std::io::{Read as _, Seek as _, SeekFrom};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

/// The folder of a store in which files are before they are whole.
const ASIDE: &str = "unfinished";

/// The time after which a file in it that nobody has written to is that of a writer who was killed:
/// chunks are written in seconds.
const FORSAKEN: Duration = Duration::from_secs(3600);

/// The arrays of a store.
pub(super) const FORM_FACTORS: &str = "form_factors";
pub(super) const BOUNDS: &str = "bounds";
pub(super) const AREAS: &str = "areas";

/// The folder in which files are written before they are moved into place.
#[derive(Debug)]
pub(super) struct Aside {
    folder: PathBuf,
    /// A token that no other writer has, on this machine or another that shares the folder.
    token: u64,
    next: AtomicUsize,
}

/// The chunks of one array.
#[derive(Debug)]
pub(super) struct Chunks {
    folder: PathBuf,
    bytes: u64,
}

impl Aside {
    /// The place beside a store's arrays; what was left there by those who were killed is removed.
    pub(super) fn new(store: &Path) -> Result<Self, StoreError> {
        let folder = store.join(FORM_FACTORS).join(ASIDE);
        fs::create_dir_all(&folder).map_err(at(&folder))?;
        for file in fs::read_dir(&folder).map_err(at(&folder))?.flatten() {
            let written = file.metadata().and_then(|file| file.modified());
            let age = written.ok().and_then(|written| written.elapsed().ok());
            if age.is_some_and(|age| age > FORSAKEN) {
                // another process may have been faster
                drop(fs::remove_file(file.path()));
            }
        }
        Ok(Self {
            folder,
            token: RandomState::new().hash_one(process::id()),
            next: AtomicUsize::new(0),
        })
    }

    /// Writes a file, the whole of it or none; a file of that name is replaced.
    pub(super) fn write(&self, path: &Path, bytes: &[u8]) -> Result<(), StoreError> {
        let number = self.next.fetch_add(1, Ordering::Relaxed);
        let aside = self.folder.join(format!("{:016x}-{number}", self.token));
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder).map_err(at(folder))?;
        }
        let written = fs::write(&aside, bytes).map_err(at(&aside));
        let moved = written.and_then(|()| fs::rename(&aside, path).map_err(at(path)));
        if moved.is_err() {
            // the first error is what matters
            drop(fs::remove_file(&aside));
        }
        moved
    }
}

impl Chunks {
    /// The form factors and the bounds of a matrix.
    pub(super) fn of_matrix(store: &Path, side: usize) -> [Self; 2] {
        let entries = side as u64 * side as u64;
        [(FORM_FACTORS, 8), (BOUNDS, 4)].map(|(name, size)| Self {
            folder: store.join(name).join("c"),
            bytes: entries * size,
        })
    }

    /// The areas of rows, in one chunk.
    pub(super) fn of_areas(store: &Path, rows: usize) -> Self {
        Self {
            folder: store.join(AREAS).join("c"),
            bytes: rows as u64 * 8,
        }
    }

    /// Whether a chunk is there, the whole of it.
    pub(super) fn is_whole(&self, place: &[usize]) -> bool {
        let file = fs::metadata(self.path(place));
        file.is_ok_and(|file| file.is_file() && file.len() == self.bytes)
    }

    /// Writes a chunk.
    pub(super) fn write(
        &self,
        aside: &Aside,
        place: &[usize],
        bytes: &[u8],
    ) -> Result<(), StoreError> {
        debug_assert!(bytes.len() as u64 == self.bytes, "chunks have one size");
        aside.write(&self.path(place), bytes)
    }

    /// The bytes of a chunk; none if it is not there, or not whole.
    pub(super) fn read(&self, place: &[usize]) -> Result<Option<Vec<u8>>, StoreError> {
        if !self.is_whole(place) {
            return Ok(None);
        }
        let path = self.path(place);
        fs::read(&path).map(Some).map_err(at(&path))
    }

    /// Some of the bytes of a chunk.
    pub(super) fn read_part(
        &self,
        place: &[usize],
        part: Range<usize>,
    ) -> Result<Vec<u8>, StoreError> {
        let path = self.path(place);
        let mut bytes = vec![0; part.len()];
        let read = |bytes: &mut [u8]| {
            let mut file = fs::File::open(&path)?;
            file.seek(SeekFrom::Start(part.start as u64))?;
            file.read_exact(bytes)
        };
        read(&mut bytes).map_err(at(&path))?;
        Ok(bytes)
    }

    fn path(&self, place: &[usize]) -> PathBuf {
        let parts = place.iter().map(usize::to_string);
        parts.fold(self.folder.clone(), |path, part| path.join(part))
    }
}

/// Numbers as little-endian f64.
pub(super) fn doubles(values: impl Iterator<Item = f64>) -> Vec<u8> {
    values.flat_map(f64::to_le_bytes).collect()
}

/// Numbers as little-endian f32, each rounded up.
pub(super) fn singles_above(values: impl Iterator<Item = f64>) -> Vec<u8> {
    values
        .map(single_above)
        .flat_map(f32::to_le_bytes)
        .collect()
}

/// Little-endian f64 as numbers.
pub(super) fn of_doubles(bytes: &[u8]) -> Vec<f64> {
    let parts = bytes.as_chunks::<8>().0.iter();
    parts.map(|part| f64::from_le_bytes(*part)).collect()
}

/// Little-endian f32 as numbers.
pub(super) fn of_singles(bytes: &[u8]) -> Vec<f64> {
    let parts = bytes.as_chunks::<4>().0.iter();
    parts
        .map(|part| f64::from(f32::from_le_bytes(*part)))
        .collect()
}

/// The least f32 that is not below a number.
fn single_above(value: f64) -> f32 {
    #[expect(clippy::cast_possible_truncation, reason = "mended on the next line")]
    let near = value as f32;
    if f64::from(near) < value {
        near.next_up()
    } else {
        near
    }
}
