//! The rows of a scene as they are seen from points, past all that stands in the way.
//!
//! ```text
//!   F_xg = Σ_i (F_xi − Σ_p F_xp)          i: the patches of row g,  p: the parts in patch i
//!   1 = Σ_g F_xg + backs + sky            backs: back sides of patches and obstructions
//! ```
//!
//! Fronts of patches receive; every surface hides from both sides. What a point does not see of
//! patches is *unseen*: it sees back sides and obstructions there, or nothing at all. A surface
//! within [`Scene::noise_length`] of a point or of another's plane counts as touching it.
//!
//! **Not covered**: what the resolution of coordinates can change beside the errors.

use super::ExchangeError;
use crate::form_factor::{ExchangeArea, FormFactorError, Polygon, Sight, Viewpoint};
use crate::numeric::{CompensatedSum, try_parallel_map};
use crate::scene::{NamedPatch, Occlusion, Scene, SceneError};
use glam::DVec3;

/// The surfaces of a scene, made ready to be seen from points.
#[derive(Debug)]
pub struct ScenePoints<'s> {
    scene: &'s Scene,
    /// Patches, then obstructions.
    surfaces: Vec<Polygon>,
    /// The screens that the surfaces make up, which hide; none if that is ignored.
    screens: Vec<Polygon>,
    occlusion: Occlusion,
}

/// The rows as a point sees them.
#[derive(Debug, Clone, PartialEq)]
pub struct PointRow {
    /// The form factor to each row, in `[0, 1]`, with a bound on its error.
    pub form_factors: Vec<ExchangeArea>,
    /// The rest to one, with a bound on its error; none where occlusion is ignored, which counts
    /// what is behind something else, too.
    pub unseen: Option<ExchangeArea>,
    /// The part of `unseen` that sees back sides of patches, or obstructions.
    pub backs: Option<ExchangeArea>,
}

impl<'s> ScenePoints<'s> {
    /// The surfaces of a scene, which hide each other unless occlusion is ignored.
    ///
    /// # Errors
    /// [`SceneError::Overlap`].
    ///
    /// # Examples
    /// ```
    /// use glam::DVec3;
    /// use infoscene::exchange::{ScenePoints, Unheard};
    /// use infoscene::scene::{Occlusion, Scene};
    /// // the middle of a cube's floor sees the cube, and nothing else
    /// let cube = Scene::built_in("cube:1")?;
    /// let points = ScenePoints::try_new(&cube, Occlusion::Refuse)?;
    /// let rows = points.seen_from(&[(DVec3::new(0.5, 0.5, 0.0), DVec3::Z)], &Unheard)?;
    /// let unseen = rows[0].unseen.expect("a scene with its occlusion");
    /// assert!(unseen.value.abs() <= unseen.error && unseen.error < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn try_new(scene: &'s Scene, occlusion: Occlusion) -> Result<Self, SceneError> {
        scene.check_overlap()?;
        let polygon = |surface: &NamedPatch| Polygon::new(surface.shape());
        let screen = |index| Polygon::new(&scene.screens().screen(index).shape);
        let screens = match occlusion {
            Occlusion::Ignore => 0,
            _ => scene.screens().count(),
        };
        Ok(Self {
            scene,
            surfaces: scene.surfaces().map(polygon).collect(),
            screens: (0..screens).map(screen).collect(),
            occlusion,
        })
    }

    /// The rows as they are seen from points of surfaces with these unit normals; the same for any
    /// number of threads.
    ///
    /// # Errors
    /// [`ExchangeError::Point`] with the first point that is refused.
    pub fn seen_from(
        &self,
        points: &[(DVec3, DVec3)],
        progress: &dyn super::Progress,
    ) -> Result<Vec<PointRow>, ExchangeError> {
        progress.begin(points.len() as u64, "points");
        try_parallel_map(points.len(), &|index| {
            let row = self.row(points[index]);
            progress.advance(1);
            row.map_err(|source| ExchangeError::Point { index, source })
        })
    }

    fn row(&self, (point, normal): (DVec3, DVec3)) -> Result<PointRow, FormFactorError> {
        let view = Viewpoint::try_new(point, normal, self.scene.noise_length())?;
        let sights = self.surfaces.iter().map(|polygon| view.sight(polygon));
        let sights = sights.collect::<Result<Vec<_>, _>>()?;
        let is_hiding = self.occlusion != Occlusion::Ignore;
        let hiding = self.screens.iter().map(|screen| view.sight(screen));
        let hiding = hiding.collect::<Result<Vec<Sight>, _>>()?;
        let patches = self.scene.patches().len();
        let mut rows = vec![Sum::default(); self.scene.group_count()];
        let (mut unseen, mut backs) = (Sum::default(), Sum::default());
        unseen.add(1.0, WHOLE);
        for (index, sight) in sights.iter().enumerate() {
            let is_patch = index < patches;
            if is_patch && sight.is_front() {
                let part = view.form_factor(sight, hiding.iter());
                rows[self.scene.group_of(index)].add(1.0, part);
                match self.scene.base_of(index) {
                    Some(base) => rows[self.scene.group_of(base)].add(-1.0, part),
                    None => unseen.add(-1.0, part),
                }
            } else if is_hiding && !(is_patch && self.scene.base_of(index).is_some()) {
                let part = view.visible(sight, hiding.iter());
                backs.add(1.0, part);
            }
        }
        Ok(PointRow {
            form_factors: rows.iter().map(Sum::total).collect(),
            unseen: is_hiding.then(|| unseen.total()),
            backs: is_hiding.then(|| backs.total()),
        })
    }
}

/// All that leaves a point.
const WHOLE: ExchangeArea = ExchangeArea {
    value: 1.0,
    error: 0.0,
};

/// A sum of form factors.
#[derive(Debug, Clone, Copy, Default)]
struct Sum {
    value: CompensatedSum,
    error: f64,
}

impl Sum {
    fn add(&mut self, sign: f64, part: ExchangeArea) {
        self.value.add(sign * part.value);
        self.error += part.error;
    }

    /// The sum, at least 0, which a difference may miss by no more than its error.
    fn total(&self) -> ExchangeArea {
        let value = self.value.total();
        ExchangeArea {
            value: value.clamp(0.0, 1.0),
            error: self.error + f64::EPSILON * value.abs(),
        }
    }
}
