//! Error against run time of mutual information from sampled lines, beside the closed forms.
//!
//! For growing numbers N of lines, several seeds each: the mean error (bias) and the root of the
//! mean square error of the plug-in estimate, less Miller and Madow's bias, and corrected; by local
//! and by global lines. Where cells are met often the corrected error falls as `N^(−1/2)`; the
//! plug-in has its bias of `(K − 1)/(2N ln 2)` on top, which governs until `N ≈ K²/(4 σ² ln² 2)`, K
//! cells, σ² the variance of one sample. [`slope`] measures it.
//!
//! Quasi-random lines (five dimensions, shifted at random) were tried and are not here. Where every
//! cell is met a thousand times they came five to eight times nearer (cube of 6 and 24 patches, 10⁶
//! lines); where cells are met fifty times they came no nearer than the corrected estimate, whose
//! correction and standard error do not hold for them.

use crate::exchange::{Congruence, ScenePairs};
use crate::form_factor::DEFAULT_TOLERANCE;
use crate::information::{
    LineKind, LineSample, OpenScene, expected_bias_of_scene, scene_information,
};
use crate::scene::{Occlusion, Scene};
use crate::study::StudyError;
use std::time::Instant;

/// The estimates made of a sample.
pub const METHODS: [&str; 3] = ["plug-in", "miller-madow", "corrected"];

/// One method with one number of lines, or the closed forms.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct SamplingRow {
    /// The scene.
    pub case: String,
    /// The number of its patches.
    pub patches: usize,
    /// `"closed-forms"`, or one of [`METHODS`].
    pub method: &'static str,
    /// The kind of the lines.
    pub kind: Option<&'static str>,
    /// Lines.
    pub lines: Option<u32>,
    /// Seeds averaged over.
    pub seeds: Option<u64>,
    /// The exact mutual information, in bits.
    pub value: f64,
    /// The root of the mean square error over the seeds; of the closed forms the bound. In bits.
    pub error: f64,
    /// The error over the value.
    pub relative_error: f64,
    /// The mean error.
    pub bias: Option<f64>,
    /// The bias of the plug-in estimate by the exact probabilities.
    pub expected_bias: Option<f64>,
    /// The root of the mean square of the standard errors.
    pub standard_error: Option<f64>,
    /// The mean part of the samples that are alone in their cell.
    pub unseen: Option<f64>,
    /// Whether all the samples have an interval.
    pub has_interval: bool,
    /// Time of one estimate, in seconds.
    pub seconds: f64,
}

/// Scenes, and how often they are quartered.
const SCENES: [(&str, u32); 5] = [
    ("cube:2", 0),
    ("cube:6", 0),
    ("cube:16", 0),
    ("dodecahedron", 1),
    ("cornell-box", 2),
];

/// Numbers of lines, and of seeds.
const LINES: [(u32, u64); 5] = [
    (1000, 100),
    (10_000, 100),
    (100_000, 50),
    (1_000_000, 20),
    (10_000_000, 3),
];

/// Every scene by every method.
///
/// **Arguments** `quick`: two scenes, up to 10^4 lines, few seeds.
///
/// # Errors
/// [`StudyError`] if a scene is refused; none is known to be.
pub fn sampling(quick: bool) -> Result<Vec<SamplingRow>, StudyError> {
    let (scenes, lines) = if quick {
        (&SCENES[..2], &LINES[..2])
    } else {
        (&SCENES[..], &LINES[..])
    };
    let mut rows = Vec::new();
    for (name, times) in scenes {
        let (scene, _) = Scene::built_in(name)?.subdivided(*times)?;
        let start = Instant::now();
        let pairs = ScenePairs::try_new(
            &scene,
            DEFAULT_TOLERANCE,
            Congruence::Shared,
            Occlusion::Refuse,
        )?;
        let closed = scene_information(&pairs, OpenScene::Refuse)?.mutual_information;
        let value = closed.value;
        let plain = SamplingRow {
            case: (*name).to_owned(),
            patches: scene.patches().len(),
            method: "closed-forms",
            kind: None,
            lines: None,
            seeds: None,
            value,
            error: closed.error,
            relative_error: closed.error / value,
            bias: None,
            expected_bias: None,
            standard_error: None,
            unseen: None,
            has_interval: false,
            seconds: start.elapsed().as_secs_f64(),
        };
        let mut estimated = Vec::new();
        for kind in [LineKind::Local, LineKind::Global] {
            for (lines, seeds) in lines {
                let seeds = if quick { 4 } else { *seeds };
                let sums = Sums::over_seeds(&scene, kind, *lines, seeds, value)?;
                let expected = expected_bias_of_scene(&pairs, (*lines).into())?;
                for method in 0..METHODS.len() {
                    estimated.push(SamplingRow {
                        kind: Some(kind.name()),
                        lines: Some(*lines),
                        seeds: Some(seeds),
                        expected_bias: (method == 0).then_some(expected),
                        ..sums.row(method, &plain)
                    });
                }
            }
        }
        rows.push(plain);
        rows.append(&mut estimated);
    }
    Ok(rows)
}

/// Sums over the samples of several seeds.
struct Sums {
    /// Errors and their squares, by method.
    errors: [[f64; 2]; METHODS.len()],
    standard_squares: f64,
    unseen: f64,
    has_interval: bool,
    count: f64,
    seconds: f64,
}

impl Sums {
    fn over_seeds(
        scene: &Scene,
        kind: LineKind,
        lines: u32,
        seeds: u64,
        value: f64,
    ) -> Result<Self, StudyError> {
        let start = Instant::now();
        #[allow(clippy::cast_precision_loss, reason = "a hundred")]
        let count = seeds as f64;
        let mut sums = Self {
            errors: [[0.0; 2]; METHODS.len()],
            standard_squares: 0.0,
            unseen: 0.0,
            has_interval: true,
            count,
            seconds: 0.0,
        };
        for seed in 0..seeds {
            let counts = LineSample::draw(scene, kind, lines, seed)?.counts;
            let found = [counts.plug_in(), counts.miller_madow(), counts.corrected()];
            for ([error, square], found) in sums.errors.iter_mut().zip(found) {
                *error += found - value;
                *square += (found - value).powi(2);
            }
            sums.standard_squares += counts.standard_error().powi(2);
            sums.unseen += counts.unseen();
            sums.has_interval &= counts.confidence_interval().is_some();
        }
        sums.seconds = start.elapsed().as_secs_f64();
        Ok(sums)
    }

    /// The row of a method, by its place in [`METHODS`].
    fn row(&self, method: usize, plain: &SamplingRow) -> SamplingRow {
        let [error, square] = self.errors[method];
        let root_mean_square = (square / self.count).sqrt();
        SamplingRow {
            method: METHODS[method],
            error: root_mean_square,
            relative_error: root_mean_square / plain.value,
            bias: Some(error / self.count),
            standard_error: Some((self.standard_squares / self.count).sqrt()),
            unseen: Some(self.unseen / self.count),
            has_interval: self.has_interval,
            seconds: self.seconds / self.count,
            ..plain.clone()
        }
    }
}

/// The slope of the logarithm of the error over that of the lines, by least squares with the seeds
/// as weights, over the rows that have an interval; `None` for fewer than two.
#[must_use]
pub fn slope<'r>(rows: impl IntoIterator<Item = &'r SamplingRow>) -> Option<f64> {
    let seen = rows.into_iter().filter(|row| row.has_interval);
    let point = |row: &SamplingRow| {
        #[allow(clippy::cast_precision_loss, reason = "a hundred")]
        let seeds = row.seeds? as f64;
        Some([seeds, f64::from(row.lines?).ln(), row.error.ln()])
    };
    let points: Vec<[f64; 3]> = seen.filter_map(point).collect();
    let sum = |term: &dyn Fn(&[f64; 3]) -> f64| points.iter().map(|p| p[0] * term(p)).sum::<f64>();
    let total = sum(&|_| 1.0);
    let [x, y] = [1, 2].map(|axis| sum(&|point| point[axis]) / total);
    let products = sum(&|point| (point[1] - x) * (point[2] - y));
    let squares = sum(&|point| (point[1] - x).powi(2));
    (points.len() > 1).then_some(products / squares)
}
