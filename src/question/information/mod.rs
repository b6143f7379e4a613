//! Questions about information: of a scene's chain, computed or sampled.

mod measure;
mod measured;
mod sample;
mod sampled;

pub use measure::Measure;
pub use measured::{Contribution, FacePairRecord, MeasureAnswer, PairLossRecord, RowSumRecord};
pub use sample::{Sample, SampleAnswer};
pub use sampled::SampledInformation;
