//! Rows that are several surfaces, and bases with a part in them: one answer for each row.

use crate::scenes::{number, read_npy};
use crate::{infoscene, json};
use serde_json::Value;
use std::fs;
use tempfile::TempDir;

/// The unit cube with a mat on half of its floor; its four walls are one row.
const ROOM: &str = "F 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nV 4 0 1 0\nV 5 0 0 1\nV 6 1 0 1\n\
    V 7 1 1 1\nV 8 0 1 1\nV 9 .5 0 0\nV 10 .5 1 0\nS 1 1 2 3 4 0 0 .5 floor\n\
    S 2 1 4 8 5 0 0 .5 side\nS 3 1 5 6 2 0 2 .5 side-b\nS 4 7 6 5 8 0 0 .5 ceiling\n\
    S 5 7 3 2 6 0 2 .5 side-c\nS 6 7 8 4 3 0 2 .5 side-d\nS 7 1 9 10 4 1 0 .5 mat\nEnd of data\n";

/// A file of this text in a folder that goes with it.
fn written(text: &str) -> (TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("room.vs3");
    fs::write(&path, text).unwrap();
    let path = path.to_str().unwrap().to_owned();
    (folder, path)
}

/// Floor and ceiling of the cube: Howell, C-11.
const OPPOSITE: f64 = 0.199_824_895_698_387_5;

/// The form factor from a row to another, where it is known: half of the floor faces the ceiling as
/// the other half does, and all of it as the cube's.
fn known(from: usize, to: usize) -> Option<f64> {
    match (from, to) {
        (0 | 3, 2) => Some(OPPOSITE),
        (2, 0 | 3) => Some(0.5 * OPPOSITE),
        (0, 3) | (3, 0) => Some(0.0),
        (0 | 2 | 3, 1) => Some(1.0 - OPPOSITE),
        (1, 1) => Some(0.5 * (1.0 + OPPOSITE)),
        _ => None,
    }
}

fn from_and_to(record: &Value) -> (usize, usize) {
    let index = |key: &str| usize::try_from(record[key].as_u64().unwrap()).unwrap();
    (index("from"), index("to"))
}

#[test]
fn a_row_has_the_name_of_its_first_surface_and_the_area_of_all() {
    let (_folder, room) = written(ROOM);
    let answer = json(&["form-factor", &room]);
    let patches = answer["patches"].as_array().unwrap().iter();
    let named = patches.map(|patch| (patch["name"].as_str().unwrap(), number(&patch["area"])));
    let rows = [
        ("floor", 0.5),
        ("side", 4.0),
        ("ceiling", 1.0),
        ("mat", 0.5),
    ];
    assert_eq!(named.collect::<Vec<_>>(), rows);
}

/// Every ordered pair has its record, and the walls with themselves.
#[test]
fn form_factors_of_rows_are_those_of_the_cube() {
    let (_folder, room) = written(ROOM);
    let answer = json(&["form-factor", &room]);
    let records = answer["form_factors"].as_array().unwrap();
    assert_eq!(records.len(), 13);
    let mut compared = 0;
    for record in records {
        let (from, to) = from_and_to(record);
        if let Some(known) = known(from, to) {
            assert!((number(&record["value"]) - known).abs() < 1e-14, "{record}");
            compared += 1;
        }
    }
    assert_eq!(compared, 10);
}

#[test]
fn the_matrix_of_rows_is_that_of_the_records_and_its_rows_sum_to_one() {
    let (folder, room) = written(ROOM);
    let path = folder.path().join("f.npy");
    let answer = json(&["form-factor", &room, "--matrix", path.to_str().unwrap()]);
    let (_, entries) = read_npy(&fs::read(&path).unwrap());
    for record in answer["form_factors"].as_array().unwrap() {
        let (from, to) = from_and_to(record);
        // the reader of JSON rounds once more
        let off = (entries[from * 4 + to] - number(&record["value"])).abs();
        assert!(off < 1e-15, "{record}");
    }
    for row in entries.chunks(4) {
        assert!((row.iter().sum::<f64>() - 1.0).abs() < 1e-13, "{row:?}");
    }
}

#[test]
fn a_room_of_rows_is_measured_as_closed() {
    let (_folder, room) = written(ROOM);
    let measured = json(&["measure", &room]);
    assert_eq!(measured["patches"], 4);
    assert_eq!(measured["closed"], true);
    assert_eq!(number(&measured["total_area"]), 6.0);
}

#[test]
fn a_row_may_be_asked_for_with_itself_and_none_beyond_the_last() {
    let (_folder, room) = written(ROOM);
    let own = json(&["form-factor", &room, "--from", "1", "--to", "1"]);
    assert_eq!(own["form_factors"].as_array().unwrap().len(), 1);
    infoscene(&["form-factor", &room, "--from", "4"])
        .assert()
        .code(2);
}

/// A screen in the middle hides from each other what the row's own surfaces exchanged.
#[test]
fn a_screen_between_the_surfaces_of_one_row_takes_away() {
    let (_folder, room) =
        written(&ROOM.replace("End", "V 11 .5 0 1\nV 12 .5 1 1\nO 8 9 10 12 11\nEnd"));
    let value = |scene: &str| {
        let answer = json(&["form-factor", scene, "--from", "1", "--to", "1"]);
        number(&answer["form_factors"][0]["value"])
    };
    let (_other, open) = written(ROOM);
    // two of four pairs of walls across: of the one that the screen parts nothing is left
    let across = 2.0 * OPPOSITE / 4.0;
    let (whole, past) = (value(&open), value(&room));
    assert!(
        past < whole - across + 1e-12 && past > 0.0,
        "{past} of {whole}"
    );
}
