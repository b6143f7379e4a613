//! Scenes from one format to another: what is kept to the last bit, what is said to be lost, and
//! what is refused.

use crate::scenes::number;
use crate::{infoscene, json};
use std::fs;
use tempfile::TempDir;

/// A folder, and paths in it.
struct Folder(TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> String {
        self.0.path().join(name).to_str().unwrap().to_owned()
    }

    fn bytes(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap()
    }

    /// Converts, and returns what is said on standard error.
    fn convert(&self, scene: &str, out: &str, options: &[&str]) -> String {
        let out = self.path(out);
        let arguments = [&["convert", scene, &out], options].concat();
        let done = infoscene(&arguments).assert().success().stdout("");
        String::from_utf8(done.get_output().stderr.clone()).unwrap()
    }

    fn refused(&self, scene: &str, out: &str) -> String {
        let done = infoscene(&["convert", scene, &self.path(out)])
            .assert()
            .code(2)
            .stdout("");
        assert!(fs::metadata(self.path(out)).is_err(), "{out} is written");
        String::from_utf8(done.get_output().stderr.clone()).unwrap()
    }
}

/// The form factors of all pairs.
fn form_factors(scene: &str, options: &[&str]) -> Vec<f64> {
    let answer = json(&[&["form-factor", scene], options].concat());
    let records = answer["form_factors"].as_array().unwrap().iter();
    records.map(|record| number(&record["value"])).collect()
}

/// Squares become triangles in STL, and the triangles, joined again, exchange what the squares did
/// to the last bit.
#[test]
fn a_cube_goes_through_stl_and_comes_back() {
    let folder = Folder::new();
    let refusal = folder.refused("cube:1", "cube.stl");
    assert!(
        refusal.contains("has 4 corners: cut it into triangles; --triangulate does"),
        "{refusal}"
    );
    let said = folder.convert("cube:1", "cube.stl", &["--triangulate"]);
    assert_eq!(
        said,
        "infoscene: STL has no names of patches: they are lost\n"
    );
    assert_eq!(folder.bytes("cube.stl").len(), 84 + 50 * 12);
    let cube = folder.path("cube.stl");
    assert_eq!(
        form_factors(&cube, &["--merge"]),
        form_factors("cube:1", &[])
    );
    let arguments = ["measure", &cube, "--merge", "--format", "json"];
    let joined = infoscene(&arguments).assert().success();
    let said = String::from_utf8(joined.get_output().stderr.clone()).unwrap();
    assert_eq!(
        said,
        "infoscene: 12 patches are joined with neighbours in their planes: 6\n"
    );
}

/// STL to OBJ or View3D and back: the same bytes.
#[test]
fn triangles_come_back_from_every_format() {
    let folder = Folder::new();
    folder.convert("octahedron", "one.stl", &[]);
    for between in ["room.obj", "room.vs3"] {
        folder.convert(&folder.path("one.stl"), between, &[]);
        folder.convert(&folder.path(between), "two.stl", &[]);
        assert_eq!(
            folder.bytes("two.stl"),
            folder.bytes("one.stl"),
            "{between}"
        );
    }
}

/// What a format cannot hold is said, and with --triangulate polygons of many corners are rows of
/// triangles in View3D, so that the answers stay.
#[test]
fn losses_are_said_and_rows_are_kept() {
    let folder = Folder::new();
    let said = folder.convert("cornell-box", "room.stl", &["--triangulate"]);
    for part in [
        "no names",
        "all patches become black",
        "rounded, by up to 2.4e-5",
    ] {
        assert!(said.contains(part), "no \"{part}\" in {said}");
    }
    let refusal = folder.refused("dodecahedron", "solid.vs3");
    assert!(
        refusal.contains("has 5 corners: cut it into triangles; --triangulate"),
        "{refusal}"
    );
    assert_eq!(
        folder.convert("dodecahedron", "solid.vs3", &["--triangulate"]),
        ""
    );
    let [one, two] = [folder.path("solid.vs3"), "dodecahedron".to_owned()]
        .map(|scene| json(&["form-factor", &scene]));
    assert_eq!(one["patches"].as_array().unwrap().len(), 12);
    let values = |answer: &serde_json::Value| -> Vec<f64> {
        let records = answer["form_factors"].as_array().unwrap().iter();
        let pairs = records.filter(|record| record["from"] != record["to"]);
        pairs.map(|record| number(&record["value"])).collect()
    };
    for (one, two) in values(&one).into_iter().zip(values(&two)) {
        assert!((one - two).abs() < 1e-12, "{one} {two}");
    }
}

/// A scene that is more than faces is refused where it would become another one.
#[test]
fn what_changes_the_geometry_is_refused() {
    let folder = Folder::new();
    let square = "F 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nV 4 0 1 0\nS 1 1 2 3 0 0 0 .5 a\n";
    for (name, more, says) in [
        ("obstructed", "O 2 1 2 3 0\n", "a polygon only obstructs"),
        (
            "summed",
            "S 2 1 3 4 0 0 1 .5 b\n",
            "patches are summed into one row",
        ),
    ] {
        let scene = folder.path(&format!("{name}.vs3"));
        fs::write(&scene, format!("{square}{more}End of data\n")).unwrap();
        for out in ["room.obj", "room.stl"] {
            let refusal = folder.refused(&scene, out);
            assert!(
                refusal.contains(says) && refusal.contains("write View3D"),
                "{refusal}"
            );
        }
    }
}
