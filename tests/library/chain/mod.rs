//! Chains of visibility and of light.

mod brightness;
mod refusals;
