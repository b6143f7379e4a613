//! The arguments that describe a chain of a scene and its light.

use infoscene::question::{Light, MaterialChanges, PatchValue, SceneChain};
use infoscene::scene::{Channel, Channels};

#[derive(Debug, clap::Args)]
pub(super) struct LightArguments {
    /// The chain that is meant.
    #[arg(long, value_enum, default_value_t = ChainName::Visibility)]
    chain: ChainName,
    /// The channel of colour: that of coloured light must be named, each has a chain of its own.
    #[arg(long, value_enum, value_name = "CHANNEL")]
    channel: Option<ChannelName>,
    #[command(flatten)]
    materials: MaterialArguments,
    /// Direct importances, for the importance chain: PATCH=VALUE,…, or PATCH alone for 1; PATCH is
    /// an index, a name, or all.
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    importance: Vec<PatchValue>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum ChainName {
    /// Weights are areas, transitions form factors.
    Visibility,
    /// Weighted with the radiosities: weights are generalised areas (§3.4).
    Radiosity,
    /// Weighted with the reflected importances (§3.5).
    Importance,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum ChannelName {
    /// Red.
    R,
    /// Green.
    G,
    /// Blue.
    B,
}

impl From<ChannelName> for Channel {
    fn from(name: ChannelName) -> Self {
        match name {
            ChannelName::R => Self::Red,
            ChannelName::G => Self::Green,
            ChannelName::B => Self::Blue,
        }
    }
}

impl From<ChainName> for SceneChain {
    fn from(name: ChainName) -> Self {
        match name {
            ChainName::Visibility => Self::Visibility,
            ChainName::Radiosity => Self::Radiosity,
            ChainName::Importance => Self::Importance,
        }
    }
}

impl LightArguments {
    /// Whether the chain is that of visibility, and no light is described.
    pub(super) fn is_absent(&self) -> bool {
        self.light() == Light::default()
    }

    /// The chain that is meant, and its light.
    pub(super) fn light(&self) -> Light {
        Light {
            chain: self.chain.into(),
            channel: self.channel.map(Channel::from),
            materials: self.materials.changes(),
            importance: self.importance.clone(),
        }
    }
}

/// Materials given beside the scene's own.
#[derive(Debug, clap::Args)]
pub(super) struct MaterialArguments {
    /// Reflectances in place of the scene's: PATCH=VALUE,…, or PATCH=R:G:B; PATCH is an index, a
    /// name, or all.
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    reflectance: Vec<PatchValue<Channels<f64>>>,
    /// Emittances in place of the scene's: PATCH=VALUE,…, or PATCH=R:G:B, or PATCH alone for 1.
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    emittance: Vec<PatchValue<Channels<f64>>>,
}

impl MaterialArguments {
    pub(super) fn changes(&self) -> MaterialChanges {
        MaterialChanges {
            reflectance: self.reflectance.clone(),
            emittance: self.emittance.clone(),
        }
    }
}
