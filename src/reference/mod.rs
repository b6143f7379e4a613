//! Slow roads that judge the fast ones.
//!
//! Nothing of the library uses them: studies, tests and benches compare with them. [`Truth`] is the
//! exact value of an exchange area to compare with; it takes aligned rectangles from their closed
//! form in intervals, and all others from [`exchange`], an independent integral of any two polygons
//! to twenty digits and more. [`fixed_float`] has its numbers. [`exact_gain`] encloses the gain of
//! a refinement from the definition. [`exchange_area_past`] integrates what points see past
//! polygons that stand in the way, and [`past_halfway_plates`] has the exact value where these
//! are half-way between two squares. [`BoxRadiosity`] is the radiosity of a box at any point.

mod box_room;
pub mod exchange;
pub mod fixed_float;
mod gain;
mod halfway;
mod occluded;
mod truth;

pub use box_room::{BoxRadiosity, BoxRoomError, ElementMoments, relative_error};
pub use gain::exact_gain;
pub use halfway::past_halfway_plates;
pub use occluded::exchange_area_past;
pub use truth::Truth;
