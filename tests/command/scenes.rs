//! `form-factor` and `measure`: keys, files, exit status.

use crate::{infoscene, json, stdout};
use serde_json::Value;

pub(crate) fn number(value: &Value) -> f64 {
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
pub(crate) fn read_npy(bytes: &[u8]) -> (String, Vec<f64>) {
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

/// The continuous mutual information of a room does not depend on its division: the cube's to 37
/// digits from outside. Random chords have the same key, and refuse what the pairs refuse only if
/// it is open.
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

/// The value is that of cube_grids.csv, row cube_regular_3.
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
    assert!(csv.starts_with("from,to,value,error,route,"));
    assert!(csv.contains("\n0,1,0.2000437760754"));
    assert!(stdout(&["form-factor", "two-squares"]).contains("0 (floor)"));
    let markdown = stdout(&["form-factor", "two-squares", "--format", "markdown"]);
    assert!(markdown.starts_with("| from | to |"));
    assert!(stdout(&["form-factor", "two-squares", "--format", "latex"]).is_ascii());
    assert!(stdout(&["measure", "cube:1"]).contains("0.263034544099"));
    let many = stdout(&["form-factor", "cube:3", "--tolerance", "1e-6"]);
    assert!(many.contains("pairs not shown: 1862: "), "{many}");
}
