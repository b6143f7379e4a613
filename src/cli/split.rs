//! `infoscene split SCENE --patch I`.

use super::Answer;
use super::light::LightArguments;
use super::output::{Output, precision, say};
use super::progress::Bar;
use super::scene::SceneArgument;
use infoscene::geometry::SplitAxis;
use infoscene::question::{self, PatchName};
use infoscene::report::split_report;

#[derive(Debug, clap::Args)]
pub(super) struct Split {
    #[command(flatten)]
    scene: SceneArgument,
    /// The patch to cut: its index from 0, or its name.
    #[arg(long, value_name = "PATCH")]
    patch: PatchName,
    /// The patches it is judged against, by index or name; all others if none is named.
    #[arg(long, value_name = "J,K,…", value_delimiter = ',')]
    against: Vec<PatchName>,
    /// The axis across which it is cut, u towards the second corner, v towards the last: cuts run
    /// parallel to the other one. The better one if none is named.
    #[arg(long, value_enum)]
    axis: Option<AxisName>,
    /// How many parts it is cut into.
    #[arg(long, value_name = "M", default_value_t = 2,
        value_parser = clap::value_parser!(u32).range(2..=64))]
    parts: u32,
    /// Enclose the best cut and its gain, too, with ends of this many bits, and prove it the best
    /// of all; for two parts of rectangles along common axes.
    #[arg(long, value_name = "BITS", value_parser = precision())]
    precision: Option<u32>,
    #[command(flatten)]
    light: LightArguments,
    #[command(flatten)]
    output: Output,
}

#[derive(Debug, Clone, Copy, clap::ValueEnum)]
enum AxisName {
    U,
    V,
}

impl From<AxisName> for SplitAxis {
    fn from(name: AxisName) -> Self {
        match name {
            AxisName::U => Self::U,
            AxisName::V => Self::V,
        }
    }
}

impl Split {
    pub(super) fn answer(&self) -> Answer {
        let question = question::Split {
            scene: self.scene.source(),
            patch: self.patch.clone(),
            against: self.against.clone(),
            axis: self.axis.map(SplitAxis::from),
            parts: self.parts,
            precision: self.precision,
            light: self.light.light(),
        };
        let answer = question.ask(&Bar::default())?;
        say(&answer.notes);
        self.output.write(&split_report(&answer)?)
    }
}
