//! Listeners to the progress of a computation.

use std::fmt;

/// A listener to the progress of a computation.
///
/// Every function `Fn(usize) + Sync` is one.
///
/// # Examples
/// ```
/// use infoscene::exchange::{Congruence, ScenePairs};
/// use infoscene::scene::{Occlusion, Scene};
/// use std::sync::atomic::{AtomicUsize, Ordering};
/// let done = AtomicUsize::new(0);
/// let listener = |finished| {
///     done.fetch_add(finished, Ordering::Relaxed);
/// };
/// let cube = Scene::built_in("cube:2")?;
/// let pairs = ScenePairs::try_new(&cube, 1e-12, Congruence::Shared, Occlusion::Exact)?;
/// let pairs = pairs.with_progress(&listener);
/// pairs.exchange_areas()?;
/// assert_eq!(done.load(Ordering::Relaxed), pairs.pairs());
/// # Ok::<(), infoscene::exchange::ExchangeError>(())
/// ```
pub trait Progress: Sync {
    /// Reports that so many units of work begin, named in the plural: `pairs`, `cases`. A listener
    /// that needs no total leaves it out.
    fn begin(&self, _units: u64, _name: &str) {}

    /// Reports that so many more units of work are finished; any thread may call it.
    fn advance(&self, finished: usize);

    /// Reports the state of a computation whose length is not known before, in one line.
    fn tell(&self, _state: &str) {}
}

impl<F: Fn(usize) + Sync> Progress for F {
    fn advance(&self, finished: usize) {
        self(finished);
    }
}

/// The listener that does nothing.
#[derive(Debug, Clone, Copy, Default)]
pub struct Unheard;

impl Progress for Unheard {
    fn advance(&self, _: usize) {}
}

/// The listener of a scene's pairs.
#[derive(Clone, Copy)]
pub(crate) struct Listener<'p>(pub(crate) &'p dyn Progress);

impl fmt::Debug for Listener<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Listener")
    }
}
