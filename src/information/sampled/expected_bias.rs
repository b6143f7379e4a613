//! The expected bias of the plug-in estimate of a mutual information, exactly, for given
//! probabilities.
//!
//! ```text
//!   Î = Σ_c (k_c/N) log2( k_c/(N m_c) ),   k_c ~ Bin(N, p_c)
//!   E[Î] − I = Σ_c p_c E[φ(x_c)] / ln 2,   x_c = k_c/(N p_c) − 1
//! ```
//!
//! with φ of [`divergence_kernel`], because Σ is linear and `E[x_c] = 0`: every term is ≥ 0, and
//! the bias does not depend on the distribution m that the estimate is compared with. It tends to
//! `(K − 1)/(2N ln 2)` for K cells. If the weights are counted, too, and no state meets itself,
//! each state is an end of `Bin(N, 2w_i)` chords, and the sum over the probabilities `2w_i` is to
//! be subtracted.
//!
//! Where `μ = Np` is small, `E[φ]` is summed over the binomial distribution outwards from its mode,
//! until the terms no longer change the sum. Where it is large,
//!
//! ```text
//!   E[φ(x)] = Σ_{r=2}^{11} (−1)^r E[x^r]/(r(r−1)) + R,     0 ≤ R ≤ E[x¹²]/11
//! ```
//!
//! (the remainder over x¹² falls with x, and is 1/11 at x = −1), and the moments follow
//! Romanovsky's recursion. The next term of the series, `E[x¹²]/132`, is taken for R.
//!
//! **Not covered**: lines with several chords, whose number of chords is itself random; states that
//! meet themselves, for counted weights.
//!
//! References: Miller, *Note on the bias of information estimates*, 1955; Romanovsky, Biometrika
//! 15, 1923.

use crate::chain::ChainError;
use crate::exchange::ScenePairs;
use crate::form_factor::ExchangeArea;
use crate::information::scene::{OpenScene, PairTerms, SceneInformation, information_with_sums};
use crate::numeric::functions::elementary::ln;
use crate::numeric::{CompensatedSum, compensated_sum, divergence_kernel, real};
use std::f64::consts::LN_2;

/// The expected number from which on the series is used: (a) there R ≤ 945/μ⁶ + O(μ⁻⁷) is 1e-15.
const SERIES_FROM: f64 = 1000.0;

/// The expected bias `E[Î] − I` in bits, of N samples of cells with these probabilities, when the
/// weights are known.
///
/// **Arguments** probabilities from 0 to 1, each with the number of cells that have it; `samples` N
/// ≥ 1.
/// **Accuracy** relative error below 1e-11, held by `expected_bias_is_that_of_all_outcomes` and
/// `both_ways_to_the_expected_bias_agree`.
///
/// # Examples
/// ```
/// use infoscene::information::expected_bias;
/// // two throws of a fair coin: with probability 1/2 the estimate of a divergence of 0 is 1 bit
/// assert!((expected_bias([(0.5, 2.0)], 2) - 0.5).abs() < 1e-15);
/// ```
#[must_use]
pub fn expected_bias(cells: impl IntoIterator<Item = (f64, f64)>, samples: u64) -> f64 {
    let samples = real(samples);
    let cells = cells.into_iter();
    let terms = cells.map(|(probability, count)| {
        if probability > 0.0 {
            count * probability * mean_kernel(samples, probability)
        } else {
            0.0
        }
    });
    compensated_sum(terms) / LN_2
}

/// The standard deviation of the plug-in estimate, in bits, to second order.
///
/// `Var Î = (1/N) Σ p_c d_c² + (K − 1)/(2N²)` in nats, with `d_c = ln(p_c/m_c) − I`;
/// [`PairCounts`](crate::information::PairCounts) estimates it from counts.
///
/// **Arguments** for each class of cells the probability p, the probability m of independent
/// states, and the number of such cells; `samples` N ≥ 1.
#[must_use]
pub fn expected_deviation(cells: impl IntoIterator<Item = ([f64; 2], f64)>, samples: u64) -> f64 {
    let mut sums = [CompensatedSum::default(); 3];
    let possible = cells.into_iter().filter(|([p, m], _)| *p > 0.0 && *m > 0.0);
    for ([p, m], count) in possible {
        let logarithm = ln(p / m);
        let terms = [
            count,
            count * p * logarithm,
            count * p * logarithm * logarithm,
        ];
        sums.iter_mut()
            .zip(terms)
            .for_each(|(sum, term)| sum.add(term));
    }
    let [count, mean, square] = sums.each_ref().map(CompensatedSum::total);
    let variance = (square - mean * mean).max(0.0);
    let n = real(samples);
    (variance / n + 0.5 * (count - 1.0).max(0.0) / (n * n)).sqrt() / LN_2
}

/// The expected bias `E[Î] − I` in bits, of N chords of a closed scene, when the weights are
/// known.
///
/// # Errors
/// [`ChainError::Exchange`] if two patches are refused, or the scene is open.
pub fn expected_bias_of_scene(pairs: &ScenePairs, samples: u64) -> Result<f64, ChainError> {
    let samples = real(samples);
    let total = compensated_sum(pairs.areas().iter().copied());
    let (sums, _) =
        pairs.row_sums(|i, j, exchange| [bias_term(samples, exchange.value / total, i == j)])?;
    Ok(compensated_sum(sums.iter().map(|[sum]| *sum)) / LN_2)
}

/// The information of a closed scene's visibility chain, and the expected bias of its plug-in
/// estimate from N chords, from one pass over the pairs.
///
/// The numbers are those of [`scene_information`](crate::information::scene_information) and
/// [`expected_bias_of_scene`].
///
/// **Arguments** `samples` N ≥ 1.
///
/// # Errors
/// [`ChainError::Scene`] if two patches are refused, or the scene is open.
pub fn scene_information_and_bias(
    pairs: &ScenePairs,
    samples: u64,
) -> Result<(SceneInformation, f64), ChainError> {
    let samples = real(samples);
    let total = compensated_sum(pairs.areas().iter().copied());
    let with_bias = |[i, j]: [usize; 2], exchange: &ExchangeArea, [a, b, c, d]: PairTerms| {
        [
            a,
            b,
            c,
            d,
            bias_term(samples, exchange.value / total, i == j),
        ]
    };
    let (information, sums) = information_with_sums(pairs.into(), OpenScene::Refuse, with_bias)?;
    let bias = compensated_sum(sums.iter().map(|[.., bias]| *bias)) / LN_2;
    Ok((information, bias))
}

/// The term of a pair in the bias of one of its two rows, in nats, from its share of the total in
/// one direction.
fn bias_term(samples: f64, share: f64, is_diagonal: bool) -> f64 {
    // a pair counts in the sums of both of its rows
    let cell = if is_diagonal { share } else { 2.0 * share };
    if cell > 0.0 {
        share * mean_kernel(samples, cell)
    } else {
        0.0
    }
}

/// The mean `E[φ(k/(Np) − 1)]`, k binomial.
///
/// **Arguments** `samples` ≥ 1, `probability` > 0; rounding above 1 counts as 1.
fn mean_kernel(samples: f64, probability: f64) -> f64 {
    debug_assert!(
        samples >= 1.0 && probability > 0.0,
        "{samples}, {probability}"
    );
    if probability >= 1.0 {
        0.0
    } else if samples * probability >= SERIES_FROM {
        by_moments(samples, probability)
    } else {
        by_summation(samples, probability)
    }
}

/// The mean by summation over the distribution, outwards from its mode.
fn by_summation(samples: f64, probability: f64) -> f64 {
    let mean = samples * probability;
    let odds = probability / (1.0 - probability);
    let mode = ((samples + 1.0) * probability).floor().min(samples);
    let kernel = |k: f64| divergence_kernel((k - mean) / mean);
    let (mut mass, mut sum) = (1.0, kernel(mode));
    let (mut weight, mut k) = (1.0, mode);
    while k < samples {
        weight *= (samples - k) / (k + 1.0) * odds;
        k += 1.0;
        let term = weight * kernel(k);
        (mass, sum) = (mass + weight, sum + term);
        if weight < f64::EPSILON * mass && term < 0.01 * f64::EPSILON * sum {
            break;
        }
    }
    (weight, k) = (1.0, mode);
    while k > 0.0 {
        weight *= k / ((samples - k + 1.0) * odds);
        k -= 1.0;
        let term = weight * kernel(k);
        (mass, sum) = (mass + weight, sum + term);
        // below the mode the kernel stays below 1
        if weight < 0.01 * f64::EPSILON * sum {
            break;
        }
    }
    sum / mass
}

/// The highest moment of the series, that of [`SERIES_FROM`].
const MOMENTS: usize = 12;

/// The mean by the series in the moments of the distribution.
fn by_moments(samples: f64, probability: f64) -> f64 {
    let mean = samples * probability;
    // E[x^r], x = k/μ − 1
    let mut moments = [0.0; MOMENTS + 1];
    moments[0] = 1.0;
    for r in 1..MOMENTS {
        let (mut binomial, mut power) = (1.0, mean.powi(-i32::try_from(r).unwrap_or(0)));
        let mut next = 0.0;
        for j in 0..r {
            next += binomial
                * power
                * ((1.0 - probability) * moments[j] - probability * moments[j + 1]);
            let (from, to) = (real(r - j), real(j + 1));
            binomial *= from / to;
            power *= mean;
        }
        moments[r + 1] = next;
    }
    let term = |r: usize| {
        let order = real(r);
        let sign = if r.is_multiple_of(2) { 1.0 } else { -1.0 };
        sign * moments[r] / (order * (order - 1.0))
    };
    (2..=MOMENTS).rev().map(term).sum()
}
