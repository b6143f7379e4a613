//! Random lines: the spread of their estimates, and the readings of fig. 5.

pub mod figure_5;
pub mod sampling;
