//! `infoscene radiosity SCENE`.

use super::output::Output;
use super::patch_values::{Materials, PatchValue, values};
use super::scene_pairs::{ScenePairsOptions, outcome};
use super::{Answer, Outcome};
use infoscene::report::radiosity_report;
use infoscene::scene::Material;
use infoscene::transport::RadiositySystem;

#[derive(Debug, clap::Args)]
pub(super) struct Radiosity {
    #[command(flatten)]
    scene: ScenePairsOptions,
    #[command(flatten)]
    materials: Materials,
    /// Also importances, for these direct ones: PATCH=VALUE,…, or PATCH alone for 1; PATCH is an index, a name, or all.
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    importance: Vec<PatchValue>,
    #[command(flatten)]
    output: Output,
}

impl Radiosity {
    pub(super) fn answer(&self) -> Answer {
        self.output.check()?;
        let scene = self.scene.scene()?;
        let materials = self.materials.of(&scene)?;
        let direct = values(&self.importance, &scene)?;
        let bar = self.scene.bar(&scene)?;
        let pairs = self.scene.pairs(&scene, &bar)?;
        let exchange = pairs.exchange_areas()?;
        let room = RadiositySystem::of(&exchange, &materials)?;
        let emittances: Vec<f64> = materials.iter().map(Material::emittance).collect();
        let radiosity = room.radiosity(&emittances)?;
        let importance = if self.importance.is_empty() {
            None
        } else {
            Some(room.importance(&direct)?)
        };
        let report = radiosity_report(
            &scene.group_names(),
            &materials,
            &exchange,
            &radiosity,
            importance.as_ref(),
        )?;
        let written = self.output.write(&report)?;
        if radiosity.relative_error > pairs.tolerance() {
            eprintln!(
                "infoscene: the radiosities may be {:.0e} off, relative, and the tolerance is {:e}",
                radiosity.relative_error,
                pairs.tolerance()
            );
            return Ok(Outcome::Differs);
        }
        match outcome(&scene, Some(exchange.summary()), pairs.tolerance()) {
            Outcome::Done => Ok(written),
            differs @ Outcome::Differs => Ok(differs),
        }
    }
}
