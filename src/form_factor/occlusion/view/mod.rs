//! Lines of sight past screens: the pair as it is set, stretches of edges, and planes through them.

pub(crate) mod frame;
pub(crate) mod outer;
pub(crate) mod pages;
pub(crate) mod region;
pub(crate) mod setting;
pub(crate) mod sight;
pub(crate) mod trace;
