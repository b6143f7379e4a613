//! Error against run time of whole scenes, from loose tolerances to tight ones.
//!
//! ```text
//!   scene   squares turned about an axis that is none of theirs, so that no edge is along an axis
//!   truth   the closed forms of the same squares before the turn
//!   time    of all pairs, preparations included, on one thread, for each pair that sees the other
//! ```
//!
//! The corners of turned squares are rounded, which moves a value by some ε times the distance in
//! sizes: `error` cannot be told from that below some 1e-15. Closed forms and the routes of turned
//! squares have no integrand in common.

use crate::exchange::{Congruence, ExchangeAreas, ExchangeError, ScenePairs};
use crate::form_factor::DEFAULT_TOLERANCE;
use crate::geometry::Patch;
use crate::numeric::real;
use crate::scene::{NamedPatch, Occlusion, Scene};
use crate::study::StudyError;
use glam::{DQuat, DVec3};
use std::time::Instant;

/// One scene at one tolerance.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct ToleranceRow {
    /// The scene.
    pub scene: String,
    /// Whether every pair is computed, or congruent ones share a value.
    pub method: &'static str,
    /// The relative error that is accepted of a form factor.
    pub tolerance: f64,
    /// Pairs whose planes face each other.
    pub pairs: usize,
    /// Pairs whose bound misses the tolerance.
    pub unreached: usize,
    /// The largest |computed − exact| / exact over the pairs.
    pub error: f64,
    /// The median of |computed − exact| / exact.
    pub median_error: f64,
    /// The largest relative bound of a pair.
    pub bound: f64,
    /// The median bound.
    pub median_bound: f64,
    /// Time for a pair, in seconds.
    pub seconds: f64,
}

/// Tolerances from the loosest that anyone asks for to what only some pairs reach.
const TOLERANCES: [f64; 13] = [
    1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14,
];

/// The rows of the study; `is_quick` takes small scenes, every third tolerance, and each time once.
///
/// # Errors
/// [`StudyError`] if a scene is refused; none is known to be.
pub fn tolerances(is_quick: bool) -> Result<Vec<ToleranceRow>, StudyError> {
    let (sizes, step, runs) = if is_quick {
        ([3, 2], 3, 1)
    } else {
        ([10, 40], 1, 5)
    };
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let one = one.map_err(|error| StudyError::Threads(error.to_string()))?;
    let mut rows = Vec::new();
    for TurnedScene {
        name,
        scene,
        turned,
    } in turned_scenes(sizes)?
    {
        let exact = areas(&scene, DEFAULT_TOLERANCE, Congruence::Ignored)?;
        let name = format!("{name}, {} squares", scene.patches().len());
        for (method, congruence) in [
            ("every pair", Congruence::Ignored),
            ("congruent pairs share", Congruence::Shared),
        ] {
            for tolerance in TOLERANCES.into_iter().step_by(step) {
                let timed = || {
                    let start = Instant::now();
                    let found = areas(&turned, tolerance, congruence)?;
                    Ok::<_, StudyError>((found, start.elapsed().as_secs_f64()))
                };
                let (found, mut seconds) = one.install(timed)?;
                for _ in 1..runs {
                    seconds = f64::min(seconds, one.install(timed)?.1);
                }
                let mut row = compared(&found, &exact);
                (row.scene, row.method) = (name.clone(), method);
                (row.tolerance, row.seconds) = (tolerance, seconds / real(row.pairs.max(1)));
                rows.push(row);
            }
        }
    }
    Ok(rows)
}

/// A scene of squares along the axes, and the same one turned.
#[derive(Debug, Clone)]
pub struct TurnedScene {
    /// The name of the turned one.
    pub name: &'static str,
    /// The squares along the axes.
    pub scene: Scene,
    /// The squares turned.
    pub turned: Scene,
}

/// The scenes of the study: the inside of a cube, and a street of boxes.
///
/// **Arguments** cells along an edge of the cube; boxes, of 60 squares each.
///
/// # Errors
/// [`StudyError`] if a scene is refused; none is known to be.
pub fn turned_scenes([cells, boxes]: [u32; 2]) -> Result<[TurnedScene; 2], StudyError> {
    let of = |name, scene: Scene| {
        let turned = turned(&scene)?;
        Ok::<_, StudyError>(TurnedScene {
            name,
            scene,
            turned,
        })
    };
    Ok([
        of("turned cube", Scene::built_in(&format!("cube:{cells}"))?)?,
        of("turned street", named(street(boxes)?)?)?,
    ])
}

/// All pairs of a scene, what stands between them ignored.
fn areas(
    scene: &Scene,
    tolerance: f64,
    congruence: Congruence,
) -> Result<ExchangeAreas, ExchangeError> {
    ScenePairs::try_new(scene, tolerance, congruence, Occlusion::Ignore)?.exchange_areas()
}

/// The errors and bounds of a scene's pairs.
fn compared(found: &ExchangeAreas, exact: &ExchangeAreas) -> ToleranceRow {
    let (mut errors, mut bounds) = (Vec::new(), Vec::new());
    let pairs = (0..found.rows()).flat_map(|i| (0..i).map(move |j| [i, j]));
    for [i, j] in pairs {
        let [found, exact] = [found, exact].map(|areas| areas.get(i, j).exchange);
        if exact.value > 0.0 {
            errors.push((found.value - exact.value).abs() / exact.value);
            bounds.push(found.error / exact.value);
        }
    }
    for list in [&mut errors, &mut bounds] {
        list.sort_by(f64::total_cmp);
    }
    let at = |list: &[f64], place: usize| list.get(place).copied().unwrap_or(0.0);
    let (last, middle) = (errors.len().saturating_sub(1), errors.len() / 2);
    ToleranceRow {
        scene: String::new(),
        method: "",
        tolerance: 0.0,
        pairs: errors.len(),
        unreached: found.summary().unreached,
        error: at(&errors, last),
        median_error: at(&errors, middle),
        bound: at(&bounds, last),
        median_bound: at(&bounds, middle),
        seconds: 0.0,
    }
}

/// The scene turned.
fn turned(scene: &Scene) -> Result<Scene, StudyError> {
    let turn = DQuat::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 0.7);
    let patches = scene.patches().iter().map(|patch| {
        let corners = patch.shape().corners().iter().map(|corner| turn * *corner);
        Patch::try_new(corners.collect())
    });
    named(patches.collect::<Result<_, _>>()?)
}

/// Patches as a scene, named by their numbers.
fn named(patches: Vec<Patch>) -> Result<Scene, StudyError> {
    let patches = patches.into_iter().enumerate();
    let named = patches.map(|(number, patch)| NamedPatch::new(format!("square {number}"), patch));
    Ok(Scene::try_new(named.collect())?)
}

/// The walls of so many boxes on both sides of a street, each of 3 × 5 squares.
fn street(boxes: u32) -> Result<Vec<Patch>, StudyError> {
    let mut patches = Vec::new();
    for number in 0..boxes {
        let (along, side) = (4.0 * f64::from(number / 2), 8.0 * f64::from(number % 2));
        let corner = DVec3::new(along, side, 0.0);
        let (x, y) = (3.0 * DVec3::X, 3.0 * DVec3::Y);
        let ring = [corner, corner + x, corner + x + y, corner + y];
        for wall in 0..4 {
            let (start, step) = (ring[wall], (ring[(wall + 1) % 4] - ring[wall]) / 3.0);
            for (i, k) in (0..3).flat_map(|i| (0..5).map(move |k| (i, k))) {
                let at = |i: i32, k: i32| start + step * f64::from(i) + DVec3::Z * f64::from(k);
                let corners = vec![at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)];
                patches.push(Patch::try_new(corners)?);
            }
        }
    }
    Ok(patches)
}
