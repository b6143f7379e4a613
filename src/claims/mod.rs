//! Every claim of the paper as data, the function that computes it, and the rule that judges it.
//!
//! The claims stand in `data/paper/`, in paper order: place, quantity in our own words, printed value if
//! there is one, the recorded verdict, the inputs of the computation, and a *control*: a change of input
//! under which the verdict must turn; and the theorems of `proofs/` that prove the claim as it stands, or its
//! contrary. One file per section computes; [`judge`] judges by the mechanical rule of [`Verdict`]. A theorem raises what
//! agrees with it to *proof*; it never hides a computation that does not agree.
//!
//! **Not here**: printing.

mod appendix;
mod claim;
mod continuous_limit;
mod error;
mod extremes;
mod figure_5;
mod finding;
mod inputs;
mod registry;
mod section_2;
mod section_3;
mod section_3_light;
mod section_4_1;
mod section_4_2;
mod section_5;
mod verdict;

pub use claim::{Claim, Printed, Task};
pub use error::ClaimError;
pub use figure_5::samples_for;
pub use finding::{Computation, Evidence, Finding, Measure};
pub use inputs::{DEFAULT_PRECISION, Inputs};
pub use registry::{Judgement, computations, judge, judge_all, judge_control, registry};
pub use verdict::Verdict;
