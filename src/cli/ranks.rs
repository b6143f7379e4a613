//! The ranks that answer a question together, if an engine has started several.

use super::{Answer, Outcome};
use infoscene::exchange::{Alone, Ranks};

/// A way in which this process may be one of several; none if it is not.
type Join = fn() -> Option<Box<dyn Ranks>>;

/// The ways in which this process may be one of several.
const WAYS: &[Join] = &[
    #[cfg(feature = "mpi")]
    Mpi::joined,
];

#[cfg(feature = "mpi")]
use infoscene::ranks::Mpi;

/// The ranks of the job that this process belongs to: itself alone, unless an engine has started
/// it.
pub(super) fn join() -> Box<dyn Ranks> {
    let joined = WAYS.iter().find_map(|join| join());
    joined.unwrap_or_else(|| Box::new(Alone))
}

/// The answer of a question that is not shared out: the first rank gives it.
pub(super) fn first_alone(ranks: &dyn Ranks, answer: impl FnOnce() -> Answer) -> Answer {
    if ranks.number() > 0 {
        return Ok(Outcome::Done);
    }
    answer()
}
