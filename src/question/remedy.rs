//! Remedies of refusals: changes of a question, or of its scene, after which it is answered.
//!
//! An error names the broken condition and what would mend it. Which option of the command or which
//! argument in Python that is, each door says in its own words; which remedy it is, wherever in the
//! chain of causes it stands, is found here for all of them.
//!
//! **Not covered**: refusals that only another scene, another folder or another name mends.

use super::error::QuestionError;
use super::patch_values::PatchValueError;
use crate::chain::ChainError;
use crate::claims::ClaimError;
use crate::discretize::DiscretizeError;
use crate::exchange::{ExchangeError, StoreError};
use crate::form_factor::FormFactorError;
use crate::geometry::GeometryError;
use crate::hierarchy::HierarchyError;
use crate::scene::SceneError;
use crate::scene::files::{Fault, FileError, FileErrors, NotExpressible, OpenError};
#[cfg(feature = "report")]
use crate::study::StudyError;
use crate::transport::TransportError;
use std::error::Error;
use std::iter;

/// A change that mends a refusal. Each door has words for all of them, or no such option.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Remedy {
    /// To compute as if nothing were in the way.
    Unoccluded,
    /// To take coordinates as rounded to this length.
    Resolution(f64),
    /// To turn the front of every patch.
    Reversed,
    /// To split faces into triangles; other faults may be left.
    Triangulated {
        /// Whether nothing else is at fault.
        is_all: bool,
    },
    /// To give a reflectance.
    Reflectance,
    /// To give an emittance.
    Emittance,
    /// To choose a chain of light.
    ChainOfLight,
    /// To name the channel of coloured light.
    OneChannel,
    /// To add the state outside to an open scene.
    StateOutside,
    /// To stop lines at what they meet.
    Occluded,
    /// To name the patches whose pairs are listed.
    FewerPairs,
    /// To ask for no enclosure.
    NoEnclosure,
    /// To cut into two parts.
    TwoParts,
    /// To ask for elements or links in place of an error.
    ElementsOrLinks,
    /// To ask for claims that print no number, too.
    AllClaims,
    /// To look the ids of claims up.
    ListOfClaims,
    /// To go on with a store that others have begun.
    ResumedStore,
    /// To compute what a store is without.
    CompletedStore,
}

impl Remedy {
    /// The remedies of a refusal: that of its condition first, then that of rounded coordinates.
    #[must_use]
    pub fn of(error: &(dyn Error + 'static)) -> Vec<Self> {
        let causes = || iter::successors(Some(error), |error| cause(*error));
        let condition = causes().find_map(of_condition);
        let resolution = causes().find_map(resolution).map(Self::Resolution);
        condition.into_iter().chain(resolution).collect()
    }
}

/// The remedy of an error itself, whatever it is the cause of.
fn of_condition(error: &(dyn Error + 'static)) -> Option<Remedy> {
    let found = of_scene(error).or_else(|| of_store(error));
    found.or_else(|| of_question(error))
}

/// The remedy of a scene, or of a file that is to become one.
fn of_scene(error: &(dyn Error + 'static)) -> Option<Remedy> {
    match error.downcast_ref() {
        Some(SceneError::MayBeBlocked { .. }) => return Some(Remedy::Unoccluded),
        Some(SceneError::MaterialUnknown { what, .. }) => {
            return Some(match *what {
                "reflectance" => Remedy::Reflectance,
                _ => Remedy::Emittance,
            });
        }
        _ => {}
    }
    if let Some(ExchangeError::TurnedAway) = error.downcast_ref() {
        return Some(Remedy::Reversed);
    }
    if let Some(refusal) = error.downcast_ref::<NotExpressible>() {
        let is_mended = refusal.mend == NotExpressible::SPLIT;
        return is_mended.then_some(Remedy::Triangulated { is_all: true });
    }
    let told = error.downcast_ref::<FileErrors>()?.told();
    let is_all = told.len() == 1;
    let is_mended = told.iter().any(|fault| bent(fault).is_some());
    is_mended.then_some(Remedy::Triangulated { is_all })
}

/// The remedy of a folder that holds a matrix.
fn of_store(error: &(dyn Error + 'static)) -> Option<Remedy> {
    match error.downcast_ref()? {
        StoreError::NotEmpty { .. } => Some(Remedy::ResumedStore),
        StoreError::Incomplete { .. } => Some(Remedy::CompletedStore),
        _ => None,
    }
}

/// The remedy of a question that cannot be asked so.
fn of_question(error: &(dyn Error + 'static)) -> Option<Remedy> {
    if let Some(DiscretizeError::NotEnclosed) = error.downcast_ref() {
        return Some(Remedy::NoEnclosure);
    }
    if let Some(ClaimError::UnknownClaim { .. }) = error.downcast_ref() {
        return Some(Remedy::ListOfClaims);
    }
    Some(match error.downcast_ref()? {
        QuestionError::OpenScene(_) => Remedy::StateOutside,
        QuestionError::ChannelNotNamed { .. } => Remedy::OneChannel,
        QuestionError::NoLightMeant => Remedy::ChainOfLight,
        QuestionError::OccludedLines => Remedy::Occluded,
        QuestionError::TooManyPairs { .. } => Remedy::FewerPairs,
        QuestionError::NoLinearEstimate => Remedy::ElementsOrLinks,
        QuestionError::SeveralCutsEnclosed { .. } => Remedy::TwoParts,
        QuestionError::TooManyCellsToEnclose { .. } => Remedy::NoEnclosure,
        QuestionError::NonePrinted { .. } => Remedy::AllClaims,
        _ => return None,
    })
}

/// The resolution that would mend an error itself.
fn resolution(error: &(dyn Error + 'static)) -> Option<f64> {
    if let Some(
        SceneError::MayBeBlocked { resolution, .. } | SceneError::Overlap { resolution, .. },
    ) = error.downcast_ref()
    {
        return *resolution;
    }
    let faults = error.downcast_ref::<FileErrors>()?.told().iter();
    faults.filter_map(|fault| bent(fault)?).reduce(f64::max)
}

/// The resolution that would explain that a face is not planar, if one would; none if it is planar.
fn bent(fault: &FileError) -> Option<Option<f64>> {
    match &fault.fault {
        Fault::Geometry {
            source: GeometryError::NotPlanar { resolution, .. },
        } => Some(*resolution),
        _ => None,
    }
}

/// Returns the error inside of each of these variants, whose message is that of the error inside.
macro_rules! passed_on {
    ($error:ident: $($(#[$condition:meta])* $type:ident: $($variant:ident)|+;)+) => {
        $(
            $(#[$condition])*
            match $error.downcast_ref() {
                $(Some($type::$variant(inner)) => return Some(inner),)+
                _ => {}
            }
        )+
    };
}

/// The cause of an error. One that only passes on another's message has it inside, and says that
/// the other's cause is its own.
fn cause<'e>(error: &'e (dyn Error + 'static)) -> Option<&'e (dyn Error + 'static)> {
    passed_on! { error:
        FormFactorError: Geometry;
        OpenError: Scene | File;
        ExchangeError: Rank | Scene;
        StoreError: Exchange;
        TransportError: Exchange;
        ChainError: Scene | Exchange;
        DiscretizeError: Numeric | Geometry | FormFactor | Scene | Exchange | Chain;
        HierarchyError: Scene | Transport | Exchange | FormFactor;
        ClaimError: Numeric | Geometry | FormFactor | Scene | Exchange | Transport | Chain
            | Hierarchy | Discretize;
        #[cfg(feature = "report")]
        StudyError: Chain | Claim | Discretize | Geometry | Scene | Exchange | Store | Transport
            | Hierarchy;
        PatchValueError: Name | Scene;
        QuestionError: OpenScene | NotExpressible | PatchName | PatchValue | Points | Open | Scene
            | Exchange | Store | Chain | Transport | Hierarchy | Discretize | Claim;
        #[cfg(feature = "report")]
        QuestionError: Study;
    }
    error.source()
}
