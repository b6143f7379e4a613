//! Error against run time of the routes to a form factor, and extreme pairs.
//!
//! [`accuracy`] measures every route on known pairs and on random ones, [`families`] draws the
//! random ones, each family aimed at one difficulty, [`occluded`] those with polygons in the way,
//! and [`extreme_pairs`] counts the digits that each route keeps of the pairs listed in
//! `extreme_cases`. [`tolerances`] takes whole scenes from loose tolerances to tight ones.
//! `gauss_order` is what engines without error control do, for comparison. All are judged by
//! [`reference`](mod@crate::reference).

pub mod accuracy;
pub(crate) mod extreme_cases;
pub mod extreme_pairs;
pub mod families;
pub(crate) mod gauss_order;
pub mod occluded;
pub mod tolerances;
