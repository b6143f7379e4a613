//! Changes of a file: by bytes, by words, by lines.

/// Words that a file may have where it should not, most of them at the ends of what is allowed.
const WORDS: [&str; 44] = [
    "v",
    "f",
    "o",
    "g",
    "usemtl",
    "mtllib",
    "newmtl",
    "Kd",
    "curv",
    "V",
    "S",
    "O",
    "F",
    "C",
    "T",
    "End",
    "#",
    "!",
    "/",
    "\\",
    "=",
    "\u{2028}",
    "\0",
    "\u{e9}",
    "0",
    "1",
    "-1",
    "2",
    "4",
    "+1",
    "1//1",
    "//",
    "0.5",
    "1.e-5",
    "1d-3",
    "1e308",
    "-5e-324",
    "nan",
    "-inf",
    "4000000000",
    "18446744073709551616",
    "-9223372036854775808",
    "1e-99999999999",
    "0.9e99999999999999999999",
];

/// Random numbers (SplitMix64; Steele, Lea, Flood 2014).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// A number below this one, which is 1 at least.
    pub(crate) fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        usize::try_from((z ^ (z >> 31)) % end.max(1) as u64).unwrap()
    }

    fn byte(&mut self) -> u8 {
        u8::try_from(self.below(256)).unwrap()
    }
}

/// The file changed once.
pub(crate) fn changed(file: &[u8], seeds: &[Vec<u8>], random: &mut Random) -> Vec<u8> {
    let at = random.below(file.len() + 1);
    let end = (at + 1 + random.below(12)).min(file.len());
    let (before, after) = (&file[..at], &file[at..]);
    let rest = &file[end..];
    match random.below(8) {
        // bytes: put in, replaced, cut out, cut off, joined with another file
        0 => {
            let count = 1 + random.below(8);
            let bytes: Vec<u8> = (0..count).map(|_| random.byte()).collect();
            [before, &bytes, after].concat()
        }
        1 => [before, &[random.byte()], rest].concat(),
        2 => [before, rest].concat(),
        3 => before.to_vec(),
        4 => {
            let other = &seeds[random.below(seeds.len())];
            [before, &other[random.below(other.len())..]].concat()
        }
        5 => changed_words(file, random),
        _ => changed_lines(file, random),
    }
}

/// A word replaced, put in, taken out or said twice, or two of a line exchanged.
fn changed_words(file: &[u8], random: &mut Random) -> Vec<u8> {
    let mut lines: Vec<Vec<&[u8]>> = file
        .split(|byte| *byte == b'\n')
        .map(|line| line.split(|byte| *byte == b' ').collect())
        .collect();
    let line = random.below(lines.len());
    let words = &mut lines[line];
    let [at, other] = [0; 2].map(|_| random.below(words.len()));
    let new = WORDS[random.below(WORDS.len())].as_bytes();
    match random.below(5) {
        0 => words.insert(at, new),
        1 => drop(words.remove(at)),
        2 => words.insert(at, words[other]),
        3 => words.swap(at, other),
        _ => words[at] = new,
    }
    let lines: Vec<Vec<u8>> = lines.iter().map(|words| words.join(&b' ')).collect();
    lines.join(&b'\n')
}

/// A line taken out, said many times or exchanged with another, or all lines ended otherwise.
fn changed_lines(file: &[u8], random: &mut Random) -> Vec<u8> {
    let mut lines: Vec<&[u8]> = file.split(|byte| *byte == b'\n').collect();
    let [at, other] = [0; 2].map(|_| random.below(lines.len()));
    let mut end: &[u8] = b"\n";
    match random.below(5) {
        0 => drop(lines.remove(at)),
        1 => {
            let line = lines[at];
            lines.splice(at..at, std::iter::repeat_n(line, random.below(40)));
        }
        2 | 3 => lines.swap(at, other),
        _ => end = [b"\r".as_slice(), b"\r\n", b"\\\n", b"\n\n"][random.below(4)],
    }
    lines.join(end)
}
