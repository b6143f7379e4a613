//! `infoscene refine SCENE`.

use super::Answer;
use super::light::{ChannelName, MaterialArguments};
use super::output::{Output, check_place, say, write_file};
use super::progress::Bar;
use super::scene::SceneArgument;
use clap::ArgGroup;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use infoscene::hierarchy::{CutCriterion, Division, Factors, Goal, OracleName};
use infoscene::question::{self, NetWish, PatchName, PatchValue};
use infoscene::report::{refinement_net, refinement_report};
use infoscene::scene::Channel;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
#[command(group(ArgGroup::new("goal").required(true).args(["elements", "links", "error"])))]
pub(super) struct Refine {
    #[command(flatten)]
    scene: SceneArgument,
    /// The oracle that says which element is cut next.
    #[arg(long, value_name = "NAME", default_value = OracleName::default().name(),
        value_parser = oracles())]
    oracle: OracleName,
    /// Refine until there are so many elements, give or take the parts of one.
    #[arg(long, value_name = "N")]
    elements: Option<usize>,
    /// Refine until there are so many links at least.
    #[arg(long, value_name = "N")]
    links: Option<usize>,
    /// Refine until the relative error in L2 over all that is not light is estimated to be at most
    /// this.
    #[arg(long, value_name = "REL")]
    error: Option<f64>,
    /// Take the radiosity to be linear on each element, not constant.
    #[arg(long)]
    linear: bool,
    #[command(flatten)]
    materials: MaterialArguments,
    /// The channel of colour: that of coloured light must be named.
    #[arg(long, value_enum, value_name = "CHANNEL")]
    channel: Option<ChannelName>,
    /// Cut elements for the light of these patches, by their direct importances: PATCH=VALUE,…, or
    /// PATCH alone for 1; PATCH is an index, a name, or all.
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    importance: Vec<PatchValue>,
    /// Take exact form factors between elements, which lose no energy, but are slower.
    #[arg(long)]
    exact: bool,
    /// The cuts of elements.
    #[arg(long, value_enum, default_value_t = Cuts::Quarters)]
    cuts: Cuts,
    /// Bound the error where something stands in the way, too: it takes seconds to minutes.
    #[arg(long)]
    bound: bool,
    /// Gather the light once more in the end, for the means of the patches and for the figure.
    #[arg(long)]
    gather: bool,
    /// Draw the walls unfolded, shaded by the radiosity, too, into an SVG file.
    #[arg(long, value_name = "PATH")]
    figure: Option<PathBuf>,
    /// Outline the elements in the figure.
    #[arg(long, requires = "figure")]
    mesh: bool,
    /// Show in the figure from where the element in the middle of this patch receives light.
    #[arg(long, value_name = "PATCH", requires = "figure")]
    links_of: Option<PatchName>,
    #[command(flatten)]
    output: Output,
}

/// The cuts of elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Cuts {
    /// Into quarters; elongated elements into halves.
    Quarters,
    /// In two, where the mean square error is least.
    MeanSquare,
    /// In two, where mutual information is highest (§4.2).
    Information,
}

impl From<Cuts> for Division {
    fn from(cuts: Cuts) -> Self {
        match cuts {
            Cuts::Quarters => Self::Quarters,
            Cuts::MeanSquare => Self::Bisection(CutCriterion::MeanSquare),
            Cuts::Information => Self::Bisection(CutCriterion::Information),
        }
    }
}

/// The names of the oracles, with what each measures.
fn oracles() -> impl TypedValueParser<Value = OracleName> {
    let named = |oracle: &OracleName| PossibleValue::new(oracle.name()).help(oracle.measure());
    let names = PossibleValuesParser::new(OracleName::ALL.iter().map(named));
    names.try_map(|name| name.parse::<OracleName>())
}

impl Refine {
    pub(super) fn answer(&self) -> Answer {
        self.output.check()?;
        if let Some(path) = &self.figure {
            check_place(path)?;
        }
        let question = question::Refine {
            scene: self.scene.source(),
            oracle: self.oracle,
            goal: self.goal()?,
            linear: self.linear,
            materials: self.materials.changes(),
            channel: self.channel.map(Channel::from),
            importance: self.importance.clone(),
            factors: match self.exact {
                true => Factors::Exact,
                false => Factors::OfPoints,
            },
            division: self.cuts.into(),
            bound: self.bound,
            gather: self.gather,
            mesh: false,
            net: self.figure.as_ref().map(|_| NetWish {
                links_of: self.links_of.clone(),
            }),
        };
        let answer = question.ask(&Bar::default())?;
        say(&answer.notes);
        let net = refinement_net(&answer, self.mesh);
        if let Some((path, net)) = self.figure.as_ref().zip(net) {
            write_file(path, net.to_svg()?.as_bytes())?;
        }
        self.output.write(&refinement_report(&answer)?)
    }

    /// The goal that is given: there is one.
    fn goal(&self) -> Result<Goal, &'static str> {
        let elements = self.elements.map(Goal::Elements);
        let links = self.links.map(Goal::Links);
        let goal = elements.or(links).or(self.error.map(Goal::Error));
        goal.ok_or("give --elements, --links or --error")
    }
}
