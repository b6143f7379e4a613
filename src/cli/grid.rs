//! `infoscene grid --box X,Y,Z --cells N`.

use super::Answer;
use super::output::{Output, precision};
use infoscene::discretize::{BestGrid, BoxGrid, CertifiedGrid};
use infoscene::numeric::Interval;
use infoscene::report::{GridAnswer, GridEnclosures, grid_report};

/// Cells an edge up to which enclosures take seconds.
const MOST_ENCLOSED: u32 = 12;

#[derive(Debug, clap::Args)]
pub(super) struct Grid {
    /// The edges of the box, in any one unit.
    #[arg(
        long = "box",
        value_name = "X,Y,Z",
        value_delimiter = ',',
        allow_negative_numbers = true,
        required = true
    )]
    edges: Vec<f64>,
    /// Cells an edge, from 1 to 64: all faces are cut by lines at the same places, relative to the edges; equally spaced ones
    /// unless others are asked for.
    #[arg(long, value_name = "N", required_unless_present = "lines")]
    cells: Option<u32>,
    /// Find the lines with the most mutual information, symmetric about the middle.
    #[arg(long, conflicts_with = "lines")]
    optimize: bool,
    /// The lines, from 0 to 1 without the ends, increasing.
    #[arg(
        long,
        value_name = "A,B,…",
        value_delimiter = ',',
        allow_negative_numbers = true
    )]
    lines: Option<Vec<f64>>,
    /// Enclose the mutual information, too, with ends of this many bits, and the best lines with proof that they are a maximum; up
    /// to 12 cells.
    #[arg(long, value_name = "BITS", value_parser = precision())]
    precision: Option<u32>,
    /// Estimate it from so many random lines, too.
    #[arg(long, value_name = "LINES", value_parser = clap::value_parser!(u32).range(2..))]
    sample: Option<u32>,
    /// The same seed draws the same lines.
    #[arg(long, value_name = "S", requires = "sample", default_value_t = 1)]
    seed: u64,
    #[command(flatten)]
    output: Output,
}

impl Grid {
    pub(super) fn answer(&self) -> Answer {
        self.output.check()?;
        let Ok(edges) = <[f64; 3]>::try_from(self.edges.as_slice()) else {
            let given = self.edges.len();
            return Err(format!("--box takes three edges X,Y,Z, and here are {given}").into());
        };
        let implied = self.lines.as_ref().map(|lines| lines.len() + 1);
        let cells = match (self.cells, implied) {
            (Some(cells), Some(implied)) if implied != cells as usize => {
                let lines = implied - 1;
                let text = format!(
                    "--lines has {lines} lines, which make {implied} cells, and --cells says {cells}: leave one of them out"
                );
                return Err(text.into());
            }
            (Some(cells), _) => cells,
            (None, implied) => u32::try_from(implied.unwrap_or(0))?,
        };
        let regular = BoxGrid::regular(edges, cells)?;
        if let Some(bits) = self.precision.filter(|_| cells > MOST_ENCLOSED) {
            let text = format!(
                "--precision {bits} is for up to {MOST_ENCLOSED} cells, and here are {cells}: leave it out"
            );
            return Err(text.into());
        }
        let best = if self.optimize {
            Some(BestGrid::find(edges, cells)?)
        } else {
            None
        };
        let grid = match (&best, &self.lines) {
            (Some(best), _) => best.grid.clone(),
            (None, Some(lines)) => BoxGrid::try_new(edges, lines)?,
            (None, None) => regular.clone(),
        };
        let certified = match self.precision {
            Some(bits) if self.optimize => Some(CertifiedGrid::best(edges, cells, bits)?),
            _ => None,
        };
        let enclosed = match (self.precision, &certified) {
            (_, Some(found)) => Some(GridEnclosures {
                half: &found.half,
                mutual_information: found.mutual_information.clone(),
                certificate: found.certificate.to_string(),
            }),
            (Some(bits), None) => Some(GridEnclosures {
                half: &[],
                mutual_information: grid
                    .lifted(&Interval::precise(1.0, bits))?
                    .mutual_information()?,
                certificate: "for lines and edges as given, read as doubles".to_owned(),
            }),
            (None, None) => None,
        };
        let information = match &best {
            Some(best) => best.information,
            None => grid.information()?,
        };
        let sampled = match self.sample {
            Some(lines) => Some((
                grid.sample(lines, self.seed)?,
                self.seed,
                grid.expected_bias(lines.into())?,
            )),
            None => None,
        };
        let answer = GridAnswer {
            edges,
            information,
            regular: regular.information()?,
            grid: &grid,
            best: best.as_ref(),
            enclosed,
            sampled,
        };
        self.output.write(&grid_report(&answer)?)
    }
}
