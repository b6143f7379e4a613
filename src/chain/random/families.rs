//! Random refinements, valid by construction and aimed at the hard spots of floating point.
//!
//! A [`RefinementDraw`] is a family of chains, a family of divisions, and a list of bytes; it is
//! turned into a [`Refinement`] by the formula
//!
//! ```text
//!   J′_kl = J_ij s_k s_l (1 + δ_kl),     k a part of i, l of j,  δ symmetric, ≥ −1
//! ```
//!
//! and the coarse chain is the sum of the parts. Small bytes mean simple numbers, so that shrinking
//! the bytes leads to readable chains. The bytes may come from a random source
//! ([`RandomChains`](super::seeded::RandomChains)) or from a proptest strategy.

use crate::chain::error::ChainError;
use crate::chain::refinement::Refinement;
use crate::chain::reversible::ReversibleChain;
use crate::exchange::{Congruence, ScenePairs};
use crate::form_factor::DEFAULT_TOLERANCE;
use crate::scene::Scene;
use nalgebra::DMatrix;

/// A family of coarse chains.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ChainFamily {
    /// A refinement whose joint matrix has every entry positive.
    Dense,
    /// About five entries in eight are zero.
    Sparse,
    /// Two blocks coupled by entries of 1e-18 and less: before a division that empties a block, a
    /// second eigenvalue within 1e-12 of 1.
    Decomposable,
    /// Weights spread from 1 to 1e-300.
    Spread,
    /// The visibility chain of a closed room, its walls cut.
    Room,
}

impl ChainFamily {
    /// All families.
    pub const ALL: [Self; 5] = [
        Self::Dense,
        Self::Sparse,
        Self::Decomposable,
        Self::Spread,
        Self::Room,
    ];
}

/// A family of divisions of states.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum DivisionFamily {
    /// Arbitrary shares and deviations.
    Free,
    /// Equal shares.
    Equal,
    /// One part next to which the others are 1e-15.
    Lopsided,
    /// A part of no weight.
    WithEmpty,
    /// Deviations of a few ε: gains near 1e-30.
    NearlyProportional,
    /// No deviation, shares that are powers of two: the gain is exactly 0.
    Proportional,
}

impl DivisionFamily {
    /// All families.
    pub const ALL: [Self; 6] = [
        Self::Free,
        Self::Equal,
        Self::Lopsided,
        Self::WithEmpty,
        Self::NearlyProportional,
        Self::Proportional,
    ];
}

/// A draw from which one random refinement is made.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RefinementDraw {
    /// The coarse chain's family.
    pub chain: ChainFamily,
    /// The division's family.
    pub division: DivisionFamily,
    /// States before the division, ≥ 2 (a room has at least 6).
    pub states: usize,
    /// Parts of each divided state, each ≥ 2; states are divided from the first on.
    pub parts: Vec<usize>,
    /// The bytes; a missing one counts as 0.
    pub bytes: Vec<u8>,
}

/// A reader of bytes, one after the other.
struct Bytes<'r> {
    bytes: std::slice::Iter<'r, u8>,
}

impl Bytes<'_> {
    fn next(&mut self) -> u8 {
        self.bytes.next().copied().unwrap_or(0)
    }

    /// A number in `(0, 1]`; byte 0 is 1.
    fn positive(&mut self) -> f64 {
        1.0 - f64::from(self.next()) / 256.0
    }

    /// 0 for five bytes in eight; the largest bytes are near 1.
    fn sparse(&mut self) -> f64 {
        f64::from(self.next().saturating_sub(159)) / 96.0
    }
}

impl RefinementDraw {
    /// Makes the refinement.
    ///
    /// # Errors
    /// [`ChainError::WrongShape`] for a state of no parts; none within the ranges stated at the
    /// fields.
    pub fn refinement(&self) -> Result<Refinement, ChainError> {
        if self.parts.contains(&0) {
            let (what, found, expected) = ("the list of parts of a state", 0, 1);
            return Err(ChainError::WrongShape {
                what,
                found,
                expected,
            });
        }
        let mut bytes = Bytes {
            bytes: self.bytes.iter(),
        };
        let base = self.base(&mut bytes)?;
        let n = base.nrows();
        // part k belongs to parents[k] and takes shares[k] of it
        let mut parents: Vec<usize> = (0..n).collect();
        let mut shares = vec![1.0; n];
        for (state, parts) in self.parts.iter().take(n).enumerate() {
            let division = self.shares(*parts, &mut bytes);
            shares[state] = division[0];
            shares.extend(&division[1..]);
            parents.extend(std::iter::repeat_n(state, parts - 1));
        }
        let size = parents.len();
        let divided = self.parts.len();
        let mut joint = DMatrix::zeros(size, size);
        for k in 0..size {
            for l in 0..=k {
                let (i, j) = (parents[k], parents[l]);
                let is_whole = i >= divided && j >= divided;
                let deviation = if is_whole {
                    0.0
                } else {
                    self.deviation(&mut bytes)
                };
                let entry = base[(i, j)] * shares[k] * shares[l] * (1.0 + deviation);
                joint[(k, l)] = entry;
                joint[(l, k)] = entry;
            }
        }
        if joint.iter().all(|entry: &f64| *entry <= 0.0) {
            joint[(0, 0)] = 1.0; // the bytes left nothing
        }
        Refinement::coarsening(ReversibleChain::try_new(joint)?, parents)
    }

    fn base(&self, bytes: &mut Bytes<'_>) -> Result<DMatrix<f64>, ChainError> {
        let n = self.states.max(2);
        let symmetric = |entry: &mut dyn FnMut(usize, usize) -> f64| {
            let mut matrix = DMatrix::zeros(n, n);
            for i in 0..n {
                for j in 0..=i {
                    let value = entry(i, j);
                    matrix[(i, j)] = value;
                    matrix[(j, i)] = value;
                }
            }
            matrix
        };
        Ok(match self.chain {
            ChainFamily::Dense => symmetric(&mut |_, _| bytes.positive()),
            ChainFamily::Sparse => {
                // never empty
                symmetric(&mut |i, j| {
                    if (i, j) == (1, 0) {
                        1.0
                    } else {
                        bytes.sparse()
                    }
                })
            }
            ChainFamily::Decomposable => symmetric(&mut |i, j| {
                let coupling = if (i % 2) == (j % 2) { 1.0 } else { 1e-18 };
                coupling * bytes.positive()
            }),
            ChainFamily::Spread => {
                let sizes: Vec<f64> = (0..n)
                    .map(|_| 10f64.powf(-300.0 * (1.0 - bytes.positive())))
                    .collect();
                symmetric(&mut |i, j| sizes[i].min(sizes[j]) * bytes.positive())
            }
            ChainFamily::Room => room(n, bytes)?,
        })
    }

    fn shares(&self, parts: usize, bytes: &mut Bytes<'_>) -> Vec<f64> {
        (0..parts)
            .map(|k| match self.division {
                #[allow(clippy::cast_precision_loss, reason = "a handful of parts")]
                DivisionFamily::Equal => 1.0 / parts as f64,
                DivisionFamily::Lopsided if k > 0 => 1e-15 * bytes.positive(),
                DivisionFamily::WithEmpty if k > 0 && k + 1 == parts => 0.0,
                DivisionFamily::Proportional => f64::from(-i32::from(bytes.next() % 8)).exp2(),
                _ => bytes.positive(),
            })
            .collect()
    }

    fn deviation(&self, bytes: &mut Bytes<'_>) -> f64 {
        match self.division {
            DivisionFamily::Proportional => 0.0,
            DivisionFamily::NearlyProportional => f64::EPSILON * f64::from(bytes.next() % 8),
            _ => f64::from(bytes.next()) / 64.0 - 1.0,
        }
    }
}

/// Exchange areas of a box with edges between 1/20 and 1, walls cut until there are `n` patches.
fn room(n: usize, bytes: &mut Bytes<'_>) -> Result<DMatrix<f64>, ChainError> {
    let mut edge = || 0.05 + 0.95 * bytes.positive();
    let (x, y, z) = (edge(), edge(), edge());
    let mut scene = Scene::inside_of_box(x, y, z)?;
    let mut patch = 0;
    while scene.patches().len() < n {
        let axis = crate::geometry::SplitAxis::ALL[usize::from(bytes.next() % 2)];
        let position = 0.9 - 0.8 * bytes.positive() / 2.0;
        scene = scene.with_patch_split(patch, axis, position)?;
        patch += 1;
    }
    // the walls of a box neither overlap nor hide anything
    let pairs = ScenePairs::unchecked(&scene, DEFAULT_TOLERANCE, Congruence::Shared)?;
    Ok(pairs.exchange_areas()?.into_values())
}
