//! §5, §6: the oracle at work in hierarchical radiosity.
//!
//! Rooms with a light are refined by oracles to the same number of elements, and judged by a
//! reference on a mesh many times finer:
//!
//! ```text
//!   error = ‖B − B_h‖/‖B‖        over all that is not light, B_h constant on elements
//! ```
//!
//! A few rooms show what an oracle is worth in them; they prove nothing of others. `infoscene study
//! oracles` has more rooms, meshes and oracles.

use crate::claims::{Case, ClaimError, Finding};
use crate::form_factor::{RectanglePair, point_kernel};
use crate::geometry::{Patch, Rectangle, centroid, quartered};
use crate::hierarchy::{
    CutCriterion, Division, Factors, Goal, HierarchyError, Indicator, Lighting, Oracle, OracleName,
    Reference, Refinement, View,
};
use crate::numeric::{larger, rank_correlation, real, smaller};
use crate::scene::{Channel, NamedPatch, Occlusion, Scene};

/// The rooms, empty and convex.
const ROOMS: [&str; 3] = ["lit-cube", "lit-cube-edge", "lit-hall"];
/// The elements of a reference over those of a mesh.
const FINER: usize = 16;
/// The error of ratios of errors: a reference is off by a twentieth of a mesh's error at most, at a
/// right angle to it nearly, as it is finer everywhere.
const CERTAIN: f64 = 0.004;
/// The ratio of errors from which one oracle counts as better than another.
const BETTER: f64 = 1.01;
/// The rank correlation from which one measure counts as an estimate of another.
const CLOSE_RANKS: f64 = 0.95;
/// The difference up to which two measures have the same rank: rounding of shares.
const SAME_SHARE: f64 = 1e-9;
/// The relative difference up to which two errors count as the same.
const SAME_ERROR: f64 = 0.05;

/// The rank correlation, over pairs of patches of a cube, of g = Σ_k |flux share − area share| of
/// four parts with its estimate from the kernel between centres; with `without_cosines` from
/// distances alone.
pub(crate) fn kernels_estimate_the_gradient(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let scene = Scene::built_in(&format!("cube:{}", case.count("cells")?))?;
    let is_flat = case.switch("without_cosines")?;
    let mut measures = Vec::new();
    for receiver in scene.patches() {
        let parts = quartered(receiver.shape()).map_err(ClaimError::from)?;
        let facing = |source: &&NamedPatch| source.shape().normal() != receiver.shape().normal();
        for source in scene.patches().iter().filter(facing) {
            let fluxes = parts.iter().map(|part| {
                let cheap = kernel(part, source.shape(), is_flat)?;
                Ok([exact(part, source.shape())?, cheap])
            });
            let fluxes = fluxes.collect::<Result<Vec<_>, ClaimError>>()?;
            measures.push([0, 1].map(|k| unevenness(fluxes.iter().map(|flux| flux[k]))));
        }
    }
    let ranks = rank_correlation(&measures, SAME_SHARE).unwrap_or_default();
    Ok(Finding::statement(ranks > CLOSE_RANKS, ranks, CERTAIN).sampled())
}

/// The least ratio, over rooms, of the error by the potential `A B H` of elements to the larger of
/// those by the full gain and by the gradient; with `by_itself` to its own.
pub(crate) fn full_gain_beats_potential(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let is_by_itself = case.switch("by_itself")?;
    let ratio = least_ratio(case, |room| {
        let potential = room.error(&Potential, Division::Quarters)?;
        if is_by_itself {
            return Ok(potential / room.error(&Potential, Division::Quarters)?);
        }
        let [gain, gradient] = [OracleName::Information, OracleName::Gradient].map(|name| {
            let oracle = name.oracle(None)?;
            room.error(&*oracle, Division::Quarters)
        });
        Ok(potential / larger(gain?, gradient?))
    })?;
    Ok(Finding::statement(ratio > BETTER, ratio, CERTAIN).sampled())
}

/// The least ratio, over rooms, of the error of a uniform mesh to that by the three steps of the
/// oracle; with `reversed` its ranking is turned round.
pub(crate) fn oracle_beats_uniform_meshes(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let is_reversed = case.switch("reversed")?;
    let ratio = least_ratio(case, |room| {
        let uniform = room.error(&*OracleName::Area.oracle(None)?, Division::Quarters)?;
        let paper = OracleName::Paper.oracle(None)?;
        let refined = if is_reversed {
            room.error(&Reversed(paper), Division::Quarters)?
        } else {
            room.error(&*paper, Division::Quarters)?
        };
        Ok(uniform / refined)
    })?;
    Ok(Finding::statement(ratio > BETTER, ratio, CERTAIN).sampled())
}

/// The largest difference, over rooms, between the errors of meshes that are cut in two where
/// mutual information is highest and where the mean square error is least, relative to the latter;
/// with `quarters` the former are cut in quarters.
pub(crate) fn information_cuts_have_least_error(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let division = if case.switch("quarters")? {
        Division::Quarters
    } else {
        Division::Bisection(CutCriterion::Information)
    };
    let mut most: f64 = 0.0;
    for name in ROOMS {
        let room = Room::new(name, case)?;
        let oracle = OracleName::Gradient.oracle(None)?;
        let least = Division::Bisection(CutCriterion::MeanSquare);
        let ratio = room.error(&*oracle, division)? / room.error(&*oracle, least)?;
        most = larger(most, (ratio - 1.0).abs());
    }
    Ok(Finding::statement(most < SAME_ERROR, most, CERTAIN).sampled())
}

/// A room in its light, with its reference.
struct Room {
    scene: Scene,
    lighting: Lighting,
    elements: usize,
    reference: Option<Reference>,
}

impl Room {
    fn new(name: &str, case: &Case<'_>) -> Result<Self, ClaimError> {
        let scene = Scene::built_in(name)?;
        let elements = case.count("elements")? as usize;
        let lighting = Lighting::of(&scene, Channel::Green)?;
        let mut room = Self {
            scene,
            lighting,
            elements,
            reference: None,
        };
        let oracle = OracleName::Gradient.oracle(None)?;
        let fine = room.refined(&*oracle, Division::Quarters, FINER * elements)?;
        let reference = Reference::new(fine.tree(), fine.lighting(), fine.solution());
        drop(fine);
        room.reference = Some(reference);
        Ok(room)
    }

    fn refined(
        &self,
        oracle: &dyn Oracle,
        division: Division,
        elements: usize,
    ) -> Result<Refinement<'_>, HierarchyError> {
        let light = self.lighting.clone();
        let room = Refinement::try_new(&self.scene, light, Occlusion::Exact, Factors::OfPoints)?;
        let mut room = room.with_division(division);
        room.refine(oracle, Goal::Elements(elements), &mut |_| ())?;
        Ok(room)
    }

    /// The error of the mesh by an oracle.
    fn error(&self, oracle: &dyn Oracle, division: Division) -> Result<f64, ClaimError> {
        let mesh = self.refined(oracle, division, self.elements)?;
        let reference = self.reference.as_ref();
        Ok(reference.map_or(1.0, |known| known.error_of(mesh.tree(), mesh.solution())))
    }
}

/// The least of a ratio over the rooms.
fn least_ratio(
    case: &Case<'_>,
    ratio: impl Fn(&Room) -> Result<f64, ClaimError>,
) -> Result<f64, ClaimError> {
    let ratios = ROOMS.map(|name| ratio(&Room::new(name, case)?));
    ratios
        .into_iter()
        .try_fold(f64::INFINITY, |least, next| Ok(smaller(least, next?)))
}

/// The potential of an element: the sum of `B_i B_j A_i F_ij` over its links.
struct Potential;

impl Indicator for Potential {
    fn priority(&self, view: &View<'_>, leaf: usize) -> Result<f64, HierarchyError> {
        let power = view.element(leaf).shape().area() * view.radiosity(leaf);
        Ok(power * view.solution.received.irradiance[leaf])
    }
}

/// An oracle whose ranking is turned round.
struct Reversed(Box<dyn Oracle>);

impl Oracle for Reversed {
    fn priorities(&self, view: &View<'_>, leaves: &[usize]) -> Result<Vec<f64>, HierarchyError> {
        let priorities = self.0.priorities(view, leaves)?;
        Ok(priorities.into_iter().map(f64::recip).collect())
    }
}

/// `A F` between parts of a cube's faces.
fn exact(part: &Patch, source: &Patch) -> Result<f64, ClaimError> {
    let [part, source] = [Rectangle::try_from(part)?, Rectangle::try_from(source)?];
    Ok(RectanglePair::try_new(&part, &source)?
        .exchange_area()?
        .value)
}

/// The kernel between the centres, times the area of the source.
fn kernel(part: &Patch, source: &Patch, is_flat: bool) -> Result<f64, ClaimError> {
    let ends = [part, source].map(|end| [centroid(end), end.normal()]);
    Ok(if is_flat {
        source.area() / ends[0][0].distance_squared(ends[1][0])
    } else {
        source.area() * point_kernel(ends[0], ends[1])?
    })
}

/// `Σ_k |flux share − 1/n|`.
fn unevenness(fluxes: impl Iterator<Item = f64> + Clone) -> f64 {
    let sum: f64 = fluxes.clone().sum();
    let even = 1.0 / real(fluxes.clone().count());
    fluxes.map(|flux| (flux / sum - even).abs()).sum()
}
