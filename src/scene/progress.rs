//! How far a pass over all pairs is.

use super::ScenePairs;
use std::fmt;
use std::sync::Arc;

/// Who is told how many more pairs of different rows are done.
#[derive(Clone, Default)]
pub(super) struct Progress(Option<Arc<dyn Fn(usize) + Send + Sync>>);

impl Progress {
    pub(super) fn done(&self, pairs: usize) {
        if let Some(told) = &self.0 {
            told(pairs);
        }
    }
}

impl fmt::Debug for Progress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let told = if self.0.is_some() { "told" } else { "not told" };
        write!(f, "Progress({told})")
    }
}

impl ScenePairs {
    /// Tells how many more pairs are done, of [`pairs`](Self::pairs) in each pass: a row of them, or a part of one, at a time, from any
    /// thread.
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::{Congruence, Occlusion, Scene, ScenePairs};
    /// use std::sync::Arc;
    /// use std::sync::atomic::{AtomicUsize, Ordering};
    /// let done = Arc::new(AtomicUsize::new(0));
    /// let so_far = Arc::clone(&done);
    /// let cube = Scene::built_in("cube:2")?;
    /// let pairs = ScenePairs::try_new(&cube, 1e-12, Congruence::Shared, Occlusion::Refuse)?;
    /// let pairs = pairs.with_progress(move |more| {
    ///     so_far.fetch_add(more, Ordering::Relaxed);
    /// });
    /// pairs.exchange_areas()?;
    /// assert_eq!(done.load(Ordering::Relaxed), pairs.pairs());
    /// # Ok::<(), infoscene::scene::ExchangeError>(())
    /// ```
    #[must_use]
    pub fn with_progress(mut self, told: impl Fn(usize) + Send + Sync + 'static) -> Self {
        self.progress = Progress(Some(Arc::new(told)));
        self
    }

    /// Number of pairs of different rows, `n(n − 1)/2`.
    #[must_use]
    pub fn pairs(&self) -> usize {
        let n = self.patches();
        n * (n - 1) / 2
    }
}
