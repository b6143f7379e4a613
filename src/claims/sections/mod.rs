//! Computations of the claims, a file for each section of the paper.
//!
//! Each function takes a [`Case`](crate::claims::Case), its inputs and the precision asked for, and
//! returns a [`Finding`](crate::claims::Finding), never a verdict: the rule of
//! [`Verdict`](crate::claims::Verdict) judges it. [`Computation`](crate::claims::Computation) names
//! the functions, and `data/paper` says which claim calls which. `continuous_limit` belongs to §2
//! and Corollary 1, `figure_5` and `regular_grids` to §4.1, `section_3_light` to §3.4 and §3.5;
//! `shadows` is fig. 1 and App. B in general position, `refinement` the oracle of §5 and §6 at
//! work; `lit` and `enclosed` hold scenes that several share.

pub(crate) mod appendix;
pub(crate) mod continuous_limit;
pub(crate) mod enclosed;
pub(crate) mod figure_5;
pub(crate) mod lit;
pub(crate) mod refinement;
pub(crate) mod regular_grids;
pub(crate) mod section_2;
pub(crate) mod section_3;
pub(crate) mod section_3_light;
pub(crate) mod section_4_1;
pub(crate) mod section_4_2;
pub(crate) mod section_5;
pub(crate) mod section_5_oracle;
pub(crate) mod shadows;
