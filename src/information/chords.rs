//! Continuous mutual information (4) of any closed scene, from random chords.
//!
//! ```text
//!   I^c = E[ log2(A_T cos θ cos θ' / (π r²)) ]     over chords from uniform points of all patches, directions by cosine
//! ```
//!
//! These are the chords that uniform lines cut out. What a chord first meets ends it, so scenes may be concave and occluded; their
//! light must not escape. The summand is bounded above where patches do not touch, and has moments of all orders
//! where they do: its upper tail is exponential, `P(I > t) ~ 2^−t` at a common edge.
//!
//! **Errors** the standard error of the mean: evidence by *sample*.
//!
//! **Not covered**: speed beyond some thousand patches (each line looks at all).

use crate::chain::ChainError;
use crate::geometry::triangulated;
use crate::numeric::tolerance;
use crate::scene::{NamedPatch, Scene, SceneError};
use glam::DVec3;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::{LN_2, PI, TAU};

/// An estimate by random chords.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChordInformation {
    /// Continuous mutual information, in bits, estimated.
    pub mutual_information: f64,
    /// Standard error of it.
    pub standard_error: f64,
    /// Lines drawn.
    pub lines: u32,
}

/// A triangle of a patch or an obstruction.
struct Triangle {
    corners: [DVec3; 3],
    normal: DVec3,
    surface: usize,
    is_patch: bool,
}

impl Triangle {
    /// The distance at which the line meets the triangle, if it does.
    fn hit(&self, origin: DVec3, direction: DVec3) -> Option<f64> {
        let slope = self.normal.dot(direction);
        let distance = self.normal.dot(self.corners[0] - origin) / slope;
        if !(distance > 0.0 && distance.is_finite()) {
            return None;
        }
        // the line passes all three edges on one side: the same numbers for neighbours, so that none slips between
        let [a, b, c] = self.corners.map(|corner| corner - origin);
        let sides = [(a, b), (b, c), (c, a)].map(|(p, q)| side(p, q, direction));
        let is_inside = sides.iter().all(|s| *s >= 0.0) || sides.iter().all(|s| *s <= 0.0);
        is_inside.then_some(distance)
    }
}

/// On which side of the edge from p to q a line from the origin passes; exactly the negative from q to p.
fn side(p: DVec3, q: DVec3, direction: DVec3) -> f64 {
    let is_first = p.to_array() <= q.to_array();
    if is_first {
        p.cross(q).dot(direction)
    } else {
        -q.cross(p).dot(direction)
    }
}

/// Continuous mutual information of a closed scene by random chords, that may be concave and occluded.
///
/// **Arguments** `lines`: how many, at least 2; fewer count as 2. `seed`: the same one gives the same estimate.
///
/// # Errors
/// [`ChainError::Scene`] with [`SceneError::LinesEscape`] if more than a millionth of the lines meet no front of a patch.
///
/// # Examples
/// ```
/// use infoscene::{information::chord_information, scene::Scene};
/// let cube = chord_information(&Scene::built_in("cube:1")?, 10_000, 1)?;
/// assert!((cube.mutual_information - 1.610_473_346_468_78).abs() < 5.0 * cube.standard_error);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn chord_information(
    scene: &Scene,
    lines: u32,
    seed: u64,
) -> Result<ChordInformation, ChainError> {
    let lines = lines.max(2);
    // a part lies in its base, which carries it
    let is_whole = |(index, _): &(usize, &NamedPatch)| scene.base_of(*index).is_none();
    let patches = scene
        .patches()
        .iter()
        .enumerate()
        .filter(is_whole)
        .map(|(_, patch)| (patch, true));
    let surfaces = patches.chain(scene.obstructions().iter().map(|patch| (patch, false)));
    let mut triangles = Vec::new();
    for (surface, (patch, is_patch)) in surfaces.enumerate() {
        let (corners, normal) = (patch.shape().corners(), patch.shape().normal());
        let parts = triangulated(corners, normal)
            .into_iter()
            .map(|part| Triangle {
                corners: part.map(|corner| corners[corner]),
                normal,
                surface,
                is_patch,
            });
        triangles.extend(parts);
    }
    let mut total = 0.0;
    let mut cumulated = Vec::new();
    for triangle in triangles.iter().filter(|triangle| triangle.is_patch) {
        let [a, b, c] = triangle.corners;
        total += 0.5 * (b - a).cross(c - a).length();
        cumulated.push(total);
    }
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let (mut mean, mut squares, mut count, mut lost) = (0.0, 0.0, 0.0, 0);
    for _ in 0..lines {
        let [place, s, t, u, v]: [f64; 5] = random.random();
        let start = cumulated.partition_point(|area| *area <= place * total);
        let from = &triangles[start.min(cumulated.len() - 1)];
        let [a, b, c] = from.corners;
        let root = s.sqrt();
        let origin = a + root * (1.0 - t) * (b - a) + root * t * (c - a);
        let across = from.normal.any_orthonormal_vector();
        let up = from.normal.cross(across);
        let (sine, cosine) = (u.sqrt(), (1.0 - u).sqrt());
        let (y, x) = (TAU * v).sin_cos();
        let direction = sine * (x * across + y * up) + cosine * from.normal;
        let others = triangles
            .iter()
            .filter(|triangle| triangle.surface != from.surface);
        // of two faces of a thin wall the one that is met is the one in front
        let hits = others.filter_map(|triangle| {
            let distance = triangle.hit(origin, direction)?;
            let is_front = triangle.is_patch && triangle.normal.dot(direction) < 0.0;
            let rank = if is_front {
                distance
            } else {
                distance * (1.0 + tolerance::PLANARITY)
            };
            Some((rank, distance, triangle))
        });
        let nearest = hits.min_by(|a, b| a.0.total_cmp(&b.0));
        let nearest = nearest.map(|(_, distance, triangle)| (distance, triangle));
        let met = nearest.filter(|(_, triangle)| triangle.is_patch);
        let met = met.map(|(distance, triangle)| (distance, -triangle.normal.dot(direction)));
        match met {
            Some((distance, other)) if other > 0.0 && cosine > 0.0 => {
                let value = (total / (PI * distance) * cosine * other / distance).ln();
                count += 1.0;
                let step = value - mean;
                mean += step / count;
                squares += step * (value - mean);
            }
            _ => lost += 1,
        }
    }
    if lost > lines / 1_000_000 {
        return Err(SceneError::LinesEscape { lost, lines }.into());
    }
    Ok(ChordInformation {
        mutual_information: mean / LN_2,
        standard_error: (squares / (count * (count - 1.0))).sqrt() / LN_2,
        lines,
    })
}
