//! Tools that several rooms share: reading `data/reference`, judges of high precision, rooms,
//! generators.
pub mod breadth;
pub mod furnished;
pub mod high_precision;
pub mod intervals;
pub mod misrounded;
pub mod ranks;
pub mod references;
pub mod rooms;
pub mod rounded_rooms;
pub mod strategies;
pub mod streets;
