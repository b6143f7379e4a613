//! `infoscene measure SCENE`.

use super::light::Light;
use super::output::{Output, progress_bar};
use super::scene_pairs::{ScenePairsOptions, outcome};
use super::{Answer, Outcome};
use crate::chain::ChainError;
use crate::information::{
    Surroundings, brightness_information, chord_information, continuous_information, pair_losses,
    scene_information,
};
use crate::report::{chord_report, measure_report};
use crate::scene::{NamedPatch, Scene, SceneError};
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
    /// The continuous mutual information, too, of a closed scene that is convex inside.
    #[arg(long)]
    continuous: bool,
    /// What each pair of patches loses against the continuous one: the most that subdividing both can gain.
    #[arg(long, requires = "continuous", conflicts_with = "lines")]
    pairs: bool,
    /// The continuous one alone, from so many random chords: of any closed scene, concave or occluded.
    #[arg(long, value_name = "N", requires = "continuous", conflicts_with = "open",
        value_parser = clap::value_parser!(u32).range(2..))]
    lines: Option<u32>,
    /// The same seed draws the same lines.
    #[arg(long, value_name = "S", requires = "lines", default_value_t = 1)]
    seed: u64,
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
        if let Some(lines) = self.lines {
            let scene = self.scene.any_scene()?;
            let chords = chord_information(&scene, lines, self.seed)?;
            return self
                .output
                .write(&chord_report(&scene, &chords, self.seed)?);
        }
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
        let continuous = if self.continuous {
            Some(continuous_information(&scene)?)
        } else {
            None
        };
        let losses = if self.pairs {
            let all = scene.patches().len();
            let bar = progress_bar((all * (all - 1) / 2) as u64, "pairs")?;
            let losses = pair_losses(&scene, || bar.inc(1))?;
            bar.finish_and_clear();
            Some(losses)
        } else {
            None
        };
        let patches: Vec<&str> = scene.patches().iter().map(NamedPatch::name).collect();
        let continuous = continuous.as_ref().map(|found| (patches.as_slice(), found));
        let written = self.output.write(&measure_report(
            &scene.group_names(),
            &measured,
            continuous,
            losses.as_deref(),
        )?)?;
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
