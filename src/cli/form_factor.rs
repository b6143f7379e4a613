//! `infoscene form-factor SCENE`.

use super::Answer;
use super::output::{Output, check_place, replace_with};
use super::scene_pairs::{ScenePairsOptions, outcome};
use crate::report::{FormFactorRecord, write_form_factors, write_npy_head, write_npy_row};
use crate::scene::{Account, ExchangeAreas, NamedPatch, Scene, ScenePairs};
use std::error::Error;
use std::path::{Path, PathBuf};

/// Up to so many patches all pairs are held: 2.3 GB.
const MOST_HELD: usize = 16_384;

#[derive(Debug, clap::Args)]
pub(super) struct FormFactor {
    #[command(flatten)]
    scene: ScenePairsOptions,
    /// Only from this patch, counted from 0.
    #[arg(long, value_name = "I")]
    from: Option<usize>,
    /// Only to this patch, counted from 0.
    #[arg(long, value_name = "J")]
    to: Option<usize>,
    /// Write the whole matrix here, too: NumPy's format, one row per patch that sends.
    #[arg(long, value_name = "OUT.npy")]
    matrix: Option<PathBuf>,
    #[command(flatten)]
    output: Output,
}

/// All pairs of a scene would be listed, and there are too many.
#[derive(Debug, thiserror::Error)]
#[error(
    "{patches} patches have too many pairs to list, {MOST_HELD} are possible: choose with --from or --to, \
     --matrix writes all"
)]
struct TooMany {
    patches: usize,
}

impl FormFactor {
    pub(super) fn answer(&self) -> Answer {
        self.output.check()?;
        if let Some(path) = &self.matrix {
            check_place(path)?;
        }
        let scene = self.scene.scene()?;
        let patches = scene.patches();
        let is_part = self.from.is_some() || self.to.is_some();
        if !is_part && patches.len() > MOST_HELD {
            let patches = patches.len();
            return Err(TooMany { patches }.into());
        }
        let pairs = self.scene.pairs(&scene)?;
        let held = if patches.len() <= MOST_HELD && (!is_part || self.matrix.is_some()) {
            Some(pairs.exchange_areas()?)
        } else {
            None
        };
        // what is asked for is checked before anything is written
        let part = if is_part {
            Some(pairs.entries(self.from, self.to)?)
        } else {
            None
        };
        let mut accounts = Vec::new();
        accounts.extend(held.as_ref().map(|held| held.account().clone()));
        if let Some(path) = &self.matrix {
            let account = write_matrix(path, &scene, &pairs, held.as_ref())?;
            accounts.extend(account);
        }
        let area = |index: usize| patches[index].shape().area();
        match (part, &held) {
            (Some((entries, account)), _) => {
                let records = entries.into_iter().map(|entry| {
                    FormFactorRecord::new(entry.from, entry.to, area(entry.from), &entry.answer)
                });
                self.write(patches, records, &account)?;
                accounts.push(account);
            }
            (None, Some(held)) => {
                let all = 0..patches.len();
                let records = all.clone().flat_map(|from| {
                    let others = all.clone().filter(move |to| *to != from);
                    others.map(move |to| {
                        FormFactorRecord::new(from, to, area(from), &held.get(from, to))
                    })
                });
                self.write(patches, records, held.account())?;
            }
            (None, None) => {}
        }
        Ok(outcome(
            &scene,
            accounts.iter().max_by_key(|account| account.plan.pairs),
            pairs.tolerance(),
        ))
    }

    fn write(
        &self,
        patches: &[NamedPatch],
        records: impl Iterator<Item = FormFactorRecord>,
        account: &Account,
    ) -> Result<(), Box<dyn Error>> {
        self.output.write_with(|format, text| {
            write_form_factors(patches, records, &account.plan, format, text)?;
            Ok(())
        })
    }
}

/// Writes F row by row, the whole of it or nothing.
fn write_matrix(
    path: &Path,
    scene: &Scene,
    pairs: &ScenePairs,
    held: Option<&ExchangeAreas>,
) -> Result<Option<Account>, Box<dyn Error>> {
    let n = pairs.patches();
    let mut account = None;
    replace_with(path, |file| {
        write_npy_head(&mut *file, n, n)?;
        if let Some(held) = held {
            for (from, patch) in scene.patches().iter().enumerate() {
                let area = patch.shape().area();
                let row = (0..n).map(|to| held.get(from, to).exchange.value / area);
                write_npy_row(&mut *file, row)?;
            }
        } else {
            let written = pairs.for_each_row(|from, row| -> Result<(), Box<dyn Error>> {
                let area = scene.patches()[from].shape().area();
                let row = row.iter().map(|answer| answer.exchange.value / area);
                Ok(write_npy_row(&mut *file, row)?)
            });
            account = Some(written?);
        }
        Ok(())
    })?;
    Ok(account)
}
