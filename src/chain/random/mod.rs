//! Random reversible chains and refinements: seeded, from bytes, or as proptest strategies.

pub mod families;
pub mod seeded;
#[cfg(feature = "proptest")]
pub mod strategies;
