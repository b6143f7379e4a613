//! `infoscene measure SCENE`.

use super::output::Output;
use super::patch_values::{Materials, PatchValue, values};
use super::scene_pairs::{ScenePairsOptions, outcome};
use super::{Answer, Outcome};
use crate::chain::ChainError;
use crate::information::{
    SceneInformation, Surroundings, brightness_information, scene_information,
};
use crate::report::measure_report;
use crate::scene::{Material, Scene, SceneError, ScenePairs};
use crate::transport::Interreflection;
use std::error::Error;

#[derive(Debug, clap::Args)]
pub(super) struct Measure {
    #[command(flatten)]
    scene: ScenePairsOptions,
    /// The chain that is measured.
    #[arg(long, value_enum, default_value_t = Chain::Visibility)]
    chain: Chain,
    /// Take an open scene, too: what escapes goes to one more state, outside.
    #[arg(long, conflicts_with_all = ["reflectance", "emittance", "importance"])]
    open: bool,
    #[command(flatten)]
    materials: Materials,
    /// Direct importances, for the importance chain: PATCH=VALUE,…, or PATCH alone for 1; PATCH is an index, a name, or all.
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    importance: Vec<PatchValue>,
    #[command(flatten)]
    output: Output,
}

#[derive(Debug, Clone, Copy, clap::ValueEnum)]
enum Chain {
    /// Weights are areas, transitions form factors.
    Visibility,
    /// Weighted with the radiosities: weights are generalised areas (§3.4).
    Radiosity,
    /// Weighted with the reflected importances (§3.5).
    Importance,
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
        let measured = match self.chain {
            Chain::Visibility => {
                scene_information(&pairs, surroundings).map_err(|error| named(error, &scene))?
            }
            Chain::Radiosity | Chain::Importance => self.lit(&scene, &pairs)?,
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

impl Measure {
    /// The chain of the scene's light, or of what is looked at.
    fn lit(&self, scene: &Scene, pairs: &ScenePairs) -> Result<SceneInformation, Box<dyn Error>> {
        let materials = self.materials.of(scene)?;
        let exchange = pairs.exchange_areas()?;
        let room = Interreflection::of(&exchange, &materials)?;
        let brightness = if matches!(self.chain, Chain::Importance) {
            room.importance(&values(&self.importance, scene)?)?
                .reflected
        } else {
            let emittances: Vec<f64> = materials.iter().map(Material::emittance).collect();
            room.radiosity(&emittances)?
        };
        Ok(brightness_information(&exchange, &brightness)?)
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
