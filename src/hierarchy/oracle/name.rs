//! The names of the oracles, as the command takes them.

use super::area::Area;
use super::chain::Chain;
use super::gather::Gather;
use super::gradient::Gradient;
use super::information::Information;
use super::kernel::Kernel;
use super::losses::Losses;
use super::neighbours::Neighbours;
use super::paper::Paper;
use super::power::Power;
use super::received::ReceivedRange;
use super::repaired::Repaired;
use super::residual::Residual;
use super::true_error::{Reference, TrueError};
use super::{HierarchyError, Oracle};
use std::fmt;
use std::str::FromStr;

/// The name of an oracle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
#[non_exhaustive]
pub enum OracleName {
    /// The three steps of §5.
    Paper,
    /// The three steps, repaired.
    PaperRepaired,
    /// The gain of §5, for a constant radiosity.
    Information,
    /// The gain of eq. (5) in the brightness chain.
    Chain,
    /// The information that links lose.
    Losses,
    /// The reflected power.
    Power,
    /// The variation of form factors.
    Kernel,
    /// The range of the irradiance over the corners.
    Received,
    /// The deviation of the parts' gathered light.
    Gather,
    /// The residual at Gauss points.
    Residual,
    /// The gradient of the irradiance.
    #[default]
    Gradient,
    /// The gradient of the neighbours' radiosities.
    Neighbours,
    /// The area.
    Area,
    /// The error against a reference.
    True,
}

impl OracleName {
    /// All names.
    pub const ALL: [Self; 14] = [
        Self::Paper,
        Self::PaperRepaired,
        Self::Information,
        Self::Chain,
        Self::Losses,
        Self::Power,
        Self::Kernel,
        Self::Received,
        Self::Gather,
        Self::Residual,
        Self::Gradient,
        Self::Neighbours,
        Self::Area,
        Self::True,
    ];

    /// The name as the command takes it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Paper => "paper",
            Self::PaperRepaired => "paper-repaired",
            Self::Information => "information",
            Self::Chain => "chain",
            Self::Losses => "losses",
            Self::Power => "power",
            Self::Kernel => "kernel",
            Self::Received => "received",
            Self::Gather => "gather",
            Self::Residual => "residual",
            Self::Gradient => "gradient",
            Self::Neighbours => "neighbours",
            Self::Area => "area",
            Self::True => "true",
        }
    }

    /// The measure by which the oracle ranks, in a few words.
    #[must_use]
    pub const fn measure(self) -> &'static str {
        match self {
            Self::Paper => "The three steps of §5, ranked",
            Self::PaperRepaired => "The three steps without what misleads",
            Self::Information => "The gain of §5, for a constant radiosity",
            Self::Chain => "The gain of eq. (5) in the brightness chain",
            Self::Losses => "The information that links lose",
            Self::Power => "The reflected power",
            Self::Kernel => "The variation of form factors",
            Self::Received => "The range of the irradiance over the corners",
            Self::Gather => "The deviation of the light that parts gather",
            Self::Residual => "The residual at Gauss points",
            Self::Gradient => "The gradient of the irradiance",
            Self::Neighbours => "The gradient of the neighbours' radiosities",
            Self::Area => "The area",
            Self::True => "The error against a mesh 16 times finer",
        }
    }

    /// The oracle; the reference is what [`True`](Self::True) compares with.
    ///
    /// # Errors
    /// [`HierarchyError::NoReference`] for [`True`](Self::True) without one.
    pub fn oracle(self, reference: Option<&Reference>) -> Result<Box<dyn Oracle>, HierarchyError> {
        Ok(match self {
            Self::Paper => Box::new(Paper),
            Self::PaperRepaired => Box::new(Repaired),
            Self::Information => Box::new(Information),
            Self::Chain => Box::new(Chain),
            Self::Losses => Box::new(Losses),
            Self::Power => Box::new(Power),
            Self::Kernel => Box::new(Kernel),
            Self::Received => Box::new(ReceivedRange),
            Self::Gather => Box::new(Gather),
            Self::Residual => Box::new(Residual),
            Self::Gradient => Box::new(Gradient),
            Self::Neighbours => Box::new(Neighbours),
            Self::Area => Box::new(Area),
            Self::True => {
                let reference = reference.ok_or(HierarchyError::NoReference)?;
                Box::new(TrueError::new(reference.clone()))
            }
        })
    }
}

impl fmt::Display for OracleName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for OracleName {
    type Err = HierarchyError;

    fn from_str(name: &str) -> Result<Self, HierarchyError> {
        let mut all = Self::ALL.into_iter();
        all.find(|oracle| oracle.name() == name)
            .ok_or_else(|| HierarchyError::UnknownOracle {
                name: name.to_owned(),
                known: Self::ALL.map(Self::name).to_vec(),
            })
    }
}
