//! Scene files: what is read, what is refused and how, and that what is written reads back.

mod decimals;
mod faces;
mod fuzzing;
mod last_places;
mod materials;
mod obj;
mod outlines;
mod refusals;
mod round_trip;
mod stl;
mod view3d;

use infoscene::scene::files::{
    FileError, FileErrors, LoadedScene, NonPlanarFaces, Source, read_obj, read_stl, read_view3d,
};
use std::path::Path;

/// A library that no file is in.
fn no_library(name: &str) -> Result<Source, FileError> {
    Source::read(&Path::new("/nowhere").join(name))
}

fn obj(text: &str) -> Result<LoadedScene, FileErrors> {
    let source = Source::new("room.obj", text);
    read_obj(&source, &no_library, NonPlanarFaces::Refuse)
}

/// An OBJ file whose only library has this text.
fn obj_with(text: &str, materials: &str) -> Result<LoadedScene, FileErrors> {
    let library = |name: &str| Ok(Source::new(name, materials));
    read_obj(
        &Source::new("room.obj", text),
        &library,
        NonPlanarFaces::Refuse,
    )
}

fn vs3(text: &str) -> Result<LoadedScene, FileErrors> {
    read_view3d(&Source::new("room.vs3", text), NonPlanarFaces::Refuse)
}

fn stl(bytes: impl Into<Vec<u8>>) -> Result<LoadedScene, FileErrors> {
    read_stl(Path::new("room.stl"), bytes.into(), NonPlanarFaces::Refuse)
}
