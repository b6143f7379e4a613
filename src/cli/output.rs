//! The place where an answer goes, and its format.

use super::{Answer, Outcome};
use clap::builder::RangedI64ValueParser;
use indicatif::style::TemplateError;
use indicatif::{ProgressBar, ProgressStyle};
use infoscene::question::{TURNED_AWAY, Unreached};
use infoscene::report::{Format, Report};
use std::fs;
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
    /// Refuses a place that cannot be written to, before long work begins.
    pub(super) fn check(&self) -> Result<(), Box<dyn std::error::Error>> {
        if self.output != Path::new("-") {
            check_place(&self.output)?;
        }
        Ok(())
    }

    /// Writes the whole answer or nothing.
    pub(super) fn write(&self, report: &Report) -> Answer {
        let text = report.render(self.format.into())?;
        if self.output == Path::new("-") {
            print(text.as_bytes())
        } else {
            write_file(&self.output, text.as_bytes())?;
            Ok(Outcome::Done)
        }
    }

    /// Writes an answer that is made while it is written, the whole of it or nothing where it goes
    /// to a file.
    pub(super) fn write_with(
        &self,
        write: impl FnOnce(Format, &mut dyn Write) -> Result<(), Box<dyn std::error::Error>>,
    ) -> Result<(), Box<dyn std::error::Error>> {
        if self.output == Path::new("-") {
            let mut text = Reader(io::BufWriter::new(io::stdout().lock()));
            write(self.format.into(), &mut text)?;
            Ok(text.flush()?)
        } else {
            replace_with(&self.output, |file| write(self.format.into(), file))
        }
    }

    /// Writes a file of this name into the folder of the output, or here.
    #[cfg(feature = "proptest")]
    pub(super) fn beside(
        &self,
        name: &str,
        text: &[u8],
    ) -> Result<PathBuf, Box<dyn std::error::Error>> {
        let path = if self.output == Path::new("-") {
            PathBuf::from(name)
        } else {
            self.output.with_file_name(name)
        };
        write_file(&path, text)?;
        Ok(path)
    }
}

/// Refuses a file that cannot be written because of its folder.
pub(super) fn check_place(path: &Path) -> Result<(), Box<dyn std::error::Error>> {
    folder_of(path).map_err(|source| cannot_write(path, source))?;
    Ok(())
}

/// Writes the whole file or nothing.
pub(super) fn write_file(path: &Path, text: &[u8]) -> Result<(), Box<dyn std::error::Error>> {
    Ok(replace(path, text).map_err(|source| cannot_write(path, source))?)
}

fn cannot_write(path: &Path, source: io::Error) -> CannotWrite {
    CannotWrite {
        path: path.to_owned(),
        source,
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

/// A standard output whose reader may go away: what is written after that is dropped.
struct Reader<W>(W);

impl<W: Write> Write for Reader<W> {
    fn write(&mut self, text: &[u8]) -> io::Result<usize> {
        match self.0.write(text) {
            Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(text.len()),
            written => written,
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self.0.flush() {
            Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
            flushed => flushed,
        }
    }
}

fn replace(path: &Path, text: &[u8]) -> io::Result<()> {
    replace_by(path, |file| file.write_all(text))
}

/// Replaces a file by [`replace_by`], with an error that says which file it was.
pub(super) fn replace_with(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> Result<(), Box<dyn std::error::Error>>,
) -> Result<(), Box<dyn std::error::Error>> {
    let mut refusal = None;
    let written = replace_by(path, |file| {
        write(file).map_err(|error| {
            let text = error.to_string();
            refusal = (!error.is::<io::Error>()).then_some(error);
            io::Error::other(text)
        })
    });
    match (written, refusal) {
        (_, Some(refusal)) => Err(refusal),
        (written, None) => Ok(written.map_err(|source| cannot_write(path, source))?),
    }
}

/// Writes beside the file and moves into place, so that no half-written file is ever seen. Links
/// are followed, an existing file keeps its mode, and a device or a pipe is written to as it is.
fn replace_by(path: &Path, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    folder_of(path)?;
    let old = fs::metadata(path).ok();
    if old.as_ref().is_some_and(|old| !old.is_file()) {
        return buffered(fs::OpenOptions::new().write(true).open(path)?, write);
    }
    let path = if old.is_some() {
        fs::canonicalize(path)?
    } else {
        path.to_owned()
    };
    let mut unfinished = Unfinished::in_folder(folder_of(&path)?)?;
    buffered(&mut unfinished.file, write)?;
    if let Some(old) = old {
        unfinished.file.set_permissions(old.permissions())?;
    }
    unfinished.move_to(&path)
}

/// A new file of a name that nobody uses; it is removed unless it is moved to where it belongs.
struct Unfinished {
    file: fs::File,
    path: PathBuf,
    is_in_place: bool,
}

/// Names to try, before a folder is taken to be full of what killed processes left.
const MOST_NAMES: u32 = 1000;

impl Unfinished {
    fn in_folder(folder: &Path) -> io::Result<Self> {
        let process = std::process::id();
        for number in 0..MOST_NAMES {
            let path = folder.join(format!(".infoscene-{process}-{number}"));
            match fs::File::create_new(&path) {
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                created => {
                    return Ok(Self {
                        file: created?,
                        path,
                        is_in_place: false,
                    });
                }
            }
        }
        Err(io::ErrorKind::AlreadyExists.into())
    }

    fn move_to(mut self, place: &Path) -> io::Result<()> {
        fs::rename(&self.path, place)?;
        self.is_in_place = true;
        Ok(())
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        if !self.is_in_place {
            // what made the file unfinished is reported, not that it cannot be removed either
            _ = fs::remove_file(&self.path);
        }
    }
}

fn buffered(
    file: impl Write,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut file = io::BufWriter::new(file);
    write(&mut file)?;
    file.flush()
}

/// The folder of a file that is to be written.
fn folder_of(path: &Path) -> io::Result<&Path> {
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
    Ok(folder)
}

/// Prints remarks on an answer to standard error.
pub(super) fn say(notes: &[String]) {
    for note in notes {
        let option = if note == TURNED_AWAY {
            " --reverse does"
        } else {
            ""
        };
        eprintln!("infoscene: {note}{option}");
    }
}

/// The exit status of an answer; a tolerance that it misses is named on standard error.
pub(super) fn finished(unreached: Option<&Unreached>) -> Outcome {
    let Some(unreached) = unreached else {
        return Outcome::Done;
    };
    eprintln!("infoscene: {unreached}");
    Outcome::Differs
}

/// A progress bar, drawn on a terminal only.
pub(super) fn progress_bar(length: u64, unit: &str) -> Result<ProgressBar, TemplateError> {
    let template = format!("{{wide_bar}} {{pos}}/{{len}} {unit}, {{eta}} left");
    Ok(ProgressBar::new(length).with_style(ProgressStyle::with_template(&template)?))
}

/// Bits that an enclosure may be asked for.
pub(super) fn precision() -> RangedI64ValueParser<u32> {
    clap::value_parser!(u32).range(53..=4096)
}
