//! Continuous mutual information (4) of any closed scene, from random chords.
//!
//! ```text
//!   I^c = E[ log2(A_T cos θ cos θ' / (π r²)) ]     over the chords that uniform lines cut out
//! ```
//!
//! What a chord first meets ends it, so scenes may be concave and occluded; their light must not escape. The summand is
//! bounded above where patches do not touch, and has moments of all orders where they do: its upper tail is exponential,
//! `P(I > t) ~ 2^−t` at a common edge.
//!
//! **Errors** the standard error of the mean, by line where a line has several chords: evidence by *sample*.

use super::{LineKind, LineSample};
use crate::chain::ChainError;
use crate::scene::{Chord, Scene};
use std::f64::consts::{LN_2, PI};

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

/// Continuous mutual information of a closed scene by random chords, that may be concave and occluded.
///
/// **Arguments** `lines`: how many, at least 2; fewer count as 2. `seed`: the same one gives the same estimate.
///
/// # Errors
/// Those of [`LineSample::draw`].
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
    Ok(LineSample::draw(scene, LineKind::Local, lines, seed)?.chords)
}

/// Sums over lines: of the number of chords c of a line, the sum v of the summand over them, and c², c·v, v².
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct ChordSums([f64; 5]);

impl ChordSums {
    /// Adds a line.
    pub(super) fn add(&mut self, chords: &[Chord]) {
        let value = |chord: &Chord| {
            let [one, other] = chord.cosines;
            (one * other / (PI * chord.square)).ln()
        };
        let values: f64 = chords.iter().map(value).sum();
        #[allow(clippy::cast_precision_loss, reason = "a few chords")]
        let count = chords.len() as f64;
        let terms = [
            count,
            values,
            count * count,
            count * values,
            values * values,
        ];
        self.merge(&Self(terms));
    }

    /// Adds the sums of other lines.
    pub(super) fn merge(&mut self, other: &Self) {
        for (sum, term) in self.0.iter_mut().zip(other.0) {
            *sum += term;
        }
    }

    /// The mean over chords, with the standard error of a quotient of means over lines.
    pub(super) fn mean(&self, lines: u32) -> ChordInformation {
        let [count, values, counts, products, squares] = self.0;
        let mean = values / count;
        let variance = squares - 2.0 * mean * products + mean * mean * counts;
        let n = f64::from(lines);
        ChordInformation {
            mutual_information: mean / LN_2,
            standard_error: (variance.max(0.0) * n / (n - 1.0)).sqrt() / count / LN_2,
            lines,
        }
    }
}
