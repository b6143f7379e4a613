//! `infoscene measure SCENE`.

use super::light::Light;
use super::output::Output;
use super::scene_pairs::{ScenePairsOptions, outcome};
use super::{Answer, Outcome};
use crate::chain::ChainError;
use crate::information::{Surroundings, brightness_information, scene_information};
use crate::report::measure_report;
use crate::scene::{Scene, SceneError};
use std::error::Error;

#[derive(Debug, clap::Args)]
pub(super) struct Measure {
    #[command(flatten)]
    scene: ScenePairsOptions,
    #[command(flatten)]
    light: Light,
    /// Take an open scene, too: what escapes goes to one more state, outside.
    #[arg(long)]
    open: bool,
    #[command(flatten)]
    output: Output,
}

/// A row of form factors that does not sum to one, with the name of its patch.
#[derive(Debug, thiserror::Error)]
#[error("{source}; that is patch {name}{mend}")]
struct BadRow {
    source: ChainError,
    name: String,
    mend: &'static str,
}

impl Measure {
    pub(super) fn answer(&self) -> Answer {
        self.output.check()?;
        let scene = self.scene.scene(None, None)?;
        let pairs = self.scene.pairs(&scene)?;
        let surroundings = if self.open {
            Surroundings::Outside
        } else {
            Surroundings::None
        };
        let measured = if self.light.is_visibility()? {
            scene_information(&pairs, surroundings).map_err(|error| named(error, &scene))?
        } else {
            let exchange = pairs.exchange_areas()?;
            brightness_information(&exchange, &self.light.brightness(&scene, &exchange)?)?
        };
        let written = self
            .output
            .write(&measure_report(&scene.group_names(), &measured)?)?;
        match outcome(&scene, Some(&measured.account), pairs.tolerance()) {
            Outcome::Done => Ok(written),
            differs @ Outcome::Differs => Ok(differs),
        }
    }
}

fn named(source: ChainError, scene: &Scene) -> Box<dyn Error> {
    let (row, mend) = match &source {
        ChainError::Scene(SceneError::OpenScene { row, .. }) => {
            (*row, "; --open adds the state outside")
        }
        ChainError::Scene(SceneError::RowAboveOne { row, .. }) => (*row, ""),
        _ => return source.into(),
    };
    let name = scene.group_names()[row].to_owned();
    BadRow { source, name, mend }.into()
}
