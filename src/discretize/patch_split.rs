//! The cut of a patch that gains the most mutual information, eq. (7).
//!
//! ```text
//!   ΔI(t) = (2/A_T) Σ_j [ Σ_k A_k F_kj log2 F_kj − A F_j log2 F_j ]
//! ```
//!
//! over the patches j named, parts k between the cuts `t`. No outside state enters: a scene
//! need not be closed.
//!
//! **Not covered**: cuts that are not parallel to an edge; occlusion.

use super::{DiscretizeError, stationarity};
use crate::form_factor::RectanglePair;
use crate::geometry::SplitAxis;
use crate::information::relative_entropy;
use crate::numeric::{
    CertifiedMaximum, Dual, End, Interval, NumericError, Objective, Scalar, certified_maximum,
    maximum, maximum_of_many, x_log2_ratio,
};
use crate::scene::Scene;
use std::cell::RefCell;

/// A patch of a scene, to be cut across one of its axes; over intervals its gains are enclosures.
#[derive(Debug, Clone, PartialEq)]
pub struct PatchSplit<S = f64> {
    pairs: Vec<RectanglePair<S>>,
    axis: SplitAxis,
    area: S,
    total_area: S,
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

/// Equally spaced points at which the derivative is scanned for maxima.
const SCANNED_INTERVALS: u32 = 64;

impl PatchSplit {
    /// Patch `patch` of `scene`, cut across `axis`, judged by what it exchanges with the
    /// patches `against`.
    ///
    /// # Errors
    /// [`DiscretizeError::Scene`] if a patch does not exist or is not a rectangle;
    /// [`DiscretizeError::FormFactor`] if a pair is not aligned;
    /// [`DiscretizeError::AgainstItself`]; [`DiscretizeError::NamedTwice`];
    /// [`DiscretizeError::NothingToGain`].
    pub fn try_new(
        scene: &Scene,
        patch: usize,
        against: &[usize],
        axis: SplitAxis,
    ) -> Result<Self, DiscretizeError> {
        let rectangle = scene.rectangle(patch)?;
        let mut pairs = Vec::new();
        let mut exchanged = 0.0;
        for other in against {
            if *other == patch {
                return Err(DiscretizeError::AgainstItself { patch });
            }
            if against.iter().filter(|index| *index == other).count() > 1 {
                return Err(DiscretizeError::NamedTwice { patch: *other });
            }
            let pair = RectanglePair::try_new(&rectangle, &scene.rectangle(*other)?)?;
            let exchange = pair.exchange_area()?.value;
            if exchange > 0.0 {
                exchanged += exchange;
                pairs.push(pair);
            }
        }
        if exchanged <= 0.0 {
            return Err(DiscretizeError::NothingToGain { patch });
        }
        Ok(Self {
            pairs,
            axis,
            area: rectangle.area(),
            total_area: scene.total_area(),
        })
    }

    /// The same split in numbers of the type and precision of `like`: its form factors become enclosures over
    /// intervals.
    #[must_use]
    pub fn lifted<S: Scalar>(&self, like: &S) -> PatchSplit<S> {
        PatchSplit {
            pairs: self.pairs.iter().map(|pair| pair.lifted(like)).collect(),
            axis: self.axis,
            area: like.constant(self.area),
            total_area: like.constant(self.total_area),
        }
    }

    /// The cuts into `parts` parts that gain the most.
    ///
    /// Two parts: the highest of the maxima that a scan of the derivative shows, each
    /// refined as its root (of equal ones, the nearest to `v0`). More: the best
    /// cuts on a fine lattice, all of them compared by dynamic programming, refined as the root of the
    /// gradient.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] below two parts; [`DiscretizeError::Numeric`] if no
    /// interior maximum is found.
    pub fn best(&self, parts: u32) -> Result<SplitOptimum, DiscretizeError> {
        if parts < 2 {
            let (parameter, condition) = ("the number of parts", "at least 2");
            return Err(DiscretizeError::OutOfRange {
                parameter,
                value: parts.into(),
                condition,
            });
        }
        let positions = if parts == 2 {
            let found = self.searching(|gain, derivative| {
                maximum(
                    |t| gain(&[t]),
                    |t| derivative(&[t], 0),
                    (0.0, 1.0),
                    SCANNED_INTERVALS,
                )
            })?;
            vec![found.position]
        } else {
            let start = self.best_on_lattice(parts as usize)?;
            self.searching(|_, derivative| {
                let gradient = |positions: &[f64]| {
                    (0..positions.len())
                        .map(|k| derivative(positions, k))
                        .collect()
                };
                maximum_of_many(gradient, start)
            })?
        };
        let mut residual: f64 = 0.0;
        for k in 0..positions.len() {
            residual = residual.max(self.gain_derivative(&positions, k)?.abs());
        }
        Ok(SplitOptimum {
            gain: self.gain(&positions)?,
            residual,
            positions,
        })
    }

    /// The cut into two parts that gains the most, enclosed to about `bits` bits, with what is proved about it.
    ///
    /// The scene is the one in `f64`: its pairs as placed (coordinates in the frame of the patch, rounded to ε of
    /// themselves) and its areas as rounded count as exact. For coordinates whose differences and products are
    /// doubles, as in the paper's scenes of two and three squares, that is the scene itself; else the true
    /// position and gain may miss the enclosures by what this rounding does. The total area does not enter the position.
    ///
    /// # Errors
    /// [`DiscretizeError::Numeric`] if no interior maximum is found.
    pub fn certified_best(&self, bits: u32) -> Result<CertifiedMaximum, DiscretizeError> {
        Ok(certified_maximum(self, (0.0, 1.0), bits)?)
    }

    /// The best cuts whose positions are multiples of a step of an eighth part or less: the gain is a sum over
    /// the parts, so the best last part extends the best cuts before it.
    fn best_on_lattice(&self, parts: usize) -> Result<Vec<f64>, DiscretizeError> {
        let count = (8 * parts).max(64);
        #[allow(clippy::cast_precision_loss, reason = "a few hundred points")]
        let at = |k: usize| k as f64 / count as f64;
        // value[from][to]: Σ_j G log2(G/W) of one part
        let mut value = vec![vec![0.0; count + 1]; count];
        for (from, row) in value.iter_mut().enumerate() {
            for (to, value) in row.iter_mut().enumerate().skip(from + 1) {
                for pair in &self.pairs {
                    let flux = self.exchange(pair, &[at(from), at(to)])?;
                    *value += x_log2_ratio(flux, at(to) - at(from));
                }
            }
        }
        // best[m][to]: the most that m + 1 parts of [0, to] bring, and where the last one starts
        let mut best: Vec<Vec<(f64, usize)>> = vec![value[0].iter().map(|v| (*v, 0)).collect()];
        for m in 1..parts {
            let before = &best[m - 1];
            let extended = (0..=count).map(|to| {
                (m..to).fold((f64::NEG_INFINITY, 0), |most, from| {
                    let sum = before[from].0 + value[from][to];
                    if sum > most.0 { (sum, from) } else { most }
                })
            });
            let extended = extended.collect();
            best.push(extended);
        }
        let mut positions = Vec::with_capacity(parts - 1);
        let mut to = count;
        for m in (1..parts).rev() {
            to = best[m][to].1;
            positions.push(at(to));
        }
        positions.reverse();
        Ok(positions)
    }

    /// Runs an optimiser that knows only numbers; where it fails, the first refusal inside is the reason.
    fn searching<T>(
        &self,
        search: impl FnOnce(
            &dyn Fn(&[f64]) -> f64,
            &dyn Fn(&[f64], usize) -> f64,
        ) -> Result<T, NumericError>,
    ) -> Result<T, DiscretizeError> {
        let refusal = RefCell::new(None);
        let number = |result: Result<f64, DiscretizeError>| {
            result.unwrap_or_else(|error| {
                refusal.borrow_mut().get_or_insert(error);
                f64::NAN
            })
        };
        let found = search(
            &|positions| number(self.gain(positions)),
            &|positions, k| number(self.gain_derivative(positions, k)),
        );
        // a refusal matters only if the optimiser could not do without that point
        found.map_err(|error| refusal.into_inner().unwrap_or(error.into()))
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
        for pair in &self.pairs {
            let parts = parts
                .iter()
                .map(|part| Ok([self.exchange(pair, part)?, part[1].clone() - &part[0]]))
                .collect::<Result<Vec<[S; 2]>, DiscretizeError>>()?;
            let flux = parts.iter().fold(zero.clone(), |sum, part| sum + &part[0]);
            gain = gain + &relative_entropy(&flux, &one, &parts);
        }
        Ok(gain * &self.area.constant(2.0) / &self.total_area)
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
        let ratio = |pair: &RectanglePair<S>, part: &[S; 2]| {
            let area = (part[1].clone() - &part[0]) * &self.area;
            self.exchange(pair, part).map(|flux| flux / &area)
        };
        let mut derivative = self.area.zero();
        for pair in &self.pairs {
            let rate = pair.strip_exchange(self.axis, &before[1])?;
            let [before, after] = [ratio(pair, before)?, ratio(pair, after)?];
            derivative = derivative + &stationarity(&rate, &self.area, &before, &after);
        }
        Ok(derivative * &self.bits_per_nat())
    }

    /// The largest gain that a regular division into `parts` could bring at all, eqs. (6), (7).
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] if an exchange area leaves `f64`'s range.
    pub fn maximum_gain(&self, parts: u32) -> Result<S, DiscretizeError> {
        let mut exchanged = self.area.zero();
        for pair in &self.pairs {
            exchanged = exchanged + &pair.exchange_value()?;
        }
        let log = self.area.constant(f64::from(parts)).ln() / &self.area.constant(2.0).ln();
        Ok(exchanged * &self.area.constant(2.0) * &log / &self.total_area)
    }

    /// `2/(A_T ln 2)`.
    fn bits_per_nat(&self) -> S {
        let two = self.area.constant(2.0);
        two.clone() / &(two.ln() * &self.total_area)
    }

    fn exchange(&self, pair: &RectanglePair<S>, [from, to]: &[S; 2]) -> Result<S, DiscretizeError> {
        Ok(pair.part(self.axis, from, to)?.exchange_value()?)
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
        for ((pair, wide), point) in split.pairs.iter().zip(&on_box.pairs).zip(&at_middle.pairs) {
            let wide = wide
                .strip_exchange(self.axis, &Dual::variable(Dual::variable(*domain)))
                .ok()?;
            let point = point
                .strip_exchange(self.axis, &Dual::variable(middle))
                .ok()?;
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
            derivative = derivative + stationarity(&rate, &area, &near, &far);
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
        for pair in &split.pairs {
            let rate = pair.strip_exchange(self.axis, position).ok()?;
            let whole = pair.exchange_value().ok()?;
            let small = rate.clone() / &split.area;
            let large = (whole - &(rate.clone() * distance)) / &(rest.clone() * &split.area);
            let (before, after) = match end {
                End::Lower => (small, large),
                End::Upper => (large, small),
            };
            derivative = derivative + &stationarity(&rate, &split.area, &before, &after);
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
