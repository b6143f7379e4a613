//! The options that mend what the library refuses.
//!
//! The library names the broken condition and its remedy; which option of the command that is
//! stands here, once for all subcommands.

use infoscene::chain::ChainError;
use infoscene::claims::ClaimError;
use infoscene::discretize::DiscretizeError;
use infoscene::exchange::{ExchangeError, StoreError};
use infoscene::geometry::GeometryError;
use infoscene::hierarchy::HierarchyError;
use infoscene::question::{PatchValueError, QuestionError};
use infoscene::scene::SceneError;
use infoscene::scene::files::{Fault, FileError, FileErrors, NotExpressible, OpenError};
use infoscene::study::StudyError;
use infoscene::transport::TransportError;
use std::error::Error;

/// The end of a message: the option that mends the error, if one does.
pub(super) fn mend(error: &(dyn Error + 'static)) -> String {
    let causes = || std::iter::successors(Some(error), |error| cause(*error));
    let option = causes().find_map(option).unwrap_or_default();
    let resolution = causes().find_map(resolution);
    let resolution = resolution.map(|length| format!("; --resolution {length:.1e} takes them so"));
    format!("{option}{}", resolution.unwrap_or_default())
}

/// The resolution that would mend an error itself.
fn resolution(error: &(dyn Error + 'static)) -> Option<f64> {
    if let Some(
        SceneError::MayBeBlocked { resolution, .. } | SceneError::Overlap { resolution, .. },
    ) = error.downcast_ref()
    {
        return *resolution;
    }
    match error.downcast_ref() {
        Some(Fault::Geometry {
            source: GeometryError::NotPlanar { resolution, .. },
        }) => *resolution,
        _ => None,
    }
}

/// The option that mends an error itself, whatever it is the cause of.
fn option(error: &(dyn Error + 'static)) -> Option<&'static str> {
    if let Some(SceneError::MayBeBlocked { .. }) = error.downcast_ref() {
        return Some("; --unoccluded computes as if nothing were in the way");
    }
    if let Some(SceneError::MaterialUnknown { what, .. }) = error.downcast_ref() {
        return Some(match *what {
            "reflectance" => "; --reflectance gives one",
            _ => "; --emittance gives one, all=0 to all",
        });
    }
    if let Some(StoreError::NotEmpty { .. }) = error.downcast_ref() {
        return Some("; --resume goes on with it");
    }
    if let Some(StoreError::Incomplete { .. }) = error.downcast_ref() {
        return Some(", with form-factor --store and --resume");
    }
    if let Some(ExchangeError::TurnedAway) = error.downcast_ref() {
        return Some("; --reverse does");
    }
    if let Some(errors) = error.downcast_ref::<FileErrors>() {
        let is_bent = |fault: &FileError| {
            let Fault::Geometry { source } = &fault.fault else {
                return false;
            };
            matches!(source, GeometryError::NotPlanar { .. })
        };
        let [first, others @ ..] = errors.told() else {
            return None;
        };
        return match others {
            [] => is_bent(first).then_some("; --triangulate does"),
            _ => errors
                .told()
                .iter()
                .any(is_bent)
                .then_some("\n--triangulate splits faces that are not planar into triangles"),
        };
    }
    if let Some(refusal) = error.downcast_ref::<NotExpressible>() {
        return (refusal.mend == NotExpressible::SPLIT).then_some("; --triangulate does");
    }
    if let Some(DiscretizeError::NotEnclosed) = error.downcast_ref() {
        return Some("; leave out --precision");
    }
    match error.downcast_ref() {
        Some(QuestionError::TooManyCellsToEnclose { .. }) => {
            return Some("; leave out --precision");
        }
        Some(QuestionError::NonePrinted { .. }) => return Some("; leave out --printed"),
        _ => {}
    }
    if let Some(ClaimError::UnknownClaim { .. }) = error.downcast_ref() {
        return Some("; `infoscene reproduce` shows all ids");
    }
    match error.downcast_ref()? {
        QuestionError::OpenScene(_) => Some("; --open adds the state outside"),
        QuestionError::ChannelNotNamed { .. } => Some(" with --channel r, g or b"),
        QuestionError::NoLightMeant => Some(": add --chain radiosity or --chain importance"),
        QuestionError::StoreOfVisibility => Some(": leave out --store, or --chain"),
        QuestionError::OccludedLines => Some(": leave out --unoccluded"),
        QuestionError::TooManyPairs { .. } => {
            Some(": choose with --from or --to, --matrix writes all")
        }
        QuestionError::NoLinearEstimate => Some(", by --elements or --links"),
        QuestionError::SeveralCutsEnclosed { .. } => Some("; leave out --parts"),
        _ => None,
    }
}

/// The cause of an error. One that only passes on another's message has it inside.
fn cause<'e>(error: &'e (dyn Error + 'static)) -> Option<&'e (dyn Error + 'static)> {
    match error.downcast_ref() {
        Some(OpenError::Scene(inner)) => return Some(inner),
        Some(OpenError::File(inner)) => return Some(inner),
        _ => {}
    }
    if let Some(ExchangeError::Scene(inner)) = error.downcast_ref() {
        return Some(inner);
    }
    match error.downcast_ref() {
        Some(ChainError::Scene(inner)) => return Some(inner),
        Some(ChainError::Exchange(inner)) => return Some(inner),
        _ => {}
    }
    if let Some(TransportError::Exchange(inner)) = error.downcast_ref() {
        return Some(inner);
    }
    match error.downcast_ref() {
        Some(DiscretizeError::Scene(inner)) => return Some(inner),
        Some(DiscretizeError::Exchange(inner)) => return Some(inner),
        Some(DiscretizeError::Chain(inner)) => return Some(inner),
        _ => {}
    }
    match error.downcast_ref() {
        Some(ClaimError::Scene(inner)) => return Some(inner),
        Some(ClaimError::Exchange(inner)) => return Some(inner),
        Some(ClaimError::Chain(inner)) => return Some(inner),
        Some(ClaimError::Transport(inner)) => return Some(inner),
        Some(ClaimError::Discretize(inner)) => return Some(inner),
        _ => {}
    }
    match error.downcast_ref() {
        Some(HierarchyError::Scene(inner)) => return Some(inner),
        Some(HierarchyError::Transport(inner)) => return Some(inner),
        Some(HierarchyError::Exchange(inner)) => return Some(inner),
        _ => {}
    }
    match error.downcast_ref() {
        Some(StudyError::Scene(inner)) => return Some(inner),
        Some(StudyError::Exchange(inner)) => return Some(inner),
        Some(StudyError::Chain(inner)) => return Some(inner),
        Some(StudyError::Claim(inner)) => return Some(inner),
        Some(StudyError::Transport(inner)) => return Some(inner),
        Some(StudyError::Discretize(inner)) => return Some(inner),
        _ => {}
    }
    match error.downcast_ref() {
        Some(QuestionError::Open(inner)) => return Some(inner),
        Some(QuestionError::Scene(inner)) => return Some(inner),
        Some(QuestionError::NotExpressible(inner)) => return Some(inner),
        Some(
            QuestionError::Exchange(inner) | QuestionError::Store(StoreError::Exchange(inner)),
        ) => {
            return Some(inner);
        }
        Some(QuestionError::Store(inner)) => return Some(inner),
        Some(QuestionError::Chain(inner)) => return Some(inner),
        Some(QuestionError::Transport(inner)) => return Some(inner),
        Some(QuestionError::Discretize(inner)) => return Some(inner),
        Some(QuestionError::Claim(inner)) => return Some(inner),
        Some(QuestionError::Hierarchy(inner)) => return Some(inner),
        Some(QuestionError::Study(inner)) => return Some(inner),
        Some(QuestionError::PatchValue(PatchValueError::Scene(inner))) => return Some(inner),
        _ => {}
    }
    error.source()
}
