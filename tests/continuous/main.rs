//! Continuous mutual information: known values, invariances, and three other roads to it.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod known_values;
