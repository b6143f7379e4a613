//! Questions: their answers, and the records that these serialize to.

mod cut;
mod grid;
mod nets;
mod patch_names;
mod remedies;
mod reproduce;
mod scenes;
mod studies;
