//! The policy for scenes in which something stands between two patches.
//!
//! Exchange areas are computed as if nothing were in the way, so an occluded scene would get
//! numbers that are too large. Every question about what patches exchange therefore checks the
//! scene first:
//!
//! ```text
//!   patches overlap                       refused always: what falls on one would count twice
//!   something may stand between patches   refused, or left out on request
//! ```
//!
//! A room that is convex inside is settled by its planes (see [`Blockers`]).
//!
//! **Not covered**: computing with occlusion.

use crate::scene::{Blockers, Scene, SceneError};

/// A policy for scenes in which something may stand between two patches.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
#[non_exhaustive]
pub enum Occlusion {
    /// Refuses the scene, and names the pair and the obstacle
    /// ([`SceneError::MayBeBlocked`]).
    #[default]
    Refuse,
    /// Computes as if nothing were in the way.
    Ignore,
}

impl Occlusion {
    /// Checks all pairs of a scene's patches under this policy.
    ///
    /// # Errors
    /// [`SceneError::Overlap`] under either policy; [`SceneError::MayBeBlocked`].
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::{Occlusion, Scene};
    /// assert_eq!(Occlusion::Refuse.check(&Scene::built_in("cube:4")?), Ok(()));
    /// # Ok::<(), infoscene::scene::SceneError>(())
    /// ```
    pub fn check(self, scene: &Scene) -> Result<(), SceneError> {
        scene.check_overlap()?;
        match self {
            Self::Refuse => scene.check_unblocked(),
            Self::Ignore => Ok(()),
        }
    }

    /// Checks one patch with some others, which all exist; others still must not overlap.
    pub(crate) fn check_pairs(
        self,
        scene: &Scene,
        patch: usize,
        others: &[usize],
    ) -> Result<(), SceneError> {
        scene.check_overlap()?;
        if self == Self::Ignore {
            return Ok(());
        }
        let blockers = Blockers::of(scene);
        let mut found = others.iter();
        let found = found.find_map(|other| blockers.of_pair(patch, *other));
        found.map_or(Ok(()), |found| Err(found.into()))
    }
}

impl Scene {
    /// Refuses the scene if something may stand between two rows, or between one row and any other;
    /// without a row all pairs are checked, as [`check_unblocked`](Self::check_unblocked) does.
    ///
    /// It admits the part of an occluded scene that is not hidden: after it
    /// [`ScenePairs::try_new`](crate::exchange::ScenePairs::try_new) may be given
    /// [`Occlusion::Ignore`], and the values between these rows are right.
    ///
    /// # Errors
    /// [`SceneError::NoSuchPatch`] if there is no such row; [`SceneError::MayBeBlocked`].
    pub fn check_rows_unblocked(
        &self,
        from: Option<usize>,
        to: Option<usize>,
    ) -> Result<(), SceneError> {
        let last = self.group_count() - 1;
        for index in [from, to].into_iter().flatten() {
            if index > last {
                return Err(SceneError::NoSuchPatch { index, last });
            }
        }
        let (one, other) = match (from, to) {
            (None, None) => return self.check_unblocked(),
            (Some(one), other) => (one, other),
            (None, Some(one)) => (one, None),
        };
        let blockers = Blockers::of(self);
        let mut patches = self.patches_of_group(one);
        let found = patches.find_map(|first| match other {
            None => blockers.of_row(first),
            Some(other) => self
                .patches_of_group(other)
                .find_map(|second| blockers.of_pair(first, second)),
        });
        found.map_or(Ok(()), |found| Err(found.into()))
    }
}
