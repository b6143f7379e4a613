//! Debug.

use infoscene::scene::files::{NonPlanarFaces, read};

#[test]
fn debug_resolution() {
    for name in ["30-panel-wall-mm", "33-turned-cube-triangles", "34-turned-cube-quads"] {
        let path = format!("/work/shared/field/{name}.obj");
        let scene = read(path.as_ref(), NonPlanarFaces::Refuse).unwrap().scene;
        println!("{name} {} {:?} {:?}", scene.resolution(), scene.blocker(), scene.overlap());
    }
}
