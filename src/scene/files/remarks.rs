//! Remarks of a reader: what it mended or ignored, each kind once, counted.

use super::error::excerpt;
use super::faces::{Face, Mend};
use super::source::Source;
use std::collections::BTreeMap;
use std::path::Path;

/// The letters of a name that count: each face has a copy.
const LONGEST_NAME: usize = 64;

/// The number of words without effect that are named.
const MOST_WORDS: usize = 20;

/// Something that was mended or left out, and may be so many times.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Remark {
    /// The outline of a face was mended.
    Mended(Mend),
    /// A face has no area.
    WithoutArea,
    /// A statement is about what has no area, such as lines.
    LeftOut(&'static str),
    /// A vertex has more than coordinates, and it is neither a weight nor a colour.
    AfterCoordinates,
    /// A name is cut.
    LongName,
    /// The normal of a facet points to its back.
    NormalToTheBack,
    /// A byte is not UTF-8.
    Latin1,
}

/// A count, and the line of the first.
#[derive(Debug, Clone, Copy)]
struct Tally {
    count: usize,
    first: usize,
}

impl Tally {
    const fn at(first: usize) -> Self {
        Self { count: 1, first }
    }
}

/// The places of a file.
#[derive(Debug, Clone, Copy, Default)]
enum Unit {
    /// Lines, from 1.
    #[default]
    Line,
    /// Facets, from 0.
    Facet,
    /// Faces, from 0.
    Face,
}

/// The remarks about one file.
#[derive(Debug, Default)]
pub(crate) struct Remarks {
    kinds: BTreeMap<Remark, Tally>,
    words: Vec<(String, Tally)>,
    more_words: Option<Tally>,
    /// The places that are counted, such as lines.
    unit: Unit,
}

impl Remarks {
    /// The remarks about how a text is written.
    pub(crate) fn of(source: &Source) -> Self {
        let mut remarks = Self::default();
        if let Some((count, first)) = source.latin_1() {
            remarks.kinds.insert(Remark::Latin1, Tally { count, first });
        }
        remarks
    }

    /// Remarks about a file without lines, whose places are the numbers of facets.
    pub(crate) fn of_facets() -> Self {
        Self {
            unit: Unit::Facet,
            ..Self::default()
        }
    }

    /// Remarks about a mesh in arrays, whose places are the numbers of faces.
    pub(crate) fn of_faces() -> Self {
        Self {
            unit: Unit::Face,
            ..Self::default()
        }
    }

    /// A name of bounded length.
    pub(crate) fn short_name(&mut self, line: usize, mut name: String) -> String {
        if let Some((end, _)) = name.char_indices().nth(LONGEST_NAME) {
            name.truncate(end);
            self.count(Remark::LongName, line);
        }
        name
    }

    /// Counts what was mended of a face.
    pub(crate) fn count_face(&mut self, face: &Face, line: usize) {
        for mend in &face.mends {
            self.count(Remark::Mended(*mend), line);
        }
        if face.patches.is_empty() {
            self.count(Remark::WithoutArea, line);
        }
    }

    /// Counts something in a line.
    pub(crate) fn count(&mut self, remark: Remark, line: usize) {
        let tally = self.kinds.entry(remark);
        let tally = tally.and_modify(|tally| tally.count += 1);
        tally.or_insert(Tally::at(line));
    }

    /// Counts a word that has no effect.
    pub(crate) fn ignore(&mut self, word: &str, line: usize) {
        let word = excerpt(word);
        if let Some((_, tally)) = self.words.iter_mut().find(|(known, _)| *known == word) {
            tally.count += 1;
        } else if self.words.len() < MOST_WORDS {
            self.words.push((word, Tally::at(line)));
        } else if let Some(tally) = &mut self.more_words {
            tally.count += 1;
        } else {
            self.more_words = Some(Tally::at(line));
        }
    }

    /// The remarks as sentences, each with the name of the file.
    pub(crate) fn into_notes(self, file: &Path) -> Vec<String> {
        let ignored = self.ignored();
        let unit = match self.unit {
            Unit::Line => "line",
            Unit::Facet => "facet",
            Unit::Face => "face",
        };
        let kinds = self.kinds.iter();
        let kinds = kinds.map(|(kind, tally)| sentence(*kind, *tally, unit));
        let all = kinds.chain(ignored);
        all.map(|text| format!("{}: {text}", file.display()))
            .collect()
    }

    fn ignored(&self) -> Option<String> {
        let place = |tally: &Tally| match tally.count {
            1 => format!("line {}", tally.first),
            count => format!("{count} times, first in line {}", tally.first),
        };
        let words = self.words.iter();
        let words = words.map(|(word, tally)| format!("{word} ({})", place(tally)));
        let more = self.more_words.iter();
        let more = more.map(|tally| format!("and other words ({})", place(tally)));
        let all: Vec<String> = words.chain(more).collect();
        (!all.is_empty()).then(|| format!("ignored, they change nothing here: {}", all.join(", ")))
    }
}

fn sentence(kind: Remark, Tally { count, first }: Tally, unit: &str) -> String {
    let (one, several, rest) = match kind {
        Remark::Mended(Mend::Repeat) => (
            "face repeats a corner",
            "faces repeat a corner",
            "; that counts once",
        ),
        Remark::Mended(Mend::Spike) => (
            "face runs out and back",
            "faces run out and back",
            "; such a spike is left out",
        ),
        Remark::Mended(Mend::Openings) => (
            "face is bridged around openings",
            "faces are bridged around openings",
            "; its polygons count as one row",
        ),
        Remark::WithoutArea => (
            "face has no area",
            "faces have no area",
            "; such a face keeps its number and exchanges nothing",
        ),
        Remark::LeftOut(keyword) => {
            let lines = if count == 1 { "line" } else { "lines" };
            return format!(
                "\"{keyword}\" has no area and is left out ({count} {lines}, first: line {first})"
            );
        }
        Remark::AfterCoordinates => (
            "vertex has more than coordinates, a weight or a colour",
            "vertices have more than coordinates, a weight or a colour",
            "; the rest is ignored",
        ),
        Remark::LongName => (
            "name is very long",
            "names are very long",
            "; its beginning counts",
        ),
        Remark::NormalToTheBack => (
            "normal points to the back of its facet",
            "normals point to the back of their facets",
            "; the order of the corners says which side is the front",
        ),
        Remark::Latin1 => (
            "byte is not UTF-8 and read as Latin-1",
            "bytes are not UTF-8 and read as Latin-1",
            "",
        ),
    };
    let what = if count == 1 { one } else { several };
    format!("{count} {what}{rest} (first: {unit} {first})")
}
