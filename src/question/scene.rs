//! The scene that a question is about.

use crate::exchange::{
    Congruence, ExchangeError, IgnoredOcclusion, Progress, ScenePairs, Tolerance,
};
use crate::scene::files::{LoadedScene, NonPlanarFaces, OpenError, Reading, open};
use crate::scene::{Occlusion, Scene};

/// The remark on a scene that exchanges nothing as all its fronts are outside.
pub const TURNED_AWAY: &str =
    "all patches face away from each other and exchange nothing: were their fronts to be reversed?";

/// The remark on occlusion that was ignored, if some was.
pub(super) fn ignored_note(ignored: Option<IgnoredOcclusion>) -> Option<String> {
    let IgnoredOcclusion {
        pairs,
        exchange_area,
    } = ignored.filter(|ignored| ignored.pairs > 0)?;
    Some(format!(
        "something stands between {pairs} pairs of patches and is ignored: exchange areas are too \
         large by up to {exchange_area:.3e} in all"
    ))
}

/// A scene that a question is about, and how it is prepared.
///
/// # Examples
/// ```
/// use infoscene::question::SceneSource;
/// let cube = SceneSource { subdivide: 1, ..SceneSource::from("cube:1") };
/// // six faces, each cut into four
/// assert_eq!(cube.open()?.scene.patches().len(), 24);
/// # Ok::<(), infoscene::scene::files::OpenError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SceneSource {
    /// The origin of the scene.
    pub origin: SceneOrigin,
    /// The treatment of faces of a file that are not planar.
    pub faces: NonPlanarFaces,
    /// The length by which each coordinate may be off, 0 for none; if it is not given, the decimals
    /// of a file say it ([`Scene::resolution`]).
    pub resolution: Option<f64>,
    /// Whether neighbours in one plane are joined ([`Scene::joined`]).
    pub join: bool,
    /// Whether the front of every patch is turned to its other side.
    pub reverse: bool,
    /// The number of times that every patch is quartered.
    pub subdivide: u32,
    /// The policy for scenes in which something may stand between two patches.
    pub occlusion: Occlusion,
}

/// The place that a scene comes from.
#[derive(Debug, Clone, PartialEq)]
pub enum SceneOrigin {
    /// The name of a built-in scene, or the path of a file.
    Named(String),
    /// A scene that was made in the program.
    Made(Box<Scene>),
}

impl SceneSource {
    fn new(origin: SceneOrigin) -> Self {
        Self {
            origin,
            faces: NonPlanarFaces::default(),
            resolution: None,
            join: false,
            reverse: false,
            subdivide: 0,
            occlusion: Occlusion::default(),
        }
    }

    /// The scene, whatever lies or stands in it, and what its reader has to say.
    ///
    /// # Errors
    /// [`OpenError::Scene`] if the name is neither a built-in scene nor a path, or if a patch
    /// cannot be quartered; [`OpenError::File`] if the file is at fault.
    pub fn open(&self) -> Result<LoadedScene, OpenError> {
        let reading = Reading {
            faces: self.faces,
            resolution: self.resolution,
        };
        let mut loaded = match &self.origin {
            SceneOrigin::Named(name) => open(name, reading)?,
            SceneOrigin::Made(scene) => {
                let scene = Scene::clone(scene);
                LoadedScene {
                    scene: match self.resolution {
                        Some(resolution) => scene.with_resolution(resolution)?,
                        None => scene,
                    },
                    notes: Vec::new(),
                }
            }
        };
        if self.join {
            let before = loaded.scene.patches().len();
            (loaded.scene, _) = loaded.scene.joined()?;
            let after = loaded.scene.patches().len();
            let note =
                format!("{before} patches are joined with neighbours in their planes: {after}");
            loaded.notes.push(note);
        }
        if self.reverse {
            loaded.scene = loaded.scene.reversed();
        }
        if loaded.scene.is_turned_away() {
            loaded.notes.push(TURNED_AWAY.to_owned());
        }
        if self.subdivide > 0 {
            (loaded.scene, _) = loaded.scene.subdivided(self.subdivide)?;
        }
        Ok(loaded)
    }

    /// The pairs of a scene under the policy of this source; their passes tell a listener.
    pub(super) fn pairs<'p>(
        &self,
        scene: &Scene,
        asked: (Tolerance, Congruence),
        progress: &'p dyn Progress,
    ) -> Result<ScenePairs<'p>, ExchangeError> {
        pairs(scene, self.occlusion, asked, progress)
    }
}

/// The pairs of a scene; their passes tell a listener.
pub(super) fn pairs<'p>(
    scene: &Scene,
    occlusion: Occlusion,
    (tolerance, congruence): (Tolerance, Congruence),
    progress: &'p dyn Progress,
) -> Result<ScenePairs<'p>, ExchangeError> {
    let rows = scene.group_count() as u64;
    progress.begin(rows * (rows - 1) / 2, "pairs");
    let pairs = ScenePairs::try_new(scene, tolerance, congruence, occlusion)?;
    Ok(pairs.with_progress(progress))
}

impl Default for SceneSource {
    /// The empty name, which no scene has.
    fn default() -> Self {
        Self::from("")
    }
}

impl From<&str> for SceneSource {
    fn from(name: &str) -> Self {
        Self::from(name.to_owned())
    }
}

impl From<String> for SceneSource {
    fn from(name: String) -> Self {
        Self::new(SceneOrigin::Named(name))
    }
}

impl From<Scene> for SceneSource {
    fn from(scene: Scene) -> Self {
        Self::new(SceneOrigin::Made(Box::new(scene)))
    }
}
