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

use std::io::{self, Write};

/// Writes the head of a file with a square matrix of this many rows.
pub(super) fn write_head(mut file: impl Write, rows: usize) -> io::Result<()> {
    const BEFORE: usize = 10;
    let header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({rows}, {rows}), }}");
    // room for the newline
    let length = (BEFORE + header.len() + 1).next_multiple_of(64) - BEFORE;
    let length_field = u16::try_from(length).map_err(io::Error::other)?;
    file.write_all(b"\x93NUMPY\x01\x00")?;
    file.write_all(&length_field.to_le_bytes())?;
    file.write_all(format!("{header:<width$}\n", width = length - 1).as_bytes())
}
