//! The state of a scene: what there is, and what stands in the way of an answer.

use super::QuestionError;
use super::scene::SceneSource;
use crate::geometry;
use crate::numeric::compensated_sum;
use crate::scene::{FreeEdge, Obstacle, Scene};
use glam::DVec3;

/// The question for the state of a scene, before anything is computed of it.
///
/// # Examples
/// ```
/// use infoscene::question::Check;
/// let room = Check { scene: "cube:1".into(), ..Check::default() };
/// let state = room.ask()?;
/// assert_eq!((state.patches, state.free_edges, state.volume), (6, 0, Some(1.0)));
/// # Ok::<(), infoscene::question::QuestionError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Check {
    /// The scene.
    pub scene: SceneSource,
}

/// The state of a scene, as a record.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[non_exhaustive]
pub struct CheckAnswer {
    /// The number of patches.
    pub patches: usize,
    /// The number of rows: patches that are summed count as one.
    pub rows: usize,
    /// The number of surfaces that only obstruct.
    pub obstructions: usize,
    /// The sum of the areas.
    pub total_area: f64,
    /// The smallest coordinates.
    pub low: [f64; 3],
    /// The largest coordinates.
    pub high: [f64; 3],
    /// The number of planes that surfaces lie in.
    pub planes: usize,
    /// The length below which two places count as one.
    pub noise: f64,
    /// The volume inside, where no edge is free: negative where fronts are outside.
    pub volume: Option<f64>,
    /// The number of stretches of edges that no other patch shares.
    pub free_edges: usize,
    /// The length of free edges in all.
    pub free_length: f64,
    /// The longest free edges, at most [`Check::MOST_LISTED`].
    pub longest_free_edges: Vec<FreeEdgeRecord>,
    /// Whether all patches face away from each other.
    pub turned_away: bool,
    /// The number of neighbours whose fronts disagree.
    pub turned_neighbours: usize,
    /// The first of them, at most [`Check::MOST_LISTED`].
    pub first_turned_neighbours: Vec<[PatchMark; 2]>,
    /// The first two patches that lie on each other.
    pub overlap: Option<[PatchMark; 2]>,
    /// The first two patches between which something stands, and what does.
    pub blocked: Option<BlockedRecord>,
    /// Remarks of the scene's reader.
    #[serde(skip)]
    pub notes: Vec<String>,
}

/// A patch by index and name.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize)]
pub struct PatchMark {
    /// The index of the row.
    pub index: usize,
    /// The name of the patch.
    pub name: String,
}

/// A stretch of an edge that no other patch shares.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct FreeEdgeRecord {
    /// The patch.
    pub patch: PatchMark,
    /// One end.
    pub from: [f64; 3],
    /// The other end.
    pub to: [f64; 3],
    /// The length.
    pub length: f64,
}

/// Two patches between which something stands.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize)]
pub struct BlockedRecord {
    /// The two patches.
    pub patches: [PatchMark; 2],
    /// The name of the surface that stands between.
    pub by: String,
    /// Whether that surface only obstructs.
    pub by_obstruction: bool,
}

impl Check {
    /// The number of edges and neighbours that are listed.
    pub const MOST_LISTED: usize = 10;

    /// Looks at the scene. Nothing is refused but a file that is no scene.
    ///
    /// # Errors
    /// The errors of the scene's origin.
    pub fn ask(&self) -> Result<CheckAnswer, QuestionError> {
        let loaded = self.scene.open()?;
        let scene = loaded.scene;
        let mark = |patch: usize| PatchMark {
            index: scene.group_of(patch),
            name: scene.patches()[patch].name().to_owned(),
        };
        let joints = scene.joints();
        let [low, high] = bounds(&scene);
        let mut longest = joints.free.clone();
        longest.sort_by(|one, other| other.length().total_cmp(&one.length()));
        longest.truncate(Self::MOST_LISTED);
        let listed_turned = joints.turned.iter().take(Self::MOST_LISTED);
        Ok(CheckAnswer {
            patches: scene.patches().len(),
            rows: scene.group_count(),
            obstructions: scene.obstructions().len(),
            total_area: scene.total_area(),
            low: low.to_array(),
            high: high.to_array(),
            planes: scene.plane_count(),
            noise: scene.noise_length(),
            volume: joints.free.is_empty().then(|| volume(&scene, low)),
            free_edges: joints.free.len(),
            free_length: compensated_sum(joints.free.iter().map(FreeEdge::length)),
            longest_free_edges: longest
                .iter()
                .map(|edge| FreeEdgeRecord {
                    patch: mark(edge.patch),
                    from: edge.ends[0].to_array(),
                    to: edge.ends[1].to_array(),
                    length: edge.length(),
                })
                .collect(),
            turned_away: scene.is_turned_away(),
            turned_neighbours: joints.turned.len(),
            first_turned_neighbours: listed_turned.map(|pair| pair.map(mark)).collect(),
            overlap: scene.overlap().map(|(one, other)| [one, other].map(mark)),
            blocked: scene.blocker().map(|found| BlockedRecord {
                patches: [found.first, found.second].map(mark),
                by: found.name,
                by_obstruction: matches!(found.obstacle, Obstacle::Obstruction(_)),
            }),
            notes: loaded.notes,
        })
    }
}

/// The smallest and the largest coordinates of patches and obstructions.
fn bounds(scene: &Scene) -> [DVec3; 2] {
    let surfaces = scene.patches().iter().chain(scene.obstructions());
    geometry::bounds(
        surfaces
            .flat_map(|surface| surface.shape().corners())
            .copied(),
    )
}

/// The volume that fronts look into, by the cones from a point to the patches: `⅓ Σ A h`, h the
/// height of the point over a patch's plane.
fn volume(scene: &Scene, apex: DVec3) -> f64 {
    let patches = (0..scene.patches().len()).filter(|patch| scene.base_of(*patch).is_none());
    let cones = patches.map(|patch| {
        let shape = scene.patches()[patch].shape();
        shape.area() * shape.normal().dot(apex - shape.corners()[0])
    });
    cones.sum::<f64>() / 3.0
}
