//! The answer to the question for everything that a report shows.

use crate::claims::{Claim, Judgement, Task, Verdict};
use crate::question::{
    CutsAnswer, GridAnswer, JudgedClaim, RefineAnswer, ReproduceAnswer, StudyAnswer, StudySubject,
};

/// Everything that a report shows, computed.
#[derive(Debug, Clone)]
pub struct ReportAnswer {
    /// Is it the quick report, of fewer claims and studies?
    pub is_quick: bool,
    /// Every claim, in paper order; in a quick report some are not judged.
    pub claims: Vec<ReportedClaim>,
    /// The claims that were judged, as their computations left them.
    pub judgements: Vec<Judgement>,
    /// The cuts of §4.2 for n = 1 to 4 in both readings, enclosed.
    pub cuts: CutsAnswer,
    /// The cuts of §4.2 for a rising exponent in both readings.
    pub rising_cuts: CutsAnswer,
    /// Mutual information of 3 × 3 cells on the faces of a cube against the first line, on the axis
    /// of fig. 4: 10 is half an edge.
    pub first_lines: Vec<[f64; 2]>,
    /// The regular grids of a cube, by cells an edge from 1 on.
    pub regular_grids: Vec<GridAnswer>,
    /// The best grids of a cube, by cells an edge from 2 on.
    pub best_grids: Vec<GridAnswer>,
    /// The studies.
    pub studies: Vec<ReportedStudy>,
    /// Rooms whose meshes the default oracle refined.
    pub meshes: Vec<RefineAnswer>,
    /// The scenes of the figures.
    pub scenes: Vec<ReportedScene>,
    /// The run times of its parts.
    pub timings: Vec<PartTime>,
    /// The machine that took these times.
    pub machine: Machine,
}

/// A claim with all that its entry in a report shows.
#[derive(Debug, Clone)]
pub struct ReportedClaim {
    /// The claim as it stands in the data.
    pub claim: Claim,
    /// The claim as judged by this run; none if a quick report leaves it out.
    pub judged: Option<JudgedClaim>,
    /// The run time of its computation, in seconds; what it shares with others is counted with one
    /// of them.
    pub seconds: Option<f64>,
}

impl ReportedClaim {
    /// The verdict of this run, or the one on record where the run leaves the claim out.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        match (&self.judged, &self.claim.task) {
            (Some(judged), _) => judged.verdict,
            (None, Task::Compute { recorded, .. } | Task::AllOf { recorded, .. }) => *recorded,
            (
                None,
                Task::Proved {
                    is_refuted: true, ..
                },
            ) => Verdict::Refuted,
            (None, Task::Proved { .. }) => Verdict::Confirmed,
            (None, Task::NotChecked { .. }) => Verdict::NotChecked,
        }
    }
}

/// A study with its rows.
#[derive(Debug, Clone, PartialEq)]
pub struct ReportedStudy {
    /// The subject.
    pub subject: StudySubject,
    /// The rows.
    pub answer: StudyAnswer,
}

/// A scene to be shown small.
#[derive(Debug, Clone, PartialEq)]
pub struct ReportedScene {
    /// The name under which figures ask for it.
    pub name: &'static str,
    /// The corners of its patches.
    pub patches: Vec<Vec<[f64; 3]>>,
    /// The patch that is cut, if one is.
    pub cut_patch: Option<usize>,
    /// Lines drawn on patches, such as a cut.
    pub lines: Vec<[[f64; 3]; 2]>,
}

/// The run time of a part of a report.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct PartTime {
    /// The part: `claims`, the name of a study, ….
    pub part: &'static str,
    /// The command that computes it alone.
    pub command: String,
    /// The run time of the command, in seconds.
    pub seconds: f64,
}

/// The machine that a report was computed on.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize)]
pub struct Machine {
    /// Threads that could run at once.
    pub cores: usize,
    /// The processor, as the system names it.
    pub processor: String,
    /// The compiler of the program.
    pub compiler: &'static str,
    /// Was the program compiled in release mode?
    pub is_release: bool,
}

impl ReportAnswer {
    /// The claims that were judged, as an answer of their own.
    #[must_use]
    pub fn reproduction(&self) -> ReproduceAnswer {
        ReproduceAnswer {
            claims: self
                .claims
                .iter()
                .filter_map(|claim| claim.judged.clone())
                .collect(),
        }
    }

    /// The ids of the claims that a quick report leaves out.
    #[must_use]
    pub fn left_out(&self) -> Vec<&str> {
        let claims = self.claims.iter().filter(|claim| claim.judged.is_none());
        claims.map(|claim| claim.claim.id.as_str()).collect()
    }

    /// The rows of a study; none if a quick report leaves it out.
    #[must_use]
    pub fn study(&self, subject: StudySubject) -> Option<&StudyAnswer> {
        let mut studies = self.studies.iter();
        let study = studies.find(|study| study.subject == subject)?;
        Some(&study.answer)
    }

    /// The curve of a claim's figure; none if the claim was left out or has none.
    #[must_use]
    pub fn curve(&self, id: &str) -> Option<&[[f64; 2]]> {
        let claim = self.claims.iter().find(|claim| claim.claim.id == id)?;
        let curve = &claim.judged.as_ref()?.curve;
        (!curve.is_empty()).then_some(curve)
    }
}

impl Machine {
    /// The machine that the program runs on.
    #[must_use]
    pub fn this_one() -> Self {
        let listed = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
        let name = listed
            .lines()
            .find_map(|line| line.strip_prefix("model name"));
        let name = name.map(|name| name.trim_start_matches([' ', '\t', ':']).to_owned());
        Self {
            cores: std::thread::available_parallelism().map_or(1, usize::from),
            processor: name.unwrap_or_else(|| format!("unnamed, {}", std::env::consts::ARCH)),
            compiler: env!("INFOSCENE_COMPILER"),
            is_release: env!("INFOSCENE_PROFILE") == "release",
        }
    }
}
