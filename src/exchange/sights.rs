//! The lines of sight between the polygons of a scene: past nothing, past some surfaces, or none.
//!
//! ```text
//!   clear    nothing enters the space between two polygons: closed forms, values of congruent pairs
//!   partial  some surfaces do: what they leave, computed past all of them
//!   hidden   one convex body is in the way of every segment: nothing, and no integral
//! ```
//!
//! What is in the way is looked up as a pair is evaluated ([`Blockers`]), so that nothing is held
//! for a pair; the polygons of surfaces that block are prepared when they are first met, once. A
//! part blocks what its base blocks, so only the base counts. In a room that is convex inside there
//! is nothing to look up, and none of this is made.
//!
//! **A base and its parts.** What blocks a part of a base blocks the base, too: the space between
//! the part and another polygon lies in that of the base. So the exchange area of a base less that
//! of its parts is that of the rest, past all that blocks the rest.
//!
//! **Congruent pairs** share a value only if both are clear; past blockers each is computed, though
//! their blockers may be congruent, too.
//!
//! **Not covered**: what touches the space between two polygons up to the noise of the coordinates,
//! which takes nothing away ([`Shaft`](crate::geometry::Shaft)).

use crate::form_factor::Polygon;
use crate::scene::{Blockers, Hiding, Occlusion, Scene};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};

/// The lines of sight between two polygons.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Sight {
    /// Nothing is between them.
    Clear,
    /// Some surfaces are; obstructions are numbered after the patches.
    Past(Vec<usize>),
    /// They see nothing of each other.
    Hidden,
}

/// The search for what stands between the patches of a scene in which something can.
#[derive(Debug, Clone)]
pub(crate) struct Sights(Arc<Parts>);

#[derive(Debug)]
struct Parts {
    scene: Scene,
    /// Whether pairs are evaluated past what is in the way; it is only counted, if not.
    is_exact: bool,
    /// Whether few pairs will be asked for, so that no trees are made.
    is_few: bool,
    /// The polygon of each surface, prepared when it first blocks something.
    polygons: Vec<OnceLock<Polygon>>,
    /// Whether a pair that nothing blocks has taken the value of each class of congruent ones.
    taken: Vec<AtomicBool>,
}

impl Sights {
    /// The lines of sight of a scene under a policy; none if nothing can be in the way, or if it
    /// was checked that nothing is.
    ///
    /// **Arguments** `is_few`: whether few pairs will be asked for; `classes`: number of classes of
    /// congruent pairs.
    pub(crate) fn of(
        scene: &Scene,
        occlusion: Occlusion,
        is_few: bool,
        classes: usize,
    ) -> Option<Self> {
        let is_exact = match occlusion {
            Occlusion::Exact => true,
            Occlusion::Ignore => false,
            Occlusion::Refuse => return None,
        };
        let can_block = is_few || Blockers::of(scene).can_block();
        can_block.then(|| {
            Self(Arc::new(Parts {
                polygons: scene.surfaces().map(|_| OnceLock::new()).collect(),
                taken: (0..classes).map(|_| AtomicBool::new(false)).collect(),
                scene: scene.clone(),
                is_exact,
                is_few,
            }))
        })
    }

    /// Whether pairs are evaluated past what is in the way.
    pub(crate) fn are_exact(&self) -> bool {
        self.0.is_exact
    }

    /// The lines of sight between two patches.
    pub(crate) fn between(&self, first: usize, second: usize) -> Sight {
        if !self.0.is_few && Hiding::of(&self.0.scene).hides(first, second) {
            return Sight::Hidden;
        }
        let surfaces = self.blockers().whole_surfaces_between(first, second);
        let surfaces: Vec<usize> = surfaces.collect();
        if surfaces.is_empty() {
            Sight::Clear
        } else {
            Sight::Past(surfaces)
        }
    }

    /// The polygon of a surface.
    pub(crate) fn polygon(&self, surface: usize) -> &Polygon {
        let polygon = || Polygon::new(self.0.scene.surface(surface).shape());
        self.0.polygons[surface].get_or_init(polygon)
    }

    /// The distance up to which surfaces count as touching, in the unit of the scene.
    pub(crate) fn touching(&self) -> f64 {
        self.0.scene.noise_length()
    }

    /// Notes that a pair has taken the value of a class.
    pub(crate) fn take(&self, class: usize) {
        let taken = &self.0.taken[class];
        if !taken.load(Ordering::Relaxed) {
            taken.store(true, Ordering::Relaxed);
        }
    }

    /// Whether a pair has taken the value of a class.
    pub(crate) fn is_taken(&self, class: usize) -> bool {
        self.0.taken[class].load(Ordering::Relaxed)
    }

    fn blockers(&self) -> Blockers<'_> {
        if self.0.is_few {
            Blockers::for_few(&self.0.scene)
        } else {
            Blockers::of(&self.0.scene)
        }
    }
}
