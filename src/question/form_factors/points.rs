//! The form factors from points of surfaces to the patches of a scene.

use crate::exchange::{PointRow, Progress, ScenePoints};
use crate::question::point_file::{self, SurfacePoint};
use crate::question::scene::SceneSource;
use crate::question::{PointFileError, QuestionError};
use glam::DVec3;
use std::path::PathBuf;

/// The question for the form factors from points to all patches, past all that stands in the way.
///
/// # Examples
/// ```
/// use infoscene::exchange::Unheard;
/// use infoscene::question::{PointSource, Points, SurfacePoint};
/// let floor = SurfacePoint { at: [0.5, 0.5, 0.0], normal: [0.0, 0.0, 2.0] };
/// let question = Points { scene: "cube:1".into(), points: PointSource::Given(vec![floor]) };
/// let answer = question.ask(&Unheard)?;
/// // Howell, B-3: four quarters of the ceiling
/// let ceiling = answer.points[0].form_factors.iter().map(|seen| seen.value).fold(0.0, f64::max);
/// assert!((ceiling - 0.239_456_5).abs() < 1e-6);
/// assert_eq!(answer.notes, ["1 normal is not 1 long, and is taken as a direction"]);
/// # Ok::<(), infoscene::question::QuestionError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Points {
    /// The scene.
    pub scene: SceneSource,
    /// The points.
    pub points: PointSource,
}

/// The place that points come from.
#[derive(Debug, Clone, PartialEq)]
pub enum PointSource {
    /// Points given one by one.
    Given(Vec<SurfacePoint>),
    /// A file of points: six numbers a line, separated by commas.
    File(PathBuf),
}

/// The parts of a scene that points see, as a record whose keys are relied on by scripts.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[non_exhaustive]
pub struct PointsAnswer {
    /// The rows.
    pub patches: Vec<SeenPatch>,
    /// The points, in the order given.
    pub points: Vec<PointRecord>,
    /// Remarks of the scene's reader, and on the points.
    #[serde(skip)]
    pub notes: Vec<String>,
}

/// A patch, or several that are summed, as a record.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct SeenPatch {
    /// The number of the row, from 0.
    pub index: usize,
    /// The name of the patch, or of the first.
    pub name: String,
    /// The area, less that of the parts in it.
    pub area: f64,
}

/// A point and what it sees, as a record.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct PointRecord {
    /// The number of the point, from 0.
    pub index: usize,
    /// The coordinates of the point.
    pub at: [f64; 3],
    /// The unit normal of the surface there.
    pub normal: [f64; 3],
    /// The part that sees the front of no patch: the sky, back sides and obstructions. None where
    /// occlusion is ignored.
    pub unseen: Option<f64>,
    /// A bound on its absolute error.
    pub unseen_error: Option<f64>,
    /// The part of `unseen` that sees a back side or an obstruction; the rest sees nothing at all.
    pub backs: Option<f64>,
    /// A bound on its absolute error.
    pub backs_error: Option<f64>,
    /// The form factors to all rows, in order.
    pub form_factors: Vec<SeenRecord>,
}

/// A form factor from a point, as a record.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct SeenRecord {
    /// The row that receives.
    pub to: usize,
    /// The form factor, from 0 to 1.
    pub value: f64,
    /// A bound on its absolute error.
    pub error: f64,
}

impl Points {
    /// Computes the form factors.
    ///
    /// # Errors
    /// [`QuestionError::Points`] for a file or a point at fault; the errors of the scene.
    pub fn ask(&self, progress: &dyn Progress) -> Result<PointsAnswer, QuestionError> {
        let given = match &self.points {
            PointSource::Given(points) => points.clone(),
            PointSource::File(path) => point_file::read(path)?,
        };
        let loaded = self.scene.open()?;
        let (scene, mut notes) = (loaded.scene, loaded.notes);
        let mut points = Vec::with_capacity(given.len());
        let mut turned = 0;
        for (index, point) in given.iter().enumerate() {
            let Some(direction) = point.direction() else {
                return Err(PointFileError::NoDirection { index }.into());
            };
            let length = DVec3::from_array(point.normal).length();
            turned += usize::from((length - 1.0).abs() > ROUNDED);
            points.push((DVec3::from_array(point.at), direction));
        }
        if turned > 0 {
            let (s, are) = if turned == 1 {
                ("", "is")
            } else {
                ("s", "are")
            };
            notes.push(format!(
                "{turned} normal{s} {are} not 1 long, and {are} taken as a direction{s}"
            ));
        }
        let rows = ScenePoints::try_new(&scene, self.scene.occlusion)?;
        let rows = rows.seen_from(&points, progress)?;
        let areas = scene.row_areas();
        let patches = scene.group_names().into_iter().zip(areas).enumerate();
        let points = points.iter().zip(rows).enumerate();
        Ok(PointsAnswer {
            patches: patches
                .map(|(index, (name, area))| SeenPatch {
                    index,
                    name: name.to_owned(),
                    area,
                })
                .collect(),
            points: points
                .map(|(index, (point, row))| PointRecord::new(index, *point, &row))
                .collect(),
            notes,
        })
    }
}

/// A normal printed to seven digits is 1 long within this.
const ROUNDED: f64 = 1e-6;

impl PointRecord {
    fn new(index: usize, (at, normal): (DVec3, DVec3), row: &PointRow) -> Self {
        let seen = row.form_factors.iter().enumerate();
        Self {
            index,
            at: at.to_array(),
            normal: normal.to_array(),
            unseen: row.unseen.map(|part| part.value),
            unseen_error: row.unseen.map(|part| part.error),
            backs: row.backs.map(|part| part.value),
            backs_error: row.backs.map(|part| part.error),
            form_factors: seen
                .map(|(to, part)| SeenRecord {
                    to,
                    value: part.value,
                    error: part.error,
                })
                .collect(),
        }
    }
}
