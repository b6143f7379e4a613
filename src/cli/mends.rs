//! The options that mend what the library refuses.
//!
//! The library names the broken condition and its remedy; which option of the command that is
//! stands here, once for all subcommands.

use infoscene::question::Remedy;
use std::error::Error;

/// The end of a message: the options that mend the error, if some do.
pub(super) fn mend(error: &(dyn Error + 'static)) -> String {
    Remedy::of(error).into_iter().map(option).collect()
}

/// The words on the option that is a remedy.
fn option(remedy: Remedy) -> String {
    let words = match remedy {
        Remedy::Resolution(length) => {
            return format!("; --resolution {length:.1e} takes them so");
        }
        Remedy::Unoccluded => "; --unoccluded computes as if nothing were in the way",
        Remedy::Reversed => "; --reverse does",
        Remedy::Triangulated { is_all: true } => "; --triangulate does",
        Remedy::Triangulated { is_all: false } => {
            "\n--triangulate splits faces that are not planar into triangles"
        }
        Remedy::Reflectance => "; --reflectance gives one",
        Remedy::Emittance => "; --emittance gives one, all=0 to all",
        Remedy::ChainOfLight => ": add --chain radiosity or --chain importance",
        Remedy::OneChannel => " with --channel r, g or b",
        Remedy::StateOutside => "; --open adds the state outside",
        Remedy::Occluded => ": leave out --unoccluded",
        Remedy::FewerPairs => ": choose with --from or --to, --matrix writes all",
        Remedy::NoEnclosure => "; leave out --precision",
        Remedy::TwoParts => "; leave out --parts",
        Remedy::ElementsOrLinks => ", by --elements or --links",
        Remedy::AllClaims => "; leave out --printed",
        Remedy::ListOfClaims => "; `infoscene reproduce` shows all ids",
        Remedy::ResumedStore => "; --resume goes on with it",
        Remedy::CompletedStore => ", with form-factor --store and --resume",
    };
    words.to_owned()
}
