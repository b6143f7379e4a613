//! The generated pages of `data/report`: claims, findings, and what is trusted.

pub(crate) mod claims;
pub(crate) mod findings;
mod findings_profiles;
mod findings_refinement;
pub(crate) mod trusted;
