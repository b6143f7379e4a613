//! What the rows of a scene exchange: sums over parts, plans, closed rooms.

mod bases;
mod closure;
mod plan;
mod promises;
mod rows;
mod tiles;
