//! `infoscene grid`: its keys, what it refuses, and the same bytes from any number of threads.

use crate::refusals::assert_refused;
use crate::{json, stdout};

/// Options, in one string.
fn grid(options: &str) -> Vec<&str> {
    std::iter::once("grid").chain(options.split(' ')).collect()
}

fn numbers(list: &serde_json::Value) -> Vec<f64> {
    list.as_array()
        .unwrap()
        .iter()
        .map(|x| x.as_f64().unwrap())
        .collect()
}

/// Values from data/reference/cube_grids.csv.
#[test]
fn grids_have_their_keys_and_values() {
    let regular = json(&grid("--box 1,1,1 --cells 6"));
    assert_eq!(regular["cells"], 6);
    assert_eq!(
        (&regular["patches"], &regular["pairs"]),
        (&216.into(), &19_440.into())
    );
    // 6·7/2 opposite classes, 6·7/2·6 adjacent ones
    assert_eq!(regular["classes"], 147);
    assert_eq!(numbers(&regular["lines"]).len(), 5);
    assert!(regular["sampled"].is_null() && regular["line_error"].is_null());
    let information = regular["mutual_information"].as_f64().unwrap();
    let error = regular["error"].as_f64().unwrap();
    assert!((information - 1.264_541_832_652_463_3).abs() <= error && error < 1e-13);

    let best = json(&grid("--box 2,2,2 --cells 6 --optimize --precision 128"));
    let lines = numbers(&best["lines"]);
    assert!((lines[0] - 0.098_485_808_008_412_18).abs() <= 1e-14);
    assert!((lines[1] - 0.283_347_123_072_093_4).abs() <= 1e-14);
    assert_eq!(lines[2], 0.5);
    let exact = 1.289_676_160_023_231_2;
    assert!((best["mutual_information"].as_f64().unwrap() / exact - 1.0).abs() <= 1e-13);
    assert_eq!(
        best["regular_mutual_information"],
        regular["mutual_information"]
    );
    assert_eq!(
        (&best["starts"], &best["starts_at_maximum"]),
        (&16.into(), &16.into())
    );
    assert!(best["curvature"].as_f64().unwrap() < 0.0);
    let half = best["enclosures"]["half"].as_array().unwrap();
    assert!(
        half[0]["lower"]
            .as_str()
            .unwrap()
            .starts_with("0.0984858080084121838399")
    );
    assert!(
        half[1]["upper"]
            .as_str()
            .unwrap()
            .starts_with("0.2833471230720934119")
    );
    let enclosed = &best["enclosures"]["mutual_information"]["lower"];
    assert!(
        enclosed
            .as_str()
            .unwrap()
            .starts_with("1.28967616002323121519515949")
    );

    let uneven = json(&grid("--box 1,2,3 --lines 0.1,0.5"));
    assert_eq!(
        (&uneven["cells"], numbers(&uneven["lines"])),
        (&3.into(), vec![0.1, 0.5])
    );
}

#[test]
fn every_format_says_the_same() {
    let options = "--box 1,2,3 --cells 4 --optimize";
    let record = json(&grid(options));
    let digits = |number: &serde_json::Value| number.to_string()[..11].to_owned();
    let (information, line) = (
        digits(&record["mutual_information"]),
        digits(&record["lines"][0]),
    );
    for format in ["table", "markdown", "latex"] {
        let text = stdout(&grid(&format!("{options} --format {format}")));
        assert!(
            text.contains(&information) && text.contains(&line),
            "{text}"
        );
        assert!(
            text.contains("(bound)") && text.contains("16 of 16 starts"),
            "{text}"
        );
        assert!(!text.contains("NaN"), "{text}");
    }
    let text = stdout(&grid(&format!("{options} --format csv")));
    let lines: Vec<&str> = text.lines().collect();
    assert!(lines.len() == 2 && lines[0].starts_with("edges,cells,spacing,lines,"));
    assert!(
        lines[1].starts_with(&format!("1.0 2.0 3.0,4,symmetric,{line}")),
        "{text}"
    );
    let trivial = stdout(&grid("--box 1,1,1 --cells 1 --optimize"));
    assert!(
        trivial.contains("no line is free") && trivial.contains("none"),
        "{trivial}"
    );
}

#[test]
fn the_same_bytes_come_out_for_any_number_of_threads() {
    for options in [
        "--box 1,1,9 --cells 16",
        "--box 1,2,3 --cells 5 --optimize",
        "--box 1,2,3 --lines 0.3,0.4",
    ] {
        let with = |threads: &str| {
            stdout(&grid(&format!(
                "{options} --format json --threads {threads}"
            )))
        };
        assert_eq!(with("1"), with("2"));
        assert_eq!(with("1"), with("7"));
    }
}

#[test]
fn bad_boxes_and_lines_are_refused() {
    for (options, message) in [
        ("--box 1,1 --cells 3", "three edges X,Y,Z, and here are 2"),
        (
            "--box 1,1,0 --cells 3",
            "an edge of the box is 0: it must be finite and > 0",
        ),
        ("--box 1,-1,1 --cells 3", "an edge of the box is -1"),
        ("--box 1,NaN,1 --cells 3", "an edge of the box is NaN"),
        ("--box 1,inf,1 --cells 3", "an edge of the box is inf"),
        (
            "--box 1,1,1e7 --cells 3",
            "at least a millionth of the longest",
        ),
        ("--box 1,1,x --cells 3", "invalid value"),
        ("--box 1,1,1", "--cells"),
        ("--cells 3", "--box"),
        (
            "--box 1,1,1 --cells 0",
            "the number of cells is 0: it must be from 1 to 64",
        ),
        ("--box 1,1,1 --cells 65", "from 1 to 64"),
        ("--box 1,1,1 --cells -1", "unexpected argument"),
        (
            "--box 1,1,1 --lines 0.5,0.4",
            "a grid line is 0.4: it must be inside (0, 1)",
        ),
        ("--box 1,1,1 --lines 0.5,0.5", "a grid line is 0.5"),
        ("--box 1,1,1 --lines 0,0.5", "a grid line is 0"),
        ("--box 1,1,1 --lines 0.5,1", "a grid line is 1"),
        ("--box 1,1,1 --lines -0.5", "a grid line is -0.5"),
        ("--box 1,1,1 --lines NaN", "a grid line is NaN"),
        (
            "--box 1,1,1 --cells 3 --lines 0.5",
            "make 2 cells, and --cells says 3",
        ),
        ("--box 1,1,1 --optimize --lines 0.5", "cannot be used with"),
        ("--box 1,1,1 --cells 13 --precision 128", "up to 12 cells"),
    ] {
        assert_refused(&grid(options), message);
    }
}
