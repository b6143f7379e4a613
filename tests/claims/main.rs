//! `cargo test` is the reproducibility check: verdicts, controls, and the committed tables.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod coverage;
mod tables;
mod verdicts;
