//! Files of points: `x,y,z,nx,ny,nz`, a line each.
//!
//! The first line may name the columns, in any order and among others; without names there are six
//! numbers a line. Empty lines, and what follows a `#`, say nothing.

use glam::DVec3;
use std::path::{Path, PathBuf};

/// The columns, in their usual order.
const COLUMNS: [&str; 6] = ["x", "y", "z", "nx", "ny", "nz"];

/// A point of a surface, and a vector along the surface's normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfacePoint {
    /// Coordinates.
    pub at: [f64; 3],
    /// A vector of any length along the normal.
    pub normal: [f64; 3],
}

impl SurfacePoint {
    /// The unit normal, if the vector has a direction.
    pub(super) fn direction(&self) -> Option<DVec3> {
        let [x, y, z] = self.normal;
        let size = x.abs().max(y.abs()).max(z.abs());
        // squares of very long and very short vectors are out of range
        let unit = DVec3::new(x / size, y / size, z / size);
        (size > 0.0 && size.is_finite() && unit.is_finite()).then(|| unit.normalize())
    }
}

/// Points, or a file of them, were refused.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PointFileError {
    /// The file cannot be read.
    #[error("{}: it cannot be read ({reason}): name a file that is there and may be read",
        file.display())]
    Unreadable {
        /// The file.
        file: PathBuf,
        /// The reason of the system.
        reason: String,
    },
    /// The first line names columns, but not all that are needed.
    #[error("{}, line {line}: no column {column:?}: name x, y, z, nx, ny and nz", file.display())]
    NoColumn {
        /// The file.
        file: PathBuf,
        /// The line, from 1.
        line: usize,
        /// The column that is missing.
        column: &'static str,
    },
    /// A line has the wrong number of columns.
    #[error("{}, line {line}: {found} columns where there should be {expected}: write {}",
        file.display(), COLUMNS.join(","))]
    Columns {
        /// The file.
        file: PathBuf,
        /// The line, from 1.
        line: usize,
        /// The number of columns found.
        found: usize,
        /// The number of columns expected.
        expected: usize,
    },
    /// A text is not a finite number.
    #[error("{}, line {line}, column {column}: {text:?} is not a finite number: write one such as \
        0.5 or -1e-3", file.display())]
    NotANumber {
        /// The file.
        file: PathBuf,
        /// The line, from 1.
        line: usize,
        /// The column.
        column: &'static str,
        /// The text.
        text: String,
    },
    /// A normal in a file has no direction.
    #[error("{}, line {line}, columns nx, ny, nz: a normal of length 0 has no direction: give a \
        longer one", file.display())]
    NoDirectionInFile {
        /// The file.
        file: PathBuf,
        /// The line, from 1.
        line: usize,
    },
    /// A normal has no direction.
    #[error("point {index}: a normal of length 0 has no direction: give a longer one")]
    NoDirection {
        /// The number of the point, from 0.
        index: usize,
    },
    /// There is no point in the file.
    #[error("{}: it has no point: write a line {} for each", file.display(), COLUMNS.join(","))]
    Empty {
        /// The file.
        file: PathBuf,
    },
}

/// The points of a file.
pub(super) fn read(file: &Path) -> Result<Vec<SurfacePoint>, PointFileError> {
    let bytes = std::fs::read(file).map_err(|reason| PointFileError::Unreadable {
        file: file.to_owned(),
        reason: reason.to_string(),
    })?;
    let text = String::from_utf8_lossy(&bytes);
    parsed(file, text.trim_start_matches('\u{feff}'))
}

fn parsed(file: &Path, text: &str) -> Result<Vec<SurfacePoint>, PointFileError> {
    let mut points = Vec::new();
    let mut places: Option<([usize; 6], usize)> = None;
    for (index, line) in text.lines().enumerate() {
        let content = line.split('#').next().unwrap_or_default().trim();
        if content.is_empty() {
            continue;
        }
        let cells: Vec<&str> = content
            .split(',')
            .map(|cell| cell.trim().trim_matches('"'))
            .collect();
        let line = Line {
            file,
            number: index + 1,
        };
        match places {
            None if cells.iter().any(|cell| is_a_name(cell)) => {
                places = Some((line.places(&cells)?, cells.len()));
            }
            None => {
                places = Some(([0, 1, 2, 3, 4, 5], COLUMNS.len()));
                points.push(line.point(&cells, places)?);
            }
            Some(_) => points.push(line.point(&cells, places)?),
        }
    }
    if points.is_empty() {
        let file = file.to_owned();
        return Err(PointFileError::Empty { file });
    }
    Ok(points)
}

/// Is this the name of a column?
fn is_a_name(cell: &str) -> bool {
    COLUMNS.iter().any(|name| cell.eq_ignore_ascii_case(name))
}

/// A line of a file, for its errors.
#[derive(Clone, Copy)]
struct Line<'a> {
    file: &'a Path,
    number: usize,
}

impl Line<'_> {
    /// The places of the columns in a line of names.
    fn places(self, names: &[&str]) -> Result<[usize; 6], PointFileError> {
        let mut places = [0; 6];
        for (place, column) in places.iter_mut().zip(COLUMNS) {
            let found = names.iter().position(|n| n.eq_ignore_ascii_case(column));
            *place = found.ok_or_else(|| PointFileError::NoColumn {
                file: self.file.to_owned(),
                line: self.number,
                column,
            })?;
        }
        Ok(places)
    }

    fn point(
        self,
        cells: &[&str],
        places: Option<([usize; 6], usize)>,
    ) -> Result<SurfacePoint, PointFileError> {
        let (file, line) = (self.file.to_owned(), self.number);
        let (places, expected) = places.unwrap_or(([0, 1, 2, 3, 4, 5], COLUMNS.len()));
        let found = cells.len();
        if found != expected {
            return Err(PointFileError::Columns {
                file,
                line,
                found,
                expected,
            });
        }
        let mut numbers = [0.0; 6];
        for ((number, place), column) in numbers.iter_mut().zip(places).zip(COLUMNS) {
            let text = cells[place];
            let parsed = text.parse().ok().filter(|number: &f64| number.is_finite());
            *number = parsed.ok_or_else(|| PointFileError::NotANumber {
                file: file.clone(),
                line,
                column,
                text: text.to_owned(),
            })?;
        }
        let [x, y, z, nx, ny, nz] = numbers;
        let point = SurfacePoint {
            at: [x, y, z],
            normal: [nx, ny, nz],
        };
        match point.direction() {
            Some(_) => Ok(point),
            None => Err(PointFileError::NoDirectionInFile { file, line }),
        }
    }
}
