//! Every claim of the paper as data, its computation, and the rule that judges it.
//!
//! The claims stand in `data/paper/`, in paper order: place, quantity in our own words, printed
//! value if there is one, the recorded verdict, the name and the inputs of the [`Computation`], a
//! *control*, and the theorems of `proofs/` that prove the claim as it stands, or its contrary. One
//! file per section computes; [`judge`] judges by the mechanical rule of [`Verdict`]. Computations
//! that share something expensive find it in their [`Context`].
//!
//! # How to read a verdict
//!
//! A printed 0.40 stands for the interval from 0.395 to 0.405. A claim in words is a predicate over
//! computed numbers.
//!
//! | verdict | means |
//! |---|---|
//! | confirmed | an enclosure lies inside what is printed, or a proof stands |
//! | supported | an estimate agrees within its stated error; nothing stronger yet |
//! | refuted | an enclosure is disjoint, and the paper states the configuration completely |
//! | undecided | anything else, with the reason |
//! | not checked | not computed yet, with the reason |
//!
//! The evidence is a [`Grade`](crate::numeric::Grade). A theorem raises a finding that agrees with
//! it to *proof* before the rule is applied; it never hides a computation that does not agree. A
//! [`Theorem`] stands beside its claim with hypotheses and conclusion: that the two say the same is
//! checked by reading, not by a machine. A
//! control changes the configuration, the formula or the printed number so that the verdict must
//! turn; the theorems say nothing of it, so it is compared with the verdict of the computation
//! alone. What a computation cannot decide, whatever it finds, its claim's data say
//! ([`OneSided`]).
//!
//! **Not here**: printing.

mod case;
mod claim;
mod computation;
mod context;
mod error;
mod finding;
mod formula;
mod inputs;
mod judge;
mod reach;
mod registry;
mod rule;
mod sections;
mod theorem;
mod verdict;

pub use case::Case;
pub use claim::{Claim, Control, Printed, Task};
pub use computation::Computation;
pub use context::{Context, DEFAULT_PRECISION};
pub use error::ClaimError;
pub use finding::{Finding, Quantity};
pub use formula::Formula;
pub use inputs::Inputs;
pub use judge::{Judgement, judge, judge_all, judge_control};
pub use reach::OneSided;
pub use registry::registry;
pub use theorem::Theorem;
pub use verdict::Verdict;
