//! infoscene
pub mod numeric; pub mod geometry; pub mod form_factor; pub mod scene; pub mod chain; pub mod information; pub mod discretize;
