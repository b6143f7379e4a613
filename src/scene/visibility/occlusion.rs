//! The policy for scenes in which something stands between two patches.
//!
//! Every question about what patches exchange checks the scene first:
//!
//! ```text
//!   patches overlap                       refused always: what falls on one would count twice
//!   something may stand between patches   computed past it; or refused, or left out on request
//! ```
//!
//! What needs the closed forms of pairs that see each other fully (continuous mutual information,
//! enclosures, derivatives) refuses. A room that is convex inside is settled by its planes (see
//! [`Blockers`]).
//!
//! **Not covered**: the pairs themselves ([`Blockers`]).

use crate::scene::{Blocker, Blockers, Scene, SceneError};

/// A policy for scenes in which something may stand between two patches.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
#[non_exhaustive]
pub enum Occlusion {
    /// Computes what is left of each pair past all that stands in its way.
    #[default]
    Exact,
    /// Refuses the scene, and names the pair and the obstacle
    /// ([`SceneError::MayBeBlocked`]).
    Refuse,
    /// Computes as if nothing were in the way.
    Ignore,
}

/// Most pairs of rows for which every surface is looked at, rather than put in trees.
const MOST_SCANNED: usize = 16;

/// Tells whether some rows have so few pairs with some others that every surface may be looked at.
pub(crate) const fn are_few(rows: &[usize], others: &[usize]) -> bool {
    rows.len() * others.len() <= MOST_SCANNED
}

impl Occlusion {
    /// Checks all pairs of a scene's patches under this policy.
    ///
    /// # Errors
    /// [`SceneError::Overlap`] under any policy; [`SceneError::MayBeBlocked`] where occlusion is
    /// refused.
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::{Occlusion, Scene};
    /// assert_eq!(Occlusion::Refuse.check(&Scene::built_in("cube:4")?), Ok(()));
    /// # Ok::<(), infoscene::scene::SceneError>(())
    /// ```
    pub fn check(self, scene: &Scene) -> Result<(), SceneError> {
        scene.check_overlap()?;
        self.refuse(scene, |scene| scene.blocker())
    }

    /// Checks some rows with some others, or with all; patches that are in neither may overlap or
    /// hide each other.
    pub(crate) fn check_rows(
        self,
        scene: &Scene,
        rows: &[usize],
        others: Option<&[usize]>,
    ) -> Result<(), SceneError> {
        let few = others.filter(|others| are_few(rows, others));
        match few {
            None => scene.check_overlap()?,
            Some(others) => {
                let ends = [rows, others].into_iter();
                for patch in ends.flat_map(|rows| scene.patches_of_groups(rows)) {
                    scene.check_overlap_of(patch)?;
                }
            }
        }
        self.refuse(scene, |scene| {
            let blockers = match few {
                None => Blockers::of(scene),
                Some(_) => Blockers::for_few(scene),
            };
            let mut patches = scene.patches_of_groups(rows);
            patches.find_map(|patch| match others {
                None => blockers.of_row(patch),
                Some(others) => {
                    let mut seconds = scene.patches_of_groups(others);
                    seconds.find_map(|second| blockers.of_pair(patch, second))
                }
            })
        })
    }

    /// Refuses what is found, if occlusion is refused.
    fn refuse(
        self,
        scene: &Scene,
        find: impl Fn(&Scene) -> Option<Blocker>,
    ) -> Result<(), SceneError> {
        match self {
            Self::Refuse => scene.refuse_blocker(find),
            Self::Exact | Self::Ignore => Ok(()),
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
        self.refuse(scene, |scene| {
            let blockers = Blockers::of(scene);
            let mut others = others.iter();
            others.find_map(|other| blockers.of_pair(patch, *other))
        })
    }
}
