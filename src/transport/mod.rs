//! The equilibrium of light: radiosity and importance of a discretized scene.
//!
//! ```text
//!   B_i = E_i + R_i H_i,   H_i = Σ_j F_ij B_j            I_i = V_i + Σ_j F_ij R_j I_j
//! ```
//!
//! With the reflected importance `U = R I` the second is the first with the source `R V`: one
//! solver serves both ([`RadiositySystem`]), to the last digit and with a bound on its own error
//! apart from that of the form factors. [`walks`] estimate the same by random walks, without
//! variance where the paper's probabilities steer them (§3.4, §3.5).
//!
//! **Not covered**: occlusion beyond what the form factors know; reflection that is not diffuse.

mod conjugate_gradients;
mod dense;
mod error;
mod operator;
mod solve;
mod system;
pub mod walks;

pub use dense::DenseExchange;
pub use error::TransportError;
pub use operator::ExchangeOperator;
pub use system::{ExchangeRows, Importance, RadiositySolution, RadiositySystem};
