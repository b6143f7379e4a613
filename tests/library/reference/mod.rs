//! The slow roads that judge the others.

mod exchange;
mod wide_numbers;
