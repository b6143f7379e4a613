//! The side to which a computation can decide, where it cannot decide to both.
//!
//! ```text
//!   estimate, sample                          supports, never refutes
//!   configuration left open by the paper      confirms, never refutes
//!   an equality of real numbers, enclosed     refutes, never confirms
//!   one instance of a general statement       confirms or refutes, as it may be
//! ```
//!
//! A claim says so in its data, and a test compares that with its finding. Theorems are not bound
//! by it: they raise a finding afterwards.

/// The only side to which a computation can decide: else the claim is left open.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum OneSided {
    /// The computation supports or confirms, and never refutes.
    Confirm,
    /// The computation refutes, and never supports.
    Refute,
}
