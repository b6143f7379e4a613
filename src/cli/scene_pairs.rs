//! What all questions about the pairs of a scene share.

use super::Outcome;
use super::scene::SceneArgument;
use crate::form_factor::DEFAULT_TOLERANCE;
use crate::scene::{Account, Congruence, Scene, SceneError, ScenePairs, Unreached};
use std::error::Error;

/// Something hides patches from each other.
#[derive(Debug, thiserror::Error)]
#[error(
    "obstruction {name} may hide patches from each other, which is not computed yet: --unoccluded leaves it out"
)]
struct Occluded {
    name: String,
}

#[derive(Debug, clap::Args)]
pub(super) struct ScenePairsOptions {
    #[command(flatten)]
    scene: SceneArgument,
    /// The relative error asked for of every form factor.
    #[arg(long, value_name = "REL", default_value_t = DEFAULT_TOLERANCE, value_parser = relative)]
    tolerance: f64,
    /// Compute congruent pairs, too.
    #[arg(long, hide = true)]
    every_pair: bool,
}

fn relative(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(number) if number > 0.0 && number < 1.0 => Ok(number),
        _ => Err("it must be a number between 0 and 1".to_owned()),
    }
}

impl ScenePairsOptions {
    pub(super) fn scene(&self) -> Result<Scene, Box<dyn Error>> {
        let scene = self.scene.read()?;
        match scene.obstructions().first() {
            Some(obstruction) if !self.scene.is_unoccluded() => {
                let name = obstruction.name().to_owned();
                Err(Occluded { name }.into())
            }
            _ => Ok(scene),
        }
    }

    pub(super) fn pairs(&self, scene: &Scene) -> Result<ScenePairs, SceneError> {
        let congruence = if self.every_pair {
            Congruence::Ignored
        } else {
            Congruence::Shared
        };
        ScenePairs::try_new(scene, self.tolerance, congruence)
    }
}

/// The exit status of an answer; what misses the tolerance is named on standard error.
pub(super) fn outcome(scene: &Scene, account: Option<&Account>, tolerance: f64) -> Outcome {
    let Some((account, worst)) = account.and_then(|account| Some((account, account.worst?))) else {
        return Outcome::Done;
    };
    let Unreached { first, second, .. } = worst;
    let name = |index: usize| scene.patches()[index].name();
    eprintln!(
        "infoscene: {} pairs miss the tolerance {tolerance:e}; the worst is {first} ({}) and {second} ({}), whose relative \
         error may be {:.0e}",
        account.unreached,
        name(first),
        name(second),
        worst.relative(),
    );
    Outcome::Differs
}
