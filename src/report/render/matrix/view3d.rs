//! Form factors as the program View3D writes them to its output, as text.
//!
//! ```text
//!   program version 0 encl emit n     filled up with blanks to 30 characters
//!   A_1 … A_n                         the areas
//!   F_11 … F_1n                       row by row
//!   …
//!   F_n1 … F_nn
//!   ε_1 … ε_n                         the emissivities, 1 − reflectance
//! ```
//!
//! `encl` is 0, since rows are not adjusted so that their sums are 1, and so is `emit`, since the
//! factors are those of black patches; a material that is not known is written as black. View3D
//! prints six decimals of F and three of ε, which its readers do not count; here are all. The
//! readers take the program's name and version for words of up to 15 and 7 characters.
//!
//! # Source
//! View3D 3.3 manual, §6.1, and the program's `SaveVF` and `ReadVF`.

use crate::scene::files::view3d::writer::emissivity;
use std::io::{self, Write};

/// Writes the lines before the form factors.
pub(super) fn write_head(mut file: impl Write, areas: &[f64]) -> io::Result<()> {
    let head = format!(
        "infoscene {} 0 0 0 {}",
        env!("CARGO_PKG_VERSION"),
        areas.len()
    );
    writeln!(file, "{head:<30}")?;
    write_line(file, areas.iter().map(|area| format!("{area:?}")))
}

/// Writes the line after the form factors.
pub(super) fn write_end(file: impl Write, reflectances: &[Option<f64>]) -> io::Result<()> {
    // as black as patches without a material
    let reflectances = reflectances.iter().map(|known| known.unwrap_or(0.0));
    write_line(file, reflectances.map(emissivity))
}

/// Writes numbers, a space between.
pub(super) fn write_line(
    mut file: impl Write,
    numbers: impl Iterator<Item = String>,
) -> io::Result<()> {
    for (place, number) in numbers.enumerate() {
        let before = if place > 0 { " " } else { "" };
        write!(file, "{before}{number}")?;
    }
    writeln!(file)
}
