//! Options that all questions about a scene take: names for patches, fronts, tolerances.

use crate::scenes::number;
use crate::{infoscene, json, stdout};

/// The inside of a cube, its faces written clockwise: all fronts are outside.
const INSIDE_OUT: &str = "\
v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1
o room\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

fn inside_out() -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("room.obj");
    std::fs::write(&path, INSIDE_OUT).unwrap();
    let path = path.to_str().unwrap().to_owned();
    (folder, path)
}

#[test]
fn fronts_that_are_all_outside_are_said_and_turned() {
    let (_folder, room) = inside_out();
    for (arguments, status) in [
        (&["form-factor"][..], 0),
        (&["form-factor", "--from", "0", "--to", "1"], 0),
        (&["measure"], 2),
        (&["measure", "--open"], 0),
        (&["split", "--patch", "0"], 2),
        (&["radiosity", "--emittance", "all"], 0),
        (&["sample", "--lines", "100"], 2),
    ] {
        let mut arguments = arguments.to_vec();
        arguments.insert(1, &room);
        let run = infoscene(&arguments).assert().code(status);
        let said = String::from_utf8_lossy(&run.get_output().stderr).into_owned();
        assert!(said.contains("--reverse"), "{arguments:?}: {said}");
    }
    // opposite faces of a cube: Howell, C-11 with X = Y = 1
    let turned = json(&[
        "form-factor",
        &room,
        "--reverse",
        "--from",
        "0",
        "--to",
        "1",
    ]);
    let value = number(&turned["form_factors"][0]["value"]);
    assert!((value - 0.199_824_895_698_387_4).abs() < 1e-14);
    let quiet = infoscene(&["measure", &room, "--reverse"])
        .assert()
        .success();
    assert!(quiet.get_output().stderr.is_empty());
}

#[test]
fn names_serve_wherever_an_index_does() {
    let by_name = [
        "form-factor",
        "cube:1",
        "--from",
        "floor",
        "--to",
        "ceiling 0,0",
    ];
    let by_index = ["form-factor", "cube:1", "--from", "0", "--to", "1"];
    assert_eq!(stdout(&by_name), stdout(&by_index));
    let cut = |patch: &str, against: &str| {
        stdout(&[
            "split",
            "three-squares",
            "--patch",
            patch,
            "--against",
            against,
        ])
    };
    assert_eq!(cut("floor", "wall,side wall"), cut("0", "1,2"));
    // all pieces of the floor shine
    let lit = json(&[
        "radiosity",
        "cube:1",
        "--subdivide",
        "1",
        "--emittance",
        "floor=1",
    ]);
    let patches = lit["patches"].as_array().unwrap();
    let shining = patches
        .iter()
        .filter(|patch| number(&patch["radiosity"]) > 0.0);
    assert_eq!(shining.count(), 4);
    let mut refusal = infoscene(&["form-factor", "two-squares", "--from", "flor"]);
    let refusal = refusal.assert().code(2);
    let said = String::from_utf8_lossy(&refusal.get_output().stderr).into_owned();
    assert!(said.contains("did you mean \"floor\"?"), "{said}");
}

/// Names and row sums stand beside the values.
#[test]
fn csv_has_names_and_row_sums() {
    let text = stdout(&[
        "form-factor",
        "cube:1",
        "--from",
        "floor",
        "--format",
        "csv",
    ]);
    let mut lines = csv::Reader::from_reader(text.as_bytes());
    let header = lines.headers().unwrap().clone();
    let expected = [
        "from",
        "to",
        "value",
        "error",
        "route",
        "from_name",
        "to_name",
        "row_sum",
    ];
    assert_eq!(header.iter().collect::<Vec<_>>(), expected);
    let records: Vec<_> = lines.records().map(Result::unwrap).collect();
    assert_eq!(records.len(), 5);
    let sum: f64 = records
        .iter()
        .map(|record| record[2].parse::<f64>().unwrap())
        .sum();
    for record in &records {
        assert_eq!(&record[5], "floor 0,0");
        // a closed room, and the sum of the lines
        assert!((record[7].parse::<f64>().unwrap() - 1.0).abs() < 1e-14);
        assert!((record[7].parse::<f64>().unwrap() - sum).abs() < 1e-14);
    }
}

/// Two squares so far apart that their form factor is known to few digits beside its size, and to
/// many beside any row sum.
#[test]
fn errors_that_no_row_sum_can_feel_are_accepted() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("far.obj");
    // two slivers whose planes almost coincide, to more decimals than they are apart
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n\
                v 3 0.1 -1.0000001e-9\nv 4 0.1 1.0000001e-9\nv 4 0.9 1.0000001e-9\n\
                v 3 0.9 -1.0000001e-9\nf 1 2 3 4\nf 5 6 7 8\n";
    std::fs::write(&path, text).unwrap();
    let path = path.to_str().unwrap();
    let tolerance = ["form-factor", path, "--tolerance", "1e-15"];
    infoscene(&tolerance).assert().success();
    let mut strict = infoscene(&[
        "form-factor",
        path,
        "--tolerance",
        "1e-15",
        "--absolute",
        "0",
    ]);
    let strict = strict.assert().code(1);
    let said = String::from_utf8_lossy(&strict.get_output().stderr).into_owned();
    assert!(
        said.contains("whose form factor is") && !said.contains("inf "),
        "{said}"
    );
    let rough = json(&[
        "form-factor",
        "cornell-box",
        "--absolute",
        "1e-3",
        "--from",
        "0",
    ]);
    for record in rough["form_factors"].as_array().unwrap() {
        assert!(number(&record["error"]) <= 1e-3);
    }
}

/// The state of a scene is told whatever it is.
#[test]
fn check_tells_the_state_of_a_scene() {
    let (folder, outside) = inside_out();
    let state = json(&["check", &outside]);
    assert_eq!(
        (number(&state["volume"]), &state["turned_away"]),
        (-1.0, &true.into())
    );
    // one face less, and one turned back
    let path = folder.path().join("open.obj");
    let text = INSIDE_OUT
        .replace("f 4 3 2 1\n", "")
        .replace("f 5 6 7 8", "f 8 7 6 5");
    std::fs::write(&path, text).unwrap();
    let open = json(&["check", path.to_str().unwrap()]);
    assert_eq!(
        (&open["free_edges"], &open["free_length"]),
        (&4.into(), &4.0.into())
    );
    assert_eq!(
        (&open["volume"], &open["turned_neighbours"]),
        (&().into(), &4.into())
    );
    assert_eq!(open["longest_free_edges"][0]["length"], 1.0);
    assert_eq!(open["first_turned_neighbours"][0][0]["name"], "room 0");
    let table = stdout(&["check", path.to_str().unwrap()]);
    assert!(
        table.contains("no: 4 free edges, 4.000000 long together"),
        "{table}"
    );
    let room = json(&["check", "box:1,2,3"]);
    assert_eq!(room["free_length"].to_string(), "0.0");
    assert_eq!(
        (number(&room["volume"]), &room["blocked"], &room["planes"]),
        (6.0, &().into(), &6.into())
    );
}
