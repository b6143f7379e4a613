//! The lines of sight between the polygons of a scene: past nothing, past some surfaces, or none.
//!
//! ```text
//!   clear    nothing enters the space between two polygons: closed forms, congruent pairs
//!   partial  some screens do: what they leave, computed past all that a line may meet first
//!   hidden   convex bodies are in the way of every segment: nothing, and no integral
//! ```
//!
//! What is in the way is looked up as a pair is evaluated ([`Screening`]; where few pairs are asked
//! for, [`Blockers`]), so that nothing is held for a pair; the polygons of screens are prepared
//! when they are first met, once. A part blocks what its base blocks, so only the base counts. In a
//! room that is convex inside there is nothing to look up, and none of this is made.
//!
//! **A base and its parts.** What blocks a part of a base blocks the base, too: the space between
//! the part and another polygon lies in that of the base. So the exchange area of a base less that
//! of its parts is that of the rest, past all that blocks the rest.
//!
//! **Congruent pairs** share a value if both are clear (`plan`); past screens, if the screens are
//! congruent, too (`configurations`).
//!
//! **Not covered**: what touches the space between two polygons up to the noise of the coordinates,
//! which takes nothing away ([`Shaft`](crate::geometry::Shaft)).

use super::configurations::Configurations;
use crate::exchange::plan::Congruence;
use crate::form_factor::{Answer, FormFactorError, Occluders, Polygon};
use crate::scene::{Blockers, Occlusion, Scene, Screened, Screening};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};

/// The lines of sight between two polygons.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Sight {
    /// Nothing is between them.
    Clear,
    /// Some screens are, by their numbers.
    Past(Vec<usize>),
    /// The two see nothing of each other.
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
    /// The polygon of each screen, prepared when it first blocks something.
    polygons: Vec<OnceLock<Polygon>>,
    /// The values that congruent pairs past screens share; none if they share nothing.
    configurations: Option<Configurations>,
    /// Whether a pair that nothing blocks has taken the value of each class of congruent ones.
    taken: Vec<AtomicBool>,
}

impl Sights {
    /// The lines of sight of a scene under a policy; none if nothing can be in the way, or if it
    /// was checked that nothing is.
    ///
    /// **Arguments** `is_few`: whether few pairs will be asked for; `congruence`: whether pairs
    /// share values; `classes`: number of classes of congruent pairs.
    pub(crate) fn of(
        scene: &Scene,
        occlusion: Occlusion,
        is_few: bool,
        congruence: Congruence,
        classes: usize,
    ) -> Option<Self> {
        let is_exact = match occlusion {
            Occlusion::Exact => true,
            Occlusion::Ignore => false,
            Occlusion::Refuse => return None,
        };
        let can_block = is_few || Blockers::of(scene).can_block();
        let is_shared = is_exact && !is_few && congruence == Congruence::Shared;
        can_block.then(|| {
            let screens = match is_few {
                true => scene.surfaces().count(),
                false => scene.screens().count(),
            };
            Self(Arc::new(Parts {
                polygons: (0..screens).map(|_| OnceLock::new()).collect(),
                configurations: is_shared.then(|| Configurations::of(scene)),
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
        let scene = &self.0.scene;
        let screened = if self.0.is_few {
            let surfaces = Blockers::for_few(scene).whole_surfaces_between(first, second);
            Screened::By(surfaces.collect())
        } else {
            Screening::of(scene).between(first, second)
        };
        match screened {
            Screened::Wholly => Sight::Hidden,
            Screened::By(screens) if !screens.is_empty() => Sight::Past(screens),
            Screened::By(_) | Screened::Nothing => Sight::Clear,
        }
    }

    /// The exchange area of two patches past some screens.
    pub(crate) fn exchange(
        &self,
        patches: [usize; 2],
        ends: [&Polygon; 2],
        screens: &[usize],
        tolerance: f64,
    ) -> Result<Answer, FormFactorError> {
        // the distance up to which surfaces count as touching, in the unit of the scene
        let touching = self.0.scene.noise_length();
        let shared = self.0.configurations.as_ref();
        let shared = shared.and_then(|all| all.exchange(patches, screens, tolerance, touching));
        if let Some(shared) = shared {
            return shared;
        }
        let polygons: Vec<&Polygon> = screens.iter().map(|s| self.polygon(*s)).collect();
        let occluders = Occluders {
            polygons: &polygons,
            touching,
        };
        ends[0].exchange_area_past(ends[1], &occluders, tolerance)
    }

    /// The polygon of a screen.
    fn polygon(&self, screen: usize) -> &Polygon {
        let scene = &self.0.scene;
        let polygon = || match self.0.is_few {
            true => Polygon::new(scene.surface(screen).shape()),
            false => Polygon::new(&scene.screens().screen(screen).shape),
        };
        self.0.polygons[screen].get_or_init(polygon)
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
}
