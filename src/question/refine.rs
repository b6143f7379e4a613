//! The light of a scene on a mesh that is refined step by step.

use super::QuestionError;
use super::light::channel_meant;
use super::material_changes::{MaterialChanges, in_channel};
use super::patch_name::PatchName;
use super::patch_values::{PatchValue, values};
use super::refined::{RefineAnswer, RefineStep, lit_elements, lit_rows};
use super::scene::{SceneOrigin, SceneSource, ignored_note};
use super::unfolded::{MeshNet, Shade};
use crate::exchange::{Congruence, Progress, Tolerance, Unheard};
use crate::hierarchy::{
    Division, ErrorBound, Factors, Goal, HierarchyError, ImportanceDriven, Lighting, Oracle,
    OracleName, Reference, Refinement, link_information,
};
use crate::scene::{Channel, Occlusion, Scene};
use std::time::{Duration, Instant};

/// The elements of a reference over those that are asked for.
const FINER: usize = 16;

/// The elements up to which the error is bounded: the time for it grows as their square.
const MOST_BOUNDED: usize = 2000;

/// The remark on a bound that was not asked for.
const UNBOUNDED: &str = "the error is estimated, not bounded, as something may stand between \
                         patches: a bound takes seconds to minutes there, and has to be asked for";

/// The question for the light of a scene on a refined mesh.
///
/// # Examples
/// ```
/// use infoscene::exchange::Unheard;
/// use infoscene::hierarchy::Goal;
/// use infoscene::question::Refine;
/// let cube = Refine {
///     scene: "lit-cube".into(),
///     goal: Goal::Elements(100),
///     ..Refine::default()
/// };
/// let answer = cube.ask(&Unheard)?;
/// let last = answer.steps.last().ok_or("the mesh of the patches is the first step")?;
/// assert!(last.elements >= 100 && last.links > 100);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Refine {
    /// The scene.
    pub scene: SceneSource,
    /// The oracle that says which element is cut next.
    pub oracle: OracleName,
    /// The end of the refinement.
    pub goal: Goal,
    /// Is the solution linear on each element, not constant?
    pub linear: bool,
    /// Materials in place of the scene's own.
    pub materials: MaterialChanges,
    /// The channel of colour, which a coloured scene needs.
    pub channel: Option<Channel>,
    /// Direct importances: if some are given, elements are cut for the light of these patches.
    pub importance: Vec<PatchValue>,
    /// The form factors that links have.
    pub factors: Factors,
    /// The division of elements.
    pub division: Division,
    /// Is the error to be bounded where something stands in the way, too, which takes long?
    pub bound: bool,
    /// Is the light gathered once more in the end, for the means of the patches and for the net?
    pub gather: bool,
    /// Are the elements of the last mesh asked for, too?
    pub mesh: bool,
    /// The net to be drawn, if one is.
    pub net: Option<NetWish>,
}

/// A net of the scene that is to be drawn.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct NetWish {
    /// The patch of whose middle the links are shown.
    pub links_of: Option<PatchName>,
}

impl Default for Refine {
    /// A thousand elements, by the default oracle.
    fn default() -> Self {
        Self {
            scene: SceneSource::default(),
            oracle: OracleName::default(),
            goal: Goal::Elements(1000),
            linear: false,
            materials: MaterialChanges::default(),
            channel: None,
            importance: Vec::new(),
            factors: Factors::default(),
            division: Division::default(),
            bound: false,
            gather: false,
            mesh: false,
            net: None,
        }
    }
}

impl Refine {
    /// Refines the mesh until the goal is reached.
    ///
    /// # Errors
    /// [`QuestionError::Hierarchy`]; [`QuestionError::GoalOutOfRange`],
    /// [`QuestionError::NoLinearEstimate`]; [`QuestionError::ChannelNotNamed`]; the errors of the
    /// scene and its materials.
    pub fn ask(&self, progress: &dyn Progress) -> Result<RefineAnswer, QuestionError> {
        self.check_goal()?;
        let loaded = self.scene.open()?;
        let scene = loaded.scene;
        let wish = self.net.as_ref();
        let shown = wish.and_then(|wish| wish.links_of.as_ref());
        let shown = shown.map(|patch| patch_named(patch, &scene)).transpose()?;
        let patches = || {
            let lighting = self.lighting(&scene)?;
            let occlusion = self.scene.occlusion;
            let started = Refinement::try_new(&scene, lighting, occlusion, self.factors)?;
            Ok(started.with_division(self.division))
        };
        let oracle = self.judge(&scene, &patches)?;
        let mut clock = Clock::started();
        let mut refinement = patches()?;
        let mut steps = vec![self.step(&refinement, &mut clock)];
        refinement.refine(&*oracle, self.goal, &mut |refinement| {
            let step = self.step(refinement, &mut clock);
            progress.tell(&step.told(steps.len()));
            steps.push(step);
        })?;
        let mut notes = loaded.notes;
        notes.extend(self.ignored(&scene)?);
        let mut last = self.step(&refinement, &mut clock);
        let bound = self.error_bound(&scene, &refinement, &mut notes)?;
        let relative = bound.as_ref().map(|bound| bound.relative);
        last.error_bound = relative.filter(|bound| bound.is_finite());
        // the last round's, solved to the end
        if let Some(step) = steps.last_mut() {
            *step = last;
        }
        let shade = match (self.gather, self.linear) {
            (true, _) => Shade::Gathered,
            (false, true) => Shade::Linear,
            (false, false) => Shade::Constant,
        };
        let net = wish.map(|_| MeshNet::of(&scene, &refinement, shade, shown));
        Ok(RefineAnswer {
            steps,
            oracle: self.oracle.name(),
            scene: match &self.scene.origin {
                SceneOrigin::Named(name) => name.clone(),
                SceneOrigin::Made(_) => "made in the program".to_owned(),
            },
            linear: self.linear,
            patches: lit_rows(&scene, &refinement, self.gather, bound.as_ref())?,
            mesh: self.mesh.then(|| lit_elements(&scene, &refinement)),
            net: net.transpose()?,
            notes,
        })
    }

    /// The remark on occlusion that is ignored, if some is.
    fn ignored(&self, scene: &Scene) -> Result<Option<String>, QuestionError> {
        if self.scene.occlusion != Occlusion::Ignore {
            return Ok(None);
        }
        let asked = (Tolerance::default(), Congruence::Shared);
        let pairs = self.scene.pairs(scene, asked, &Unheard)?;
        let (_, summary) = pairs.row_sums(|_, _, exchange| [exchange.value, exchange.error])?;
        Ok(ignored_note(summary.plan.ignored))
    }

    /// The bound on the error, where one is known; a note says why there is none.
    fn error_bound(
        &self,
        scene: &Scene,
        refinement: &Refinement<'_>,
        notes: &mut Vec<String>,
    ) -> Result<Option<ErrorBound>, QuestionError> {
        let (tree, radiosity) = (refinement.tree(), &refinement.solution().radiosity);
        if tree.leaf_count() > MOST_BOUNDED {
            return Ok(None);
        }
        if refinement.factors().can_be_hidden() && !self.bound {
            notes.push(UNBOUNDED.to_owned());
            return Ok(None);
        }
        let values: Vec<f64> = tree.leaves().map(|leaf| radiosity[leaf]).collect();
        let (light, solution) = (refinement.lighting(), refinement.solution());
        let bound = if self.linear {
            let gradients = tree.leaves().map(|l| solution.gradient(tree, light, l));
            ErrorBound::of_linear(scene, tree, light, &values, &gradients.collect::<Vec<_>>())
        } else {
            ErrorBound::try_new(scene, tree, light, &values)
        };
        match bound {
            Ok(bound) => Ok(Some(bound)),
            Err(refused @ HierarchyError::NotDamped) => {
                notes.push(format!("no bound on the error: {refused}"));
                Ok(None)
            }
            Err(error) => Err(error.into()),
        }
    }

    /// The oracle, with what it takes of the mesh of the patches.
    fn judge<'s>(
        &self,
        scene: &Scene,
        patches: &dyn Fn() -> Result<Refinement<'s>, QuestionError>,
    ) -> Result<Box<dyn Oracle>, QuestionError> {
        let oracle = match self.oracle {
            OracleName::True => self.oracle.oracle(Some(&self.reference(patches()?)?))?,
            known => known.oracle(None)?,
        };
        if self.importance.is_empty() {
            return Ok(oracle);
        }
        let rows = values(&self.importance, scene)?;
        let direct = 0..scene.patches().len();
        let direct: Vec<f64> = direct.map(|patch| rows[scene.group_of(patch)]).collect();
        let driven = ImportanceDriven::try_new(oracle, &self.lighting(scene)?, &direct)?;
        Ok(Box::new(driven))
    }

    /// What the oracle of the true error compares with: the same room on a mesh so much finer.
    fn reference(&self, mut room: Refinement<'_>) -> Result<Reference, QuestionError> {
        let elements = match self.goal {
            Goal::Elements(elements) => elements,
            Goal::Links(links) => links / 10,
            Goal::Error(_) => 1000,
        };
        let fine = Goal::Elements(FINER * elements.max(room.tree().patches()));
        room.refine(&*OracleName::Gradient.oracle(None)?, fine, &mut |_| ())?;
        Ok(Reference::new(
            room.tree(),
            room.lighting(),
            room.solution(),
        ))
    }

    fn check_goal(&self) -> Result<(), QuestionError> {
        match self.goal {
            Goal::Error(error) if !(error > 0.0 && error.is_finite()) => {
                Err(QuestionError::GoalOutOfRange { error })
            }
            Goal::Error(_) if self.linear => Err(QuestionError::NoLinearEstimate),
            _ => Ok(()),
        }
    }

    /// The materials of the patches in the channel that is meant.
    fn lighting(&self, scene: &Scene) -> Result<Lighting, QuestionError> {
        let reflectances = self.materials.reflectances(scene)?;
        let emittances = self.materials.emittances(scene)?;
        let channel = channel_meant(self.channel, scene, [&reflectances, &emittances])?;
        let of_patches = |colours: &[_]| -> Vec<f64> {
            let rows = in_channel(colours, channel);
            let patches = 0..scene.patches().len();
            patches.map(|patch| rows[scene.group_of(patch)]).collect()
        };
        let [reflectances, emittances] = [reflectances, emittances].map(|rows| of_patches(&rows));
        Ok(Lighting::try_new(reflectances, emittances)?)
    }

    fn step(&self, refinement: &Refinement<'_>, clock: &mut Clock) -> RefineStep {
        let seconds = clock.stop();
        let step = RefineStep {
            elements: refinement.tree().leaf_count(),
            links: refinement.links().count(),
            evaluations: refinement.evaluations(),
            seconds,
            error_bound: None,
            error_estimate: (!self.linear).then(|| refinement.error_estimate()),
            mutual_information: link_information(
                refinement.tree(),
                refinement.links(),
                refinement.lighting(),
                &refinement.solution().radiosity,
            ),
        };
        clock.go_on();
        step
    }
}

/// A clock that stands still while records are made.
struct Clock {
    begin: Instant,
    before: Duration,
}

impl Clock {
    fn started() -> Self {
        Self {
            begin: Instant::now(),
            before: Duration::ZERO,
        }
    }

    /// Stops the clock, and reads it in seconds.
    fn stop(&mut self) -> f64 {
        self.before += self.begin.elapsed();
        self.before.as_secs_f64()
    }

    fn go_on(&mut self) {
        self.begin = Instant::now();
    }
}

/// The one patch that has a name.
fn patch_named(name: &PatchName, scene: &Scene) -> Result<usize, QuestionError> {
    Ok(scene.patch_of_row(name.row(scene)?)?)
}
