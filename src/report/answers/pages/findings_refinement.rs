//! The numbers of the page of findings on the oracle at work.

use crate::claims::{ClaimError, Judgement, Quantity, Verdict};
use crate::numeric::Bounded;
use crate::report::render::page::{PageError, Texts};

/// The claims, the places of their numbers, the factor in which these are told, and decimals.
const NUMBERS: [(&str, &str, f64, u32); 4] = [
    ("s5-cheap-gradient", "kernel_ranks", 1.0, 2),
    (
        "s5-full-gain-is-the-better-oracle",
        "potential_ratio",
        1.0,
        1,
    ),
    ("s6-oracle-is-useful", "uniform_ratio", 1.0, 1),
    ("s6-minimises-error", "cut_difference", 100.0, 0),
];

/// Adds the numbers, from the judgements of all claims.
pub(super) fn refinement(judgements: &[Judgement], texts: &mut Texts) -> Result<(), PageError> {
    for (id, place, factor, decimals) in NUMBERS {
        let found = judgements.iter().find(|judgement| judgement.claim.id == id);
        let judgement = found.ok_or_else(|| ClaimError::UnknownClaim {
            id: id.to_owned(),
            nearest: None,
        })?;
        PageError::unless(judgement.verdict == Verdict::Supported, id)?;
        if let Some(Quantity::Value { value, error }) =
            judgement.finding.as_ref().map(|f| f.quantity)
        {
            texts.number(
                place,
                Bounded::estimate(factor * value, factor * error),
                decimals,
            )?;
        }
    }
    Ok(())
}
