//! `form-factor` and `measure`: keys, files, exit status.

use crate::{infoscene, json, stdout};
use serde_json::Value;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

/// A record per ordered pair, with names, areas and the plan.
#[test]
fn form_factors_of_every_ordered_pair_are_listed() {
    let answer = json(&["form-factor", "three-squares"]);
    let patches = answer["patches"].as_array().unwrap();
    let names: Vec<_> = patches
        .iter()
        .map(|patch| patch["name"].as_str().unwrap())
        .collect();
    assert_eq!(names, ["floor", "wall", "side wall"]);
    let records = answer["form_factors"].as_array().unwrap();
    let pairs: Vec<_> = records
        .iter()
        .map(|record| {
            (
                record["from"].as_u64().unwrap(),
                record["to"].as_u64().unwrap(),
            )
        })
        .collect();
    assert_eq!(pairs, [(0, 1), (0, 2), (1, 0), (1, 2), (2, 0), (2, 1)]);
    for record in records {
        // unit squares with a common edge: Howell, C-14
        assert!((number(&record["value"]) - 0.200_043_776_075_4).abs() < 1e-13);
        assert!((0.0..1e-12).contains(&number(&record["error"])));
        assert!(record["route"].as_str().unwrap().ends_with("rectangles"));
    }
    assert_eq!(answer["plan"]["pairs"], 3);
    assert_eq!(answer["plan"]["reciprocal"], 3);
}

#[test]
fn from_and_to_choose_pairs() {
    let one = json(&["form-factor", "cube:2", "--from", "3", "--to", "20"]);
    let records = one["form_factors"].as_array().unwrap();
    assert_eq!((records.len(), &one["plan"]["pairs"]), (1, &Value::from(1)));
    assert_eq!(
        (&records[0]["from"], &records[0]["to"]),
        (&3.into(), &20.into())
    );
    let row = json(&["form-factor", "cube:2", "--from", "3"]);
    let records = row["form_factors"].as_array().unwrap();
    assert_eq!(records.len(), 23);
    let sum: f64 = records.iter().map(|record| number(&record["value"])).sum();
    assert!((sum - 1.0).abs() < 1e-13, "{sum}");
    let column = json(&["form-factor", "cube:2", "--to", "3"]);
    assert!(
        column["form_factors"]
            .as_array()
            .unwrap()
            .iter()
            .all(|record| record["to"] == 3)
    );
    // a pair has the same value in every listing
    let all = json(&["form-factor", "cube:2"]);
    let all = all["form_factors"].as_array().unwrap();
    assert!(records.iter().all(|record| all.contains(record)));
    infoscene(&["form-factor", "cube:2", "--from", "24"])
        .assert()
        .code(2);
}

/// Head and entries of an NPY file, read as NEP 1 describes it.
fn read_npy(bytes: &[u8]) -> (String, Vec<f64>) {
    assert_eq!(&bytes[..8], b"\x93NUMPY\x01\x00");
    let length = usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
    assert_eq!((10 + length) % 64, 0);
    let head = String::from_utf8(bytes[10..10 + length].to_vec()).unwrap();
    let entries = bytes[10 + length..].chunks(8);
    let entries = entries.map(|eight| f64::from_le_bytes(eight.try_into().unwrap()));
    (head, entries.collect())
}

#[test]
fn the_matrix_is_written_in_numpys_format() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("f.npy");
    let name = path.to_str().unwrap();
    let answer = json(&["form-factor", "cube:2", "--matrix", name]);
    let (head, entries) = read_npy(&std::fs::read(&path).unwrap());
    assert!(head.starts_with("{'descr': '<f8', 'fortran_order': False, 'shape': (24, 24), }"));
    assert!(head.ends_with(" \n"));
    assert_eq!(entries.len(), 24 * 24);
    for record in answer["form_factors"].as_array().unwrap() {
        let index = |key: &str| usize::try_from(record[key].as_u64().unwrap()).unwrap();
        assert_eq!(
            entries[index("from") * 24 + index("to")],
            number(&record["value"])
        );
    }
    for row in entries.chunks(24) {
        assert!((row.iter().sum::<f64>() - 1.0).abs() < 1e-13);
    }
    // all of it or nothing: the folder holds one file, and bad input leaves it alone
    infoscene(&["form-factor", "cube:2", "--from", "99", "--matrix", name])
        .assert()
        .code(2);
    assert_eq!(read_npy(&std::fs::read(&path).unwrap()).1, entries);
    assert_eq!(folder.path().read_dir().unwrap().count(), 1);
    let missing = folder.path().join("missing").join("f.npy");
    let missing = [
        "form-factor",
        "cube:2",
        "--matrix",
        missing.to_str().unwrap(),
    ];
    let refused = infoscene(&missing).assert().code(2);
    assert!(refused.get_output().stdout.is_empty());
}

#[test]
fn threads_do_not_change_a_byte() {
    let folder = tempfile::tempdir().unwrap();
    for question in ["form-factor", "measure"] {
        for format in ["json", "csv", "table", "markdown", "latex"] {
            let text = |threads: &str| {
                let arguments = [
                    "--tolerance",
                    "1e-6",
                    "--format",
                    format,
                    "--threads",
                    threads,
                ];
                stdout(&[&[question, "cube:4"], &arguments[..]].concat())
            };
            assert_eq!(text("1"), text("2"), "{question} {format}");
        }
    }
    let matrix = |threads: &str| {
        let path = folder.path().join(threads);
        stdout(&[
            "form-factor",
            "cube:3",
            "--threads",
            threads,
            "--tolerance",
            "1e-6",
            "--matrix",
            path.to_str().unwrap(),
        ]);
        std::fs::read(path).unwrap()
    };
    assert_eq!(matrix("1"), matrix("2"));
}

/// The continuous mutual information of a room does not depend on its division: the cube's to 37 digits from outside. Random chords have the
/// same key, and refuse what the pairs refuse only if it is open.
#[test]
fn measure_answers_with_the_continuous_one_if_asked() {
    let exact = 1.610_473_346_468_777_7;
    let answer = json(&["measure", "cube:2", "--continuous"]);
    let number = |answer: &Value, key: &str| answer[key].as_f64().unwrap();
    let found = number(&answer, "continuous_mutual_information");
    assert!((found - exact).abs() <= number(&answer, "continuous_error"));
    assert_eq!(answer["continuous_error_grade"], "estimate");
    let parts = answer["continuous_contributions"].as_array().unwrap();
    assert_eq!(parts.len(), 15);
    let sum: f64 = parts
        .iter()
        .map(|part| number(part, "mutual_information"))
        .sum();
    assert!((sum - exact).abs() < 1e-12);
    assert!(number(&answer, "mutual_information") < exact);
    assert!(stdout(&["measure", "cube:1", "--continuous"]).contains("(1.610473346"));
    assert_eq!(answer["pair_losses"], Value::Null);
    let answer = json(&["measure", "cube:2", "--continuous", "--pairs"]);
    let pairs = answer["pair_losses"].as_array().unwrap();
    assert_eq!(pairs.len(), 15 * 16);
    let lost: f64 = pairs.iter().map(|pair| number(pair, "loss")).sum();
    assert!((lost + number(&answer, "mutual_information") - exact).abs() < 1e-12);

    let chords = [
        "measure",
        "cube:1",
        "--continuous",
        "--lines",
        "20000",
        "--seed",
        "7",
    ];
    let answer = json(&chords);
    let error = number(&answer, "continuous_standard_error");
    assert!((number(&answer, "continuous_mutual_information") - exact).abs() < 5.0 * error);
    assert_eq!(
        (&answer["seed"], &answer["mutual_information"]),
        (&7.into(), &Value::Null)
    );
    assert_eq!(stdout(&chords), stdout(&chords));
    assert!(stdout(&chords).contains("standard error"));

    let refused = infoscene(&["measure", "two-squares", "--continuous", "--lines", "100"])
        .assert()
        .code(2);
    let message = String::from_utf8(refused.get_output().stderr.clone()).unwrap();
    assert!(
        message.contains("the scene is open") && refused.get_output().stdout.is_empty(),
        "{message}"
    );
    infoscene(&["measure", "two-squares", "--continuous", "--open"])
        .assert()
        .code(2);
}

/// cube_grids.csv, row cube_regular_3.
#[test]
fn measure_finds_the_mutual_information_of_a_cube() {
    let answer = json(&["measure", "cube:3"]);
    let information = number(&answer["mutual_information"]);
    assert!((information - 0.994_346_184_970_692_6).abs() <= 1e-13);
    assert!(number(&answer["mutual_information_error"]) < 1e-10);
    assert_eq!(
        (&answer["patches"], &answer["closed"]),
        (&54.into(), &true.into())
    );
    assert!((number(&answer["total_area"]) - 6.0).abs() < 1e-14);
    assert!((number(&answer["positional_entropy"]) - 54f64.log2()).abs() < 1e-14);
    let rate = number(&answer["entropy_rate"]);
    assert!((number(&answer["positional_entropy"]) - rate - information).abs() < 1e-14);
    assert!(answer["continuous_mutual_information"].is_null());
    assert_eq!(answer["plan"]["untouched"], 6 * 9 * 8 / 2);
    let parts = answer["contributions"].as_array().unwrap();
    let sum: f64 = parts
        .iter()
        .map(|part| number(&part["mutual_information"]))
        .sum();
    assert!((sum - information).abs() < 1e-14);
    assert!(
        (number(&answer["closure"]["row_sum"]) - 1.0).abs() <= number(&answer["closure"]["error"])
    );
    // sharing changes no certain digit; a tolerance is made use of, within the error stated
    let apart = json(&["measure", "cube:3", "--every-pair"]);
    assert!((number(&apart["mutual_information"]) - information).abs() <= 1e-13);
    let rough = json(&["measure", "cube:3", "--every-pair", "--tolerance", "1e-6"]);
    let stated = number(&rough["mutual_information_error"]);
    assert!((number(&rough["mutual_information"]) - information).abs() <= stated && stated < 1e-4);
    assert_eq!(apart["plan"]["congruent"], 0);
}

/// Without `--open` the worst row is named; with it the outside is a state of the chain.
#[test]
fn an_open_scene_is_measured_only_on_request() {
    let refused = infoscene(&["measure", "two-squares"]).assert().code(2);
    let output = refused.get_output();
    assert!(output.stdout.is_empty());
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(
        message.contains("row 0") && message.contains("patch floor") && message.contains("--open"),
        "{message}"
    );
    let open = json(&["measure", "two-squares", "--open"]);
    assert_eq!(open["closed"], false);
    // F = 0.2000…: weights 1, 1, 2(1 − F) of N = 4 − 2F
    let escaping = 1.0 - 0.200_043_776_075_403_16;
    let total = 2.0 + 2.0 * escaping;
    let term = |weight: f64| -weight / total * (weight / total).log2();
    let entropy = 2.0 * term(1.0) + term(2.0 * escaping);
    assert!((number(&open["positional_entropy"]) - entropy).abs() < 1e-13);
    assert!(number(&open["outside_contribution"]) > 0.0);
}

/// No route reaches 1e-18: the answer is there, the pairs are named, the status is 1.
#[test]
fn a_tolerance_out_of_reach_is_said() {
    for question in ["form-factor", "measure"] {
        let arguments = [
            question,
            "cube:1",
            "--tolerance",
            "1e-18",
            "--format",
            "json",
        ];
        let answer = infoscene(&arguments).assert().code(1);
        let output = answer.get_output();
        assert!(serde_json::from_slice::<Value>(&output.stdout).is_ok());
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(
            message.contains("15 pairs miss the tolerance 1e-18")
                && message.contains("(floor 0,0)"),
            "{message}"
        );
    }
    for tolerance in ["0", "-1", "NaN", "inf", "x"] {
        let arguments = ["measure", "cube:1", &format!("--tolerance={tolerance}")];
        infoscene(&arguments).assert().code(2);
    }
}

#[test]
fn form_factors_come_in_every_format() {
    let csv = stdout(&["form-factor", "two-squares", "--format", "csv"]);
    assert!(csv.starts_with("from,to,value,error,route\n0,1,0.2000437760754"));
    assert!(stdout(&["form-factor", "two-squares"]).contains("0 (floor)"));
    let markdown = stdout(&["form-factor", "two-squares", "--format", "markdown"]);
    assert!(markdown.starts_with("| from | to |"));
    assert!(stdout(&["form-factor", "two-squares", "--format", "latex"]).is_ascii());
    assert!(stdout(&["measure", "cube:1"]).contains("0.263034544099"));
    let many = stdout(&["form-factor", "cube:3", "--tolerance", "1e-6"]);
    assert!(many.contains("pairs not shown: 1862: "), "{many}");
}

/// A room whose four walls are one row and whose floor has a mat: a row for each, named by its first surface, and one with itself.
#[test]
fn bases_and_summed_rows_are_answered() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let room = "F 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\nV 4 0 1 0\nV 5 0 0 1\nV 6 1 0 1\nV 7 1 1 1\nV 8 0 1 1\n\
        V 9 .5 0 0\nV 10 .5 1 0\nS 1 1 2 3 4 0 0 .5 floor\nS 2 1 4 8 5 0 0 .5 side\nS 3 1 5 6 2 0 2 .5 side-b\n\
        S 4 7 6 5 8 0 0 .5 ceiling\nS 5 7 3 2 6 0 2 .5 side-c\nS 6 7 8 4 3 0 2 .5 side-d\n\
        S 7 1 9 10 4 1 0 .5 mat\nEnd of data\n";
    std::fs::write(path("room.vs3"), room).unwrap();
    let (room, matrix) = (path("room.vs3"), path("f.npy"));
    let answer = json(&["form-factor", &room, "--matrix", &matrix]);
    let patches = answer["patches"].as_array().unwrap().iter();
    let patches: Vec<_> = patches
        .map(|patch| (patch["name"].as_str().unwrap(), number(&patch["area"])))
        .collect();
    let rows = [
        ("floor", 0.5),
        ("side", 4.0),
        ("ceiling", 1.0),
        ("mat", 0.5),
    ];
    assert_eq!(patches, rows);
    let records = answer["form_factors"].as_array().unwrap();
    // every ordered pair, and the walls with themselves
    assert_eq!(records.len(), 13);
    let index = |record: &Value, key: &str| usize::try_from(record[key].as_u64().unwrap()).unwrap();
    let (_, entries) = read_npy(&std::fs::read(&matrix).unwrap());
    // half of the floor sees the ceiling as the other half does, and all of it as the cube's: Howell, C-11
    let opposite = 0.199_824_895_698_387_5;
    let expected = |from: usize, to: usize| match (from, to) {
        (0 | 3, 2) => Some(opposite),
        (2, 0 | 3) => Some(0.5 * opposite),
        (0, 3) | (3, 0) => Some(0.0),
        (0 | 2 | 3, 1) => Some(1.0 - opposite),
        (1, 1) => Some(0.5 * (1.0 + opposite)),
        _ => None,
    };
    for record in records {
        let (from, to) = (index(record, "from"), index(record, "to"));
        // the reader of JSON rounds once more
        assert!((entries[from * 4 + to] - number(&record["value"])).abs() < 1e-15);
        if let Some(expected) = expected(from, to) {
            let off = (number(&record["value"]) - expected).abs();
            assert!(off < 1e-14, "{record}");
        }
    }
    for row in entries.chunks(4) {
        assert!((row.iter().sum::<f64>() - 1.0).abs() < 1e-13);
    }
    let measured = json(&["measure", &room]);
    assert_eq!(measured["patches"], 4);
    assert_eq!(
        (&measured["closed"], number(&measured["total_area"])),
        (&true.into(), 6.0)
    );
    let own = json(&["form-factor", &room, "--from", "1", "--to", "1"]);
    assert_eq!(own["form_factors"].as_array().unwrap().len(), 1);
    infoscene(&["form-factor", &room, "--from", "4"])
        .assert()
        .code(2);
    // between the four walls of one row stands a screen
    let screen = std::fs::read_to_string(&room).unwrap();
    let screen = screen.replace("End", "V 11 .5 0 1\nV 12 .5 1 1\nO 8 9 10 12 11\nEnd");
    std::fs::write(path("screen.vs3"), screen).unwrap();
    let refused = infoscene(&[
        "form-factor",
        &path("screen.vs3"),
        "--from",
        "1",
        "--to",
        "1",
    ]);
    let refused = { refused }.assert().code(2);
    let message = String::from_utf8_lossy(&refused.get_output().stderr).into_owned();
    assert!(message.contains("obstruction 0 (surface 8)"), "{message}");
}
