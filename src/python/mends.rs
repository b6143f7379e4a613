//! The arguments that mend what the library refuses.
//!
//! The library names the broken condition and its remedy; which argument in Python that is stands
//! here, once for all functions.

use crate::chain::ChainError;
use crate::claims::ClaimError;
use crate::discretize::DiscretizeError;
use crate::exchange::ExchangeError;
use crate::geometry::GeometryError;
use crate::hierarchy::HierarchyError;
use crate::question::{PatchValueError, QuestionError};
use crate::scene::SceneError;
use crate::scene::files::{Fault, FileError, FileErrors, OpenError};
use crate::transport::TransportError;
use std::error::Error;

/// The end of a message: the argument that mends the error, if one does.
pub(super) fn mend(error: &(dyn Error + 'static)) -> String {
    let causes = || std::iter::successors(Some(error), |error| cause(*error));
    let argument = causes().find_map(argument).unwrap_or_default();
    let resolution = causes().find_map(resolution);
    let resolution =
        resolution.map(|length| format!("; Scene(…, resolution={length:.1e}) takes them so"));
    format!("{argument}{}", resolution.unwrap_or_default())
}

/// The resolution that would mend an error itself.
fn resolution(error: &(dyn Error + 'static)) -> Option<f64> {
    if let Some(
        SceneError::MayBeBlocked { resolution, .. } | SceneError::Overlap { resolution, .. },
    ) = error.downcast_ref()
    {
        return *resolution;
    }
    let errors: &FileErrors = error.downcast_ref()?;
    errors.told().iter().find_map(|one| match one.fault {
        Fault::Geometry {
            source: GeometryError::NotPlanar { resolution, .. },
        } => resolution,
        _ => None,
    })
}

/// The argument that mends an error itself, whatever it is the cause of.
fn argument(error: &(dyn Error + 'static)) -> Option<&'static str> {
    match error.downcast_ref() {
        Some(SceneError::MayBeBlocked { .. }) => {
            return Some("; Scene(…, occlusion=\"ignore\") computes as if nothing were in the way");
        }
        Some(SceneError::MaterialUnknown { what, .. }) => {
            return Some(match *what {
                "reflectance" => "; reflectance=… gives one",
                _ => "; emittance=… gives one",
            });
        }
        _ => {}
    }
    if let Some(ExchangeError::TurnedAway) = error.downcast_ref() {
        return Some("; Scene(…, reverse=True) does");
    }
    if let Some(errors) = error.downcast_ref::<FileErrors>() {
        let mend = match errors.told() {
            [_] => "; Scene(…, triangulate=True) does",
            _ => "\nScene(…, triangulate=True) splits faces that are not planar into triangles",
        };
        return errors.told().iter().any(is_bent).then_some(mend);
    }
    if let Some(DiscretizeError::NotEnclosed) = error.downcast_ref() {
        return Some("; leave out precision");
    }
    if let Some(ClaimError::UnknownClaim { .. }) = error.downcast_ref() {
        return Some("; reproduce() without ids has all");
    }
    match error.downcast_ref()? {
        QuestionError::OpenScene(_) => Some("; open=True adds the state outside"),
        QuestionError::ChannelNotNamed { .. } => Some(" by channel=\"r\", \"g\" or \"b\""),
        QuestionError::NoLightMeant => Some(": give chain=\"radiosity\" or \"importance\""),
        QuestionError::NonePrinted { .. } => Some("; leave out printed_only"),
        QuestionError::NoLinearEstimate => Some(", by elements=… or links=…"),
        QuestionError::SeveralCutsEnclosed { .. } => Some("; leave out parts"),
        _ => None,
    }
}

/// Whether a face is not planar.
fn is_bent(fault: &FileError) -> bool {
    let Fault::Geometry { source } = &fault.fault else {
        return false;
    };
    matches!(source, GeometryError::NotPlanar { .. })
}

/// The cause of an error. One that only passes on another's message has it inside.
fn cause<'e>(error: &'e (dyn Error + 'static)) -> Option<&'e (dyn Error + 'static)> {
    let inner = in_question(error).or_else(|| in_room(error));
    inner.or_else(|| error.source())
}

/// The error that a question's passes on.
fn in_question<'e>(error: &'e (dyn Error + 'static)) -> Option<&'e (dyn Error + 'static)> {
    match error.downcast_ref() {
        Some(OpenError::Scene(inner)) => return Some(inner),
        Some(OpenError::File(inner)) => return Some(inner),
        _ => {}
    }
    Some(match error.downcast_ref()? {
        QuestionError::Open(inner) => inner,
        QuestionError::Scene(inner) => inner,
        QuestionError::Exchange(inner) => inner,
        QuestionError::Chain(inner) => inner,
        QuestionError::Transport(inner) => inner,
        QuestionError::Discretize(inner) => inner,
        QuestionError::Claim(inner) => inner,
        QuestionError::Hierarchy(inner) => inner,
        QuestionError::PatchValue(PatchValueError::Scene(inner)) => inner,
        _ => return None,
    })
}

/// The error that one of the rooms before passes on.
fn in_room<'e>(error: &'e (dyn Error + 'static)) -> Option<&'e (dyn Error + 'static)> {
    if let Some(ExchangeError::Scene(inner)) = error.downcast_ref() {
        return Some(inner);
    }
    if let Some(TransportError::Exchange(inner)) = error.downcast_ref() {
        return Some(inner);
    }
    match error.downcast_ref() {
        Some(ChainError::Scene(inner)) => return Some(inner),
        Some(ChainError::Exchange(inner)) => return Some(inner),
        _ => {}
    }
    match error.downcast_ref() {
        Some(DiscretizeError::Scene(inner)) => return Some(inner),
        Some(DiscretizeError::Exchange(inner)) => return Some(inner),
        Some(DiscretizeError::Chain(inner)) => return Some(inner),
        _ => {}
    }
    match error.downcast_ref() {
        Some(HierarchyError::Scene(inner)) => Some(inner),
        Some(HierarchyError::Transport(inner)) => Some(inner),
        Some(HierarchyError::Exchange(inner)) => Some(inner),
        _ => None,
    }
}
