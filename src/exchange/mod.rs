//! Exchange of light between the rows of a scene: exchange areas, form factors and their sums.
//!
//! ```text
//!   J_gh = A_g F_gh = A_h F_hg        the exchange area of the rows g and h
//!   J_gh = Σ_k Σ_l c_gk c_hl J_kl     k, l: the polygons of the rows, with their signs
//! ```
//!
//! # Words
//!
//! * A *patch* is a named polygon of the scene with a material, the unit in which a user thinks.
//! * A *polygon* is a patch prepared for the evaluation of form factors.
//! * A *surface* is a patch or an obstruction as a file states it.
//! * A *face* is one flat side of a room or a solid; its patches divide it.
//! * A *part* is a patch that lies in another one, its *base*; the base counts without it.
//! * A *group* is a set of patches that are summed
//!   ([`Scene::group_of`](crate::scene::Scene::group_of)): one patch, unless labels say otherwise.
//! * A *row* stands for a group in matrices, lists and sums: its patches less their parts. A face
//!   without area is a row without a patch, and exchanges nothing.
//! * A *term* of a row is one of its polygons with its sign: 1, or −1 for a part of a base in it.
//! * A *plane set* is the set of planes that the terms of a row lie in.
//! * A *tile* is a block of pairs, some rows against some rows: the unit of work of a pass.
//! * A *cell* is one rectangle of a grid on a face; the cells of a box are patches like any other.
//!
//! # A pass
//!
//! [`ScenePairs`] checks the scene for overlap and occlusion, prepares its polygons and makes a
//! plan. Nothing is evaluated yet, except one value for each class of congruent pairs. A pass then
//! runs in three steps:
//!
//! 1. **Plan** (`plan`). Pairs of planes that do not face each other are left out whole; congruent
//!    pairs share one value: those of rectangles along the axes, however these are turned, and
//!    translates and mirror images of any polygons.
//! 2. **Tiles** (`passes/tiles`). The other pairs are walked in tiles, each pair once, on all
//!    threads. The exchange area of two rows (`pairs/row_pair`) is the sum over the terms of both,
//!    pairs of polygons (`pairs/polygon_pair`).
//! 3. **Sums** (`passes`). The results of the tiles are added in their order, so that they do not
//!    depend on the number of threads: [`ScenePairs::row_sums`] holds nothing but the sums,
//!    [`ScenePairs::for_each_row`] one row, [`ScenePairs::tile`] one tile, [`ExchangeAreas`] the
//!    whole matrix.
//!
//! Where coordinates are rounded, [`ScenePairs::resolution_error`] bounds what that can change of
//! an exchange area; it stands beside the error of the computation and is never mixed with it.
//!
//! [`Closure`] asks whether the rows of form factors sum to one, [`MatrixLaws`] which laws a matrix
//! from anywhere breaks; [`PassSummary`] counts pairs by route and reports the pair that is
//! farthest from its tolerance.
//!
//! # The pairs that are not computed
//!
//! The inside of a cube, as counted by `infoscene measure cube:N` (its JSON has the whole plan):
//!
//! | N | patches | pairs | computed |
//! |---|---|---|---|
//! | 10 | 600 | 179,700 | 796 |
//! | 16 | 1,536 | 1,178,880 | 2,312 |
//! | 32 | 6,144 | 18,871,296 | 17,424 |
//! | 64 | 24,576 | 301,977,600 | 135,200 |
//!
//! Corners that were turned are rounded, and congruent pairs equal within a bound, which is part of
//! the error of the value that they share: where it does not meet the tolerance, near 1e-13, each
//! pair is computed.
//!
//! A pass takes time of order n², as every pair that is not left out looks its class up, and memory
//! of order n, unless the matrix is held. `--every-pair` ([`Congruence::Ignored`]) computes each
//! pair on its own: a check on the plan, and a measure of its worth. A grid on a box finds its
//! classes without comparing single pairs ([`BoxGrid`](crate::discretize::BoxGrid)).
//!
//! # What stands in the way
//!
//! Where something can stand between two patches, each pair looks up what does (`pairs/sights`),
//! and is evaluated past it ([`Polygon::exchange_area_past`]), once for all configurations that are
//! congruent (`pairs/configurations`); a pair that convex bodies hide is 0 without an integral.
//! [`Occlusion`] is the policy. The plan counts pairs that are visible, partial and hidden.
//!
//! [`Occlusion`]: crate::scene::Occlusion
//! [`Polygon::exchange_area_past`]: crate::form_factor::Polygon::exchange_area_past
//!
//! [`ScenePoints`] sees the rows from single points, past all that stands in the way.
//!
//! A pass may be shared out among processes ([`Ranks`]); its sums have the same bits for any
//! number.
//!
//! [`MatrixStore`] keeps a matrix that is larger than memory in a folder, tile by tile.
//!
//! **Not covered**: reflection on the way, which is transport's.

mod blocks;
mod closure;
mod error;
mod matrix_laws;
mod pair_source;
mod pairs;
mod passes;
mod plan;
mod points;
mod progress;
mod ranks;
mod resolution;
mod resolution_errors;
mod rows;
mod scene_pairs;
mod selection;
mod store;
mod tolerance;

pub use blocks::{HeldBlocks, LowerBlocks};
pub use closure::{Closure, RowSum};
pub use error::ExchangeError;
pub use matrix_laws::{BrokenLaw, MatrixLaws, MatrixLawsError};
pub use pair_source::PairSource;
pub use passes::lower_pairs::LowerPairs;
pub use passes::matrix::ExchangeAreas;
pub use passes::row_sums::TileSums;
pub use passes::rows::Entry;
pub use passes::shared_out::{ExchangeBlocks, ResolutionRows};
pub use passes::tiles::{Tile, TileAnswers};
pub use plan::Congruence;
pub use plan::counts::{
    IgnoredOcclusion, OcclusionCounts, PassCounts, PassSummary, PlanSummary, Unreached,
};
pub use points::{PointRow, ScenePoints};
pub use progress::{Progress, Unheard};
#[cfg(feature = "report")]
pub(crate) use ranks::gather_texts;
pub use ranks::{Alone, RankFailed, Ranks, failure};
pub(crate) use ranks::{Deal, agreed};
pub use resolution_errors::ResolutionErrors;
pub use scene_pairs::ScenePairs;
pub use selection::Selection;
pub(crate) use store::unread;
pub use store::{
    MatrixStore, ProductFiles, Shard, StoreError, StoreFilled, StoreState, StoredBlocks,
    StoredMatrix, check_store,
};
pub use tolerance::Tolerance;
