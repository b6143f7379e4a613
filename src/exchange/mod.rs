//! What the rows of a scene exchange: the plan, the passes over all pairs, the sums of rows.

mod closure;
mod error;
mod passes;
mod plan;
mod progress;
mod row_pair;
mod rows;
mod scene_pairs;

pub use closure::{Closure, RowSum};
pub use error::ExchangeError;
pub use passes::matrix::ExchangeAreas;
pub use passes::row_sums::TileSums;
pub use passes::rows::Entry;
pub use passes::tiles::{Tile, TileAnswers};
pub use plan::Congruence;
pub use plan::counts::{PassCounts, PassSummary, PlanSummary, Unreached};
pub use progress::{Progress, Unheard};
pub use scene_pairs::ScenePairs;
