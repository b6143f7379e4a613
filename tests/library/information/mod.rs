//! Mutual information: Theorem 1, measures of scenes, continuous and sampled values.

mod continuous;
mod divergence;
mod known_values;
mod light;
mod negative_controls;
#[cfg(feature = "proptest")]
mod refinement;
mod sampled;
mod streaming;
