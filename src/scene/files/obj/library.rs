//! The files that a line `mtllib` means.
//!
//! ```text
//!   mtllib paint.mtl                 beside the file, in any letter case
//!   mtllib a.mtl my paint.mtl        several, with spaces in their names or between them
//!   mtllib "my paint.mtl"            in quotes, or my\ paint.mtl
//!   mtllib .\textures\paint.mtl      with backslashes
//!   mtllib C:\Users\x\paint.mtl      of another machine: the file of that name beside this one
//! ```
//!
//! A name is tried as it stands, then without its quotes, escapes and backslashes, then in other
//! letter cases, then without its folders. Two files that differ in case alone are refused if
//! neither is named exactly.

use crate::scene::files::error::FileError;
use crate::scene::files::fault::Fault;
use crate::scene::files::source::Source;
use std::path::{Component, Path, PathBuf};

/// Words that the name of one file may have.
const MOST_WORDS: usize = 8;

/// Words of a line that are looked at.
const MOST_LOOKED_AT: usize = 64;

/// The library that a file `scene` means by a name.
///
/// # Errors
/// [`Fault::CannotRead`] if there is none; [`Fault::Ambiguous`]; the errors of [`Source::read`].
pub(crate) fn read_beside(scene: &Path, name: &str) -> Result<Source, FileError> {
    let folder = scene.parent().unwrap_or_else(|| Path::new(""));
    let written = readings(name);
    for name in &written {
        let path = folder.join(name);
        if path.is_file() {
            return Source::read(&path);
        }
    }
    let bare = written.iter().filter_map(|name| name.rsplit('/').next());
    let bare: Vec<&str> = bare.filter(|name| !name.is_empty()).collect();
    for name in written.iter().map(String::as_str).chain(bare) {
        if let Some(path) = in_any_case(folder, name)? {
            return Source::read(&path);
        }
    }
    // a folder, or nothing at all; what else is no file may have no end
    let path = folder.join(name);
    Source::check(&path)?;
    let reason = "it is no file".to_owned();
    Err(FileError::of_file(&path, Fault::CannotRead { reason }))
}

/// Whether a library was found where a name says.
pub(crate) fn is_as_written(scene: &Path, name: &str, found: &Path) -> bool {
    let folder = scene.parent().unwrap_or_else(|| Path::new(""));
    readings(name).iter().any(|name| folder.join(name) == found)
}

/// A name as it stands, and without quotes, escapes and backslashes.
fn readings(name: &str) -> Vec<String> {
    let name = name.trim();
    let quotes = ['"', '\''];
    let bare = quotes
        .into_iter()
        .find_map(|quote| name.strip_prefix(quote)?.strip_suffix(quote));
    let bare = bare.unwrap_or(name).trim();
    let unescaped = bare.replace("\\ ", " ");
    let slashes = unescaped.replace('\\', "/");
    let mut readings = Vec::new();
    for reading in [name.to_owned(), bare.to_owned(), unescaped, slashes] {
        if !readings.contains(&reading) {
            readings.push(reading);
        }
    }
    readings
}

/// The file below a folder whose path is this one but for the case of letters.
fn in_any_case(folder: &Path, name: &str) -> Result<Option<PathBuf>, FileError> {
    let mut path = folder.to_owned();
    for component in Path::new(name).components() {
        match component {
            Component::CurDir => {}
            Component::ParentDir => path.push(".."),
            Component::Prefix(_) | Component::RootDir => return Ok(None),
            Component::Normal(part) => match child(&path, &part.to_string_lossy())? {
                Some(child) => path = child,
                None => return Ok(None),
            },
        }
    }
    Ok(path.is_file().then_some(path))
}

/// The entry of a folder under a name: of this name exactly, or but for the case of letters.
fn child(folder: &Path, name: &str) -> Result<Option<PathBuf>, FileError> {
    let exact = folder.join(name);
    if exact.exists() {
        return Ok(Some(exact));
    }
    let here = Path::new(".");
    let listed = if folder.as_os_str().is_empty() {
        here
    } else {
        folder
    };
    let lower = name.to_lowercase();
    let entries = listed.read_dir().into_iter().flatten().flatten();
    let names = entries.map(|entry| entry.file_name().to_string_lossy().into_owned());
    let mut fitting: Vec<String> = names.filter(|name| name.to_lowercase() == lower).collect();
    fitting.sort_unstable();
    match fitting.as_slice() {
        [] => Ok(None),
        [one] => Ok(Some(folder.join(one))),
        [one, other, ..] => {
            let names = [one.clone(), other.clone()];
            Err(FileError::of_file(&exact, Fault::Ambiguous { names }))
        }
    }
}

/// The libraries of a line, each read or refused: the whole line is one name, or words that follow
/// each other make up a name, as many as there is a file for.
pub(crate) fn libraries(
    names: &str,
    open: impl Fn(&str) -> Result<Source, FileError>,
) -> Vec<(&str, Result<Source, FileError>)> {
    let names = names.trim();
    if let Ok(library) = open(names) {
        return vec![(names, Ok(library))];
    }
    let words = words(names);
    let (mut found, mut at) = (Vec::new(), 0);
    while at < words.len() && at < MOST_LOOKED_AT {
        let end = words.len().min(at + MOST_WORDS);
        let text = |end: usize| &names[words[at].0..words[end - 1].1];
        let read = (at + 1..=end)
            .rev()
            .find_map(|end| Some((end, open(text(end)).ok()?)));
        if let Some((end, library)) = read {
            found.push((text(end), Ok(library)));
            at = end;
            continue;
        }
        let word = text(at + 1);
        if word.starts_with('#') {
            break;
        }
        let is_last = |end: &usize| text(*end).to_ascii_lowercase().ends_with(".mtl");
        let end = (at + 1..=words.len()).find(is_last).unwrap_or(words.len());
        let name = text(end);
        found.extend(open(name).err().map(|error| (name, Err(error))));
        at = end;
    }
    found
}

/// The ends of the words of a text.
fn words(text: &str) -> Vec<(usize, usize)> {
    let start = |word: &str| word.as_ptr() as usize - text.as_ptr() as usize;
    text.split_whitespace()
        .map(|word| (start(word), start(word) + word.len()))
        .collect()
}
