//! Rounded coordinates at the command: keys, columns, the note, `--resolution`.

use crate::{infoscene, json, stdout};

/// A room of 8 × 5 × 3, turned by 0.7 rad about the vertical, one wall in two panels; millimetres.
const ROOM: &str = "\
v 0.000 0.000 0.000\nv 3.059 2.577 0.000\nv 6.119 5.154 0.000\nv 2.898 8.978 0.000
v -3.221 3.824 0.000\nv -3.221 3.824 3.000\nv 2.898 8.978 3.000\nv 6.119 5.154 3.000
v 3.059 2.577 3.000\nv 0.000 0.000 3.000
f 1 2 3 4 5\nf 6 7 8 9 10\nf 5 6 10 1\nf 3 8 7 4\nf 4 7 6 5\nf 1 10 9 2\nf 2 9 8 3\n";

fn room() -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("room.obj");
    std::fs::write(&path, ROOM).unwrap();
    let path = path.to_str().unwrap().to_owned();
    (folder, path)
}

#[test]
fn rounded_rooms_are_answered_with_what_the_resolution_can_change() {
    let (_folder, room) = room();
    // the mutual information of the room before it was rounded, from contour integrals
    let unrounded = 0.353_353_838_672_917_4;
    for flag in [&[][..], &["--unoccluded"]] {
        let answer = json(&[&["measure", room.as_str()], flag].concat());
        assert_eq!(answer["resolution"], 0.0005);
        let change = (answer["mutual_information"].as_f64().unwrap() - unrounded).abs();
        let allowed = answer["resolution_error"].as_f64().unwrap();
        assert!(
            change > 1e-6 && change <= allowed && allowed < 0.05,
            "{change} {allowed}"
        );
        let plan = &answer["plan"]["resolution"];
        let counted = ["bent", "coplanar", "touching"].map(|key| plan[key].as_u64().unwrap());
        assert_eq!((&plan["length"], counted), (&0.0005.into(), [0, 2, 0]));
    }
    let answer = json(&["form-factor", &room]);
    assert_eq!(answer["resolution"], 0.0005);
    for record in answer["form_factors"].as_array().unwrap() {
        let change = record["resolution_error"].as_f64().unwrap();
        assert!(change > 0.0 && change < 0.05, "{record}");
    }
    let light = json(&[
        "radiosity",
        &room,
        "--reflectance",
        "all=0.5",
        "--emittance",
        "all=0.5",
    ]);
    for patch in light["patches"].as_array().unwrap() {
        let moved = (patch["radiosity"].as_f64().unwrap() - 1.0).abs();
        assert!(
            moved <= patch["resolution_error"].as_f64().unwrap() + 1e-12,
            "{patch}"
        );
    }
    assert_eq!(
        json(&["split", &room, "--patch", "0", "--unoccluded"])["resolution"],
        0.0005
    );
}

/// A column for rounded scenes only, and a note on what counts as what.
#[test]
fn columns_and_notes_are_for_rounded_scenes() {
    let (_folder, room) = room();
    let head = |scene: &str| {
        let lines = stdout(&["form-factor", scene, "--format", "csv"]);
        lines.lines().next().unwrap().to_owned()
    };
    assert!(head(&room).ends_with(",resolution_error"));
    assert!(!head("cube:1").contains("resolution"));
    assert!(stdout(&["form-factor", &room]).contains("± resolution"));
    assert!(!stdout(&["form-factor", "cube:1"]).contains("resolution"));
    assert_eq!(
        json(&["form-factor", "cube:1"])["form_factors"][0]["resolution_error"],
        0.0
    );
    let run = infoscene(&["measure", &room]).assert().success();
    let note = String::from_utf8_lossy(&run.get_output().stderr).into_owned();
    assert!(
        note.contains("± 5e-4") && note.contains("2 as lying in a plane"),
        "{note}"
    );
}

/// Without a resolution the room is blocked by its own panels; what needs full sight is refused,
/// and the message names the flag and a length that does; a length that tells nothing apart is
/// refused.
#[test]
fn a_resolution_is_given() {
    let (_folder, room) = room();
    let refused = |arguments: &[&str]| {
        let run = infoscene(arguments).assert().code(2);
        String::from_utf8_lossy(&run.get_output().stderr).into_owned()
    };
    let message = refused(&["measure", &room, "--resolution", "0", "--continuous"]);
    let length = message
        .split("--resolution ")
        .nth(1)
        .unwrap_or_else(|| panic!("{message}"));
    let length = length.split_whitespace().next().unwrap();
    let answer = json(&["measure", &room, "--resolution", length]);
    assert_eq!(answer["resolution"].as_f64(), length.parse().ok());
    let message = refused(&["measure", &room, "--resolution", "1"]);
    assert!(message.contains("does not tell the surfaces"), "{message}");
    assert!(refused(&["measure", &room, "--resolution=-1"]).contains("resolution"));
}
