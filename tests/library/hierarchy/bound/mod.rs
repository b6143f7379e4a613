//! The bound on the error of radiosities against the continuous solution.

mod effectivity;
mod furnace;
mod hidden;
mod linear;
mod local;
mod rooms;
mod solver;
mod truth;
