//! The measured information of a scene, as records.

use crate::exchange::PlanSummary;
use crate::information::{
    ChordInformation, ContinuousInformation, FacePair, PairLoss, SceneInformation,
};
use crate::numeric::Grade;
use crate::question::unreached::Unreached;
use crate::scene::{Channel, NamedPatch, Scene};

/// The information of a scene, as a record whose keys are relied on by scripts.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[non_exhaustive]
pub struct MeasureAnswer {
    /// The channel of colour, if one was named.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub channel: Option<Channel>,
    /// The number of rows: patches, of which those that are summed count as one.
    pub patches: usize,
    /// The sum of their areas.
    pub total_area: f64,
    /// Do all rows of form factors sum to one?
    pub closed: bool,
    /// Positional entropy, eq. (1), in bits.
    pub positional_entropy: f64,
    /// Entropy rate, eq. (2), in bits.
    pub entropy_rate: f64,
    /// Mutual information, eq. (3), in bits.
    pub mutual_information: f64,
    /// Continuous mutual information, eq. (4), in bits, if it was asked for.
    pub continuous_mutual_information: Option<f64>,
    /// The error of the continuous mutual information.
    pub continuous_error: Option<f64>,
    /// The grade of its error: of a sample the error is a standard error.
    pub continuous_error_grade: Option<Grade>,
    /// A lower bound on it, if it is sampled: the discrete one less its error.
    pub continuous_lower_bound: Option<f64>,
    /// The number of random lines, if it is sampled.
    pub continuous_lines: Option<u32>,
    /// The terms of pairs of faces in it, both directions together.
    pub continuous_contributions: Option<Vec<FacePairRecord>>,
    /// The terms of pairs of patches in (3) and (4), and their differences.
    pub pair_losses: Option<Vec<PairLossRecord>>,
    /// The error of the mutual information.
    pub mutual_information_error: f64,
    /// The length by which each coordinate may be off.
    pub resolution: f64,
    /// A bound on what that can change of the mutual information, beside its error; an estimate
    /// for an open scene, and none under a light.
    pub resolution_error: Option<f64>,
    /// A bound on what it can change of the positional entropy; that of the entropy rate is at most
    /// the sum of both.
    pub entropy_resolution_error: Option<f64>,
    /// The grade of its error.
    pub error_grade: Grade,
    /// The row of form factors whose sum is farthest from one.
    pub closure: RowSumRecord,
    /// The terms of eq. (3), by row.
    pub contributions: Vec<Contribution>,
    /// The term of the state `outside`, if there is one.
    pub outside_contribution: Option<f64>,
    /// The pairs that were left out, shared and computed.
    pub plan: PlanSummary,
    /// The number of faces of the room, if the continuous mutual information was asked for.
    #[serde(skip)]
    pub faces: Option<usize>,
    /// The pairs that miss the tolerance, if some do.
    #[serde(skip)]
    pub unreached: Option<Unreached>,
    /// Remarks of the scene's reader.
    #[serde(skip)]
    pub notes: Vec<String>,
}

/// Two faces of a convex room, each named by its first patch.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct FacePairRecord {
    /// The names of the first patches.
    pub faces: [String; 2],
    /// The indices of the patches.
    pub patches: [usize; 2],
    /// The probability of a transition between the two.
    pub probability: f64,
    /// The term of the pair in (4), in bits; may be negative.
    pub mutual_information: f64,
}

/// Two patches, both directions together.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct PairLossRecord {
    /// The indices of the patches.
    pub patches: [usize; 2],
    /// The probability of a transition between the two.
    pub probability: f64,
    /// The term of the pair in (3), in bits; may be negative.
    pub mutual_information: f64,
    /// The term of the pair in (4), in bits; may be negative.
    pub continuous_mutual_information: f64,
    /// The difference of the two, ≥ 0 but for the error.
    pub loss: f64,
    /// The estimated absolute error of each of the three.
    pub error: f64,
}

impl PairLossRecord {
    pub(super) fn new(pair: &PairLoss, scene: &Scene) -> Self {
        Self {
            patches: [pair.first, pair.second].map(|patch| scene.group_of(patch)),
            probability: pair.probability,
            mutual_information: pair.mutual_information,
            continuous_mutual_information: pair.continuous_mutual_information,
            loss: pair.loss,
            error: pair.error,
        }
    }
}

/// The sum of a row of form factors.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct RowSumRecord {
    /// The row, from 0.
    pub patch: usize,
    /// The name of the row.
    pub name: String,
    /// The sum.
    pub row_sum: f64,
    /// A bound on its error.
    pub error: f64,
    /// A bound on what the resolution can change of a sum of one.
    pub resolution_error: f64,
}

/// The term of a row in eq. (3).
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Contribution {
    /// The row, from 0.
    pub patch: usize,
    /// The name of the row.
    pub name: String,
    /// The stationary probability.
    pub weight: f64,
    /// The term, in bits.
    pub mutual_information: f64,
    /// The sum of its form factors.
    pub row_sum: f64,
}

impl MeasureAnswer {
    /// The discrete measures of a scene whose rows have these names.
    pub(super) fn new(names: &[&str], measured: SceneInformation) -> Self {
        let closure = &measured.closure;
        let worst = closure.worst();
        let rows = measured.contributions.iter().zip(closure.rows());
        let contributions = rows.map(|(information, row)| Contribution {
            patch: row.row,
            name: names[row.row].to_owned(),
            weight: measured.weights[row.row],
            mutual_information: *information,
            row_sum: row.sum,
        });
        Self {
            channel: None,
            patches: names.len(),
            total_area: measured.total_area,
            closed: closure.is_closed(),
            positional_entropy: measured.positional_entropy,
            entropy_rate: measured.entropy_rate,
            mutual_information: measured.mutual_information.value,
            continuous_mutual_information: None,
            continuous_error: None,
            continuous_error_grade: None,
            continuous_lower_bound: None,
            continuous_lines: None,
            continuous_contributions: None,
            pair_losses: None,
            mutual_information_error: measured.mutual_information.error,
            resolution: 0.0,
            resolution_error: measured.resolution.map(|bounds| bounds.mutual_information),
            entropy_resolution_error: measured.resolution.map(|bounds| bounds.positional_entropy),
            error_grade: measured.mutual_information.grade,
            closure: RowSumRecord {
                patch: worst.row,
                name: names[worst.row].to_owned(),
                row_sum: worst.sum,
                error: worst.error,
                resolution_error: worst.resolution_error,
            },
            contributions: contributions.collect(),
            outside_contribution: measured.outside_contribution,
            plan: measured.summary.plan,
            faces: None,
            unreached: None,
            notes: Vec::new(),
        }
    }

    /// Adds the sampled continuous mutual information, and what is known of it from below.
    pub(super) fn add_sampled(&mut self, chords: ChordInformation, is_visibility: bool) {
        self.continuous_mutual_information = Some(chords.mutual_information);
        self.continuous_error = Some(chords.standard_error);
        self.continuous_error_grade = Some(Grade::Sample);
        self.continuous_lines = Some(chords.lines);
        // Corollary 1 is of the chain of visibility
        let lower = self.mutual_information - self.mutual_information_error;
        self.continuous_lower_bound = is_visibility.then_some(lower.max(0.0));
    }

    pub(super) fn add_continuous(&mut self, scene: &Scene, found: &ContinuousInformation) {
        let names: Vec<&str> = scene.patches().iter().map(NamedPatch::name).collect();
        let first = |face: usize| {
            let mut faces = found.face_of.iter();
            faces.position(|of| *of == face).unwrap_or(0)
        };
        let record = |pair: &FacePair| {
            let patches = [first(pair.first), first(pair.second)];
            FacePairRecord {
                faces: patches.map(|patch| names[patch].to_owned()),
                patches: patches.map(|patch| scene.group_of(patch)),
                probability: pair.probability,
                mutual_information: pair.mutual_information,
            }
        };
        self.continuous_mutual_information = Some(found.mutual_information.value);
        self.continuous_error = Some(found.mutual_information.error);
        self.continuous_error_grade = Some(found.mutual_information.grade);
        self.continuous_contributions = Some(found.pairs.iter().map(record).collect());
        self.faces = Some(found.faces);
    }
}
