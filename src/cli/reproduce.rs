//! `infoscene reproduce [ID…]`.

use super::output::{Output, precision, progress_bar};
use super::{Answer, Outcome};
use infoscene::claims::{Claim, ClaimError, Context, DEFAULT_PRECISION, judge_all, registry};
use infoscene::report::reproduction_report;

#[derive(Debug, clap::Args)]
pub(super) struct Reproduce {
    /// Claims to compute; all if none is named.
    #[arg(value_name = "ID")]
    ids: Vec<String>,
    /// Only the claims that print a number.
    #[arg(long)]
    printed: bool,
    /// Bits of the enclosures' ends.
    #[arg(long, value_name = "BITS", default_value_t = DEFAULT_PRECISION, value_parser = precision())]
    precision: u32,
    #[command(flatten)]
    output: Output,
}

impl Reproduce {
    pub(super) fn answer(&self) -> Answer {
        let mut claims = selected(&self.ids)?;
        if self.printed {
            claims.retain(|claim| claim.printed.is_some());
            if claims.is_empty() {
                return Err("none of the claims named prints a number; leave out --printed".into());
            }
        }
        self.output.check()?;
        let bar = progress_bar(claims.len() as u64, "claims")?;
        let judgements = judge_all(&claims, &Context::new(self.precision), || bar.inc(1))?;
        bar.finish_and_clear();
        self.output.write(&reproduction_report(&judgements)?)?;
        let as_recorded = judgements.iter().all(|j| j.verdict == j.recorded());
        Ok(if as_recorded {
            Outcome::Done
        } else {
            Outcome::Differs
        })
    }
}

/// The claims with these ids in paper order, all for none.
pub(super) fn selected(ids: &[String]) -> Result<Vec<Claim>, ClaimError> {
    let mut claims = registry()?;
    for id in ids {
        if !claims.iter().any(|claim| claim.id == *id) {
            let common = |claim: &Claim| {
                claim
                    .id
                    .chars()
                    .zip(id.chars())
                    .take_while(|(a, b)| a == b)
                    .count()
            };
            let nearest = claims.iter().max_by_key(|claim| common(claim));
            let nearest = nearest
                .filter(|claim| common(claim) > 1)
                .map(|claim| claim.id.clone());
            return Err(ClaimError::UnknownClaim {
                id: id.clone(),
                nearest,
            });
        }
    }
    if !ids.is_empty() {
        claims.retain(|claim| ids.contains(&claim.id));
    }
    Ok(claims)
}
