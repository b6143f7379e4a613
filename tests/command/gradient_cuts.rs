//! `cut` with lists and ranges, its figure, and the studies of §4.2.

use crate::refusals::assert_refused;
use crate::{json, stdout};
use infoscene::discretize::{CutComparison, GradientCut};
use serde_json::Value;

fn pairs(answer: &Value) -> Vec<[f64; 2]> {
    let number = |cut: &Value, key: &str| cut[key].as_f64().unwrap();
    let cuts = answer["cuts"].as_array().unwrap();
    let keys = ["exponent", "irradiance_exponent"];
    cuts.iter()
        .map(|cut| keys.map(|key| number(cut, key)))
        .collect()
}

/// N and M in every combination, `n` for the radiosity's own exponent; each record is the one of a
/// single cut.
#[test]
fn lists_of_exponents_make_lists_of_cuts() {
    let lists = [
        "cut",
        "--exponent",
        "1..3,8",
        "--irradiance-exponent",
        "1,n",
    ];
    let answer = json(&lists);
    let expected = [1.0, 2.0, 3.0, 8.0].map(|n| [[n, 1.0], [n, n]]).concat();
    assert_eq!(pairs(&answer), expected);
    let single = json(&["cut", "--exponent", "2", "--irradiance-exponent", "n"]);
    assert_eq!(answer["cuts"][3], single);
    assert_eq!(single["irradiance_exponent"], 2.0);
    let repeated = [
        "cut",
        "--exponent",
        "1",
        "--exponent",
        "2..3",
        "--exponent",
        "8",
    ];
    let repeated = [
        &repeated[..],
        &["--irradiance-exponent", "1", "--irradiance-exponent", "n"],
    ];
    assert_eq!(json(&repeated.concat()), answer);
    let csv = stdout(&[&lists[..], &["--format", "csv"]].concat());
    assert_eq!(csv.lines().count(), 9);
    assert!(csv.starts_with("exponent,irradiance_exponent,mutual_information_cut,"));
}

/// `a..b:count` is evenly spaced in the logarithm, and ends where it says.
#[test]
fn ranges_with_a_count_are_geometric() {
    let exponents: Vec<f64> = pairs(&json(&["cut", "--exponent", "0.5..5e5:7"]))
        .into_iter()
        .map(|[n, _]| n)
        .collect();
    assert_eq!((exponents.len(), exponents[0], exponents[6]), (7, 0.5, 5e5));
    for pair in exponents.windows(2) {
        assert!((pair[1] / pair[0] / 10.0 - 1.0).abs() < 1e-12);
    }
}

/// Either cut judged by both measures: nothing is gained by the other's, and little is lost.
#[test]
fn each_cut_is_judged_by_both_measures() {
    for (n, m) in [(0.5, 1.0), (1.0, 1.0), (4.0, 4.0), (1e6, 1.0)] {
        let cuts = CutComparison::try_new(GradientCut::try_new(n, m).unwrap(), None).unwrap();
        assert!(cuts.gain_kept() < 1.0 && cuts.gain_kept() > 0.9, "{cuts:?}");
        assert!(
            cuts.error_excess() > 0.0 && cuts.error_excess() < 0.1,
            "{cuts:?}"
        );
        let positions = cuts.square.position - cuts.information.position;
        assert!((cuts.distance() - positions).abs() < 1e-15);
    }
    // B = l cut at 1/2: G = 1/4, W = 1/8; at the other cut x the error is (x³ + (1−x)³)/12
    let cut = json(&["cut", "--exponent", "1"]);
    let [gain, error, x] = [
        "gain_at_mean_square_cut",
        "error_at_mutual_information_cut",
        "mutual_information_cut",
    ]
    .map(|key| cut[key].as_f64().unwrap());
    let exact = 0.25 * 2f64.log2() + 0.75 * (6.0 / 7.0f64).log2();
    assert!((gain - exact).abs() < 1e-15, "{gain} {exact}");
    assert!((error - (x.powi(3) + (1.0 - x).powi(3)) / 12.0).abs() < 1e-15);
}

/// Every record of a list is enclosed with --precision, and the table has the digits.
#[test]
fn lists_are_enclosed_on_request() {
    let lists = [
        "cut",
        "--exponent",
        "2..3",
        "--irradiance-exponent",
        "n",
        "--precision",
        "160",
    ];
    for (index, digits) in [
        "0.622369282329992550285413384224",
        "0.703398015615179600738410101406",
    ]
    .iter()
    .enumerate()
    {
        let bounds = &json(&lists)["cuts"][index]["enclosures"]["mutual_information_cut"];
        // data/reference/section_4_2.csv; its last digit may be rounded
        assert!(bounds["lower"].as_str().unwrap().starts_with(&digits[..31]));
        assert!(bounds["upper"].as_str().unwrap().starts_with(&digits[..31]));
        assert!(stdout(&lists).contains(&digits[..20]));
    }
}

/// The figure is written beside the answer, names its axes, and each line has a dash pattern and a
/// marker in the legend.
#[test]
fn a_figure_of_cuts_names_axes_and_lines() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cuts.svg");
    let figure = ["--figure", path.to_str().unwrap()];
    let cut = [
        "cut",
        "--exponent",
        "0.2..200:21",
        "--irradiance-exponent",
        "1,n",
    ];
    let answer = stdout(&[&cut[..], &figure].concat());
    assert_eq!(answer, stdout(&cut));
    let svg = std::fs::read_to_string(&path).unwrap();
    // the drawing fills its page: the view box has the sides of the page, and its numbers are whole
    let head = svg.split('>').next().unwrap();
    let number = |key: &str| {
        head.split(&format!(" {key}=\""))
            .nth(1)
            .unwrap()
            .split('"')
            .next()
    };
    let side = |key: &str| number(key).unwrap().parse::<u32>().unwrap();
    let view: Vec<u32> = number("viewBox")
        .unwrap()
        .split(' ')
        .map(|n| n.parse().unwrap())
        .collect();
    assert_eq!(view[..2], [0, 0]);
    assert_eq!(view[2] * side("height"), view[3] * side("width"));
    for text in [
        "exponent n of the radiosity",
        "best cut l",
        "irradiance ∝ lⁿ",
        "mean square error",
    ] {
        assert!(svg.contains(text), "{text}");
    }
    // three lines of eight markers or so, and one each in the legend
    let markers = svg.matches("<polygon").count();
    assert!((24..=40).contains(&markers), "{markers}");
    for colour in ["#000000", "#0072B2", "#D55E00"] {
        assert!(svg.contains(colour), "{colour}");
    }
    assert!(!svg.contains("NaN"));
}

/// A claim's curve, with its axes; a single line needs neither marker nor legend.
#[test]
fn a_figure_of_one_curve_has_neither_marker_nor_legend() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("curve.svg");
    stdout(&[
        "curve",
        "s42-across-the-gradient",
        "--figure",
        path.to_str().unwrap(),
    ]);
    let svg = std::fs::read_to_string(&path).unwrap();
    assert!(
        svg.contains("angle to the perpendicular (degrees)")
            && svg.contains("gain of the best cut (bits)")
    );
    assert!(svg.contains("<polyline") && !svg.contains("<polygon"));
    // an axis that ends where the data do, with ticks at round numbers
    assert!(svg.contains("\n80\n") && !svg.contains("\n100\n"));
}

#[test]
fn lists_that_mean_nothing_are_refused() {
    for (list, message) in [
        ("1,,2", "is no number"),
        ("3..1", "is no range"),
        ("0..5", "is no range"),
        ("1..inf", "is no range"),
        ("1..NaN:4", "is no range"),
        ("1..1e9", "more than 1000"),
        ("1..9:1", "from 2 to 1000"),
        ("1..9:x", "is no count"),
        ("n", "is no number"),
    ] {
        assert_refused(&["cut", "--exponent", list], message);
    }
    let other = ["cut", "--exponent", "1", "--irradiance-exponent", "m"];
    assert_refused(&other, "nor the letter n");
    let many = [
        "cut",
        "--exponent",
        "1..200",
        "--irradiance-exponent",
        "1..200",
    ];
    assert_refused(&many, "40000 pairs");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cuts.svg");
    let path = path.to_str().unwrap();
    assert_refused(&["cut", "--exponent", "2", "--figure", path], "two points");
    let seven = [
        "cut",
        "--exponent",
        "1..2",
        "--irradiance-exponent",
        "1..7",
        "--figure",
        path,
    ];
    assert_refused(&seven, "8 lines");
    assert!(!std::path::Path::new(path).exists());
}

#[test]
fn limits_are_those_of_the_reference_and_are_missed_by_a_multiple_of_one_over_n() {
    let answer = json(&["study", "limits"]);
    assert_eq!(answer["study"], "limits");
    let rows = answer["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 39);
    for row in rows {
        let n = row["exponent"].as_f64().unwrap();
        let error = row["relative_error"].as_f64().unwrap();
        assert!(error < 3.3 / n && error > 0.1 / n, "{row}");
        // data/reference/section_4_2.csv
        let limit = match row["method"].as_str().unwrap() {
            "mutual information, m = 1" => "1.5936242600400400923230418758",
            "mutual information, m = n" => "1.3664879106311163128910335503",
            _ => "1.2564312086261696769827376166",
        };
        assert!(
            row["limit"]["lower"].as_str().unwrap().starts_with(limit),
            "{row}"
        );
    }
    let table = stdout(&["study", "limits", "--format", "markdown"]);
    assert!(table.contains("| ∞ | 1.593624260040040 | 1.366487910631116 | 1.256431208626169 |"));
}

/// Constant irradiance has no best cut by mutual information; every other profile has one inside,
/// by either measure.
#[test]
fn every_profile_has_its_cuts_but_the_constant_one() {
    let answer = json(&["study", "profiles"]);
    assert_eq!(answer["study"], "profiles");
    let is_cut =
        |row: &&Value| row["irradiance"] != "constant" || row["method"] != "mutual information";
    let rows = answer["rows"].as_array().unwrap();
    let (cut, uncut): (Vec<&Value>, Vec<&Value>) = rows.iter().partition(is_cut);
    assert!(!cut.is_empty() && !uncut.is_empty());
    for row in uncut {
        assert!(row["value"].is_null() && row["gain"] == 0.0, "{row}");
    }
    for row in cut {
        let value = row["value"].as_f64().unwrap();
        assert!(value > 0.0 && value < 1.0, "{row}");
        let is_at_least = |key: &str| row[key].is_null() || row[key].as_f64().unwrap() >= 0.0;
        assert!(is_at_least("relative_error"), "{row}");
        let share = &row["gain_share"];
        assert!(share.is_null() || share.as_f64().unwrap() <= 1.0, "{row}");
    }
    assert!(stdout(&["study", "profiles"]).contains("e^(4l)"));
}

/// Across the gradient the gain is that of `cut`, along it nothing is left, and in between it
/// falls.
#[test]
fn gains_fall_with_the_angle_to_nothing() {
    let answer = json(&["study", "directions"]);
    assert_eq!(answer["study"], "directions");
    let rows = answer["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 5 * 19);
    for patch in rows.chunks(19) {
        let number = |row: usize, key: &str| patch[row][key].as_f64().unwrap();
        let cut = GradientCut::try_new(number(0, "exponent"), number(0, "irradiance_exponent"));
        let best = cut.unwrap().mutual_information_cut().unwrap();
        assert!((number(0, "gain") / best.value - 1.0).abs() < 1e-12);
        assert!((number(0, "offset") - best.position).abs() < 1e-10);
        assert_eq!((number(18, "degrees"), number(18, "gain")), (90.0, 0.0));
        for row in 0..18 {
            assert!(number(row, "gain_share") > number(row + 1, "gain_share"));
        }
    }
    assert!(stdout(&["study", "directions"]).contains("45°"));
}

/// LaTeX stays plain ASCII.
#[test]
fn tables_in_latex_are_ascii() {
    for question in [
        &["study", "limits"][..],
        &["study", "profiles"],
        &["study", "directions"],
        &["cut", "--exponent", "1"],
        &["cut", "--exponent", "1..2"],
    ] {
        let latex = stdout(&[question, &["--format", "latex"]].concat());
        assert!(latex.is_ascii() && latex.contains("\\begin{"), "{latex}");
    }
}
