//! Scenes: what is there, what overlaps, what stands between, and their files.

mod blockers;
mod cornell_box;
mod files;
mod fronts;
mod joined;
mod joints;
mod lit_rooms;
mod mesh_arrays;
mod overlap;
mod parts;
mod refusals;
mod resolution;
mod shafts;
