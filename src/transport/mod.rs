//! The equilibrium of light: radiosity and importance of a discretized scene.
//!
//! ```text
//!   B_i = E_i + R_i H_i,   H_i = Σ_j F_ij B_j            I_i = V_i + Σ_j F_ij R_j I_j
//! ```
//!
//! With the reflected importance `U = R I` the second equation is the first with the source `R V`:
//! one solver serves both ([`RadiositySystem`]). [`walks`] estimate the same by random walks,
//! without variance where the paper's probabilities steer them (§3.4, §3.5).
//!
//! # Accuracy
//!
//! Reflectances may be any up to 1, as long as light from everywhere comes to a patch that absorbs
//! some or to an opening ([`Sinkless`]). Each value has two bounds: one on the solution for the
//! form factors as computed, and one on the effect of the form factors' own errors. A closed scene
//! is solved in a form in which it is closed, so that no error is divided by 1 − R, and residuals
//! are taken with 106 bits. Rooms that absorb 1e-15 of the light, rooms that see 1e-100 of each
//! other, and emission over thirty orders of magnitude therefore keep all their digits, where
//! elimination and iterated bounces lose some or all. `infoscene study stability` compares the
//! three, judged by enclosures of 256 bits; `stiff_scenes_keep_their_digits` holds it.
//! `cargo bench --bench transport` times 5,046 patches.
//!
//! ```
//! use infoscene::chain::brightness_chain;
//! use infoscene::information::mutual_information;
//! use infoscene::scene::{Material, Scene};
//! use infoscene::transport::RadiositySystem;
//! use infoscene::transport::walks::Steering;
//!
//! // a cube whose faces reflect 60 % and of which one emits
//! let exchange = Scene::built_in("cube:2")?.exchange_areas()?;
//! let room = RadiositySystem::of(&exchange, &[Material::try_new(0.6, 0.0)?; 24])?;
//! let emittances: Vec<f64> = (0..24).map(|patch| if patch < 4 { 1.0 } else { 0.0 }).collect();
//! let light = room.radiosity(&emittances)?;
//! // R is the same everywhere: mean B = mean E/(1 − R), whatever the geometry
//! assert!((light.values.iter().sum::<f64>() / 24.0 - (1.0 / 6.0) / 0.4).abs() < 1e-14);
//! assert!(light.relative_error < 1e-15);
//!
//! // the chain of §3.4, and walks by its probabilities, each of which finds the radiosity
//! let chain = brightness_chain(&exchange, &light.values)?;
//! assert!(mutual_information(&chain) > 0.3);
//! let walks = room.gathering_walks(10, &emittances, Steering::Towards(&light.values), 100, 1)?;
//! assert!(walks.farthest < 1e-14);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Not covered**: occlusion beyond the form factors given; reflection that is not diffuse.

mod changes;
mod dense;
mod error;
mod form_factor_errors;
mod held_system;
mod operator;
mod products;
mod scene_exchange;
mod sinks;
mod solve;
mod system;
pub mod walks;

pub use dense::DenseExchange;
pub use error::TransportError;
pub use operator::ExchangeOperator;
pub use scene_exchange::{SceneExchange, SceneOperator};
pub use sinks::Sinkless;
pub use system::{ExchangeRows, Importance, RadiositySolution, RadiositySystem};
