//! Continuous mutual information (4) of any closed scene, from random chords.
//!
//! ```text
//!   I^c = E[ log2(A_T cos θ cos θ' / (π r²)) ]     over the chords that uniform lines cut out
//! ```
//!
//! A chord ends at the first front that it meets, so scenes may be concave and occluded; their
//! light must not escape. The summand is bounded above where patches do not touch, and has moments
//! of all orders where they do: its upper tail is exponential, `P(I > t) ~ 2^−t` at a common edge.
//!
//! **Errors** the standard error of the mean, by line where a line has several chords: evidence by
//! *sample*.

use crate::numeric::functions::elementary::ln;
use crate::numeric::real;
use crate::scene::Chord;
use std::f64::consts::{LN_2, PI};

/// The continuous mutual information of a scene, estimated by random chords.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChordInformation {
    /// Continuous mutual information, in bits, estimated.
    pub mutual_information: f64,
    /// The standard error of the estimate.
    pub standard_error: f64,
    /// The number of lines drawn.
    pub lines: u32,
}

/// Sums over lines: of the number c of chords of a line, the sum v of the summand over them, and of
/// c², c·v, v².
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ChordSums([f64; 5]);

impl ChordSums {
    /// Adds a line.
    pub(crate) fn add(&mut self, chords: &[Chord]) {
        let value = |chord: &Chord| {
            let [one, other] = chord.cosines;
            ln(one * other / (PI * chord.square))
        };
        let values: f64 = chords.iter().map(value).sum();
        let count = real(chords.len());
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
    pub(crate) fn merge(&mut self, other: &Self) {
        for (sum, term) in self.0.iter_mut().zip(other.0) {
            *sum += term;
        }
    }

    /// The mean over chords, with the standard error of a quotient of means over lines.
    pub(crate) fn mean(&self, lines: u32) -> ChordInformation {
        debug_assert!(lines >= 2, "{lines} lines have no standard error");
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
