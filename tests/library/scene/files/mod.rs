//! Scene files: what is read, what is refused and how, and that what is written reads back.

mod decimals;
mod faces;
mod fuzzing;
mod last_places;
mod obj;
mod refusals;
mod round_trip;
mod view3d;

use infoscene::scene::files::{
    FileError, LoadedScene, NonPlanarFaces, Source, read_obj, read_view3d,
};

/// A library that no file is in.
fn no_library(name: &str) -> Result<Source, FileError> {
    Source::read(&std::path::Path::new("/nowhere").join(name))
}

fn obj(text: &str) -> Result<LoadedScene, FileError> {
    let source = Source::new("room.obj", text);
    read_obj(&source, &no_library, NonPlanarFaces::Refuse)
}

/// An OBJ file whose only library has this text.
fn obj_with(text: &str, materials: &str) -> Result<LoadedScene, FileError> {
    let library = |name: &str| Ok(Source::new(name, materials));
    read_obj(
        &Source::new("room.obj", text),
        &library,
        NonPlanarFaces::Refuse,
    )
}

fn vs3(text: &str) -> Result<LoadedScene, FileError> {
    read_view3d(&Source::new("room.vs3", text), NonPlanarFaces::Refuse)
}
