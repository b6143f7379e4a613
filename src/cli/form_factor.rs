//! `infoscene form-factor SCENE`.

use super::Answer;
use super::output::{Output, check_place, finished, replace_with, say};
use super::progress::Bar;
use super::scene::ScenePairsArguments;
use infoscene::question::{FormFactorMatrix, FormFactors, PatchName, Unreached};
use infoscene::report::{write_form_factors, write_npy_head, write_npy_row};
use std::error::Error;
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
    /// Write the whole matrix here, too: NumPy's format, one row per patch that sends.
    #[arg(long, value_name = "OUT.npy")]
    matrix: Option<PathBuf>,
    #[command(flatten)]
    output: Output,
}

impl FormFactor {
    pub(super) fn answer(&self) -> Answer {
        self.output.check()?;
        if let Some(path) = &self.matrix {
            check_place(path)?;
        }
        let question = FormFactors {
            scene: self.scene.source(),
            tolerance: self.scene.tolerance(),
            congruence: self.scene.congruence(),
            from: self.from.clone(),
            to: self.to.clone(),
            matrix: self.matrix.is_some(),
        };
        let bar = Bar::default();
        let answer = question.ask(&bar)?;
        say(&answer.notes);
        let mut unreached = answer.unreached.clone();
        if let Some((path, matrix)) = self.matrix.as_ref().zip(answer.matrix()) {
            // it has seen all pairs
            unreached = write_matrix(path, &matrix)?;
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
}

/// Writes F row by row, the whole of it or nothing.
fn write_matrix(
    path: &Path,
    matrix: &FormFactorMatrix<'_>,
) -> Result<Option<Unreached>, Box<dyn Error>> {
    let mut unreached = None;
    replace_with(path, |file| {
        write_npy_head(&mut *file, matrix.rows(), matrix.rows())?;
        let written = matrix.for_each_row(|from, row| -> Result<(), Box<dyn Error>> {
            Ok(write_npy_row(&mut *file, from, row.iter().copied())?)
        });
        unreached = written?;
        Ok(())
    })?;
    Ok(unreached)
}
