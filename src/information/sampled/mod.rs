//! Mutual information estimated from random lines, with its bias and its standard error.
//!
//! The chords of random lines tell which pairs of patches exchange light, whatever stands between
//! others: the first front that a line meets is the visible one. The estimates are therefore those
//! of any closed room, concave or occluded. `line_sample` draws the lines and counts the pairs,
//! `pair_counts` turns counts into estimates, `expected_bias` computes their bias exactly where the
//! probabilities are known, `chords` estimates the continuous mutual information from the same
//! lines.
//!
//! ```text
//!   plug-in       above the exact value by about (pairs)/(2 N ln 2) for N lines
//!   corrected     by Chao, Wang and Jost; a fifth of the unseen part is still missing
//! ```
//!
//! The corrected estimate has an interval of 95 % once that fifth is below the standard error. Over
//! 200 seeds of several scenes the intervals covered the exact values in 187 to 196, and the exact
//! continuous ones in 182 to 196 (`coverage_over_200_seeds`).
//!
//! Closed forms are faster and more accurate wherever they apply. Absolute errors for the inside of
//! a cube, 216 patches, where closed forms err by 4e-13 bit (`infoscene study sampling`):
//!
//! | lines | plug-in, bits | Miller and Madow | corrected |
//! |---|---|---|---|
//! | 10⁵ | 0.15 | 0.028 | 0.0076 |
//! | 10⁷ | 0.0016 | 0.00058 | 0.00058 |
//!
//! The corrected error falls as N^−0.51 to N^−0.57 where pairs are met often (24 and 60 patches,
//! 10³ and 10⁴ to 10⁷ lines); that of the plug-in estimate falls nearly as 1/N until its bias no
//! longer governs.
//!
//! ```
//! use infoscene::information::{LineKind, LineSample};
//! use infoscene::scene::Scene;
//!
//! let cube = LineSample::draw(&Scene::built_in("cube:2")?, LineKind::Local, 50_000, 1)?;
//! let [from, to] = cube.counts.confidence_interval().ok_or("pairs are met often")?;
//! assert!(from < 0.769_765_173_793_8 && 0.769_765_173_793_8 < to);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Not covered**: open scenes; quasi-random lines, for which neither the correction nor the
//! standard error holds.
//!
//! Reference: Chao, Wang and Jost, "Entropy and the species accumulation curve", *Methods in
//! Ecology and Evolution* 4 (2013), 1091–1100.

pub(crate) mod chords;
pub(crate) mod expected_bias;
pub(crate) mod line_sample;
pub(crate) mod pair_counts;
