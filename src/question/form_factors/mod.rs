//! Questions about form factors: of pairs, as a matrix, from points, in a store.

mod matrix;
mod pairs;
mod points;
pub(super) mod store;

pub use matrix::{FormFactorMatrix, MatrixEntries, MatrixLine};
pub use pairs::{FormFactorRecord, FormFactors, FormFactorsAnswer, PatchRecord};
pub use points::{PointRecord, PointSource, Points, PointsAnswer, SeenPatch, SeenRecord};
pub use store::{CheckStore, StoreAnswer, StoreFormFactors};
