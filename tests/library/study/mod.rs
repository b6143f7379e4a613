//! Studies, as far as they are claims of the library.

mod families;
mod refinement;
