//! SCENE as its users give it: a built-in name or a file, with messages on standard error only.

use crate::scenes::read_npy;
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
fn patches_of_the_cornell_box_can_be_cut() {
    // the floor, the ceiling around the light, a wall
    for patch in [0, 3, 8] {
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
    let answered = infoscene(&arguments).arg("--unoccluded").assert().success();
    let message = String::from_utf8(answered.get_output().stderr.clone()).unwrap();
    let says = "ignored, they change nothing here: C encl (line 1), C maxU (line 1)";
    assert!(message.contains(says), "{message}");
    assert!(
        message.contains("something stands between 1 pairs of patches"),
        "{message}"
    );
    let mut answer: serde_json::Value =
        serde_json::from_slice(&answered.get_output().stdout).unwrap();
    let ignored = answer
        .as_object_mut()
        .unwrap()
        .shift_remove("ignored")
        .unwrap();
    assert_eq!(ignored["pairs"], 1);
    assert_eq!(answer, json(&["split", "two-squares", "--patch", "0"]));
    // past the obstruction another cut is best
    let past = json(&["split", path, "--patch", "0"]);
    assert!(past["gain"].as_f64() != answer["gain"].as_f64(), "{past}");
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
            ["it has no patch", "\"f a b c\""],
        ),
        (
            "noise.vs3",
            "noise\nEnd of data\n".to_owned(),
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
        ("room.step", wall.to_owned(), [".obj", ".stl"]),
    ] {
        assert_refused(&written(&folder, name, text), &parts);
    }
    assert_refused(
        &written(&folder, "bytes.obj", b"\xff\xfev\0 \x000\0"),
        &["UTF-16", "UTF-8"],
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
        ["convert", "cornell-box", &path("room.step")],
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

/// The vertices of two unit squares at distance 1, and a point on an edge.
const SQUARES: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n\
    v 0.5 0 0\n";

/// Parallel unit squares at distance 1: Howell, C-11.
const OPPOSITE: f64 = 0.199_824_895_698_387_5;

/// A repeated corner, a thread between the squares, a statement nobody knows and a name in Latin-1:
/// one remark each, and the answer.
#[test]
fn what_is_clear_is_mended_and_said() {
    let folder = tempfile::tempdir().unwrap();
    let mut text = format!("{SQUARES}frame 7\n").into_bytes();
    text.extend(b"o W\xe4nde # 2\nf 1 2 3 4 4\nf 1 9 2\nf 5 8 7 6\n");
    let path = written(&folder, "squares.obj", text);
    let path = path.to_str().unwrap();
    let output = infoscene(&["form-factor", path, "--from", "0", "--format", "json"])
        .assert()
        .success();
    let answer: serde_json::Value = serde_json::from_slice(&output.get_output().stdout).unwrap();
    let names = answer["patches"].as_array().unwrap().iter();
    let names: Vec<&str> = names.map(|patch| patch["name"].as_str().unwrap()).collect();
    assert_eq!(
        names,
        ["W\u{e4}nde # 2 0", "W\u{e4}nde # 2 1", "W\u{e4}nde # 2 2"]
    );
    let values = answer["form_factors"].as_array().unwrap().iter();
    let values: Vec<f64> = values
        .map(|record| record["value"].as_f64().unwrap())
        .collect();
    assert!(
        values[0] == 0.0 && (values[1] - OPPOSITE).abs() < 1e-14,
        "{values:?}"
    );
    let notes = String::from_utf8(output.get_output().stderr.clone()).unwrap();
    for note in [
        "1 face repeats a corner; that counts once (first: line 12)",
        "1 face has no area; such a face keeps its number and exchanges nothing (first: line 13)",
        "1 byte is not UTF-8 and read as Latin-1 (first: line 11)",
        "ignored, they change nothing here: frame (line 10)",
    ] {
        assert_eq!(notes.matches(note).count(), 1, "{notes}");
    }
    assert_eq!(notes.lines().count(), 4, "{notes}");
}

/// A face without area has 0 in every answer and changes nothing for the others.
#[test]
fn a_face_without_area_exchanges_nothing_in_any_answer() {
    let folder = tempfile::tempdir().unwrap();
    let faces = "f 1 9 2\nf 1 2 3 4\nf 5 8 7 6\n";
    let path = written(&folder, "squares.obj", format!("{SQUARES}{faces}"));
    let path = path.to_str().unwrap();
    let matrix = folder.path().join("f.npy");
    let matrix = matrix.to_str().unwrap();
    infoscene(&["form-factor", path, "--matrix", matrix])
        .assert()
        .success();
    let (_, entries) = read_npy(&std::fs::read(matrix).unwrap());
    let expected = [0.0, 0.0, 0.0, 0.0, 0.0, OPPOSITE, 0.0, OPPOSITE, 0.0];
    for (entry, expected) in entries.iter().zip(expected) {
        assert!((entry - expected).abs() < 1e-14, "{entries:?}");
    }
    // R = ½ and E = 1 on patch 1, E = 3 on the thread: B₂ = R F B₁, B₁ = 1 + R F B₂
    let light = [
        "--reflectance",
        "all=0.5",
        "--emittance",
        "0=3,1=1",
        "--importance",
        "0",
    ];
    let answer = json(&[&["radiosity", path], light.as_slice()].concat());
    let of = |patch: usize, key: &str| answer["patches"][patch][key].as_f64().unwrap();
    let reflected = 0.5 * OPPOSITE;
    let lit = 1.0 / (1.0 - reflected * reflected);
    for (patch, radiosity) in [(0, 3.0), (1, lit), (2, reflected * lit)] {
        assert!(
            (of(patch, "radiosity") - radiosity).abs() < 1e-14,
            "{answer}"
        );
    }
    assert_eq!(
        (
            of(0, "irradiance"),
            of(0, "importance"),
            of(1, "importance")
        ),
        (0.0, 1.0, 0.0)
    );
    let measured = json(&["measure", path, "--open"]);
    assert_eq!(measured["contributions"][0]["weight"].as_f64(), Some(0.0));
    assert_eq!(measured["contributions"][0]["row_sum"].as_f64(), Some(0.0));
    let bare = written(
        &folder,
        "bare.obj",
        format!("{SQUARES}f 1 2 3 4\nf 5 8 7 6\n"),
    );
    let bare = json(&["measure", bare.to_str().unwrap(), "--open"]);
    for key in [
        "mutual_information",
        "positional_entropy",
        "total_area",
        "plan",
    ] {
        assert_eq!(measured[key], bare[key], "{key}");
    }
    let refused = infoscene(&["split", path, "--patch", "0"]).assert().code(2);
    let message = String::from_utf8(refused.get_output().stderr.clone()).unwrap();
    assert!(
        message.contains("patch 0 (face 0) has no area"),
        "{message}"
    );
    let split = json(&["split", path, "--patch", "1"]);
    assert_eq!(split["patch"].as_u64(), Some(1));
    let cut = json(&["form-factor", path, "--subdivide", "1"]);
    assert_eq!(cut["patches"].as_array().unwrap().len(), 9);
    assert_eq!(cut["patches"][0]["area"].as_f64(), Some(0.0));
    let written = folder.path().join("again.obj");
    infoscene(&["convert", path, written.to_str().unwrap()])
        .assert()
        .success();
    let again = json(&["form-factor", written.to_str().unwrap()]);
    assert_eq!(
        again["form_factors"],
        json(&["form-factor", path])["form_factors"]
    );
}

/// A closed room with a thread in it is closed, in every measure and for lines at random.
#[test]
fn a_room_with_a_thread_in_it_is_closed() {
    let folder = tempfile::tempdir().unwrap();
    let room = std::fs::read_to_string(scene_file("cube.obj")).unwrap();
    let path = written(
        &folder,
        "room.obj",
        format!("{room}\no thread\nf -1 -2 -1\n"),
    );
    let path = path.to_str().unwrap();
    let ask = |options: &[&str]| json(&[options, &[path]].concat());
    let options = ["measure", "--continuous", "--pairs"];
    let measured = ask(&options);
    let bare = json(&[&options[..], &["cube:1"]].concat());
    assert_eq!(measured["closed"], true);
    for key in [
        "mutual_information",
        "continuous_mutual_information",
        "pair_losses",
    ] {
        assert_eq!(measured[key], bare[key], "{key}");
    }
    let sampled = ask(&["sample", "--lines", "20000", "--seed", "3"]);
    let bare = json(&["sample", "cube:1", "--lines", "20000", "--seed", "3"]);
    assert_eq!(sampled["sampled"], bare["sampled"]);
}

/// All faults of a file in one message, a line each.
#[test]
fn all_faults_are_told_in_one_run() {
    let folder = tempfile::tempdir().unwrap();
    let text = format!("{SQUARES}v x\nf 1 2 10\nf 1 2 99\nv 0 0 2\nf 1 2 7 4\nf 1 2 11 4\n");
    let path = written(&folder, "faults.obj", text);
    let refused = infoscene(&["measure", path.to_str().unwrap()])
        .assert()
        .code(2);
    let message = String::from_utf8(refused.get_output().stderr.clone()).unwrap();
    let lines: Vec<&str> = message.lines().collect();
    assert_eq!(lines.len(), 5, "{message}");
    for (line, says) in lines
        .iter()
        .zip(["line 10", "line 12", "line 14", "line 15", "--triang"])
    {
        assert!(line.contains(says), "{message}");
    }
}
