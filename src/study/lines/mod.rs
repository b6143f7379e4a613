//! Random lines: the spread of their estimates, and the readings of fig. 5.
//!
//! [`sampling`] sets error against run time for the plug-in and the corrected estimates, beside the
//! closed forms; [`figure_5`] reads the values printed there as plug-in estimates.

pub mod figure_5;
pub mod sampling;
