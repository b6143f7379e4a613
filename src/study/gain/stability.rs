//! Digits that a gain loses when it is written naively.
//!
//! A state in two halves shares `p = 1 + d` and `q = 1 − d` with one state, `q` and `p` with
//! another, so that both halves weigh the same and `ΔI = ½ (φ(d) + φ(−d))/ln 2`, nearly `0.72 d²`:
//! d from 1 to 1e-15 takes ΔI from 1 bit to 1e-30. Each form is judged by an enclosure with 256
//! bits of the gain of the numbers it was given:
//!
//! * `difference`: `I′ − I` of the two chains, each by eq. (3), itself a stable sum;
//! * `equation-5`: eq. (5), second line, as it is printed;
//! * `sum-of-terms`: the sum of non-negative terms of [`refinement_gain`];
//! * the last two in single precision, for fluxes rounded to it.

use crate::chain::{ChainError, Refinement, ReversibleChain};
use crate::information::{mutual_information, refinement_gain};
use crate::numeric::{Interval, Scalar, x_log2_ratio};
use crate::reference::exact_gain;
use crate::study::Row;
use crate::study::run_time::mean_time;
use nalgebra::DMatrix;
use std::hint::black_box;

/// Bits of the enclosures that judge.
const JUDGE: u32 = 256;

/// The rows of the study; each evaluation is repeated `repetitions` times for its time.
///
/// # Errors
/// None that is known: the chains are valid by construction.
pub fn gain_stability(repetitions: u32) -> Result<Vec<Row>, ChainError> {
    let mut rows = Vec::new();
    for exponent in 0..=15 {
        let d = 10f64.powi(-exponent);
        let case = format!("gain of halves, d = 1e-{exponent}");
        let (p, q) = (1.0 + d, 1.0 - d);
        let refinement = halves(p, q)?;
        let mut add = |method: &str, exact: &Interval, form: &dyn Fn() -> f64| {
            let (gain, seconds) = mean_time(repetitions, form);
            let error = ((exact.constant(gain) - exact) / exact).abs().to_f64();
            let (case, value) = (case.clone(), exact.to_f64());
            rows.push(Row {
                case,
                method: method.to_owned(),
                value,
                relative_error: error,
                seconds,
            });
        };
        let exact = exact_gain(&refinement, JUDGE);
        add("difference", &exact, &|| {
            mutual_information(refinement.refined()) - mutual_information(refinement.coarse())
        });
        add("equation-5", &exact, &|| {
            equation_5(black_box(p), black_box(q))
        });
        add("sum-of-terms", &exact, &|| refinement_gain(&refinement));
        #[expect(clippy::cast_possible_truncation, reason = "the rounding is the point")]
        let [p, q] = [p as f32, q as f32];
        // below 6e-8 both round to 1 and there is no gain to compute
        if p > q {
            let exact = exact_gain(&halves(p.into(), q.into())?, JUDGE);
            add("equation-5, single", &exact, &|| {
                equation_5_single(p, q).into()
            });
            add("sum-of-terms, single", &exact, &|| {
                sum_of_terms_single(p, q).into()
            });
        }
    }
    Ok(rows)
}

fn halves(p: f64, q: f64) -> Result<Refinement, ChainError> {
    #[rustfmt::skip]
    let joint = DMatrix::from_row_slice(4, 4, &[
        0.0, 0.0, p, q,
        0.0, 0.0, q, p,
        p, q, 0.0, 0.0,
        q, p, 0.0, 0.0,
    ]);
    Refinement::coarsening(ReversibleChain::try_new(joint)?, vec![0, 0, 1, 2])
}

/// Eq. (5), second line, over both pairs: `2/Σw · 2 (p log2 P_p + q log2 P_q − (p+q) log2 P)` with
/// Σw = 4 (p+q), P_p = p/(p+q), P = 1/2.
fn equation_5(p: f64, q: f64) -> f64 {
    let weight = p + q;
    (x_log2_ratio(p, weight) + x_log2_ratio(q, weight) - weight * 0.5f64.log2()) / weight
}

/// Eq. (5), second line, in single precision.
fn equation_5_single(p: f32, q: f32) -> f32 {
    let weight = p + q;
    let term = |flux: f32| {
        if flux > 0.0 {
            flux * (flux / weight).log2()
        } else {
            0.0
        }
    };
    (term(p) + term(q) - weight * 0.5f32.log2()) / weight
}

/// `½ (φ(x) + φ(−x))/ln 2` with `x = (p−q)/(p+q)`, in single precision throughout.
fn sum_of_terms_single(p: f32, q: f32) -> f32 {
    let phi = |x: f32| {
        if x.abs() >= 0.25 {
            return if x > -1.0 {
                (1.0 + x) * x.ln_1p() - x
            } else {
                -x
            };
        }
        let z = x / (2.0 + x);
        let square = z * z;
        let tail = 1.0 / 3.0 + square * (1.0 / 5.0 + square * (1.0 / 7.0 + square / 9.0));
        2.0 * square * (1.0 + (1.0 + z) * z * tail) / (1.0 - z)
    };
    let x = (p - q) / (p + q); // the difference is exact: p/2 ≤ q or q is small
    0.5 * (phi(x) + phi(-x)) / std::f32::consts::LN_2
}
