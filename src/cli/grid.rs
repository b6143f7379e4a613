//! `infoscene grid --box X,Y,Z --cells N`.

use super::Answer;
use super::output::{Output, precision};
use infoscene::exchange::Unheard;
use infoscene::question::{self, GridLines, GridSample};
use infoscene::report::grid_report;
use std::error::Error;

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
    /// Cells an edge, from 1 to 64: all faces are cut by lines at the same places, relative to the
    /// edges; equally spaced ones unless others are asked for.
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
    /// Enclose the mutual information, too, with ends of this many bits, and the best lines with
    /// proof that they are a maximum; up to 12 cells.
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
        let answer = self.question()?.ask(&Unheard)?;
        self.output.write(&grid_report(&answer)?)
    }

    fn question(&self) -> Result<question::Grid, Box<dyn Error>> {
        let Ok(edges) = <[f64; 3]>::try_from(self.edges.as_slice()) else {
            let given = self.edges.len();
            return Err(format!("--box takes three edges X,Y,Z, and here are {given}").into());
        };
        let lines = match (&self.lines, self.cells) {
            (Some(lines), Some(cells)) if lines.len() + 1 != cells as usize => {
                let (lines, implied) = (lines.len(), lines.len() + 1);
                let text = format!(
                    "--lines has {lines} lines, which make {implied} cells, and --cells says \
                     {cells}: leave one of them out"
                );
                return Err(text.into());
            }
            (Some(lines), _) => GridLines::At(lines.clone()),
            (None, cells) => {
                let cells = cells.unwrap_or(0);
                if self.optimize {
                    GridLines::Best { cells }
                } else {
                    GridLines::Regular { cells }
                }
            }
        };
        Ok(question::Grid {
            edges,
            lines,
            precision: self.precision,
            sample: self.sample.map(|lines| GridSample {
                lines,
                seed: self.seed,
            }),
        })
    }
}
