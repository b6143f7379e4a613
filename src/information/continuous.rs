//! Continuous mutual information (4) of a closed room that is convex inside.
//!
//! ```text
//!   I^c = (1/A_T) ∫∫ F log2(A_T F) dy dx = Σ_ij I^c_ij
//!   I^c_ij = (1/A_T) [∫∫ F ln(A_T F)]_ij / ln 2
//! ```
//!
//! over pairs of faces; the parts of a pair are [`LogMeans`], so nothing singular is integrated.
//! The result does not depend on the division of the faces into patches. Both end angles of a chord
//! of a closed room are cosine-distributed, `E[ln cos θ] = −½`:
//!
//! ```text
//!   Σ_j C_ij = −A_i/2 for every face i,     so
//!   I^c = log2(A_T/(π e)) − 2 E[log2 r],     E[ln r] = (1/A_T) Σ_ij R_ij
//! ```
//!
//! and the deviation of `Σ_j C_ij + A_i/2` from 0 is part of the error. A sphere has `F = 1/A_T`
//! everywhere and `I^c = 0`.
//!
//! Discrete values rise to the continuous one from below (Corollary 1): the gap tends to c·h for
//! patches of size h, because the pairs along an edge lose what the others do not. For 6,144
//! patches of the cube 0.074 bit are still missing. Per length of edge the gap depends on the angle
//! and the shape of the patches only: 1.24 bits, to 1 %, for all boxes of squares
//! (`infoscene study refinement`). The loss of a single pair
//! ([`pair_losses`](super::pair_losses())) bounds what any subdivision of its patches can gain.
//!
//! **Not covered**: rooms that are open or not convex inside;
//! [`chord_information`](super::chord_information) samples closed ones.

use crate::chain::ChainError;
use crate::exchange::ExchangeError;
use crate::form_factor::{FormFactorError, LogMeans};
use crate::geometry::{GeometryError, Patch, clipped};
use crate::numeric::{Bounded, CompensatedSum, compensated_sum, tolerance, try_parallel_map};
use crate::scene::{Occlusion, Scene};
use glam::DVec3;
use std::f64::consts::LN_2;

/// The contribution of a pair of faces to the continuous mutual information, in both directions
/// together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FacePair {
    /// Index of one face.
    pub first: usize,
    /// Index of the other, larger.
    pub second: usize,
    /// The part of the pair in (4), in bits; may be negative.
    pub mutual_information: f64,
    /// The probability of a transition between the two.
    pub probability: f64,
}

/// The continuous mutual information (4) of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct ContinuousInformation {
    /// The information in bits, ≥ 0 but for rounding; its error is an estimate.
    pub mutual_information: Bounded,
    /// Number of faces.
    pub faces: usize,
    /// The face of each patch.
    pub face_of: Vec<usize>,
    /// All pairs of faces, in order.
    pub pairs: Vec<FacePair>,
}

/// Computes the continuous mutual information (4) of a closed scene that is convex inside.
///
/// | room | I^c, bits |
/// |---|---|
/// | tetrahedron | 2.61945798793 |
/// | cube | 1.61047334647 |
/// | octahedron | 1.25768687805 |
/// | dodecahedron | 0.813520276613 |
/// | icosahedron | 0.542459960968 |
/// | box 1 × 1 × 2 | 1.79699690779 |
/// | box 1 × 1 × 1000 | 9.66487556298 |
/// | box 1 × 1 × 0.001 | 16.4051008577 |
///
/// These are values of `infoscene measure SCENE --continuous`.
///
/// **Accuracy** 1e-12 relative for the regular solids, held by
/// `solids_agree_with_their_cross_sections`; 1e-10 for boxes from 1e-9 to 1e8 times as high as
/// wide, held by `boxes_agree_with_a_formula_of_their_own`; the error returned is an estimate.
///
/// # Errors
/// [`ChainError::Scene`] if the room is not convex inside, an obstruction stands in it (leave it
/// out with [`Scene::with_obstructions`]), or patches overlap; [`ChainError::Exchange`] if it is
/// not closed, or a pair is refused.
///
/// # Examples
/// ```
/// use infoscene::information::continuous_information;
/// use infoscene::scene::Scene;
/// let cube = continuous_information(&Scene::built_in("cube:2")?)?;
/// // from an independent evaluation to 37 digits
/// assert!((cube.mutual_information.value - 1.610_473_346_468_777_7).abs() < 2e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn continuous_information(scene: &Scene) -> Result<ContinuousInformation, ChainError> {
    let (faces, face_of) = scene.convex_room()?;
    Occlusion::Refuse.check(scene)?;
    let first_patch = |face: usize| face_of.iter().position(|of| *of == face).unwrap_or(0);
    let unscaled = faces.iter().map(Patch::area).collect::<Vec<_>>();
    let faces = in_own_unit(faces.iter())
        .map_err(|(face, source)| scene.refused(first_patch(face), source))?;
    let total_area = compensated_sum(faces.iter().map(Patch::area));
    let scale = (total_area / compensated_sum(unscaled.iter().copied())).sqrt();
    let seam = tolerance::RESOLVED_NOISE * scene.resolution() * scale;
    let places: Vec<[usize; 2]> = (0..faces.len())
        .flat_map(|second| (0..second).map(move |first| [first, second]))
        .collect();
    let measured = try_parallel_map(places.len(), &|place| {
        let [first, second] = places[place];
        let pair = [&faces[first], &faces[second]];
        log_means(pair, seam).map_err(|source| ExchangeError::Pair {
            first: first_patch(first),
            second: first_patch(second),
            source,
        })
    })?;
    let mut rows = vec![[CompensatedSum::default(); 3]; faces.len()];
    for ([first, second], pair) in places.iter().zip(&measured) {
        for (face, cosine) in [(*first, pair.cosines[0]), (*second, pair.cosines[1])] {
            let [received, cosines, bound] = &mut rows[face];
            received.add(pair.exchange.value);
            cosines.add(cosine);
            bound.add(pair.exchange.error);
        }
    }
    let unclosed = deviation_from_closure(&rows, &faces, seam, |face| {
        let row = first_patch(face);
        (row, scene.patches()[row].name())
    })?;
    let kernels = measured.iter().map(|pair| pair.kernel(total_area));
    let kernels: Vec<Bounded> = kernels.collect();
    let contributions = places.iter().zip(measured.iter().zip(&kernels)).map(
        |([first, second], (pair, kernel))| FacePair {
            first: *first,
            second: *second,
            mutual_information: 2.0 * kernel.value / (total_area * LN_2),
            probability: 2.0 * pair.exchange.value / total_area,
        },
    );
    let mut pairs: Vec<FacePair> = contributions.collect();
    pairs.sort_by_key(|pair| (pair.first, pair.second));
    let mutual_information = compensated_sum(pairs.iter().map(|pair| pair.mutual_information));
    let estimates = compensated_sum(kernels.iter().map(|kernel| kernel.error));
    let error = 2.0 * (estimates + unclosed) / (total_area * LN_2);
    Ok(ContinuousInformation {
        mutual_information: Bounded::estimate(
            mutual_information,
            error + tolerance::INFORMATION * (1.0 + mutual_information.abs()),
        ),
        faces: faces.len(),
        face_of,
        pairs,
    })
}

/// The sum `Σ_i |Σ_j C_ij + A_i/2|` over the faces, each of which must receive all that it sends.
///
/// **Arguments** `rows`: for each face its exchange areas, its C and the bounds of the first,
/// summed; `seam`: the width of what neighbours may leave open; `first_patch`: the index and the
/// name of a face's first patch.
fn deviation_from_closure<'s>(
    rows: &[[CompensatedSum; 3]],
    faces: &[Patch],
    seam: f64,
    first_patch: impl Fn(usize) -> (usize, &'s str),
) -> Result<f64, ExchangeError> {
    let mut unclosed = 0.0;
    for (face, (row, patch)) in rows.iter().zip(faces).enumerate() {
        let [received, cosines, bound] = row.each_ref().map(CompensatedSum::total);
        let open = seam * patch.perimeter() / patch.area();
        let allowed = bound / patch.area() + tolerance::COVERED + open;
        let sum = received / patch.area();
        if (sum - 1.0).abs() > allowed {
            let (row, name) = first_patch(face);
            return Err(ExchangeError::OpenScene {
                row,
                name: name.to_owned(),
                sum,
                tolerance: allowed,
                resolution_error: 0.0,
            });
        }
        unclosed += (cosines + 0.5 * patch.area()).abs();
    }
    Ok(unclosed)
}

/// The means of two polygons, of which a seam may reach behind the plane of the other.
fn log_means([first, second]: [&Patch; 2], seam: f64) -> Result<LogMeans, FormFactorError> {
    if seam <= 0.0 {
        return LogMeans::of(first, second);
    }
    let in_front = |patch: &Patch, of: &Patch| {
        let heights = patch.corners().iter();
        let heights = heights.map(|corner| of.normal().dot(*corner - of.corners()[0]));
        let heights: Vec<f64> = heights.collect();
        let lowest = heights.iter().copied().fold(0.0, f64::min);
        if lowest >= 0.0 || lowest < -seam {
            return patch.clone();
        }
        let front = clipped(patch.corners(), &heights, DVec3::lerp);
        Patch::within(front, patch.resolution()).unwrap_or_else(|_| patch.clone())
    };
    let [one, other] = [in_front(first, second), in_front(second, first)];
    LogMeans::of(&one, &other)
}

/// Polygons in units of a power of two near the root of their area, so that logarithms are of
/// moderate numbers; or the index of one that is too small, with the reason.
pub(super) fn in_own_unit<'p>(
    polygons: impl Iterator<Item = &'p Patch> + Clone,
) -> Result<Vec<Patch>, (usize, GeometryError)> {
    let total_area = compensated_sum(polygons.clone().map(Patch::area));
    let unit = crate::numeric::power_of_two_near(total_area.sqrt());
    let scaled = polygons.enumerate().map(|(index, polygon)| {
        let corners = polygon.corners().iter().map(|corner| *corner / unit);
        let resolution = polygon.resolution() / unit;
        Patch::within(corners.collect(), resolution).map_err(|source| (index, source))
    });
    scaled.collect()
}
