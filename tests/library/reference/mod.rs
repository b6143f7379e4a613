//! The slow roads that judge the others.

mod box_radiosity;
mod exchange;
mod fixed_float;
mod halfway;
