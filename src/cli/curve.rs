//! `infoscene curve ID`.

use super::Answer;
use super::output::Output;
use super::reproduce::selected;
use crate::claims::{DEFAULT_PRECISION, judge, registry};
use crate::report::curve_report;

#[derive(Debug, clap::Args)]
pub(super) struct Curve {
    /// The claim whose figure is printed, as in `infoscene reproduce`.
    #[arg(value_name = "ID")]
    id: String,
    #[command(flatten)]
    output: Output,
}

#[derive(Debug, thiserror::Error)]
#[error("claim \"{id}\" has no curve; these have one: {}", with_curve.join(", "))]
struct NoCurve {
    id: String,
    with_curve: Vec<String>,
}

impl Curve {
    pub(super) fn answer(&self) -> Answer {
        let claims = selected(std::slice::from_ref(&self.id))?;
        let mut curve = Vec::new();
        for claim in &claims {
            curve = judge(claim, DEFAULT_PRECISION)?
                .finding
                .map(|finding| finding.curve)
                .unwrap_or_default();
        }
        if curve.is_empty() {
            let claims = registry()?.into_iter().filter(|claim| claim.has_curve);
            let with_curve = claims.map(|claim| claim.id).collect();
            return Err(NoCurve {
                id: self.id.clone(),
                with_curve,
            }
            .into());
        }
        self.output.write(&curve_report(&curve)?)
    }
}
