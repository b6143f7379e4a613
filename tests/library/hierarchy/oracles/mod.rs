//! Oracles: names, laws, known values, and what each is worth.

mod known_values;
mod laws;
mod names;
mod worth;
