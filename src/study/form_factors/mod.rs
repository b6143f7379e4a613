//! Error against run time of the routes to a form factor, and extreme pairs.

pub mod accuracy;
pub(crate) mod extreme_cases;
pub mod extreme_pairs;
pub mod families;
pub(crate) mod gauss_order;
