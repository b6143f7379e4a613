//! Chains of visibility and of light.

mod brightness;
mod refinement;
mod reversible;
