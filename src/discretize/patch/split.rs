//! The cut of a patch that gains the most mutual information, eq. (7).
//!
//! ```text
//!   ΔI(t) = (2/A_T) Σ_j [ Σ_k A_k F_kj log2 F_kj − A F_j log2 F_j ]
//! ```
//!
//! over the patches j named, parts k between the cuts `t`. No outside state enters: a scene
//! need not be closed. Under a brightness (§5), radiosity or reflected importance, constant on each
//! patch,
//!
//! ```text
//!   ΔI(t) = (2/Σw) Σ_j B_i B_j [ Σ_k A_k F_kj log2 F_kj − A F_j log2 F_j ]
//! ```
//!
//! The patch is any polygon and so are the others, at any angle; lines run as
//! [`CutLines`](crate::geometry::CutLines) describes, in a parallelogram parallel to an edge. If
//! all are rectangles with edges along common axes, the split is a [`RectangleSplit`] too, and has
//! enclosures and proofs.
//!
//! Where other surfaces stand between, the parts exchange what is left past all that block the
//! whole patch ([`Occlusion`]); such a split has no enclosures. A surface that stands on the patch
//! may cut its light off along a line, where the derivative of the gain jumps.
//!
//! **Not covered**: cuts that are not parallel to each other.

use super::between::Between;
use super::part_exchange;
use super::part_exchange::{PartExchange, SplitWeights};
use super::polygons::{CutPair, CutSurface, PolygonSplit};
use super::rectangles::RectangleSplit;
use crate::discretize::error::DiscretizeError;
use crate::discretize::measure::CutMeasure;
use crate::exchange::{ExchangeError, IgnoredOcclusion};
use crate::geometry::{CutLines, SplitAxis};
use crate::numeric::CertifiedMaximum;
use crate::scene::{Occlusion, Scene};
use glam::DVec3;

/// A patch of a scene, to be cut across one of its axes.
#[derive(Debug, Clone, PartialEq)]
pub struct PatchSplit {
    shapes: Shapes,
    lines: CutLines,
    /// The other patch of each pair.
    others: Vec<usize>,
    /// Increasing positions inside `(0, 1)` at which the derivative of the gain jumps.
    pub(crate) kinks: Vec<f64>,
    ignored: Option<IgnoredOcclusion>,
}

/// The shapes of a split, which decide how its parts are evaluated.
#[derive(Debug, Clone, PartialEq)]
enum Shapes {
    /// Rectangles with edges along common axes.
    Rectangles(RectangleSplit),
    /// Any other shapes.
    Polygons(Box<PolygonSplit>),
}

/// The best cuts of a patch, with their gain.
#[derive(Debug, Clone, PartialEq)]
pub struct SplitOptimum {
    /// Relative positions of the cuts, increasing, in `(0, 1)`.
    pub positions: Vec<f64>,
    /// The gain `ΔI` of these cuts, in bits.
    pub gain: f64,
    /// The largest remaining |∂ΔI/∂t|, in bits.
    pub residual: f64,
}

/// Positions nearer than this are one kink: (a) corners carry some ε, so that planes which meet in
/// one line cross the patch at positions equal up to that, over the sine of their angle to it.
const SAME_KINK: f64 = 1e-12;

impl PatchSplit {
    /// Patch `patch` of `scene`, cut across `axis`, judged by its exchange with the patches
    /// `against`, past all that stands between.
    ///
    /// # Errors
    /// The errors of [`with_occlusion`](Self::with_occlusion).
    pub fn try_new(
        scene: &Scene,
        patch: usize,
        against: &[usize],
        axis: SplitAxis,
    ) -> Result<Self, DiscretizeError> {
        Self::with_occlusion(scene, patch, against, axis, Occlusion::default())
    }

    /// The split of [`try_new`](Self::try_new) under a policy for what may stand between the
    /// patches.
    ///
    /// # Errors
    /// [`DiscretizeError::Scene`] if a patch does not exist, has others lying in it, has no axes,
    /// if patches of the scene overlap, or if something may stand between the cut patch and one of
    /// the others and that is refused; [`DiscretizeError::Exchange`] if the exchange area of a pair
    /// leaves `f64`'s range, or if all patches face away from each other;
    /// [`DiscretizeError::AgainstItself`]; [`DiscretizeError::NamedTwice`];
    /// [`DiscretizeError::NothingToGain`].
    pub fn with_occlusion(
        scene: &Scene,
        patch: usize,
        against: &[usize],
        axis: SplitAxis,
        occlusion: Occlusion,
    ) -> Result<Self, DiscretizeError> {
        let surface = CutSurface::try_new(scene.whole_patch(patch)?.shape(), axis);
        let surface = surface.map_err(|source| scene.refused(patch, source))?;
        Self::of_surface(scene, patch, against, surface, occlusion)
    }

    /// The split of [`try_new`](Self::try_new) by lines along any direction, in order to the right
    /// of it as seen from the front; the position is 0 where the patch begins and 1 where it ends.
    ///
    /// **Arguments** `direction`: of any length; its part in the plane of the patch counts.
    ///
    /// # Errors
    /// As [`with_occlusion`](Self::with_occlusion); [`DiscretizeError::Scene`] if the direction is
    /// perpendicular to the patch.
    pub fn parallel_to(
        scene: &Scene,
        patch: usize,
        against: &[usize],
        direction: DVec3,
        occlusion: Occlusion,
    ) -> Result<Self, DiscretizeError> {
        let surface = CutSurface::parallel_to(scene.whole_patch(patch)?.shape(), direction);
        let surface = surface.map_err(|source| scene.refused(patch, source))?;
        Self::of_surface(scene, patch, against, surface, occlusion)
    }

    fn of_surface(
        scene: &Scene,
        patch: usize,
        against: &[usize],
        surface: CutSurface,
        occlusion: Occlusion,
    ) -> Result<Self, DiscretizeError> {
        let area = scene.whole_patch(patch)?.shape().area();
        let mut pairs = Vec::new();
        let mut others = Vec::new();
        let mut kinks = surface.lines().steps();
        let mut between = Between::of(scene, patch);
        let mut ignored = IgnoredOcclusion::default();
        for other in against {
            if *other == patch {
                return Err(DiscretizeError::AgainstItself { patch });
            }
            if against.iter().filter(|index| *index == other).count() > 1 {
                return Err(DiscretizeError::NamedTwice { patch: *other });
            }
            let shape = scene.whole_patch(*other)?.shape();
            let past = match occlusion {
                Occlusion::Exact => between.past(*other),
                _ => None,
            };
            let pair = match past {
                Some(past) => surface.pair_past(shape, past),
                None => surface.pair(shape),
            };
            let (pair, exchange) = pair.map_err(|source| ExchangeError::Pair {
                first: patch,
                second: *other,
                source,
            })?;
            if occlusion == Occlusion::Ignore && between.is_blocked(*other) {
                ignored.pairs += 1;
                ignored.exchange_area += exchange;
            }
            if exchange > 0.0 {
                pairs.push(pair);
                others.push(*other);
                let plane = surface.lines().in_plane(shape.corners()[0], shape.normal());
                kinks.extend(plane);
            }
        }
        occlusion.check_pairs(scene, patch, against)?;
        if pairs.is_empty() && scene.is_turned_away() {
            return Err(ExchangeError::TurnedAway.into());
        }
        if pairs.is_empty() {
            return Err(DiscretizeError::NothingToGain { patch });
        }
        let standing = between.standing();
        kinks.extend(standing.filter_map(|(at, normal)| surface.lines().in_plane(at, normal)));
        kinks.sort_by(f64::total_cmp);
        kinks.dedup_by(|a, b| *a - *b < SAME_KINK);
        let weights = SplitWeights {
            brightness: vec![1.0; pairs.len()],
            area,
            total: scene.total_area(),
        };
        Ok(Self {
            lines: surface.lines().clone(),
            shapes: Shapes::new(surface, pairs, weights),
            others,
            kinks,
            ignored: between.can_block().then_some(ignored),
        })
    }

    /// The occlusion that was ignored; none where nothing can stand in the way. Exchange areas are
    /// those of the cut patch.
    #[must_use]
    pub const fn ignored_occlusion(&self) -> Option<IgnoredOcclusion> {
        self.ignored
    }

    /// Whether something stands between the cut patch and one of the others: positions and gains
    /// are estimates then.
    #[must_use]
    pub fn is_occluded(&self) -> bool {
        match &self.shapes {
            Shapes::Rectangles(_) => false,
            Shapes::Polygons(split) => {
                let mut pairs = split.pairs.iter();
                pairs.any(|pair| matches!(pair, CutPair::Occluded { .. }))
            }
        }
    }

    /// The split under a brightness, as in §5: constant on each patch, the cut one included.
    ///
    /// **Arguments** `patch`: the one that is cut; `brightness`: radiosities, or importances times
    /// reflectances, of all patches; `total`: `Σw = Σ_ij B_i A_i F_ij B_j` of the scene, in the
    /// same unit squared.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] unless all are ≥ 0 and finite, and the total > 0;
    /// [`DiscretizeError::NothingToGain`] if the patch, or every patch visible from it, is dark.
    pub fn under(
        mut self,
        patch: usize,
        brightness: &[f64],
        total: f64,
    ) -> Result<Self, DiscretizeError> {
        let own = brightness.get(patch).copied().unwrap_or(f64::NAN);
        let products = self.others.iter().map(|other| {
            let value = own * brightness.get(*other).copied().unwrap_or(f64::NAN);
            if value.is_finite() && value >= 0.0 {
                return Ok(value);
            }
            Err(DiscretizeError::OutOfRange {
                parameter: "the product of two brightnesses",
                value,
                condition: "finite and at least 0, one brightness for each patch",
            })
        });
        let products: Vec<f64> = products.collect::<Result<_, _>>()?;
        if !(total.is_finite() && total > 0.0) {
            return Err(DiscretizeError::OutOfRange {
                parameter: "the sum of the weights",
                value: total,
                condition: "finite and > 0",
            });
        }
        if products.iter().all(|product| *product <= 0.0) {
            return Err(DiscretizeError::NothingToGain { patch });
        }
        let weights = match &mut self.shapes {
            Shapes::Rectangles(split) => &mut split.weights,
            Shapes::Polygons(split) => &mut split.weights,
        };
        weights.brightness = products;
        weights.total = total;
        Ok(self)
    }

    /// The split as one of aligned rectangles, whose gains can be enclosed.
    ///
    /// # Errors
    /// [`DiscretizeError::NotEnclosed`] unless all patches are rectangles with edges along common
    /// axes, and nothing stands between them.
    pub const fn rectangles(&self) -> Result<&RectangleSplit, DiscretizeError> {
        match &self.shapes {
            Shapes::Rectangles(split) => Ok(split),
            Shapes::Polygons(_) => Err(DiscretizeError::NotEnclosed),
        }
    }

    /// Whether all pairs are rectangles with edges along common axes, so that their exchange areas
    /// are closed forms.
    #[must_use]
    pub const fn is_closed_form(&self) -> bool {
        matches!(self.shapes, Shapes::Rectangles(_))
    }

    /// The cut into two parts that gains the most, enclosed to about `bits` bits, with what is
    /// proved about it: [`RectangleSplit::certified_best`].
    ///
    /// # Errors
    /// [`DiscretizeError::NotEnclosed`] unless all are rectangles with edges along common axes;
    /// [`DiscretizeError::Numeric`] if no interior maximum is found.
    pub fn certified_best(&self, bits: u32) -> Result<CertifiedMaximum, DiscretizeError> {
        self.rectangles()?.certified_best(bits)
    }

    /// The gain of cuts at increasing relative positions, in bits.
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] unless `0 < t_1 < … < 1`.
    pub fn gain(&self, positions: &[f64]) -> Result<f64, DiscretizeError> {
        part_exchange::gain(self.parts(), positions)
    }

    /// The derivative of the gain as cut `k` moves, in bits per relative position.
    ///
    /// # Errors
    /// As [`gain`](Self::gain); [`DiscretizeError::OutOfRange`] if there is no cut `k`.
    pub fn gain_derivative(&self, positions: &[f64], k: usize) -> Result<f64, DiscretizeError> {
        part_exchange::gain_derivative(self.parts(), positions, k)
    }

    /// The gain of cuts at increasing relative positions by a measure: in bits, or in squared form
    /// factors, summed over the patches that the cut is judged by.
    ///
    /// # Errors
    /// As [`gain`](Self::gain).
    pub fn gain_by(&self, measure: CutMeasure, positions: &[f64]) -> Result<f64, DiscretizeError> {
        part_exchange::gain_by(measure, self.parts(), positions)
    }

    /// The derivative of [`gain_by`](Self::gain_by) as cut `k` moves, per relative position.
    ///
    /// # Errors
    /// As [`gain_derivative`](Self::gain_derivative).
    pub fn gain_derivative_by(
        &self,
        measure: CutMeasure,
        positions: &[f64],
        k: usize,
    ) -> Result<f64, DiscretizeError> {
        part_exchange::gain_derivative_by(measure, self.parts(), positions, k)
    }

    /// The share of the patch's area before a relative position.
    ///
    /// **Arguments** `position` inside `(0, 1)`.
    #[must_use]
    pub fn share_before(&self, position: f64) -> f64 {
        self.lines.share(0.0, position)
    }

    /// The relative position of the cut through a point of the patch's plane.
    ///
    /// **Arguments** `point`: any point; what it is off the plane does not matter.
    /// **Returns** a number in `(0, 1)` for a point inside the patch, 0 and 1 on its borders, and
    /// beyond these outside; dimensionless.
    #[must_use]
    pub fn position_of(&self, point: DVec3) -> f64 {
        self.lines.position(point)
    }

    /// The largest gain that a regular division into `parts` could bring at all, eqs. (6), (7).
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] if an exchange area leaves `f64`'s range.
    pub fn maximum_gain(&self, parts: u32) -> Result<f64, DiscretizeError> {
        part_exchange::maximum_gain(self.parts(), parts)
    }

    /// Flux and share of the parts.
    pub(crate) fn parts(&self) -> &dyn PartExchange<f64> {
        match &self.shapes {
            Shapes::Rectangles(split) => split,
            Shapes::Polygons(split) => &**split,
        }
    }
}

impl Shapes {
    /// Rectangles if all pairs are aligned, else polygons.
    fn new(surface: CutSurface, pairs: Vec<CutPair>, weights: SplitWeights<f64>) -> Self {
        let aligned = pairs.iter().map(|pair| match pair {
            CutPair::Aligned(pair) => Some(*pair),
            CutPair::Polygon { .. } | CutPair::Occluded { .. } => None,
        });
        match aligned.collect() {
            Some(pairs) => Self::Rectangles(RectangleSplit::new(pairs, surface.axis(), weights)),
            None => Self::Polygons(Box::new(PolygonSplit {
                surface,
                pairs,
                weights,
            })),
        }
    }
}
