//! The arguments that mend what the library refuses.
//!
//! The library names the broken condition and its remedy; which argument in Python that is stands
//! here, once for all functions.

use crate::question::Remedy;
use std::error::Error;

/// The end of a message: the arguments that mend the error, if some do.
pub(super) fn mend(error: &(dyn Error + 'static)) -> String {
    Remedy::of(error).into_iter().map(argument).collect()
}

/// The words on the argument that is a remedy; none where no function has one.
fn argument(remedy: Remedy) -> String {
    let words = match remedy {
        Remedy::Resolution(length) => {
            return format!("; Scene(…, resolution={length:.1e}) takes them so");
        }
        Remedy::Unoccluded => {
            "; Scene(…, occlusion=\"ignore\") computes as if nothing were in the way"
        }
        Remedy::Reversed => "; Scene(…, reverse=True) does",
        Remedy::Triangulated { is_all: true } => "; Scene(…, triangulate=True) does",
        Remedy::Triangulated { is_all: false } => {
            "\nScene(…, triangulate=True) splits faces that are not planar into triangles"
        }
        Remedy::Reflectance => "; reflectance=… gives one",
        Remedy::Emittance => "; emittance=… gives one",
        Remedy::ChainOfLight => ": give chain=\"radiosity\" or \"importance\"",
        Remedy::OneChannel => " by channel=\"r\", \"g\" or \"b\"",
        Remedy::StateOutside => "; open=True adds the state outside",
        Remedy::NoEnclosure => "; leave out precision",
        Remedy::TwoParts => "; leave out parts",
        Remedy::ElementsOrLinks => ", by elements=… or links=…",
        Remedy::AllClaims => "; leave out printed_only",
        Remedy::ListOfClaims => "; reproduce() without ids has all",
        // there are no lines at random, no lists of pairs and no stores
        Remedy::Occluded | Remedy::FewerPairs | Remedy::ResumedStore | Remedy::CompletedStore => "",
    };
    words.to_owned()
}
