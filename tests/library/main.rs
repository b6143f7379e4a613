//! The library: one folder a room of `src`, one law or idea a file, with its negative controls.
#![expect(
    clippy::unwrap_used,
    clippy::float_cmp,
    reason = "a test may panic, and compares what is exact"
)]
#![expect(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "a test counts little"
)]
#![expect(
    unreachable_pub,
    reason = "nothing is reached from outside: what other modules use is `pub`"
)]

mod chain;
mod claims;
mod discretize;
mod exchange;
mod form_factor;
mod geometry;
mod hierarchy;
mod information;
mod numeric;
mod question;
mod reference;
mod report;
mod scene;
mod study;
mod support;
mod transport;
