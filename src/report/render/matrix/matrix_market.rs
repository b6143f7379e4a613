//! Matrices in the Matrix Market's format, as coordinates or as an array.
//!
//! ```text
//!   %%MatrixMarket matrix coordinate real general        %%MatrixMarket matrix array real general
//!   % comments                                           % comments
//!   rows columns entries                                 rows columns
//!   i j F_ij        row by row, from 1                   F_ij             column by column
//! ```
//!
//! Coordinates leave out the entries that are exactly zero: pairs of patches that see nothing of
//! each other.
//!
//! Reference: Boisvert, Pozo, Remington, *The Matrix Market Exchange Formats: Initial Design*,
//! NISTIR 5935 (1996).

use crate::question::MatrixEntries;
use std::io::{self, Write};

/// Writes all that comes before the entries of a square matrix: of coordinates, if their number is
/// given, or else of an array.
pub(super) fn write_head(
    mut file: impl Write,
    entries: MatrixEntries,
    rows: usize,
    coordinates: Option<usize>,
) -> io::Result<()> {
    let kind = match coordinates {
        Some(_) => "coordinate",
        None => "array",
    };
    writeln!(file, "%%MatrixMarket matrix {kind} real general")?;
    let version = env!("CARGO_PKG_VERSION");
    writeln!(
        file,
        "% infoscene {version}, patches in the order of the scene"
    )?;
    file.write_all(match entries {
        MatrixEntries::FormFactors => {
            b"% row i, column j: the form factor from patch i to patch j, the part of the power \
              that\n% leaves i and reaches j; the sum of a row is 1 in a closed scene\n"
                as &[u8]
        }
        MatrixEntries::Bounds => {
            b"% row i, column j: a bound on the absolute error of the form factor from patch i to\n\
              % patch j\n"
        }
    })?;
    match coordinates {
        Some(count) => writeln!(file, "{rows} {rows} {count}"),
        None => writeln!(file, "{rows} {rows}"),
    }
}
