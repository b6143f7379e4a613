//! Estimates of a scene's information from random lines.

use crate::exchange::{Congruence, ExchangeError, Progress, ScenePairs, Tolerance};
use crate::information::{LineKind, LineSample, scene_information_and_bias};
use crate::numeric::Grade;
use crate::question::scene::SceneSource;
use crate::question::{QuestionError, SampledInformation};
use crate::scene::{Occlusion, Scene};

/// The question for the information of any closed scene, concave or occluded, from random lines.
///
/// # Examples
/// ```
/// use infoscene::exchange::Unheard;
/// use infoscene::question::Sample;
/// let cube = Sample { scene: "cube:1".into(), lines: 10_000, ..Sample::default() };
/// let sampled = cube.ask(&Unheard)?.sampled;
/// // one patch per face, from a 50-digit evaluation
/// let off = sampled.corrected - 0.263_034_544_099_12;
/// assert!(off.abs() < 4.0 * sampled.standard_error);
/// # Ok::<(), infoscene::question::QuestionError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Sample {
    /// The scene. Lines end at what they first meet: occlusion cannot be left out.
    pub scene: SceneSource,
    /// The number of lines, at least 2; fewer count as 2.
    pub lines: u32,
    /// The way lines are drawn.
    pub kind: LineKind,
    /// The seed: one seed always draws the same lines.
    pub seed: u64,
    /// Whether the continuous mutual information is asked for, too.
    pub continuous: bool,
    /// Are the exact mutual information and the expected bias asked for, too? They are found where
    /// the scene has at most [`MOST_EXACT_ROWS`](Self::MOST_EXACT_ROWS) rows.
    pub exact: bool,
    /// The error that is accepted of every form factor behind the exact values.
    pub tolerance: Tolerance,
    /// The treatment of congruent pairs behind them.
    pub congruence: Congruence,
}

impl Default for Sample {
    /// A million local lines.
    fn default() -> Self {
        Self {
            scene: SceneSource::default(),
            lines: 1_000_000,
            kind: LineKind::Local,
            seed: 1,
            continuous: false,
            exact: false,
            tolerance: Tolerance::default(),
            congruence: Congruence::Shared,
        }
    }
}

/// Estimates from random lines, as a record whose keys are relied on by scripts.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[non_exhaustive]
pub struct SampleAnswer {
    /// The number of rows.
    pub patches: usize,
    /// The sum of their areas.
    pub total_area: f64,
    /// Always none: that of [`MeasureAnswer`](crate::question::MeasureAnswer) is not computed.
    pub mutual_information: Option<f64>,
    /// The continuous mutual information by the chords, in bits, if it was asked for.
    pub continuous_mutual_information: Option<f64>,
    /// The standard error of the continuous mutual information.
    pub continuous_standard_error: Option<f64>,
    /// The grade of its error.
    pub continuous_error_grade: Option<Grade>,
    /// The number of lines that met a front.
    pub lines: u32,
    /// The seed.
    pub seed: u64,
    /// The estimates.
    pub sampled: SampledInformation,
    /// Remarks of the scene's reader.
    #[serde(skip)]
    pub notes: Vec<String>,
}

impl Sample {
    /// The number of rows up to which exact values are computed: a second or so.
    pub const MOST_EXACT_ROWS: usize = 6144;

    /// Draws the lines.
    ///
    /// # Errors
    /// [`QuestionError::OccludedLines`] if occlusion was to be ignored; the errors of the scene and
    /// of [`LineSample::draw`].
    pub fn ask(&self, progress: &dyn Progress) -> Result<SampleAnswer, QuestionError> {
        if self.scene.occlusion == Occlusion::Ignore {
            return Err(QuestionError::OccludedLines);
        }
        let loaded = self.scene.open()?;
        let scene = loaded.scene;
        let sample = LineSample::draw(&scene, self.kind, self.lines, self.seed)?;
        let exact = if let Some(pairs) = self.exact_pairs(&scene, progress)? {
            let (measured, bias) = scene_information_and_bias(&pairs, sample.counts.samples())?;
            Some([measured.mutual_information.value, bias])
        } else {
            None
        };
        let chords = self.continuous.then_some(sample.chords);
        Ok(SampleAnswer {
            patches: scene.group_count(),
            total_area: scene.total_area(),
            mutual_information: None,
            continuous_mutual_information: chords.map(|chords| chords.mutual_information),
            continuous_standard_error: chords.map(|chords| chords.standard_error),
            continuous_error_grade: chords.map(|_| Grade::Sample),
            lines: sample.lines,
            seed: self.seed,
            sampled: SampledInformation::new(&sample, self.seed, exact),
            notes: loaded.notes,
        })
    }

    /// The pairs, if exact values are asked for of a scene that is small enough.
    fn exact_pairs<'p>(
        &self,
        scene: &Scene,
        progress: &'p dyn Progress,
    ) -> Result<Option<ScenePairs<'p>>, ExchangeError> {
        if !self.exact || scene.group_count() > Self::MOST_EXACT_ROWS {
            return Ok(None);
        }
        let asked = (self.tolerance, self.congruence);
        self.scene.pairs(scene, asked, progress).map(Some)
    }
}
