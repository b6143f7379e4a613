//! `infoscene form-factor SCENE`.

use super::Answer;
use super::output::{Output, check_place, replace_with};
use super::scene_pairs::{ScenePairsOptions, outcome};
use infoscene::exchange::{Entry, ExchangeAreas, PassSummary, ScenePairs};
use infoscene::report::{
    FormFactorRecord, PatchRecord, write_form_factors, write_npy_head, write_npy_row,
};
use std::error::Error;
use std::path::{Path, PathBuf};

/// Up to so many patches all pairs are held: 2.3 GB.
const MOST_HELD: usize = 16_384;

#[derive(Debug, clap::Args)]
pub(super) struct FormFactor {
    #[command(flatten)]
    scene: ScenePairsOptions,
    /// Only from this patch, counted from 0; patches that are summed into one row count as one.
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
        // the matrix wants all rows
        let asked = |index: Option<usize>| index.filter(|_| self.matrix.is_none());
        let scene = self.scene.scene()?;
        let patches = scene.group_count();
        let is_part = self.from.is_some() || self.to.is_some();
        if !is_part && patches > MOST_HELD {
            return Err(TooMany { patches }.into());
        }
        let [from, to] = [self.from, self.to].map(asked);
        let bar = self.scene.bar(&scene)?;
        let pairs = self.scene.pairs_between(&scene, from, to, &bar)?;
        let held = if patches <= MOST_HELD && (!is_part || self.matrix.is_some()) {
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
        accounts.extend(held.as_ref().map(|held| held.summary().clone()));
        if let Some(path) = &self.matrix {
            let account = write_matrix(path, &pairs, held.as_ref())?;
            accounts.extend(account);
        }
        let areas = || pairs.areas().iter().zip(pairs.area_bounds());
        let areas: Vec<[f64; 2]> = areas().map(|(area, bound)| [*area, *bound]).collect();
        let records = scene.group_names().into_iter().zip(pairs.areas());
        let records: Vec<PatchRecord<'_>> = records
            .enumerate()
            .map(|(index, (name, area))| PatchRecord {
                index,
                name,
                area: *area,
            })
            .collect();
        let patches = &records;
        match (part, &held) {
            (Some((entries, account)), _) => {
                let records = entries.into_iter().map(|entry| {
                    let Entry { from, to, answer } = entry;
                    FormFactorRecord::new([from, to], areas[from], &answer)
                });
                self.write(patches, records, &account)?;
                accounts.push(account);
            }
            (None, Some(held)) => {
                let all = 0..patches.len();
                let records = all.clone().flat_map(|from| {
                    let others = all.clone();
                    let others = others.filter(move |to| *to != from || held.sees_itself(from));
                    let area = areas[from];
                    others
                        .map(move |to| FormFactorRecord::new([from, to], area, &held.get(from, to)))
                });
                self.write(patches, records, held.summary())?;
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
        patches: &[PatchRecord<'_>],
        records: impl Iterator<Item = FormFactorRecord>,
        account: &PassSummary,
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
    pairs: &ScenePairs<'_>,
    held: Option<&ExchangeAreas>,
) -> Result<Option<PassSummary>, Box<dyn Error>> {
    let n = pairs.rows();
    let mut account = None;
    replace_with(path, |file| {
        write_npy_head(&mut *file, n, n)?;
        if let Some(held) = held {
            for (from, area) in pairs.areas().iter().enumerate() {
                let row = (0..n).map(|to| held.get(from, to).exchange.value / area);
                write_npy_row(&mut *file, from, row)?;
            }
        } else {
            let written = pairs.for_each_row(|from, row| -> Result<(), Box<dyn Error>> {
                let area = pairs.areas()[from];
                let row = row.iter().map(|answer| answer.exchange.value / area);
                Ok(write_npy_row(&mut *file, from, row)?)
            });
            account = Some(written?);
        }
        Ok(())
    })?;
    Ok(account)
}
