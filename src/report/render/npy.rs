//! Matrices in NumPy's file format, version 1.0.
//!
//! ```text
//!   "\x93NUMPY" 1 0 | length of the header, two bytes, little-endian |
//!   header, padded with blanks to a multiple of 64, newline |
//!   the entries row by row, eight bytes each, little-endian
//! ```
//!
//! It is written by hand: the crates for it bring a parser of Python literals, whose dependencies
//! need a C compiler.
//!
//! Reference: NumPy Enhancement Proposal 1, *A simple file format for NumPy arrays*.

use crate::report::ReportError;
use std::io::{self, Write};

/// Writes the head of a file with a matrix of this many rows and columns.
///
/// # Errors
/// If it cannot be written.
///
/// # Examples
/// ```
/// use infoscene::report::{write_npy_head, write_npy_row};
/// let mut file = Vec::new();
/// write_npy_head(&mut file, 1, 2)?;
/// write_npy_row(&mut file, 0, [0.5, 0.25])?;
/// assert_eq!(file.len(), 128 + 2 * 8);
/// # Ok::<(), infoscene::report::ReportError>(())
/// ```
pub fn write_npy_head(mut file: impl Write, rows: usize, columns: usize) -> io::Result<()> {
    const BEFORE: usize = 10;
    let header =
        format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({rows}, {columns}), }}");
    // room for the newline
    let length = (BEFORE + header.len() + 1).next_multiple_of(64) - BEFORE;
    let length_field = u16::try_from(length).map_err(io::Error::other)?;
    file.write_all(b"\x93NUMPY\x01\x00")?;
    file.write_all(&length_field.to_le_bytes())?;
    file.write_all(format!("{header:<width$}\n", width = length - 1).as_bytes())
}

/// Writes the row with this index, which is for messages only.
///
/// # Errors
/// [`ReportError::NotFinite`] with the entry's place, `matrix[2][5]`; [`ReportError::Write`].
pub fn write_npy_row(
    mut file: impl Write,
    index: usize,
    row: impl IntoIterator<Item = f64>,
) -> Result<(), ReportError> {
    for (column, entry) in row.into_iter().enumerate() {
        if !entry.is_finite() {
            let key = format!("matrix[{index}][{column}]");
            return Err(ReportError::NotFinite { key });
        }
        file.write_all(&entry.to_le_bytes())?;
    }
    Ok(())
}
