//! Stiff radiosity systems, and the variance of random walks.
//!
//! [`stability`] sets the solvers side by side on scenes where digits are lost (reflectance near 1,
//! rooms that hardly see each other, emission over thirty orders of magnitude), judged at 256 bits.
//! [`walks`] measures the variance of random walks by the probabilities that steer them.

pub mod stability;
pub mod walks;
