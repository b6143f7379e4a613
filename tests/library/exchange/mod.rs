//! Exchange between the rows of a scene: sums over parts, plans, closed rooms.

mod bases;
mod closure;
mod frames;
mod images;
mod matrix_laws;
mod occluded;
mod plan;
mod points;
mod promises;
mod ranks;
mod resolution;
mod rows;
mod screens;
mod selections;
mod stored;
mod stores;
mod tiles;
mod together;
