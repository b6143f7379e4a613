//! `infoscene form-factor SCENE`.

use super::output::{Output, check_place, finished, replace_with, say};
use super::progress::Bar;
use super::ranks::first_alone;
use super::scene::ScenePairsArguments;
use super::store::shard;
use super::{Answer, Outcome};
use infoscene::exchange::{Ranks, Shard};
use infoscene::question::{
    FormFactorMatrix, FormFactors, MatrixEntries, PatchName, StoreFormFactors, Unreached,
};
use infoscene::report::{MatrixFormat, MatrixWriter, store_report, write_form_factors};
use std::error::Error;
use std::io::Write;
use std::path::{Path, PathBuf};

#[derive(Debug, clap::Args)]
pub(super) struct FormFactor {
    #[command(flatten)]
    scene: ScenePairsArguments,
    /// Only from this patch: its index from 0, or a name; that of an object means all its faces.
    /// Patches that are summed into one row count as one.
    #[arg(long, value_name = "PATCH")]
    from: Option<PatchName>,
    /// Only to this patch, likewise.
    #[arg(long, value_name = "PATCH")]
    to: Option<PatchName>,
    /// Write the whole matrix here, too, one row per patch that sends. The end of the name says
    /// how: .npy (NumPy), .mtx (Matrix Market, zeros left out), .array.mtx (Matrix Market, all
    /// entries), .txt (lines "i j F", counted from 1) or .vf (as View3D writes).
    #[arg(long, value_name = "OUT")]
    matrix: Option<PathBuf>,
    /// Write the matrix of the bounds on the errors here, in any of these formats but .vf.
    #[arg(long, value_name = "OUT")]
    bounds: Option<PathBuf>,
    /// Write the whole matrix and its bounds into this folder, as a group of Zarr arrays that may
    /// be larger than memory; nothing is listed.
    #[arg(long, value_name = "DIR", conflicts_with_all = ["from", "to", "matrix", "bounds"])]
    store: Option<PathBuf>,
    /// Go on with the matrix that is in the folder already.
    #[arg(long, requires = "store")]
    resume: bool,
    /// Compute one of N shares of it, as 3/16: shares may run at once, on any machines that share
    /// the folder.
    #[arg(long, value_name = "K/N", requires = "store", value_parser = shard)]
    shard: Option<Shard>,
    #[command(flatten)]
    output: Output,
}

impl FormFactor {
    pub(super) fn answer(&self, ranks: &dyn Ranks) -> Answer {
        self.output.check()?;
        match &self.store {
            Some(folder) => self.fill(folder, ranks),
            None => first_alone(ranks, || self.listed()),
        }
    }

    /// Lists form factors, and writes the matrix into files.
    fn listed(&self) -> Answer {
        let files = self.matrices()?;
        let question = FormFactors {
            scene: self.scene.source(),
            tolerance: self.scene.tolerance(),
            congruence: self.scene.congruence(),
            from: self.from.clone(),
            to: self.to.clone(),
            matrix: !files.is_empty(),
        };
        let bar = Bar::default();
        let answer = question.ask(&bar)?;
        say(&answer.notes);
        let mut unreached = answer.unreached.clone();
        if let Some(matrix) = answer.matrix() {
            // it has seen all pairs
            unreached = write_matrices(&files, &matrix)?;
        }
        self.output.write_with(|format, text| {
            let (patches, records) = (&answer.patches, answer.records());
            Ok(write_form_factors(
                patches,
                records,
                (answer.resolution, &answer.plan),
                format,
                text,
            )?)
        })?;
        Ok(finished(unreached.as_ref()))
    }

    /// Fills a store.
    fn fill(&self, folder: &Path, ranks: &dyn Ranks) -> Answer {
        let question = StoreFormFactors {
            scene: self.scene.source(),
            tolerance: self.scene.tolerance(),
            congruence: self.scene.congruence(),
            folder: folder.to_owned(),
            resume: self.resume,
            shard: self.shard.unwrap_or_default(),
        };
        let answer = question.ask_among(ranks, &Bar::default())?;
        if ranks.number() > 0 {
            return Ok(Outcome::Done);
        }
        say(&answer.notes);
        self.output.write(&store_report(&answer)?)?;
        Ok(finished(answer.unreached.as_ref()))
    }

    /// The files for matrices, which can be written.
    fn matrices(&self) -> Result<Vec<MatrixFile<'_>>, Box<dyn Error>> {
        let matrices = [
            (&self.matrix, MatrixEntries::FormFactors),
            (&self.bounds, MatrixEntries::Bounds),
        ];
        let named = matrices.into_iter();
        let named = named.filter_map(|(path, entries)| Some((path.as_ref()?, entries)));
        let files = named.map(|(path, entries)| {
            check_place(path)?;
            let format = MatrixFormat::of_file(path, entries)?;
            Ok(MatrixFile {
                path,
                entries,
                format,
            })
        });
        files.collect()
    }
}

/// A file for a matrix.
struct MatrixFile<'a> {
    path: &'a Path,
    entries: MatrixEntries,
    format: MatrixFormat,
}

/// Writes matrices line by line in one pass, the whole of each or none.
fn write_matrices(
    files: &[MatrixFile<'_>],
    matrix: &FormFactorMatrix<'_>,
) -> Result<Option<Unreached>, Box<dyn Error>> {
    if files.iter().any(|file| file.format == MatrixFormat::View3d) {
        let unknown = matrix.reflectances()?.into_iter().filter(Option::is_none);
        let count = unknown.count();
        let note = format!("View3D's output has emissivities: {count} that are not known are 1");
        say(&Vec::from_iter((count > 0).then_some(note)));
    }
    let mut unreached = None;
    let mut pass = |open: &mut [&mut dyn Write]| {
        let begun = files
            .iter()
            .zip(open)
            .map(|(file, open)| MatrixWriter::begin(open, file.format, file.entries, matrix));
        let mut writers = begun.collect::<Result<Vec<_>, _>>()?;
        unreached = matrix.for_each_line(|line| -> Result<(), Box<dyn Error>> {
            Ok(writers
                .iter_mut()
                .try_for_each(|writer| writer.line(line))?)
        })?;
        Ok(writers.into_iter().try_for_each(MatrixWriter::end)?)
    };
    match files {
        [] => {}
        [file] => replace_with(file.path, |open| pass(&mut [open]))?,
        [file, other, ..] => replace_with(file.path, |open| {
            replace_with(other.path, |other| pass(&mut [&mut *open, other]))
        })?,
    }
    Ok(unreached)
}
