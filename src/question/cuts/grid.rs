//! The mutual information of a grid on the faces of a box, and the best grid.

use crate::discretize::{BestGrid, BoxGrid, CertifiedGrid, GridInformation, Spacing, UNIT_CUBE};
use crate::exchange::Progress;
use crate::numeric::{Grade, Interval};
use crate::question::decimals;
use crate::question::{QuestionError, SampledInformation};

/// Cells an edge up to which enclosures take seconds.
const MOST_ENCLOSED: u32 = 12;

/// The question for the mutual information of a grid: all faces of a box are cut by lines at the
/// same places, relative to the edges.
///
/// # Examples
/// ```
/// use infoscene::exchange::Unheard;
/// use infoscene::question::{Grid, GridLines};
/// // fig. 4: the best grid of 3 × 3 cells on each face of a cube; half an edge is 10 of its units
/// let fig_4 = Grid { lines: GridLines::Best { cells: 3 }, ..Grid::default() };
/// let best = fig_4.ask(&Unheard)?;
/// assert!((20.0 * best.lines[0] - 6.051_482_351_011).abs() < 1e-9);
/// # Ok::<(), infoscene::question::QuestionError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    /// The edges of the box, in any one unit.
    pub edges: [f64; 3],
    /// The lines.
    pub lines: GridLines,
    /// Bits of the ends of enclosures, if the mutual information and the best lines are to be
    /// enclosed, too; for up to 12 cells an edge.
    pub precision: Option<u32>,
    /// Random lines that estimate the mutual information, too.
    pub sample: Option<GridSample>,
}

/// The lines of a grid.
#[derive(Debug, Clone, PartialEq)]
pub enum GridLines {
    /// Equally spaced lines.
    Regular {
        /// Cells an edge, from 1 to 64.
        cells: u32,
    },
    /// The lines with the most mutual information, symmetric about the middle.
    Best {
        /// Cells an edge, from 1 to 64.
        cells: u32,
    },
    /// Lines at these places, from 0 to 1 without the ends, increasing.
    At(Vec<f64>),
}

/// A number of random lines, and the seed that they are drawn from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GridSample {
    /// The number of lines, at least 2.
    pub lines: u32,
    /// The seed: the same one draws the same lines.
    pub seed: u64,
}

impl Default for Grid {
    /// The faces of the unit cube, undivided.
    fn default() -> Self {
        Self {
            edges: UNIT_CUBE,
            lines: GridLines::Regular { cells: 1 },
            precision: None,
            sample: None,
        }
    }
}

/// The mutual information of a grid, in bits, and the evidence that it is the best one.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct GridAnswer {
    /// The edges of the box, as given.
    pub edges: [f64; 3],
    /// Cells an edge.
    pub cells: usize,
    /// The spacing of the lines: `"regular"`, `"symmetric"` or `"any"`.
    pub spacing: &'static str,
    /// The lines, relative to the edges, without the ends.
    pub lines: Vec<f64>,
    /// Mutual information.
    pub mutual_information: f64,
    /// The error of the mutual information.
    pub error: f64,
    /// The grade of that error.
    pub error_grade: Grade,
    /// Mutual information of the regular grid of as many cells.
    pub regular_mutual_information: f64,
    /// The bound on its error.
    #[serde(skip)]
    pub regular_error: f64,
    /// The number of patches.
    pub patches: usize,
    /// The number of pairs that see each other.
    pub pairs: usize,
    /// The number of classes of congruent pairs.
    pub classes: usize,
    /// The error of the lines, if they were searched for.
    pub line_error: Option<f64>,
    /// The grade of that error.
    pub line_error_grade: Option<Grade>,
    /// The largest derivative that is left.
    pub slope: Option<f64>,
    /// The largest curvature; none if no line is free.
    pub curvature: Option<f64>,
    /// The estimate of its error.
    pub curvature_error: Option<f64>,
    /// The number of starts of the search.
    pub starts: Option<usize>,
    /// The number of starts that ended at this maximum.
    pub starts_at_maximum: Option<usize>,
    /// The number of starts that did not converge.
    pub starts_lost: Option<usize>,
    /// Mutual information of the other maxima found, the highest first.
    pub other_maxima: Option<Vec<f64>>,
    /// Estimates from random lines, if they were asked for.
    pub sampled: Option<SampledInformation>,
    /// Enclosures, if they were asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub enclosures: Option<GridEnclosures>,
}

/// Enclosures of a grid's numbers.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct GridEnclosures {
    /// The best lines below 1/2, if they were searched for.
    #[serde(serialize_with = "decimals::all_ends")]
    pub half: Vec<Interval>,
    /// Mutual information.
    #[serde(serialize_with = "decimals::ends")]
    pub mutual_information: Interval,
    /// The statement that is proved.
    pub certificate: String,
}

impl GridAnswer {
    /// Are the lines equally spaced?
    #[must_use]
    pub fn is_regular(&self) -> bool {
        self.spacing == Spacing::Regular.name()
    }

    /// The mutual information beyond that of the regular grid, and the bound on its error.
    #[must_use]
    pub fn gain_over_regular(&self) -> [f64; 2] {
        let gain = self.mutual_information - self.regular_mutual_information;
        [gain, self.error + self.regular_error]
    }
}

impl Grid {
    /// Computes the answer.
    ///
    /// # Errors
    /// [`QuestionError::Discretize`] if an edge, a line or the number of cells is out of range, or
    /// no maximum is found; [`QuestionError::TooManyCellsToEnclose`].
    pub fn ask(&self, _: &dyn Progress) -> Result<GridAnswer, QuestionError> {
        let cells = match &self.lines {
            GridLines::Regular { cells } | GridLines::Best { cells } => *cells,
            GridLines::At(lines) => u32::try_from(lines.len() + 1).unwrap_or(u32::MAX),
        };
        let regular = BoxGrid::regular(self.edges, cells)?;
        if let Some(bits) = self.precision.filter(|_| cells > MOST_ENCLOSED) {
            return Err(QuestionError::TooManyCellsToEnclose {
                bits,
                cells,
                most: MOST_ENCLOSED,
            });
        }
        let (grid, best) = match &self.lines {
            GridLines::Regular { .. } => (regular.clone(), None),
            GridLines::At(lines) => (BoxGrid::try_new(self.edges, lines)?, None),
            GridLines::Best { .. } => {
                let best = BestGrid::find(self.edges, cells)?;
                (best.grid.clone(), Some(best))
            }
        };
        let enclosures = match self.precision {
            Some(bits) => Some(self.enclosures(&grid, cells, bits)?),
            None => None,
        };
        let information = match &best {
            Some(best) => best.information,
            None => grid.information()?,
        };
        let sampled = match self.sample {
            Some(GridSample { lines, seed }) => {
                let sample = grid.sample(lines, seed)?;
                let bias = grid.expected_bias(lines.into())?;
                let exact = Some([information.mutual_information.value, bias]);
                Some(SampledInformation::new(&sample, seed, exact))
            }
            None => None,
        };
        let regular = regular.information()?;
        let answer = self.answer(&grid, information, regular, best.as_ref());
        Ok(GridAnswer {
            sampled,
            enclosures,
            ..answer
        })
    }

    fn enclosures(
        &self,
        grid: &BoxGrid,
        cells: u32,
        bits: u32,
    ) -> Result<GridEnclosures, QuestionError> {
        if let GridLines::Best { .. } = self.lines {
            let found = CertifiedGrid::best(self.edges, cells, bits)?;
            return Ok(GridEnclosures {
                certificate: found.certificate.to_string(),
                half: found.half,
                mutual_information: found.mutual_information,
            });
        }
        Ok(GridEnclosures {
            half: Vec::new(),
            mutual_information: grid
                .lifted(&Interval::precise(1.0, bits))?
                .mutual_information()?,
            certificate: "for lines and edges as given, read as doubles".to_owned(),
        })
    }

    fn answer(
        &self,
        grid: &BoxGrid,
        information: GridInformation,
        regular: GridInformation,
        best: Option<&BestGrid>,
    ) -> GridAnswer {
        let cells = grid.cells();
        let curvature = best.and_then(|best| best.curvature);
        GridAnswer {
            edges: self.edges,
            cells,
            spacing: grid.spacing().name(),
            lines: grid.lines().to_vec(),
            mutual_information: information.mutual_information.value,
            error: information.mutual_information.error,
            error_grade: Grade::Bound,
            regular_mutual_information: regular.mutual_information.value,
            regular_error: regular.mutual_information.error,
            patches: 6 * cells.pow(2),
            pairs: 15 * cells.pow(4),
            classes: information.classes,
            line_error: best.map(|best| best.line_error),
            line_error_grade: best.map(|_| Grade::Estimate),
            slope: best.map(|best| best.slope),
            curvature: curvature.map(|curvature| curvature.value),
            curvature_error: curvature.map(|curvature| curvature.error),
            starts: best.map(|best| best.search.starts),
            starts_at_maximum: best.map(|best| best.search.reached),
            starts_lost: best.map(|best| best.search.lost),
            other_maxima: best.map(|best| best.search.others.clone()),
            sampled: None,
            enclosures: None,
        }
    }
}
