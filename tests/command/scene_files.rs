//! SCENE as its users give it: a built-in name or a file, with messages on standard error only.

use crate::{infoscene, json};
use std::path::{Path, PathBuf};

fn scene_file(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/scenes");
    folder.join(name).to_str().unwrap().to_owned()
}

/// A file in a folder that lives as long as the test.
fn written(folder: &tempfile::TempDir, name: &str, text: impl AsRef<[u8]>) -> PathBuf {
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    path
}

/// Exit status 2, one message on standard error, nothing on standard output and no file.
fn assert_refused(path: &Path, parts: &[&str]) {
    let folder = tempfile::tempdir().unwrap();
    let output = folder.path().join("answer.json");
    let assertion = infoscene(&["split", path.to_str().unwrap(), "--patch", "0"])
        .args(["--format", "json", "--output", output.to_str().unwrap()])
        .assert()
        .code(2);
    let streams = assertion.get_output();
    assert!(streams.stdout.is_empty() && !output.exists());
    let message = String::from_utf8(streams.stderr.clone()).unwrap();
    assert_eq!(message.lines().count(), 1, "{message}");
    for part in parts.iter().chain(&[path.to_str().unwrap()]) {
        assert!(message.contains(part), "no \"{part}\" in {message}");
    }
}

#[test]
fn a_file_answers_as_the_built_in_scene_does() {
    for (file, name) in [
        ("two-squares.obj", "two-squares"),
        ("three-squares.obj", "three-squares"),
        ("cube-3.obj", "cube:3"),
    ] {
        let ask = |scene: &str| {
            json(&[
                "split",
                scene,
                "--patch",
                "0",
                "--triangulate",
                "--unoccluded",
            ])
        };
        assert_eq!(ask(&scene_file(file)), ask(name), "{file}");
    }
}

/// The light of the Cornell box against the right wall: as in fig. 2 the best cut is nearer to the
/// wall, which is where axis v runs to.
#[test]
fn the_cornell_box_is_a_scene() {
    let right = infoscene::scene::Scene::built_in("cornell-box").unwrap();
    assert_eq!(right.patches()[7].name(), "right wall 0");
    let light = [
        "split",
        "cornell-box",
        "--patch",
        "1",
        "--against",
        "7",
        "--axis",
        "v",
    ];
    let answer = json(&light);
    assert!(answer["gain"].as_f64().unwrap() > 0.0);
    assert!(answer["position"].as_f64().unwrap() > 0.5);
    let file = scene_file("cornell-box.obj");
    assert_eq!(
        answer,
        json(&[&["split", file.as_str()], &light[2..]].concat())
    );
}

/// Every patch of the Cornell box can be cut against all others, which stand at any angle.
#[test]
fn every_patch_of_the_cornell_box_can_be_cut() {
    let patches = infoscene::scene::Scene::built_in("cornell-box").unwrap();
    for patch in 0..patches.patches().len() {
        let patch = patch.to_string();
        let answer = json(&["split", "cornell-box", "--patch", &patch]);
        let number = |key: &str| answer[key].as_f64().unwrap();
        assert!(
            number("gain") > 0.0 && number("gain") <= number("maximum_gain"),
            "{answer}"
        );
        assert!(
            number("gain") >= number("gain_at_middle") * (1.0 - 1e-11),
            "{answer}"
        );
        assert!(number("residual") <= 1e-12, "{answer}");
    }
}

#[test]
fn what_is_ignored_is_said_on_standard_error() {
    let folder = tempfile::tempdir().unwrap();
    let text = "C encl=1 maxU=9\nF 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nV 4 0 1 0\nV 5 0 0 1\n\
        V 6 0 1 1\nS 1 1 2 3 4 0 0 .5 floor\nS 2 1 4 6 5 0 0 .5 wall\nO 3 1 3 5 0\nEnd of data\n";
    let path = written(&folder, "squares.vs3", text);
    let path = path.to_str().unwrap();
    let arguments = ["split", path, "--patch", "0", "--format", "json"];
    let refused = infoscene(&arguments).assert().code(2);
    let message = String::from_utf8(refused.get_output().stderr.clone()).unwrap();
    assert!(
        message.contains("unoccluded values; --unoccluded computes"),
        "{message}"
    );
    let answered = infoscene(&arguments).arg("--unoccluded").assert().success();
    let message = String::from_utf8(answered.get_output().stderr.clone()).unwrap();
    assert!(message.contains("encl, maxu are ignored"), "{message}");
    let answer: serde_json::Value = serde_json::from_slice(&answered.get_output().stdout).unwrap();
    assert_eq!(answer, json(&["split", "two-squares", "--patch", "0"]));
}

#[test]
fn bad_files_are_refused_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let wall =
        "v 552.8 0 0\nv 549.6 0 559.2\nv 556 548.8 559.2\nv 556 548.8 0\no left wall\nf 1 2 3 4\n";
    let bent = written(&folder, "bent.obj", wall);
    assert_refused(
        &bent,
        &[
            "line 6",
            "patch 0 (left wall 0)",
            "off the plane",
            "--triangulate",
        ],
    );
    // its triangles see each other, at the shallow angle of the bend
    let bent = bent.to_str().unwrap();
    let answer = json(&["split", bent, "--patch", "0", "--triangulate"]);
    assert!(answer["gain"].as_f64().unwrap() > 0.0, "{answer}");
    for (name, text, parts) in [
        (
            "noise.obj",
            "noise\n".repeat(1_000_000),
            ["line 1", "no \"noise\""],
        ),
        (
            "noise.vs3",
            "noise\n".repeat(1_000_000),
            ["line 1", "no \"noise\""],
        ),
        (
            "empty.obj",
            String::new(),
            ["it has no patch", "\"f a b c\""],
        ),
        (
            "empty.vs3",
            String::new(),
            ["\"End of data\" is missing", "add it"],
        ),
        (
            "lost.obj",
            "mtllib lost.mtl\n".to_owned(),
            ["line 1", "lost.mtl: it cannot be read"],
        ),
        ("room.stl", wall.to_owned(), [".obj", ".vs3"]),
    ] {
        assert_refused(&written(&folder, name, text), &parts);
    }
    assert_refused(
        &written(&folder, "bytes.obj", b"v 0 0 0\n\xff\xfe"),
        &["line 2", "UTF-8"],
    );
    assert_refused(&folder.path().join("missing.obj"), &["cannot be read"]);
    assert_refused(folder.path(), &["it is a folder"]);
}

/// A scene that is written is the same when read, in either format; one that a format cannot hold
/// is refused and nothing is written.
#[test]
fn scenes_are_converted() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let names = || {
        let entries = folder.path().read_dir().unwrap();
        let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name()).collect();
        names.sort();
        names
    };
    for refused in [
        ["convert", "cornell-box", &path("room.vs3")],
        ["convert", "cornell-box", &path("room.stl")],
        ["convert", "cornell-box", &path("no folder/room.obj")],
        ["convert", "cornell-box", &path("room #1.obj")],
        ["convert", "nothing", &path("room.obj")],
    ] {
        infoscene(&refused).assert().code(2).stdout("");
        assert!(names().is_empty(), "{refused:?} wrote {:?}", names());
    }
    for (scene, out, written) in [
        (
            "cornell-box",
            "my room.obj",
            vec!["my room.mtl", "my room.obj"],
        ),
        (
            "two-squares",
            "squares.vs3",
            vec!["my room.mtl", "my room.obj", "squares.vs3"],
        ),
    ] {
        infoscene(&["convert", scene, &path(out)])
            .assert()
            .success()
            .stdout("");
        assert_eq!(names(), written);
    }
    let read = |name: &str| {
        let path = folder.path().join(name);
        infoscene::scene::files::read(&path, infoscene::scene::files::NonPlanarFaces::default())
            .unwrap()
            .scene
    };
    let built_in = |name: &str| infoscene::scene::Scene::built_in(name).unwrap();
    assert_eq!(read("my room.obj"), built_in("cornell-box"));
    assert_eq!(read("squares.vs3"), built_in("two-squares"));
}
