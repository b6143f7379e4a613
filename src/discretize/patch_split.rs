//! The cut of a patch that gains the most mutual information, eq. (7).
//!
//! ```text
//!   ΔI(t) = (2/A_T) Σ_j [ Σ_k A_k F_kj log2 F_kj − A F_j log2 F_j ]
//! ```
//!
//! over the patches j named, parts k between the cuts `t`. No outside state enters: a scene
//! need not be closed. Under a brightness (§5), radiosity or reflected importance, constant on each patch,
//!
//! ```text
//!   ΔI(t) = (2/Σw) Σ_j B_i B_j [ Σ_k A_k F_kj log2 F_kj − A F_j log2 F_j ]
//! ```
//!
//! The patch is any polygon and so are the others, at any angle; lines run as [`CutLines`] says, in a
//! parallelogram parallel to an edge. Enclosures and proofs are for rectangles with edges along common axes.
//!
//! **Not covered**: cuts in other directions; computing with occlusion.

use super::cut_pair::CutPair;
use super::{DiscretizeError, stationarity};
use crate::geometry::{CutLines, Rectangle, SplitAxis};
use crate::information::relative_entropy;
use crate::numeric::{CertifiedMaximum, Dual, End, Interval, Objective, Scalar, certified_maximum};
use crate::scene::{ExchangeError, Occlusion, Scene};

/// A patch of a scene, to be cut across one of its axes; over intervals its gains are enclosures.
#[derive(Debug, Clone, PartialEq)]
pub struct PatchSplit<S = f64> {
    pub(super) pairs: Vec<CutPair<S>>,
    /// The other patch of each pair.
    others: Vec<usize>,
    /// `B_i B_j` of each pair; 1 for visibility.
    pub(super) brightness: Vec<S>,
    pub(super) axis: SplitAxis,
    pub(super) lines: CutLines,
    /// Increasing positions inside `(0, 1)` at which the derivative of the gain jumps.
    pub(super) kinks: Vec<f64>,
    /// Is the share of a part its length? Of other shapes it is known in `f64` only.
    is_rectangle: bool,
    area: S,
    /// `Σw`: the total area for visibility.
    total: S,
}

/// The best cuts, with what they gain.
#[derive(Debug, Clone, PartialEq)]
pub struct SplitOptimum {
    /// Relative positions of the cuts, increasing, in `(0, 1)`.
    pub positions: Vec<f64>,
    /// `ΔI` there, in bits.
    pub gain: f64,
    /// The largest |∂ΔI/∂t| that is left, in bits.
    pub residual: f64,
}

/// Positions nearer than this are one kink: planes that meet in a line, up to rounding.
const SAME_KINK: f64 = 1e-12;

impl PatchSplit {
    /// Patch `patch` of `scene`, cut across `axis`, judged by what it exchanges with the
    /// patches `against`; a scene in which something may stand between these is refused.
    ///
    /// # Errors
    /// Those of [`with_occlusion`](Self::with_occlusion).
    pub fn try_new(
        scene: &Scene,
        patch: usize,
        against: &[usize],
        axis: SplitAxis,
    ) -> Result<Self, DiscretizeError> {
        Self::with_occlusion(scene, patch, against, axis, Occlusion::Refuse)
    }

    /// As [`try_new`](Self::try_new), with a policy for what may stand between the patches.
    ///
    /// # Errors
    /// [`DiscretizeError::Scene`] if a patch does not exist, has others lying in it, has no axes,
    /// if what a pair exchanges leaves `f64`'s range, if patches of the scene overlap, or if
    /// something may stand between the cut patch and one of the others;
    /// [`DiscretizeError::AgainstItself`]; [`DiscretizeError::NamedTwice`];
    /// [`DiscretizeError::NothingToGain`].
    pub fn with_occlusion(
        scene: &Scene,
        patch: usize,
        against: &[usize],
        axis: SplitAxis,
        occlusion: Occlusion,
    ) -> Result<Self, DiscretizeError> {
        let surface = scene.whole_patch(patch)?.shape();
        let lines = CutLines::try_new(surface, axis);
        let lines = lines.map_err(|source| scene.refused(patch, source))?;
        let mut pairs = Vec::new();
        let mut others = Vec::new();
        let mut kinks = lines.steps();
        for other in against {
            if *other == patch {
                return Err(DiscretizeError::AgainstItself { patch });
            }
            if against.iter().filter(|index| *index == other).count() > 1 {
                return Err(DiscretizeError::NamedTwice { patch: *other });
            }
            let shape = scene.whole_patch(*other)?.shape();
            let pair = CutPair::try_new(&lines, [surface, shape]);
            let (pair, exchange) = pair.map_err(|source| ExchangeError::Pair {
                first: patch,
                second: *other,
                source,
            })?;
            if exchange > 0.0 {
                pairs.push(pair);
                others.push(*other);
                kinks.extend(lines.in_plane(shape.corners()[0], shape.normal()));
            }
        }
        occlusion.check_pairs(scene, patch, against)?;
        if pairs.is_empty() {
            return Err(DiscretizeError::NothingToGain { patch });
        }
        kinks.sort_by(f64::total_cmp);
        kinks.dedup_by(|a, b| *a - *b < SAME_KINK);
        Ok(Self {
            brightness: vec![1.0; pairs.len()],
            pairs,
            others,
            axis,
            kinks,
            is_rectangle: Rectangle::try_from(surface).is_ok(),
            area: surface.area(),
            total: scene.total_area(),
            lines,
        })
    }

    /// The same split under a brightness, as §5 has it: constant on each patch, the cut one included.
    ///
    /// **Arguments** `patch`: the one that is cut; `brightness`: radiosities, or importances times reflectances, of all patches;
    /// `total`: `Σw = Σ_ij B_i A_i F_ij B_j` of the scene, in the same unit squared.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] unless all are ≥ 0 and finite, and the total > 0; [`DiscretizeError::NothingToGain`] if what
    /// is cut, or all that it sees, is dark.
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
        self.brightness = products.collect::<Result<_, _>>()?;
        if !(total.is_finite() && total > 0.0) {
            return Err(DiscretizeError::OutOfRange {
                parameter: "the sum of the weights",
                value: total,
                condition: "finite and > 0",
            });
        }
        if self.brightness.iter().all(|product| *product <= 0.0) {
            return Err(DiscretizeError::NothingToGain { patch });
        }
        self.total = total;
        Ok(self)
    }

    /// The same split in numbers of the type and precision of `like`: its form factors become enclosures over
    /// intervals, if all are rectangles with edges along common axes; others are refused as
    /// [`DiscretizeError::NotEnclosed`] when they are asked for.
    #[must_use]
    pub fn lifted<S: Scalar>(&self, like: &S) -> PatchSplit<S> {
        PatchSplit {
            pairs: self.pairs.iter().map(|pair| pair.lifted(like)).collect(),
            others: self.others.clone(),
            brightness: self.brightness.iter().map(|b| like.constant(*b)).collect(),
            axis: self.axis,
            lines: self.lines.clone(),
            kinks: self.kinks.clone(),
            is_rectangle: self.is_rectangle,
            area: like.constant(self.area),
            total: like.constant(self.total),
        }
    }

    /// Are all pairs rectangles with edges along common axes, so that their exchange areas are closed forms?
    #[must_use]
    pub fn is_closed_form(&self) -> bool {
        self.pairs.iter().all(CutPair::is_aligned)
    }

    /// The cut into two parts that gains the most, enclosed to about `bits` bits, with what is proved about it.
    ///
    /// The scene is the one in `f64`: its pairs as placed (coordinates in the frame of the patch, rounded to ε of
    /// themselves) and its areas as rounded count as exact. For coordinates whose differences and products are
    /// doubles, as in the paper's scenes of two and three squares, that is the scene itself; else the true
    /// position and gain may miss the enclosures by what this rounding does. The total area does not enter the position.
    ///
    /// # Errors
    /// [`DiscretizeError::NotEnclosed`] unless all are rectangles with edges along common axes;
    /// [`DiscretizeError::Numeric`] if no interior maximum is found.
    pub fn certified_best(&self, bits: u32) -> Result<CertifiedMaximum, DiscretizeError> {
        if !self.is_closed_form() {
            return Err(DiscretizeError::NotEnclosed);
        }
        Ok(certified_maximum(self, (0.0, 1.0), bits)?)
    }
}

impl<S: Scalar> PatchSplit<S> {
    /// The gain of cuts at increasing relative positions, in bits.
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] unless `0 < t_1 < … < 1`.
    pub fn gain(&self, positions: &[S]) -> Result<S, DiscretizeError> {
        let parts = self.parts(positions);
        let (zero, one) = (self.area.zero(), self.area.constant(1.0));
        let mut gain = zero.clone();
        for (pair, brightness) in self.pairs.iter().zip(&self.brightness) {
            let parts = parts
                .iter()
                .map(|part| Ok([self.exchange(pair, part)?, self.share(part)]))
                .collect::<Result<Vec<[S; 2]>, DiscretizeError>>()?;
            let flux = parts.iter().fold(zero.clone(), |sum, part| sum + &part[0]);
            gain = gain + &(relative_entropy(&flux, &one, &parts) * brightness);
        }
        Ok(gain * &self.area.constant(2.0) / &self.total)
    }

    /// The derivative of the gain as cut `k` moves, in bits per relative position.
    ///
    /// # Errors
    /// As [`gain`](Self::gain); [`DiscretizeError::OutOfRange`] if there is no cut `k`.
    pub fn gain_derivative(&self, positions: &[S], k: usize) -> Result<S, DiscretizeError> {
        let parts = self.parts(positions);
        let (Some(before), Some(after)) = (parts.get(k), parts.get(k + 1)) else {
            let (parameter, condition) = ("the index of a cut", "that of one of the positions");
            #[allow(clippy::cast_precision_loss, reason = "only shown")]
            let value = k as f64;
            return Err(DiscretizeError::OutOfRange {
                parameter,
                value,
                condition,
            });
        };
        let weight_rate = self.share_rate(&before[1]) * &self.area;
        let ratio = |pair: &CutPair<S>, part: &[S; 2]| {
            let area = self.share(part) * &self.area;
            self.exchange(pair, part).map(|flux| flux / &area)
        };
        let mut derivative = self.area.zero();
        for (pair, brightness) in self.pairs.iter().zip(&self.brightness) {
            let rate = pair.strip(self.axis, &before[1])?;
            let [before, after] = [ratio(pair, before)?, ratio(pair, after)?];
            let term = stationarity(&rate, &weight_rate, &before, &after);
            derivative = derivative + &(term * brightness);
        }
        Ok(derivative * &self.bits_per_nat())
    }

    /// The largest gain that a regular division into `parts` could bring at all, eqs. (6), (7).
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] if an exchange area leaves `f64`'s range.
    pub fn maximum_gain(&self, parts: u32) -> Result<S, DiscretizeError> {
        let mut exchanged = self.area.zero();
        for (pair, brightness) in self.pairs.iter().zip(&self.brightness) {
            exchanged = exchanged + &(pair.whole(&self.area)? * brightness);
        }
        let log = self.area.constant(f64::from(parts)).ln() / &self.area.constant(2.0).ln();
        Ok(exchanged * &self.area.constant(2.0) * &log / &self.total)
    }

    /// `2/(A_T ln 2)`.
    fn bits_per_nat(&self) -> S {
        let two = self.area.constant(2.0);
        two.clone() / &(two.ln() * &self.total)
    }

    fn exchange(&self, pair: &CutPair<S>, part: &[S; 2]) -> Result<S, DiscretizeError> {
        pair.part(self.axis, part)
    }

    /// The share of a part in the area.
    pub(super) fn share(&self, part: &[S; 2]) -> S {
        let [from, to] = part;
        if self.is_rectangle {
            to.clone() - from
        } else {
            from.constant(self.lines.share(from.to_f64(), to.to_f64()))
        }
    }

    /// Its derivative by the position of the part's end.
    fn share_rate(&self, position: &S) -> S {
        position.constant(if self.is_rectangle {
            1.0
        } else {
            self.lines.share_rate(position.to_f64())
        })
    }

    /// The parts between cuts, as relative positions from and to.
    fn parts(&self, positions: &[S]) -> Vec<[S; 2]> {
        let (zero, one) = (self.area.zero(), self.area.constant(1.0));
        let from = std::iter::once(&zero).chain(positions);
        let to = positions.iter().chain(std::iter::once(&one));
        from.zip(to)
            .map(|(from, to)| [from.clone(), to.clone()])
            .collect()
    }
}

/// The gain of one cut. Next to an end the ratio of flux to weight of the small part is a mean of the strip's
/// exchange, so that it lies between the least and the largest of these.
impl Objective for PatchSplit {
    fn value<S: Scalar>(&self, x: &S) -> Option<S> {
        self.lifted(x).gain(std::slice::from_ref(x)).ok()
    }

    fn slope<S: Scalar>(&self, x: &S) -> Option<S> {
        let split = self.lifted(x);
        split.gain_derivative(std::slice::from_ref(x), 0).ok()
    }

    /// With m the middle of the box X, r what a strip exchanges and G what `[0, t]` does,
    ///
    /// ```text
    ///   r′(X) ⊂ r′(m) + r″(X) (X − m),   r(X) ⊂ r(m) + r′(X) (X − m),   G(X) ⊂ G(m) + r(X) (X − m)
    /// ```
    ///
    /// which far from the other patches is much narrower than closed forms of X, whose terms cancel.
    fn slope_on_box(&self, domain: &Interval<f64>) -> Option<Dual<Interval<f64>>> {
        let middle = Interval::point(domain.midpoint());
        let aside = *domain - middle;
        let (zero, one) = (domain.zero(), domain.constant(1.0));
        let on_box = self.lifted(&Dual::variable(Dual::variable(*domain)));
        let at_middle = self.lifted(&Dual::variable(middle));
        let split = self.lifted(domain);
        let area = Dual::constant_like(&split.area);
        let before = Dual::variable(*domain);
        let after = Dual::constant_like(&one) - before;
        let mut derivative = Dual::constant_like(&zero);
        let pairs = split.pairs.iter().zip(&split.brightness);
        for (((pair, brightness), wide), point) in pairs.zip(&on_box.pairs).zip(&at_middle.pairs) {
            let wide = wide
                .strip(self.axis, &Dual::variable(Dual::variable(*domain)))
                .ok()?;
            let point = point.strip(self.axis, &Dual::variable(middle)).ok()?;
            let slope = point.slope + wide.slope.slope * aside;
            let value = point.value + slope * aside;
            let rate = Dual { value, slope };
            let moved = value * aside;
            let flux = |part: [Interval<f64>; 2], change: Interval<f64>, slope| {
                let at_middle = split.exchange(pair, &part).ok()?;
                let value = at_middle + change;
                Some(Dual { value, slope })
            };
            let near = flux([zero, middle], moved, value)? / (area * before);
            let far = flux([middle, one], -moved, -value)? / (area * after);
            let term = stationarity(&rate, &area, &near, &far);
            derivative = derivative + term * Dual::constant_like(brightness);
        }
        Some(derivative * Dual::constant_like(&split.bits_per_nat()))
    }

    fn slope_near<S: Scalar>(&self, end: End, distance: &S) -> Option<S> {
        let split = self.lifted(distance);
        let rest = distance.constant(1.0) - distance;
        let position = match end {
            End::Lower => distance,
            End::Upper => &rest,
        };
        let mut derivative = distance.zero();
        for (pair, brightness) in split.pairs.iter().zip(&split.brightness) {
            let rate = pair.strip(self.axis, position).ok()?;
            let whole = pair.whole(&split.area).ok()?;
            let small = rate.clone() / &split.area;
            let large = (whole - &(rate.clone() * distance)) / &(rest.clone() * &split.area);
            let (before, after) = match end {
                End::Lower => (small, large),
                End::Upper => (large, small),
            };
            let term = stationarity(&rate, &split.area, &before, &after);
            derivative = derivative + &(term * brightness);
        }
        Some(derivative * &split.bits_per_nat())
    }
}

/// `1/m, 2/m, …`: the regular division into `parts`.
#[must_use]
pub fn regular_positions(parts: u32) -> Vec<f64> {
    (1..parts)
        .map(|k| f64::from(k) / f64::from(parts))
        .collect()
}
