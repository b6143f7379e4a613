//! Matrices in the formats of other programs, read by strict parsers of their own, and judged by
//! form factors that are known.

use crate::scenes::{number, read_npy};
use crate::{infoscene, json};
use serde_json::Value;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// The unit cube with a mat on half of its floor; its four walls are one row.
const ROOM: &str = "F 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nV 4 0 1 0\nV 5 0 0 1\nV 6 1 0 1\n\
    V 7 1 1 1\nV 8 0 1 1\nV 9 .5 0 0\nV 10 .5 1 0\nS 1 1 2 3 4 0 0 .9 floor\n\
    S 2 1 4 8 5 0 0 .75 side\nS 3 1 5 6 2 0 2 .75 side-b\nS 4 7 6 5 8 0 0 .123456789 ceiling\n\
    S 5 7 3 2 6 0 2 .75 side-c\nS 6 7 8 4 3 0 2 .75 side-d\nS 7 1 9 10 4 1 0 1 mat\n\
    End of data\n";

/// Howell, C-11: opposite faces of a cube; the rest by additivity, reciprocity and row sums.
const OPPOSITE: f64 = 0.199_824_895_698_387_38;
const KNOWN: [[f64; 4]; 4] = [
    [0.0, 1.0 - OPPOSITE, OPPOSITE, 0.0],
    [
        0.125 * (1.0 - OPPOSITE),
        0.5 * (1.0 + OPPOSITE),
        0.25 * (1.0 - OPPOSITE),
        0.125 * (1.0 - OPPOSITE),
    ],
    [0.5 * OPPOSITE, 1.0 - OPPOSITE, 0.0, 0.5 * OPPOSITE],
    [0.0, 1.0 - OPPOSITE, OPPOSITE, 0.0],
];
const ZEROS: usize = 5;

fn room() -> (TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("room.vs3");
    fs::write(&path, ROOM).unwrap();
    let path = path.to_str().unwrap().to_owned();
    (folder, path)
}

/// The answer about the room, and the text of the file that its matrix was written to.
fn written(option: &str, name: &str) -> (Value, Vec<u8>) {
    let (folder, room) = room();
    let path = folder.path().join(name);
    let answer = json(&["form-factor", &room, option, path.to_str().unwrap()]);
    assert_eq!(folder.path().read_dir().unwrap().count(), 2);
    (answer, fs::read(path).unwrap())
}

fn lines(text: &[u8]) -> impl Iterator<Item = &str> {
    let text = str::from_utf8(text).unwrap();
    assert!(text.ends_with('\n') && !text.contains('\r'));
    text.lines()
}

fn numbers(line: &str) -> Vec<f64> {
    line.split(' ').map(|word| word.parse().unwrap()).collect()
}

/// A matrix of 4 rows from lines of `i j value`, counted from 1: in order, none twice, none zero.
fn from_triplets<'t>(lines: impl Iterator<Item = &'t str>) -> Vec<Vec<f64>> {
    let mut matrix = vec![vec![0.0; 4]; 4];
    let mut last = (0, 0);
    for line in lines {
        let words: Vec<&str> = line.split(' ').collect();
        let [row, column, value] = words[..] else {
            panic!("{line}")
        };
        let place: (usize, usize) = (row.parse().unwrap(), column.parse().unwrap());
        assert!(place > last, "{line}");
        last = place;
        matrix[place.0 - 1][place.1 - 1] = value.parse().unwrap();
        assert!(matrix[place.0 - 1][place.1 - 1] != 0.0, "{line}");
    }
    matrix
}

/// The size and the lines of a Matrix Market file, as NISTIR 5935 describes it.
fn market<'t>(text: &'t [u8], kind: &str) -> (&'t str, Vec<&'t str>) {
    let mut lines = lines(text);
    let head = format!("%%MatrixMarket matrix {kind} real general");
    assert_eq!(lines.next(), Some(head.as_str()));
    let mut lines = lines.skip_while(|line| line.starts_with('%'));
    (lines.next().unwrap(), lines.collect())
}

/// Values of the JSON answer, which are the entries to the bit.
fn listed(answer: &Value, key: &str) -> Vec<Vec<f64>> {
    let mut matrix = vec![vec![0.0; 4]; 4];
    for record in answer["form_factors"].as_array().unwrap() {
        let index = |key: &str| usize::try_from(record[key].as_u64().unwrap()).unwrap();
        matrix[index("from")][index("to")] = number(&record[key]);
    }
    matrix
}

fn assert_known(matrix: &[Vec<f64>], answer: &Value, what: &str) {
    assert_eq!(matrix, listed(answer, "value"), "{what}");
    for (row, known) in matrix.iter().zip(KNOWN) {
        for (entry, known) in row.iter().zip(known) {
            assert!((entry - known).abs() < 1e-12, "{what}: {entry} for {known}");
        }
    }
}

#[test]
fn every_format_holds_the_same_matrix() {
    let (answer, text) = written("--matrix", "f.mtx");
    let (size, entries) = market(&text, "coordinate");
    assert_eq!(size, format!("4 4 {}", 16 - ZEROS));
    assert_eq!(entries.len(), 16 - ZEROS);
    assert_known(&from_triplets(entries.into_iter()), &answer, "coordinates");

    let (answer, text) = written("--matrix", "f.array.mtx");
    let (size, entries) = market(&text, "array");
    assert_eq!((size, entries.len()), ("4 4", 16));
    // column by column
    let entry = |row: usize, column: usize| entries[4 * column + row].parse().unwrap();
    let rows = (0..4).map(|row| (0..4).map(|column| entry(row, column)).collect());
    assert_known(&rows.collect::<Vec<_>>(), &answer, "array");

    let (answer, text) = written("--matrix", "f.txt");
    assert_known(&from_triplets(lines(&text)), &answer, "triplets");

    let (answer, bytes) = written("--matrix", "f.npy");
    let rows: Vec<Vec<f64>> = read_npy(&bytes).1.chunks(4).map(<[f64]>::to_vec).collect();
    assert_known(&rows, &answer, "npy");
}

/// Read as View3D's own `ReadVF` does: a line of at most 34 characters, of which six words count,
/// then numbers between white space.
#[test]
fn view3ds_own_reader_can_read_it() {
    let (answer, text) = written("--matrix", "f.vf");
    let lines: Vec<&str> = lines(&text).collect();
    assert_eq!(lines.len(), 1 + 1 + 4 + 1);
    assert!(lines[0].len() == 30 && lines[0].ends_with(' '));
    let head: Vec<&str> = lines[0].split_whitespace().collect();
    let [program, version, "0", "0", "0", "4"] = head[..] else {
        panic!("{}", lines[0])
    };
    // its arrays of characters, the end of the string included
    assert!(program.len() < 16 && version.len() < 8, "{}", lines[0]);
    assert_eq!(numbers(lines[1]), [0.5, 4.0, 1.0, 0.5]);
    let rows: Vec<Vec<f64>> = lines[2..6].iter().map(|line| numbers(line)).collect();
    assert_known(&rows, &answer, "View3D");
    // the emissivities of the file, to the digit
    assert_eq!(lines[6], "0.9 0.75 0.123456789 1");
}

/// The bounds are the errors of the records; they hold for what is known.
#[test]
fn bounds_have_a_matrix_of_their_own() {
    let (folder, room) = room();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    for (name, kind) in [("e.mtx", "coordinate"), ("e.array.mtx", "array")] {
        let (values, bounds) = (path("f.npy"), path(name));
        let answer = json(&[
            "form-factor",
            &room,
            "--matrix",
            &values,
            "--bounds",
            &bounds,
        ]);
        let expected = listed(&answer, "error");
        let text = fs::read(&bounds).unwrap();
        let (_, entries) = market(&text, kind);
        let found = if kind == "array" {
            let entry = |place: usize| entries[place].parse().unwrap();
            let rows = (0..4).map(|row| (0..4).map(|column| entry(4 * column + row)).collect());
            rows.collect()
        } else {
            from_triplets(entries.into_iter())
        };
        assert_eq!(found, expected);
        let values = read_npy(&fs::read(&values).unwrap()).1;
        for (value, (bound, known)) in values
            .iter()
            .zip(found.iter().flatten().zip(KNOWN.as_flattened()))
        {
            // the last place of what is known
            assert!(
                (value - known).abs() <= bound + 2e-16,
                "{value} ± {bound} for {known}"
            );
        }
    }
}

/// The name says the format, before anything is computed; what is refused leaves no file.
#[test]
fn a_name_without_a_format_is_refused() {
    let (folder, room) = room();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    for (option, name, says) in [
        ("--matrix", "f.xlsx", ".npy, .mtx, .array.mtx, .txt or .vf"),
        ("--bounds", "e.vf", "no place for bounds"),
        ("--bounds", "e.csv", ".npy, .mtx"),
        ("--matrix", "missing/f.mtx", "its folder does not exist"),
    ] {
        let refused = infoscene(&["form-factor", &room, option, &path(name)]);
        let refused = { refused }.assert().code(2).stdout("");
        let message = String::from_utf8(refused.get_output().stderr.clone()).unwrap();
        assert!(message.contains(says), "{message}");
    }
    // a row of two emissivities has none
    let mixed = path("mixed.vs3");
    fs::write(&mixed, ROOM.replace("2 .75 side-c", "2 .5 side-c")).unwrap();
    let refused = infoscene(&["form-factor", &mixed, "--matrix", &path("f.vf")])
        .assert()
        .code(2);
    let message = String::from_utf8(refused.get_output().stderr.clone()).unwrap();
    assert!(message.contains("differ in reflectance"), "{message}");
    // nor is one of two files written
    let both = ["--matrix", &path("f.vf"), "--bounds", &path("e.npy")];
    infoscene(&[&["form-factor", &mixed], &both[..]].concat())
        .assert()
        .code(2);
    infoscene(&["form-factor", &mixed, "--matrix", &path("f.mtx")])
        .assert()
        .success();
    let mut left: Vec<_> = names(folder.path());
    left.sort();
    assert_eq!(left, ["f.mtx", "mixed.vs3", "room.vs3"]);
}

fn names(folder: &Path) -> Vec<String> {
    let entries = folder.read_dir().unwrap();
    entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect()
}
