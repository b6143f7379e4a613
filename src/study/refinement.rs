//! Corollary 1, measured: discrete mutual information along nested refinements, and its gap to the
//! continuous one.
//!
//! ```text
//!   I^c − I = c h + o(h),      h the size of the patches
//! ```
//!
//! The order is first because, near an edge at which two faces meet, F is homogeneous of degree −2
//! in the distances s from the edge, and varies within a patch by a part h/s of itself. The pairs
//! at distances s to 2s, the same from all patches along the edge, carry a flux ~ s per length;
//! what they lose is its square's part, s (h/s)², and the sum over s = h, 2h, 4h, … is led by s =
//! h: O(h) for a unit of edge. Pairs that do not touch lose O(h²), those around a vertex O(h²) up
//! to a logarithm. So
//!
//! ```text
//!   c h = (1/A_T) Σ_e L_e h κ(angle at edge e, shape of the patches along it)
//! ```
//!
//! with κ the larger the sharper the angle; a solid without edges has no first order.
//!
//! This is an argument, not a proof; the table measures it: quartering every patch halves the gap,
//! `2 I(h/2) − I(h)` is nearer to `I^c` by an order, and κ is the same for rooms of the same angles
//! and patches, whatever their shape (`rate_depends_on_the_edges_alone`).
//!
//! **Not covered**: refinements that are finer at the edges, which the argument says are the better
//! ones.

use super::StudyError;
use crate::exchange::{Congruence, ScenePairs};
use crate::form_factor::DEFAULT_TOLERANCE;
use crate::information::{OpenScene, continuous_information, scene_information};
use crate::scene::{Occlusion, Scene};
use std::time::Instant;

/// One refinement of one scene.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct RefinementRow {
    /// The scene, and how often its patches were quartered.
    pub case: String,
    /// The scene.
    pub scene: String,
    /// Number of quarterings.
    pub times: u32,
    /// Number of patches.
    pub patches: usize,
    /// Discrete mutual information, in bits.
    pub mutual_information: f64,
    /// Bound on its error.
    pub error: f64,
    /// Continuous mutual information, in bits.
    pub continuous_mutual_information: f64,
    /// Estimated error of it.
    pub continuous_error: f64,
    /// The gap between the two.
    pub gap: f64,
    /// The gap before, over this one.
    pub ratio: Option<f64>,
    /// `I^c − (2 I − I before)`: what the extrapolated value lacks.
    pub extrapolated_gap: Option<f64>,
    /// `gap · A_T/(Σ L_e √(A_T/n))` for n patches and edges of length `L_e`: on the way to the mean
    /// of κ, in bits.
    pub gap_per_edge: f64,
    /// Time of the discrete one, in seconds.
    pub seconds: f64,
}

/// The scenes, and how many patches they are refined to at most; rectangles share pairs.
const SCENES: [(&str, usize); 8] = [
    ("tetrahedron", 1024),
    ("cube:1", 6144),
    ("octahedron", 512),
    ("dodecahedron", 960),
    ("icosahedron", 320),
    ("box:1,1,2", 6144),
    ("box:1,1,10", 6144),
    ("box:1,1,0.1", 6144),
];

/// `A_T/(Σ L_e √(A_T/n))` of a convex room whose faces are divided into n patches.
///
/// # Errors
/// [`StudyError::Scene`] if the room is not convex.
#[allow(clippy::cast_precision_loss, reason = "some thousand patches")]
pub fn patch_sizes_per_edge(scene: &Scene) -> Result<f64, StudyError> {
    let (faces, _) = scene.convex_room()?;
    let sides = faces.iter().flat_map(|face| {
        let corners = face.corners();
        let next = corners.iter().cycle().skip(1);
        corners.iter().zip(next).map(|(a, b)| a.distance(*b))
    });
    // two faces meet at an edge
    let edges = 0.5 * sides.sum::<f64>();
    Ok((scene.total_area() * scene.patches().len() as f64).sqrt() / edges)
}

/// Each scene, refined again and again.
///
/// **Arguments** `quick`: up to a few hundred patches.
///
/// # Errors
/// [`StudyError`] if a scene is refused; none is known to be.
pub fn refinements(quick: bool) -> Result<Vec<RefinementRow>, StudyError> {
    let mut rows: Vec<RefinementRow> = Vec::new();
    for (name, most) in SCENES {
        let most = if quick { most.min(100) } else { most };
        let whole = Scene::built_in(name)?;
        let continuous = continuous_information(&whole)?.mutual_information;
        let limit = continuous.value;
        for times in 0.. {
            let (scene, _) = whole.subdivided(times)?;
            if scene.patches().len() > most {
                break;
            }
            let start = Instant::now();
            let pairs = ScenePairs::try_new(
                &scene,
                DEFAULT_TOLERANCE,
                Congruence::Shared,
                Occlusion::Refuse,
            )?;
            let discrete = scene_information(&pairs, OpenScene::Refuse)?.mutual_information;
            let seconds = start.elapsed().as_secs_f64();
            let information = discrete.value;
            let before = rows.last().filter(|row| row.scene == name);
            let gap = limit - information;
            rows.push(RefinementRow {
                case: format!("{name}, {times}"),
                scene: name.to_owned(),
                times,
                patches: scene.patches().len(),
                mutual_information: information,
                error: discrete.error,
                continuous_mutual_information: limit,
                continuous_error: continuous.error,
                gap,
                ratio: before.map(|row| row.gap / gap),
                extrapolated_gap: before.map(|row| 2.0 * gap - row.gap),
                gap_per_edge: gap * patch_sizes_per_edge(&scene)?,
                seconds,
            });
        }
    }
    Ok(rows)
}
