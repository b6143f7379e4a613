//! `infoscene measure SCENE`.

use super::light::Light;
use super::output::{Output, progress_bar};
use super::scene_pairs::{PairsBar, ScenePairsOptions, outcome};
use super::{Answer, Outcome};
use infoscene::chain::ChainError;
use infoscene::exchange::{ExchangeError, ScenePairs};
use infoscene::information::{
    LineKind, LineSample, OpenScene, brightness_information, continuous_information, pair_losses,
    scene_information, scene_information_and_bias,
};
use infoscene::report::{measure_report, sample_report};
use infoscene::scene::{NamedPatch, Scene, SceneError};
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
    /// The continuous mutual information, too: of a closed scene that is convex inside, or from random lines.
    #[arg(long)]
    continuous: bool,
    /// What each pair of patches loses against the continuous one: the most that subdividing both can gain.
    #[arg(long, requires = "continuous", conflicts_with = "sample")]
    pairs: bool,
    /// Estimates from so many random lines: of any closed scene, concave or occluded; light and tolerance do not enter.
    #[arg(long, visible_alias = "lines", value_name = "LINES", conflicts_with = "open",
        value_parser = clap::value_parser!(u32).range(2..))]
    sample: Option<u32>,
    /// How the lines are drawn.
    #[arg(long, value_enum, requires = "sample", default_value_t = KindName::Local)]
    kind: KindName,
    /// The same seed draws the same lines.
    #[arg(long, value_name = "S", requires = "sample", default_value_t = 1)]
    seed: u64,
    #[command(flatten)]
    output: Output,
}

#[derive(Debug, Clone, Copy, clap::ValueEnum)]
enum KindName {
    /// From points of the patches, to what is met first.
    Local,
    /// Through the whole scene, with all that is met.
    Global,
}

impl From<KindName> for LineKind {
    fn from(name: KindName) -> Self {
        match name {
            KindName::Local => Self::Local,
            KindName::Global => Self::Global,
        }
    }
}

/// Rows up to which the exact value stands beside a sampled one, where nothing is in the way: a second or so.
const MOST_ROWS: usize = 6144;

/// An open scene was refused, and could have been taken.
#[derive(Debug, thiserror::Error)]
#[error("{0}; --open adds the state outside")]
struct OpenRefused(ChainError);

impl Measure {
    pub(super) fn answer(&self) -> Answer {
        self.output.check()?;
        if let Some(lines) = self.sample {
            return self.sampled(lines);
        }
        let scene = self.scene.scene()?;
        let bar = self.scene.bar(&scene)?;
        let pairs = self.scene.pairs(&scene, &bar)?;
        let open_scene = if self.open {
            OpenScene::AddOutsideState
        } else {
            OpenScene::Refuse
        };
        let measured = if self.light.is_visibility()? {
            scene_information(&pairs, open_scene).map_err(with_mend)?
        } else {
            let exchange = pairs.exchange_areas()?;
            brightness_information(&exchange, &self.light.brightness(&scene, &exchange)?)?
        };
        // without obstructions nothing is in the way in a room that is convex inside
        let bare = self.scene.is_unoccluded().then(|| scene.clone());
        let bare = bare.map(|scene| scene.with_obstructions(Vec::new()));
        let room = bare.as_ref().unwrap_or(&scene);
        let continuous = if self.continuous {
            Some(continuous_information(room)?)
        } else {
            None
        };
        let losses = if self.pairs {
            let all = scene.patches().len();
            let bar = progress_bar((all * (all - 1) / 2) as u64, "pairs")?;
            let losses = pair_losses(room, &|finished: usize| bar.inc(finished as u64))?;
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
        match outcome(&scene, Some(&measured.summary), pairs.tolerance()) {
            Outcome::Done => Ok(written),
            differs @ Outcome::Differs => Ok(differs),
        }
    }

    fn sampled(&self, lines: u32) -> Answer {
        if !self.light.is_visibility()? {
            return Err(
                "lines at random know the chain of visibility only: leave out --sample, or --chain"
                    .into(),
            );
        }
        let scene = self.scene.occluded_scene()?;
        let sample = LineSample::draw(&scene, self.kind.into(), lines, self.seed)?;
        let bar = self.scene.bar(&scene)?;
        let exact = if let Some(pairs) = self.unblocked_pairs(&scene, &bar)? {
            let (measured, bias) = scene_information_and_bias(&pairs, sample.counts.samples())?;
            Some([measured.mutual_information.value, bias])
        } else {
            None
        };
        let report = sample_report(&scene, &sample, exact, self.continuous, self.seed)?;
        self.output.write(&report)
    }

    /// The pairs of a scene that is small enough, and in which nothing is in the way.
    fn unblocked_pairs<'b>(
        &self,
        scene: &Scene,
        bar: &'b PairsBar,
    ) -> Result<Option<ScenePairs<'b>>, Box<dyn Error>> {
        if scene.group_count() > MOST_ROWS {
            return Ok(None);
        }
        match self.scene.pairs(scene, bar) {
            Err(ExchangeError::Scene(SceneError::MayBeBlocked { .. })) => Ok(None),
            pairs => Ok(Some(pairs?)),
        }
    }
}

/// Names the flag that mends it.
fn with_mend(source: ChainError) -> Box<dyn Error> {
    match source {
        ChainError::Exchange(ExchangeError::OpenScene { .. }) => OpenRefused(source).into(),
        _ => source.into(),
    }
}
