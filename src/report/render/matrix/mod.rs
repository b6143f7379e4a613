//! Matrices in the formats of other programs, written a line at a time.
//!
//! ```text
//!   .npy          NumPy: all entries, 64 bits each
//!   .mtx          Matrix Market, coordinates: the entries that are not exactly zero
//!   .array.mtx    Matrix Market, an array: all entries
//!   .txt          triplets: lines "i j F", counted from 1, of the entries that are not exactly
//!                 zero; no other line
//!   .vf           as View3D writes its output: areas, form factors, emissivities
//! ```
//!
//! Numbers in text read back to the same `f64`. Triplets are as urban energy balances read them
//! (`vfsparse.inp` of uDALES) and as `spconvert(load(…))` of MATLAB and Octave does: no heading,
//! and counted from 1.
//!
//! Open `npy`, `matrix_market` or `view3d` for a format.

mod matrix_market;
mod npy;
mod view3d;

use crate::question::{FormFactorMatrix, MatrixEntries, MatrixLine};
use crate::report::ReportError;
use std::io::Write;
use std::path::Path;

/// A format of matrices.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MatrixFormat {
    /// NumPy, `.npy`.
    Npy,
    /// Matrix Market, `.mtx`, as coordinates.
    Coordinates,
    /// Matrix Market, `.array.mtx`, as an array.
    Array,
    /// Triplets, `.txt`.
    Triplets,
    /// View3D's output, `.vf`.
    View3d,
}

impl MatrixFormat {
    /// The format that the end of a file's name says; NumPy's if the name has no end.
    ///
    /// # Errors
    /// [`ReportError::UnknownMatrixFormat`]; [`ReportError::NoPlaceForBounds`] if the format is of
    /// form factors only.
    ///
    /// # Examples
    /// ```
    /// use infoscene::question::MatrixEntries;
    /// use infoscene::report::MatrixFormat;
    /// let format = |name| MatrixFormat::of_file(name, MatrixEntries::FormFactors);
    /// assert_eq!(format("F.mtx".as_ref())?, MatrixFormat::Coordinates);
    /// assert_eq!(format("F.ARRAY.MTX".as_ref())?, MatrixFormat::Array);
    /// assert!(format("F.xlsx".as_ref()).is_err());
    /// # Ok::<(), infoscene::report::ReportError>(())
    /// ```
    pub fn of_file(file: &Path, entries: MatrixEntries) -> Result<Self, ReportError> {
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        let name = name.to_ascii_lowercase();
        let format = match name.rsplit_once('.') {
            None | Some((_, "npy")) => Self::Npy,
            Some((stem, "mtx")) if stem.ends_with(".array") => Self::Array,
            Some((_, "mtx")) => Self::Coordinates,
            Some((_, "txt")) => Self::Triplets,
            Some((_, "vf")) => Self::View3d,
            Some(_) => {
                let file = file.to_owned();
                return Err(ReportError::UnknownMatrixFormat { file });
            }
        };
        if format == Self::View3d && entries == MatrixEntries::Bounds {
            let file = file.to_owned();
            return Err(ReportError::NoPlaceForBounds { file });
        }
        Ok(format)
    }
}

/// A matrix that is being written.
#[derive(Debug)]
pub struct MatrixWriter<W> {
    file: W,
    format: MatrixFormat,
    entries: MatrixEntries,
    /// The reflectances of the rows, if the format has them.
    reflectances: Vec<Option<f64>>,
}

impl<W: Write> MatrixWriter<W> {
    /// Writes the head of a matrix.
    ///
    /// # Errors
    /// [`ReportError::CountNotKnown`] if coordinates are asked for of a matrix that is not held;
    /// [`ReportError::Scene`] if the format has emissivities and patches of one row differ in
    /// theirs; [`ReportError::Write`].
    pub fn begin(
        mut file: W,
        format: MatrixFormat,
        entries: MatrixEntries,
        matrix: &FormFactorMatrix<'_>,
    ) -> Result<Self, ReportError> {
        let rows = matrix.rows();
        let mut reflectances = Vec::new();
        match format {
            MatrixFormat::Npy => npy::write_head(&mut file, rows)?,
            MatrixFormat::Coordinates => {
                let count = matrix.count(entries);
                let count = count.ok_or(ReportError::CountNotKnown { rows })?;
                matrix_market::write_head(&mut file, entries, rows, Some(count))?;
            }
            MatrixFormat::Array => matrix_market::write_head(&mut file, entries, rows, None)?,
            MatrixFormat::Triplets => {}
            MatrixFormat::View3d => {
                reflectances = matrix.reflectances()?;
                view3d::write_head(&mut file, matrix.areas())?;
            }
        }
        Ok(Self {
            file,
            format,
            entries,
            reflectances,
        })
    }

    /// Writes the next line.
    ///
    /// # Errors
    /// [`ReportError::NotFinite`] with the entry's place, `matrix[2][5]`; [`ReportError::Write`].
    pub fn line(&mut self, line: &MatrixLine<'_>) -> Result<(), ReportError> {
        let (file, index) = (&mut self.file, line.index());
        for (other, entry) in line.row(self.entries).enumerate() {
            if !entry.is_finite() {
                let key = format!("matrix[{index}][{other}]");
                return Err(ReportError::NotFinite { key });
            }
        }
        let mut entries = line.row(self.entries);
        match self.format {
            MatrixFormat::Npy => {
                entries.try_for_each(|entry| file.write_all(&entry.to_le_bytes()))?;
            }
            MatrixFormat::Coordinates | MatrixFormat::Triplets => {
                let entries = entries.zip(1..).filter(|(entry, _)| *entry != 0.0);
                for (entry, column) in entries {
                    writeln!(file, "{} {column} {entry:?}", index + 1)?;
                }
            }
            MatrixFormat::Array => {
                let mut entries = line.column(self.entries);
                entries.try_for_each(|entry| writeln!(file, "{entry:?}"))?;
            }
            MatrixFormat::View3d => {
                view3d::write_line(file, entries.map(|entry| format!("{entry:?}")))?;
            }
        }
        Ok(())
    }

    /// Writes what comes after the lines.
    ///
    /// # Errors
    /// [`ReportError::Write`].
    pub fn end(mut self) -> Result<(), ReportError> {
        if self.format == MatrixFormat::View3d {
            view3d::write_end(&mut self.file, &self.reflectances)?;
        }
        Ok(self.file.flush()?)
    }
}
