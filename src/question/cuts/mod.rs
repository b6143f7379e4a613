//! Questions about cuts: of a patch, along its lines of discontinuity, across a gradient, of a box.

mod discontinuities;
mod gradient;
mod grid;
mod receiver_map;
mod split;

pub use discontinuities::{
    BestCutRecord, Discontinuities, DiscontinuitiesAnswer, DiscontinuityRecord,
};
pub use gradient::{Cut, CutAnswer, CutEnclosures, Cuts, CutsAnswer, IrradianceExponent};
pub use grid::{Grid, GridAnswer, GridEnclosures, GridLines, GridSample};
pub use receiver_map::{GainCurve, ReceiverMap};
pub use split::{Split, SplitAnswer, SplitEnclosures};
