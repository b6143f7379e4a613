//! The slow roads that judge the others.

mod exchange;
mod fixed_float;
mod halfway;
