//! The letters of a PDF file's two fonts, with their widths.
//!
//! # Source
//! Adobe, *PDF Reference*, 6th ed., appendix D (Latin and Symbol character sets); the widths are
//! those of Adobe's metrics of Helvetica.

/// A letter in one of the fonts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Letter {
    /// The code in its font.
    pub(crate) code: u8,
    /// Is the font Symbol, not Helvetica?
    pub(crate) is_symbol: bool,
    /// Is it a small one, above the line?
    pub(crate) is_raised: bool,
}

/// The size of small letters over that of others, and how far they are raised, in em.
pub(crate) const SMALL: (f64, f64) = (0.65, 0.35);

/// Widths of Helvetica's letters from the space on, in thousandths of an em.
const WIDTHS: [u16; 95] = [
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667, 611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584,
];

/// Signs of the font Symbol.
const SYMBOLS: [(char, u8); 16] = [
    ('Δ', 0x44),
    ('Σ', 0x53),
    ('Φ', 0x46),
    ('δ', 0x64),
    ('ε', 0x65),
    ('μ', 0x6d),
    ('π', 0x70),
    ('ρ', 0x72),
    ('σ', 0x73),
    ('≤', 0xa3),
    ('∞', 0xa5),
    ('→', 0xae),
    ('≥', 0xb3),
    ('∝', 0xb5),
    ('√', 0xd6),
    ('≈', 0xbb),
];

/// Signs of Helvetica beyond Latin-1.
const OTHERS: [(char, u8); 5] = [
    ('−', 0x96),
    ('–', 0x96),
    ('—', 0x97),
    ('’', 0x92),
    ('…', 0x85),
];

/// Small letters above the line.
const RAISED: [(char, char); 9] = [
    ('ⁿ', 'n'),
    ('⁰', '0'),
    ('⁴', '4'),
    ('⁵', '5'),
    ('⁶', '6'),
    ('⁷', '7'),
    ('⁸', '8'),
    ('⁹', '9'),
    ('⁻', '-'),
];

/// The letter for a sign; none if neither font has it.
pub(crate) fn letter(sign: char) -> Option<Letter> {
    let among = |list: &[(char, u8)]| list.iter().find(|(own, _)| *own == sign).map(|own| own.1);
    let raised = RAISED.iter().find(|(own, _)| *own == sign);
    let plain = raised.map_or(sign, |(_, plain)| *plain);
    let is_latin = matches!(plain, ' '..='~' | '\u{a1}'..='ÿ');
    let latin = u8::try_from(u32::from(plain)).ok().filter(|_| is_latin);
    let symbol = among(&SYMBOLS);
    let code = latin.or_else(|| among(&OTHERS)).or(symbol)?;
    Some(Letter {
        code,
        is_symbol: symbol.is_some(),
        is_raised: raised.is_some(),
    })
}

/// The width of a letter, in em; that of a figure where it is not in the list.
pub(crate) fn width(letter: &Letter) -> f64 {
    let place = usize::from(letter.code).checked_sub(0x20);
    let listed = place.and_then(|place| WIDTHS.get(place));
    let listed = listed.filter(|_| !letter.is_symbol);
    let scale = if letter.is_raised { SMALL.0 } else { 1.0 };
    scale * f64::from(*listed.unwrap_or(&556)) / 1000.0
}
