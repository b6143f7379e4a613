//! Stiff radiosity systems, and the variance of random walks.

pub mod stability;
pub mod walks;
