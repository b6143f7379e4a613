//! Where an answer goes, and in which format.

use super::{Answer, Outcome};
use crate::report::{Format, Report};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// The options every question has.
#[derive(Debug, clap::Args)]
pub(super) struct Output {
    /// How the answer is written.
    #[arg(long, value_enum, default_value_t = FormatName::Table)]
    format: FormatName,
    /// Where it is written; `-` is standard output.
    #[arg(long, value_name = "PATH", default_value = "-")]
    output: PathBuf,
}

#[derive(Debug, Clone, Copy, clap::ValueEnum)]
enum FormatName {
    Table,
    Markdown,
    Csv,
    Json,
    Latex,
}

impl From<FormatName> for Format {
    fn from(name: FormatName) -> Self {
        match name {
            FormatName::Table => Self::Table,
            FormatName::Markdown => Self::Markdown,
            FormatName::Csv => Self::Csv,
            FormatName::Json => Self::Json,
            FormatName::Latex => Self::Latex,
        }
    }
}

/// A file that could not be written.
#[derive(Debug, thiserror::Error)]
#[error("cannot write {}: {source}; nothing was written", path.display())]
struct CannotWrite {
    path: PathBuf,
    source: io::Error,
}

impl Output {
    /// Writes the whole answer or nothing.
    pub(super) fn write(&self, report: &Report) -> Answer {
        let text = report.render(self.format.into())?;
        if self.output == Path::new("-") {
            print(text.as_bytes())
        } else {
            replace(&self.output, text.as_bytes()).map_err(|source| CannotWrite {
                path: self.output.clone(),
                source,
            })?;
            Ok(Outcome::Done)
        }
    }
}

/// Prints to standard output; a reader that has gone away is no error.
pub(super) fn print(text: &[u8]) -> Answer {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(Outcome::Done),
    }
}

/// Writes beside the file and moves into place, so that no half-written file is ever seen.
fn replace(path: &Path, text: &[u8]) -> io::Result<()> {
    let folder = path
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty());
    let folder = folder.unwrap_or_else(|| Path::new("."));
    if !folder.is_dir() {
        return Err(io::Error::new(
            io::ErrorKind::NotFound,
            "its folder does not exist",
        ));
    }
    if path.is_dir() {
        return Err(io::Error::new(
            io::ErrorKind::IsADirectory,
            "it is a folder",
        ));
    }
    let mut file = tempfile::Builder::new()
        .prefix(".infoscene-")
        .tempfile_in(folder)?;
    file.write_all(text)?;
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        file.as_file()
            .set_permissions(std::fs::Permissions::from_mode(0o644))?;
    }
    file.persist(path)?;
    Ok(())
}
