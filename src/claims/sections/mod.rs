//! Computations of the claims, a file for each section of the paper.

pub(crate) mod appendix;
pub(crate) mod continuous_limit;
pub(crate) mod figure_5;
pub(crate) mod section_2;
pub(crate) mod section_3;
pub(crate) mod section_3_light;
pub(crate) mod section_4_1;
pub(crate) mod section_4_2;
pub(crate) mod section_5;
