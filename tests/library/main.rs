//! The library: one folder a room of `src`, one law or idea a file, with its negative controls.
#![expect(
    clippy::unwrap_used,
    clippy::float_cmp,
    reason = "a test may panic, and compares what is exact"
)]
#![allow(clippy::cast_precision_loss, reason = "a test counts little")]

mod chain;
mod claims;
mod discretize;
mod exchange;
mod form_factor;
mod geometry;
mod information;
mod numeric;
mod question;
mod reference;
mod scene;
mod study;
mod support;
mod transport;
