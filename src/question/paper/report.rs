//! Everything that a report shows, asked for at once.

use super::reported::{
    Machine, PartTime, ReportAnswer, ReportedClaim, ReportedScene, ReportedStudy,
};
use crate::claims::{Claim, Context, DEFAULT_PRECISION, Judgement, judge_all, registry};
use crate::exchange::{Progress, Unheard};
use crate::hierarchy::Goal;
use crate::question::{
    Cuts, CutsAnswer, Grid, GridAnswer, GridLines, IrradianceExponent, JudgedClaim, NetWish,
    QuestionError, Refine, RefineAnswer, SceneSource, Study, StudySubject,
};
use std::collections::BTreeMap;
use std::sync::Mutex;
use std::time::Instant;

/// The question for everything that a report shows.
///
/// # Examples
/// ```no_run
/// use infoscene::exchange::Unheard;
/// use infoscene::question::Report;
/// let answer = Report { is_quick: true }.ask(&Unheard)?;
/// assert!(answer.reproduction().is_as_recorded());
/// # Ok::<(), infoscene::question::QuestionError>(())
/// ```
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Report {
    /// Are claims and studies that take seconds left out?
    pub is_quick: bool,
}

/// Claims that take a second and more, of which a quick report shows the verdict on record.
const SLOW_CLAIMS: [&str; 13] = [
    "s2-finer-grids-know-more",
    "s2-discretizing-loses",
    "eq4-limit",
    "fig4-optimum",
    "fig4-cases",
    "fig4-displaced-towards-the-edges",
    "fig5-optimal",
    "fig5-order",
    "s6-oracle-is-useful",
    "s6-minimises-error",
    "appB2-limit",
    "appB2-penumbra",
    "appB2-plate",
];

/// The studies: subject, name in the command, tenths of a second that one takes about, and whether
/// a quick report has it.
const STUDIES: [(StudySubject, &str, u64, bool); 13] = [
    (StudySubject::Accuracy, "accuracy", 15, true),
    (StudySubject::Tolerances, "tolerances", 60, true),
    (StudySubject::Stability, "stability", 35, false),
    (StudySubject::Precision, "precision", 10, true),
    (StudySubject::Limits, "limits", 3, true),
    (StudySubject::Profiles, "profiles", 1, true),
    (StudySubject::Directions, "directions", 1, true),
    (StudySubject::Walks, "walks", 1, true),
    (StudySubject::Refinement, "refinement", 100, false),
    (StudySubject::Sampling, "sampling", 5, true),
    (StudySubject::Figure5, "figure-5", 15, true),
    (StudySubject::Oracles, "oracles", 60, false),
    (StudySubject::Information, "information", 10, true),
];

/// Tenths of a second that a claim takes on average, and the grids of figs. 4 and 5.
const CLAIM: usize = 3;
const GRIDS: usize = 10;
/// Cells an edge up to which a figure has regular and best grids.
const MOST_REGULAR: u32 = 10;
const MOST_BEST: u32 = 6;
/// Places of the first line in fig. 4.
const FIRST_LINES: u32 = 80;

impl Report {
    /// Computes the answer; progress advances by about one in a tenth of a second.
    ///
    /// # Errors
    /// [`QuestionError`] of the part that is refused; none is known to be.
    pub fn ask(&self, progress: &dyn Progress) -> Result<ReportAnswer, QuestionError> {
        let is_asked = |id: &str| !self.is_quick || !SLOW_CLAIMS.contains(&id);
        let mut asked = registry()?;
        asked.retain(|claim| is_asked(&claim.id));
        let studies = STUDIES.iter();
        let studies = studies.filter(|(_, _, _, is_quick)| *is_quick || !self.is_quick);
        let long: u64 = studies.clone().map(|(_, _, tenths, _)| tenths).sum();
        progress.begin(
            (CLAIM * asked.len() + GRIDS) as u64 + long,
            "tenths of a second",
        );
        let mut timings = Timings::default();
        let times = Mutex::new(BTreeMap::new());
        let judgements = timings.of("claims", "infoscene reproduce".to_owned(), || {
            let context = Context::new(DEFAULT_PRECISION);
            judge_all(&asked, &context, |claim, time| {
                progress.advance(CLAIM);
                if let Ok(mut times) = times.lock() {
                    times.insert(claim.id.clone(), time.as_secs_f64());
                }
            })
        })?;
        timings.of_claims = times.into_inner().unwrap_or_default();
        let subjects: Vec<StudySubject> = studies.map(|(subject, _, _, _)| *subject).collect();
        self.gathered(judgements, &subjects, timings, progress)
    }

    /// Computes the answer around claims that are judged already, with these studies only.
    ///
    /// # Errors
    /// As [`ask`](Self::ask).
    pub fn gather(
        &self,
        judgements: Vec<Judgement>,
        subjects: &[StudySubject],
    ) -> Result<ReportAnswer, QuestionError> {
        self.gathered(judgements, subjects, Timings::default(), &Unheard)
    }

    fn gathered(
        &self,
        judgements: Vec<Judgement>,
        subjects: &[StudySubject],
        mut timings: Timings,
        progress: &dyn Progress,
    ) -> Result<ReportAnswer, QuestionError> {
        let command = "infoscene grid --box 1,1,1 --cells 6 --optimize".to_owned();
        let grids = timings.of("grids", command, grids)?;
        progress.advance(GRIDS);
        let rising: Vec<f64> = (0..=40).map(|k| 10f64.powf(f64::from(k) / 20.0)).collect();
        let studies = STUDIES.iter().filter(|study| subjects.contains(&study.0));
        let studies = studies.map(|(subject, name, tenths, _)| {
            let question = Study {
                subject: *subject,
                quick: true,
            };
            let command = format!("infoscene study {name} --quick");
            let answer = timings.of(name, command, || question.ask(&Unheard))?;
            progress.advance(usize::try_from(*tenths).unwrap_or(0));
            Ok(ReportedStudy {
                subject: *subject,
                answer,
            })
        });
        let studies = studies.collect::<Result<Vec<_>, QuestionError>>()?;
        let command = format!("infoscene refine {} --elements {ELEMENTS}", MESHES[0]);
        let meshes = timings.of("meshes", command, || -> Result<Vec<_>, QuestionError> {
            MESHES.into_iter().map(mesh).collect()
        })?;
        let claims = reported(registry()?, &judgements, &timings);
        Ok(ReportAnswer {
            meshes,
            is_quick: self.is_quick,
            scenes: scenes(&claims)?,
            claims,
            judgements,
            cuts: cuts(&[1.0, 2.0, 3.0, 4.0], Some(DEFAULT_PRECISION))?,
            rising_cuts: cuts(&rising, None)?,
            first_lines: grids.first_lines,
            regular_grids: grids.regular,
            best_grids: grids.best,
            studies,
            timings: timings.of_parts,
            machine: Machine::this_one(),
        })
    }
}

/// Run times.
#[derive(Default)]
struct Timings {
    of_parts: Vec<PartTime>,
    /// Seconds by the id of the claim.
    of_claims: BTreeMap<String, f64>,
}

impl Timings {
    /// Runs a part and notes its time.
    fn of<T>(&mut self, part: &'static str, command: String, run: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let answer = run();
        self.of_parts.push(PartTime {
            part,
            command,
            seconds: start.elapsed().as_secs_f64(),
        });
        answer
    }
}

/// Every claim beside its judgement.
fn reported(claims: Vec<Claim>, judgements: &[Judgement], timings: &Timings) -> Vec<ReportedClaim> {
    let judged = |id: &str| judgements.iter().find(|judged| judged.claim.id == id);
    let claims = claims.into_iter().map(|claim| ReportedClaim {
        judged: judged(&claim.id).map(JudgedClaim::from),
        seconds: timings.of_claims.get(&claim.id).copied(),
        claim,
    });
    claims.collect()
}

/// The cuts of §4.2, as printed (irradiance ∝ l) and under the hypotheses (∝ B).
fn cuts(exponents: &[f64], precision: Option<u32>) -> Result<CutsAnswer, QuestionError> {
    let question = Cuts {
        exponents: exponents.to_vec(),
        irradiance: vec![
            IrradianceExponent::Fixed(1.0),
            IrradianceExponent::OfRadiosity,
        ],
        precision,
    };
    question.ask(&Unheard)
}

/// The grids of figs. 4 and 5.
struct CubeGrids {
    first_lines: Vec<[f64; 2]>,
    regular: Vec<GridAnswer>,
    best: Vec<GridAnswer>,
}

fn grids() -> Result<CubeGrids, QuestionError> {
    let grid = |lines: GridLines| {
        let question = Grid {
            lines,
            ..Grid::default()
        };
        question.ask(&Unheard)
    };
    let first_lines = (1..FIRST_LINES).map(|k| {
        let share = f64::from(k) / f64::from(FIRST_LINES);
        let line = 0.5 * share;
        let information = grid(GridLines::At(vec![line, 1.0 - line]))?.mutual_information;
        Ok([10.0 * share, information])
    });
    let first_lines = first_lines.collect::<Result<_, QuestionError>>()?;
    let regular = (1..=MOST_REGULAR).map(|cells| grid(GridLines::Regular { cells }));
    let best = (2..=MOST_BEST).map(|cells| grid(GridLines::Best { cells }));
    Ok(CubeGrids {
        first_lines,
        regular: regular.collect::<Result<_, _>>()?,
        best: best.collect::<Result<_, _>>()?,
    })
}

/// The rooms whose refined meshes are drawn, and the elements of each.
const MESHES: [&str; 2] = ["lit-cube", "shaded-cube"];
const ELEMENTS: usize = 200;

/// The mesh of a room by the default oracle, with its net.
fn mesh(scene: &str) -> Result<RefineAnswer, QuestionError> {
    let question = Refine {
        scene: scene.into(),
        goal: Goal::Elements(ELEMENTS),
        net: Some(NetWish::default()),
        ..Refine::default()
    };
    question.ask(&Unheard)
}

/// The scenes of the figures, each with the claim that is the best cut of its first patch.
const SCENES: [(&str, Option<&str>); 4] = [
    ("two-squares", Some("fig2-parallel-cut")),
    ("three-squares", Some("fig3-cut")),
    ("cube:3", None),
    ("cornell-box", None),
];

/// The scenes of the figures.
fn scenes(claims: &[ReportedClaim]) -> Result<Vec<ReportedScene>, QuestionError> {
    let scenes = SCENES.map(|(name, cut)| {
        let scene = SceneSource::from(name).open()?.scene;
        let patches = scene.patches().iter().map(|patch| {
            let corners = patch.shape().corners().iter();
            corners.map(|corner| corner.to_array()).collect()
        });
        let patches: Vec<Vec<[f64; 3]>> = patches.collect();
        let found = claims
            .iter()
            .find(|claim| Some(claim.claim.id.as_str()) == cut);
        let position = found.and_then(|claim| claim.judged.as_ref()?.computed);
        let line = position.zip(patches.first());
        Ok(ReportedScene {
            name,
            cut_patch: cut.map(|_| 0),
            lines: line
                .and_then(|(at, patch)| cut_line(patch, at))
                .into_iter()
                .collect(),
            patches,
        })
    });
    scenes.into_iter().collect()
}

/// The cut of a parallelogram v0 v1 v2 v3 at this share of the way from v0 to v1.
fn cut_line(corners: &[[f64; 3]], at: f64) -> Option<[[f64; 3]; 2]> {
    let [v0, v1, v2, v3] = *corners.first_chunk::<4>()?;
    let between = |a: [f64; 3], b: [f64; 3]| std::array::from_fn(|k| a[k] + at * (b[k] - a[k]));
    Some([between(v0, v1), between(v3, v2)])
}
