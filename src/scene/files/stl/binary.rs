//! Binary STL: a head of 84 bytes, then 50 for each facet.

use super::{Facet, Reader};
use crate::scene::files::error::{FileError, FileErrors};
use crate::scene::files::fault::Fault;
use glam::DVec3;
use std::path::Path;

/// Bytes before the number of facets.
const TITLE: usize = 80;
/// Bytes before the first facet.
const HEAD: usize = TITLE + 4;
/// Bytes of a facet.
const FACET: usize = 50;

/// Tells a binary file from a text, which may both begin with `solid`.
pub(super) fn is_binary(bytes: &[u8]) -> bool {
    let begins_as_text = || {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let word = bytes.trim_ascii_start().get(..5);
        word.is_some_and(|word| word.eq_ignore_ascii_case(b"solid"))
    };
    let has_the_length = |facets: usize| bytes.len() == HEAD.saturating_add(FACET * facets);
    count(bytes).is_some_and(has_the_length) || !begins_as_text() || bytes.contains(&0)
}

/// The number of facets that the head counts.
fn count(bytes: &[u8]) -> Option<usize> {
    let (_, rest) = bytes.split_at_checked(TITLE)?;
    let (count, _) = rest.split_first_chunk()?;
    usize::try_from(u32::from_le_bytes(*count)).ok()
}

pub(super) fn read(file: &Path, bytes: &[u8], reader: &mut Reader) -> Result<(), FileErrors> {
    let not = |fault| FileError::of_file(file, fault);
    let head = || not(Fault::NoStlHead { bytes: bytes.len() });
    let counted = count(bytes).ok_or_else(head)?;
    let (facets, rest) = bytes[HEAD..].as_chunks::<FACET>();
    let held = facets.len();
    let Some(facets) = facets.get(..counted) else {
        return Err(not(Fault::FacetsMissing { counted, held }).into());
    };
    let left = rest.len() + (held - counted) * FACET;
    if left > 0 {
        let (file, what) = (file.display(), "are ignored");
        let note = format!("{file}: {left} bytes after the last of {counted} facets {what}");
        reader.notes.push(note);
    }
    let mut faults = FileErrors::default();
    for (place, facet) in facets.iter().enumerate() {
        let [normal, corners @ ..] = vectors(facet);
        let facet = Facet {
            corners: corners.to_vec(),
            normal: normal.is_finite().then_some(normal),
            place,
        };
        let added = reader.facet("", facet);
        faults.keep(added.map_err(|(patch, fault)| FileError {
            patch: Some(patch),
            ..not(fault)
        }));
    }
    faults.none_or_refused()
}

/// The normal and the corners of a facet.
fn vectors(facet: &[u8; FACET]) -> [DVec3; 4] {
    let (words, _attribute) = facet.as_chunks::<4>();
    let number = |place: usize| {
        let word = words.get(place).copied().unwrap_or_default();
        f64::from(f32::from_le_bytes(word))
    };
    [0, 3, 6, 9].map(|first| DVec3::from_array([0, 1, 2].map(|axis| number(first + axis))))
}
