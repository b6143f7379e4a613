//! The cut of a patch that gains the most mutual information.

use crate::discretize::{DiscretizeError, PatchSplit, regular_positions};
use crate::exchange::{Congruence, IgnoredOcclusion, Progress, Tolerance};
use crate::geometry::SplitAxis;
use crate::numeric::interval::DecimalBounds;
use crate::numeric::{Interval, compensated_sum, is_higher, tolerance};
use crate::question::PatchName;
use crate::question::QuestionError;
use crate::question::light::Light;
use crate::question::scene::{SceneSource, ignored_note};
use crate::scene::{Channel, Occlusion, Scene};
use crate::transport::SceneExchange;

/// The question for the best cut of a patch.
///
/// # Examples
/// ```
/// use infoscene::exchange::Unheard;
/// use infoscene::question::Split;
/// // fig. 2: two unit squares with a common edge
/// let squares = Split { scene: "two-squares".into(), ..Split::default() };
/// let best = squares.ask(&Unheard)?;
/// assert_eq!((best.axis, format!("{:.2}", best.position).as_str()), ("u", "0.40"));
/// # Ok::<(), infoscene::question::QuestionError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Split {
    /// The scene.
    pub scene: SceneSource,
    /// The patch to cut.
    pub patch: PatchName,
    /// The patches it is judged against; all others if none is named.
    pub against: Vec<PatchName>,
    /// The axis across which it is cut; the better one if none is named.
    pub axis: Option<SplitAxis>,
    /// The number of parts.
    pub parts: u32,
    /// The number of bits to which the best cut and its gain are to be enclosed, and proved best.
    pub precision: Option<u32>,
    /// The chain that is meant, and its light.
    pub light: Light,
}

impl Default for Split {
    /// Two parts of the first patch, under the visibility chain.
    fn default() -> Self {
        Self {
            scene: SceneSource::default(),
            patch: 0.into(),
            against: Vec::new(),
            axis: None,
            parts: 2,
            precision: None,
            light: Light::default(),
        }
    }
}

/// The best cuts of a patch, as a record whose keys are relied on by scripts.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[non_exhaustive]
pub struct SplitAnswer {
    /// The channel of colour, if one was named.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub channel: Option<Channel>,
    /// The patch.
    pub patch: usize,
    /// The axis across which it is cut, `"u"` or `"v"`.
    pub axis: &'static str,
    /// The relative position of the first cut.
    pub position: f64,
    /// The relative positions of all cuts.
    pub positions: Vec<f64>,
    /// The gain, in bits.
    pub gain: f64,
    /// The gain of equal parts, in bits.
    pub gain_at_middle: f64,
    /// The largest gain that equal parts could bring at all, in bits.
    pub maximum_gain: f64,
    /// The largest derivative of the gain that is left, in bits.
    pub residual: f64,
    /// The length by which each coordinate of the scene may be off; what that can change is not
    /// known.
    pub resolution: f64,
    /// The enclosures, if they were asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub enclosures: Option<SplitEnclosures>,
    /// The occlusion that was ignored: pairs of the cut patch, and their exchange areas; none where
    /// nothing can stand in the way.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ignored: Option<IgnoredOcclusion>,
    /// The absolute error of a position.
    #[serde(skip)]
    pub position_error: f64,
    /// The relative error of a gain.
    #[serde(skip)]
    pub gain_error: f64,
    /// Remarks of the scene's reader.
    #[serde(skip)]
    pub notes: Vec<String>,
}

/// Decimal bounds of the best cut, and what is proved about it.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct SplitEnclosures {
    /// The relative position of the cut.
    pub position: DecimalBounds,
    /// The gain, in bits.
    pub gain: DecimalBounds,
    /// The statement that is proved.
    pub certificate: String,
}

/// The brightness of each patch, and Σw.
type Lit = (Vec<f64>, f64);

impl Split {
    /// Finds the best cut.
    ///
    /// # Errors
    /// [`QuestionError::SeveralCutsEnclosed`] if an enclosure of more than one cut is asked for;
    /// [`QuestionError::NoLightMeant`]; the errors of the scene, of its light and of
    /// [`PatchSplit`].
    pub fn ask(&self, progress: &dyn Progress) -> Result<SplitAnswer, QuestionError> {
        if self.precision.is_some() && self.parts != 2 {
            return Err(QuestionError::SeveralCutsEnclosed { parts: self.parts });
        }
        let loaded = self.scene.open()?;
        let scene = loaded.scene;
        let patch = self.patch(&scene)?;
        let against = self.against(&scene, patch)?;
        let lit = if self.light.is_visibility()? {
            None
        } else {
            Some(self.lit(&scene, progress)?)
        };
        let along = |axis| self.along(&scene, patch, &against, axis, lit.as_ref());
        let mut answer = match self.axis {
            Some(axis) => along(axis)?,
            None => {
                let [first, second] = SplitAxis::ALL;
                let (first, second) = (along(first)?, along(second)?);
                // of equal axes the first
                if is_higher(second.gain, first.gain) {
                    second
                } else {
                    first
                }
            }
        };
        answer.notes = loaded.notes;
        answer.notes.extend(ignored_note(answer.ignored));
        Ok(answer)
    }

    /// The patch to cut: one that is a row of its own.
    fn patch(&self, scene: &Scene) -> Result<usize, QuestionError> {
        let row = self.patch.row(scene)?;
        Ok(scene.patch_of_row(row)?)
    }

    /// The patches that the cut is judged against; a name of several may include the patch itself.
    fn against(&self, scene: &Scene, patch: usize) -> Result<Vec<usize>, QuestionError> {
        let all = PatchName::from("all");
        let named = if self.against.is_empty() {
            std::slice::from_ref(&all)
        } else {
            &self.against
        };
        let mut against = Vec::new();
        for name in named {
            let rows = name.rows(scene)?;
            let is_one = rows.len() == 1;
            let patches = scene.patches_of_groups(&rows);
            against.extend(patches.filter(|other| is_one || *other != patch));
        }
        Ok(against)
    }

    /// The brightness of each patch, and Σw.
    fn lit(&self, scene: &Scene, progress: &dyn Progress) -> Result<Lit, QuestionError> {
        let asked = (Tolerance::default(), Congruence::Shared);
        let pairs = self.scene.pairs(scene, asked, progress)?;
        let exchange = SceneExchange::held(&pairs)?;
        let found = self.light.brightness(scene, &exchange)?;
        let rows = found.values.iter().zip(&found.received);
        let weights = rows
            .zip(exchange.areas())
            .map(|((value, received), area)| value * received * area);
        let total = compensated_sum(weights);
        let patches = 0..scene.patches().len();
        let brightness = patches.map(|patch| found.values[scene.group_of(patch)]);
        Ok((brightness.collect(), total))
    }

    /// The best cuts across an axis.
    fn along(
        &self,
        scene: &Scene,
        patch: usize,
        against: &[usize],
        axis: SplitAxis,
        lit: Option<&Lit>,
    ) -> Result<SplitAnswer, DiscretizeError> {
        let occlusion = self.scene.occlusion;
        let mut split = PatchSplit::with_occlusion(scene, patch, against, axis, occlusion)?;
        if let Some((brightness, total)) = lit {
            split = split.under(patch, brightness, *total)?;
        }
        let best = split.best(self.parts)?;
        let (position_error, gain_error) = if split.is_occluded() {
            (tolerance::OCCLUDED_POSITION, tolerance::OCCLUDED_GAIN)
        } else if split.is_closed_form() {
            (tolerance::POSITION, tolerance::GAIN)
        } else {
            (tolerance::POLYGON_POSITION, tolerance::POLYGON_GAIN)
        };
        Ok(SplitAnswer {
            channel: self.light.channel,
            patch: scene.group_of(patch),
            axis: axis.name(),
            position: best.positions[0],
            gain: best.gain,
            gain_at_middle: split.gain(&regular_positions(self.parts))?,
            maximum_gain: split.maximum_gain(self.parts)?,
            residual: best.residual,
            resolution: scene.resolution(),
            positions: best.positions,
            enclosures: match self.precision {
                Some(bits) => enclosures(&split, bits)?,
                None => None,
            },
            ignored: split
                .ignored_occlusion()
                .filter(|_| occlusion == Occlusion::Ignore),
            position_error,
            gain_error,
            notes: Vec::new(),
        })
    }
}

fn enclosures(split: &PatchSplit, bits: u32) -> Result<Option<SplitEnclosures>, DiscretizeError> {
    let best = split.certified_best(bits)?;
    let bounds = |enclosure: &Interval| enclosure.every_decimal();
    let both = bounds(&best.position).zip(bounds(&best.value));
    Ok(both.map(|(position, gain)| SplitEnclosures {
        position,
        gain,
        certificate: best.certificate.to_string(),
    }))
}
