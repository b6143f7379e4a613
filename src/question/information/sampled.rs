//! Mutual information from random lines, as a record.

use crate::information::LineSample;
use crate::numeric::Grade;

/// Estimates of mutual information from the pairs that random lines met, in bits.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct SampledInformation {
    /// The number of lines.
    pub lines: u32,
    /// The seed that they were drawn from.
    pub seed: u64,
    /// The way they were drawn: `"local"` or `"global"`.
    pub kind: &'static str,
    /// The number of chords: several for a line where a room is not convex.
    pub samples: u64,
    /// The number of pairs that were met.
    pub occupied_cells: usize,
    /// The part of the samples that are alone in their cell.
    pub unseen: f64,
    /// The amount that the corrected estimate takes off for pairs not met.
    pub taken_for_unseen: f64,
    /// The plug-in estimate with the areas known.
    pub mutual_information: f64,
    /// The mean distance of the plug-in estimate above the exact value, where that is known.
    pub expected_bias: Option<f64>,
    /// The plug-in estimate with the areas counted, too.
    pub counted_weights: f64,
    /// The estimate less the bias by Miller and Madow.
    pub miller_madow: f64,
    /// The estimate corrected by Chao, Wang and Jost.
    pub corrected: f64,
    /// The standard error of each.
    pub standard_error: f64,
    /// The grade of that error.
    pub error_grade: Grade,
    /// An interval of 95 % around the corrected estimate; none if too much is unseen.
    pub confidence_interval: Option<[f64; 2]>,
    /// The exact mutual information, where it is known.
    pub exact_mutual_information: Option<f64>,
}

impl SampledInformation {
    /// Constructs the record of a sample; beside it the exact mutual information and the expected
    /// bias, where they are known.
    pub(crate) fn new(sample: &LineSample, seed: u64, exact: Option<[f64; 2]>) -> Self {
        let counts = &sample.counts;
        Self {
            lines: sample.lines,
            seed,
            kind: sample.kind.name(),
            samples: counts.samples(),
            occupied_cells: counts.occupied(),
            unseen: counts.unseen(),
            taken_for_unseen: counts.taken_for_unseen(),
            mutual_information: counts.plug_in(),
            expected_bias: exact.map(|[_, bias]| bias),
            counted_weights: counts.plug_in_of_counted_weights(),
            miller_madow: counts.miller_madow(),
            corrected: counts.corrected(),
            standard_error: counts.standard_error(),
            error_grade: Grade::Sample,
            confidence_interval: counts.confidence_interval(),
            exact_mutual_information: exact.map(|[information, _]| information),
        }
    }
}
