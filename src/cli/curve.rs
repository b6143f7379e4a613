//! `infoscene curve ID`.

use super::Answer;
use super::output::{Output, check_place, write_file};
use super::reproduce::selected;
use infoscene::claims::{Context, judge, registry};
use infoscene::report::{curve_figure, curve_report};
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub(super) struct Curve {
    /// The claim whose figure is printed, as in `infoscene reproduce`.
    #[arg(value_name = "ID")]
    id: String,
    /// Draw the curve, too, into an SVG file.
    #[arg(long, value_name = "PATH")]
    figure: Option<PathBuf>,
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
        self.output.check()?;
        if let Some(path) = &self.figure {
            check_place(path)?;
        }
        let claims = selected(std::slice::from_ref(&self.id))?;
        let mut drawn = None;
        for claim in &claims {
            if let Some(axes) = &claim.curve_axes {
                let finding = judge(claim, &Context::default())?.finding;
                drawn = finding.map(|finding| (axes, finding.curve));
            }
        }
        let Some((axes, curve)) = drawn else {
            let claims = registry()?.into_iter();
            let with_curve = claims.filter(|claim| claim.curve_axes.is_some());
            return Err(NoCurve {
                id: self.id.clone(),
                with_curve: with_curve.map(|claim| claim.id).collect(),
            }
            .into());
        };
        if let Some(path) = &self.figure {
            write_file(path, curve_figure(axes, &curve).to_svg()?.as_bytes())?;
        }
        self.output.write(&curve_report(&curve)?)
    }
}
