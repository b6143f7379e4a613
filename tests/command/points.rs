//! `infoscene point`: keys, files of points, refusals.

use crate::refusals::assert_refused;
use crate::{infoscene, json, stdout};
use std::path::PathBuf;

/// A file of this text in a folder of its own.
fn file(text: &str) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("points.csv");
    std::fs::write(&path, text).unwrap();
    (folder, path)
}

/// What the middle of a cube's floor sees: Howell, B-3, four times.
fn ceiling() -> f64 {
    let a = 0.5 / 1.25f64.sqrt();
    4.0 / std::f64::consts::PI * a * a.atan()
}

#[test]
fn a_point_has_its_keys_and_sums_to_one() {
    let answer = json(&["point", "cube:1", "--at", "0.5,0.5,0", "--normal", "0,0,1"]);
    assert_eq!(answer["patches"][5]["index"], 5);
    assert!(answer["patches"][0]["name"].is_string() && answer["patches"][0]["area"].is_f64());
    let point = &answer["points"][0];
    assert_eq!(point["index"], 0);
    let number = |key: &str| point[key].as_f64().unwrap();
    assert!(number("unseen") <= number("unseen_error") && number("unseen_error") < 1e-13);
    let seen = point["form_factors"].as_array().unwrap();
    assert_eq!(seen.len(), 6);
    let off = seen[1]["value"].as_f64().unwrap() - ceiling();
    assert!(off.abs() <= seen[1]["error"].as_f64().unwrap());
    assert_eq!(
        (&seen[0]["to"], &seen[0]["value"]),
        (&0.into(), &0.0.into())
    );
}

/// With names in any order, or without; comments, blank lines, a mark of byte order, any line ends.
#[test]
fn files_of_points_are_read_as_people_write_them() {
    let texts = [
        "x,y,z,nx,ny,nz\n0.5,0.5,0,0,0,1\n",
        "0.5, 0.5, 0, 0, 0, 1",
        "\u{feff}# a floor\r\n\r\nname,nx,ny,nz,x,y,z\r\nmiddle,0,0,1,0.5,0.5,0 # its middle\r\n",
    ];
    for text in texts {
        let (_folder, path) = file(text);
        let answer = json(&["point", "cube:1", "--points", path.to_str().unwrap()]);
        let found = &answer["points"][0]["form_factors"][1]["value"];
        assert!(
            (found.as_f64().unwrap() - ceiling()).abs() < 1e-15,
            "{text:?}"
        );
    }
}

#[test]
fn points_as_csv_have_a_line_for_each_patch() {
    let (_folder, path) = file("0.5,0.5,0,0,0,1\n0.2,0.5,0,0,0,1\n");
    let path = path.to_str().unwrap();
    let text = stdout(&["point", "cube:1", "--points", path, "--format", "csv"]);
    let mut lines = text.lines();
    let header = lines.next().unwrap();
    assert!(header.starts_with("point,to,value,error,to_name,unseen,unseen_error"));
    assert_eq!(lines.count(), 12);
    let table = stdout(&["point", "cube:1", "--points", path]);
    assert!(table.contains("no patch") && table.contains("ceiling"));
    for threads in ["1", "2"] {
        let arguments = [
            "--threads",
            threads,
            "point",
            "cube:1",
            "--points",
            path,
            "--format",
        ];
        let arguments: Vec<&str> = arguments.into_iter().chain(["csv"]).collect();
        assert_eq!(stdout(&arguments), text);
    }
}

/// A normal of any length is a direction, and that is said.
#[test]
fn normals_are_normalised_with_a_note() {
    let run = |normal: &str| {
        let arguments = ["point", "cube:1", "--at", "0.5,0.5,0", "--normal", normal];
        let output = infoscene(&arguments)
            .assert()
            .success()
            .get_output()
            .clone();
        (output.stdout, String::from_utf8(output.stderr).unwrap())
    };
    let (unit, silence) = run("0,0,1");
    let (long, note) = run("0,0,1e200");
    assert_eq!(unit, long);
    assert_eq!(silence, "");
    assert!(note.contains("1 normal is not 1 long"), "{note}");
    // the other way, it sees nothing of the cube
    let answer = json(&[
        "point",
        "cube:1",
        "--at",
        "0.5,0.5,0",
        "--normal",
        "-0,-0,-1",
    ]);
    assert_eq!(answer["points"][0]["unseen"], 1.0);
}

#[test]
fn points_at_fault_are_refused_with_their_line() {
    let faults = [
        ("x,y,z,nx,ny\n0,0,0,0,0\n", "line 1: no column \"nz\""),
        (
            "0,0,0,0,0,1\n\n1,2,3\n",
            "line 3: 3 columns where there should be 6",
        ),
        (
            "0,0,0,0,one,1\n",
            "line 1, column ny: \"one\" is not a finite number",
        ),
        ("0,0,0,0,0,1\n0,NaN,0,0,0,1\n", "line 2, column y: \"NaN\""),
        (
            "0,0,0,0,0,0\n",
            "line 1, columns nx, ny, nz: a normal of length 0 has no direction",
        ),
        (
            "# nothing\n",
            "it has no point: write a line x,y,z,nx,ny,nz",
        ),
    ];
    for (text, message) in faults {
        let (_folder, path) = file(text);
        assert_refused(
            &["point", "cube:1", "--points", path.to_str().unwrap()],
            message,
        );
    }
    assert_refused(
        &["point", "cube:1", "--points", "nowhere.csv"],
        "nowhere.csv: it cannot be read",
    );
    let at = ["point", "cube:1", "--at", "0,0,0"];
    assert_refused(&at, "--normal");
    let with = |normal| ["point", "cube:1", "--at", "0,0,0", "--normal", normal];
    assert_refused(
        &with("0,0,0"),
        "point 0: a normal of length 0 has no direction",
    );
    assert_refused(&with("0,0"), "three finite numbers");
    assert_refused(&["point", "cube:1"], "--at");
    assert_refused(
        &["point", "cube:1", "--at", "1e70,0,0", "--normal", "0,0,1"],
        "point 0",
    );
}
