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

use crate::scene::{Blocker, Blockers, Scene, SceneError};

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
        self.refuse(|| scene.blocker())
    }

    /// Checks some rows with some others, or with all; patches that are in neither may overlap or
    /// hide each other.
    pub(crate) fn check_rows(
        self,
        scene: &Scene,
        rows: &[usize],
        others: Option<&[usize]>,
    ) -> Result<(), SceneError> {
        let Some(others) = others else {
            scene.check_overlap()?;
            return self.refuse(|| {
                let blockers = Blockers::of(scene);
                let mut patches = scene.patches_of_groups(rows);
                patches.find_map(|patch| blockers.of_row(patch))
            });
        };
        let ends = scene
            .patches_of_groups(rows)
            .chain(scene.patches_of_groups(others));
        for patch in ends {
            scene.check_overlap_of(patch)?;
        }
        self.refuse(|| {
            let blockers = Blockers::of(scene);
            let mut patches = scene.patches_of_groups(rows);
            patches.find_map(|patch| {
                let mut seconds = scene.patches_of_groups(others);
                seconds.find_map(|second| blockers.of_pair(patch, second))
            })
        })
    }

    /// Refuses what is found, unless occlusion is ignored.
    fn refuse(self, find: impl FnOnce() -> Option<Blocker>) -> Result<(), SceneError> {
        let found = match self {
            Self::Refuse => find(),
            Self::Ignore => None,
        };
        found.map_or(Ok(()), |found| Err(found.into()))
    }

    /// Checks one patch with some others, which all exist; others still must not overlap.
    pub(crate) fn check_pairs(
        self,
        scene: &Scene,
        patch: usize,
        others: &[usize],
    ) -> Result<(), SceneError> {
        scene.check_overlap()?;
        self.refuse(|| {
            let blockers = Blockers::of(scene);
            let mut others = others.iter();
            others.find_map(|other| blockers.of_pair(patch, *other))
        })
    }
}
