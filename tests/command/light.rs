//! Light: `radiosity`, and the chains that it makes.

use crate::refusals::assert_refused;
use crate::{infoscene, json, stdout};

/// The floor of a cube emits as much as it absorbs, and so do all: B = 1 and H = 1.
const FURNACE: [&str; 6] = [
    "radiosity",
    "cube:2",
    "--reflectance",
    "all=0.75",
    "--emittance",
    "all=0.25",
];

#[test]
fn radiosity_writes_every_patch_with_its_keys() {
    let mut arguments = FURNACE.to_vec();
    arguments.extend(["--importance", "0=2,5"]);
    let answer = json(&arguments);
    let patches = answer["patches"].as_array().unwrap();
    assert_eq!(patches.len(), 24);
    for (index, patch) in patches.iter().enumerate() {
        assert_eq!(patch["index"], index);
        for key in ["radiosity", "irradiance"] {
            let value = patch[key].as_f64().unwrap();
            assert!((value - 1.0).abs() < 1e-15, "{key}: {value}");
        }
        assert!(patch["importance"].as_f64().unwrap() > 0.0);
        assert!(patch["form_factor_error"].as_f64().unwrap() < 1e-14);
    }
    assert!(patches[0]["importance"].as_f64() > Some(2.0));
    assert!(answer["residual"].as_f64().unwrap() < 1e-15);
    assert!(answer["iterations"].as_u64().unwrap() > 0);
    assert!(answer["relative_error"].as_f64().unwrap() < 1e-15);
    assert_eq!(answer["closed"], true);
    assert_eq!(answer["plan"]["pairs"], 276);
    // 24 patches of area 1/4 that emit 1/4
    let power = |key: &str| answer["power"][key].as_f64().unwrap();
    assert!((power("emitted") - 1.5).abs() < 1e-15);
    assert!((power("absorbed") - 1.5).abs() < 1e-14);
    assert_eq!(power("escaped"), 0.0);
    assert!(json(&FURNACE)["patches"][3]["importance"].is_null());
}

/// All formats, and the same bytes for any number of threads.
#[test]
fn radiosity_does_not_depend_on_threads() {
    for format in ["table", "csv", "markdown", "latex", "json"] {
        let run = |threads: &str| {
            let mut arguments = FURNACE.to_vec();
            arguments[1] = "cube:8";
            arguments[5] = "0=1,77=3";
            arguments.extend([
                "--importance",
                "9",
                "--format",
                format,
                "--threads",
                threads,
            ]);
            stdout(&arguments)
        };
        let one = run("1");
        assert!(one.lines().count() > 100, "{one}");
        assert_eq!(one, run("2"), "{format}");
    }
}

/// A furnace's chains are those of visibility (§3.4, §3.5); uneven light is not.
#[test]
fn light_makes_other_chains() {
    let information = |more: &[&str]| {
        let answer = json(&[&["measure", "cube:2"], more].concat());
        answer["mutual_information"].as_f64().unwrap()
    };
    let visibility = information(&[]);
    let furnace = ["--reflectance", "all=0.5", "--emittance", "all=0.5"];
    let radiosity = [&["--chain", "radiosity"], &furnace[..]].concat();
    assert!((information(&radiosity) - visibility).abs() < 1e-13);
    let looked_at = [
        "--chain",
        "importance",
        "--reflectance",
        "all=0.5",
        "--importance",
    ];
    assert!((information(&[&looked_at[..], &["all"]].concat()) - visibility).abs() < 1e-13);
    assert!((information(&[&looked_at[..], &["3"]].concat()) - visibility).abs() > 1e-2);
    // the cornell box brings its own light, and its chain has weights that sum to one
    let answer = json(&["measure", "cornell-box", "--chain", "radiosity"]);
    let contributions = answer["contributions"].as_array().unwrap();
    let weights = contributions
        .iter()
        .map(|part| part["weight"].as_f64().unwrap());
    assert!((weights.sum::<f64>() - 1.0).abs() < 1e-14);
}

/// Two squares, one of which emits: the cut is that of fig. 2, and Σw = 2 J B₁ B₂ takes the
/// brightness out of the gain.
#[test]
fn the_cut_under_light_is_judged_by_section_5() {
    let dark = json(&["split", "two-squares", "--patch", "0", "--axis", "u"]);
    let light = [
        "--chain",
        "radiosity",
        "--reflectance",
        "all=0.5",
        "--emittance",
        "1",
    ];
    let split = ["split", "two-squares", "--patch", "0", "--axis", "u"];
    let lit = json(&[&split[..], &light[..]].concat());
    let number = |answer: &serde_json::Value, key: &str| answer[key].as_f64().unwrap();
    assert!((number(&lit, "position") - number(&dark, "position")).abs() < 1e-13);
    // 2/A_T Σ… against 2 B₁ B₂/(2 J B₁ B₂) Σ…, J = 0.2000437760754 (Howell C-14)
    let ratio = number(&lit, "gain") / number(&dark, "gain");
    assert!((ratio * 0.200_043_776_075_4 - 1.0).abs() < 1e-12, "{ratio}");
    assert!((number(&lit, "maximum_gain") - 1.0).abs() < 1e-12);
}

/// `--subdivide`: parts of parts, and the light stays that of the whole.
#[test]
fn scenes_are_quartered_on_the_way_in() {
    let answer = json(&["measure", "cornell-box", "--subdivide", "2"]);
    assert_eq!(answer["patches"], 176);
    let whole = json(&["measure", "cornell-box"]);
    let area = |answer: &serde_json::Value| answer["total_area"].as_f64().unwrap();
    assert!((area(&answer) / area(&whole) - 1.0).abs() < 1e-14);
    assert!(answer["mutual_information"].as_f64() > whole["mutual_information"].as_f64());
}

#[test]
fn light_that_cannot_be_is_refused() {
    let of_cube = |more: &[&str], says: &str| {
        assert_refused(&[&["radiosity", "cube:1"], more].concat(), says);
    };
    of_cube(&[], "no patch has a positive emittance");
    of_cube(&["--reflectance", "all=1.5"], "at most 1");
    of_cube(&["--reflectance", "3=-0.5"], "at least 0");
    of_cube(&["--emittance", "0=NaN"], "finite");
    of_cube(&["--emittance", "0=bright"], "is not a number");
    of_cube(&["--emittance", "0=1:2"], "PATCH=R:G:B");
    of_cube(&["--importance", "0=1:2:3"], "is not a number");
    of_cube(&["--emittance", "lamp"], "there is no patch \"lamp\"");
    of_cube(&["--emittance", "6"], "index from 0 to 5");
    of_cube(
        &["--emittance", "0", "--importance", "9"],
        "there is no patch",
    );
    of_cube(
        &["--emittance", "0", "--reflectance", "1=1e-300"],
        "1e-200 at least",
    );
    assert_refused(
        &["measure", "cube:1", "--emittance", "0"],
        "--chain radiosity",
    );
    assert_refused(
        &[
            "measure",
            "cube:1",
            "--chain",
            "importance",
            "--reflectance",
            "all=0.5",
        ],
        "no patch has a positive direct importance",
    );
    assert_refused(&["measure", "cube:1", "--chain", "heat"], "radiosity");
    assert_refused(
        &["split", "cube:1", "--patch", "0", "--importance", "1"],
        "--chain importance",
    );
    assert_refused(&["measure", "cube:1", "--subdivide", "9"], "0..=8");
    // a dark receiver has nothing to gain
    let dark = [
        "--chain",
        "radiosity",
        "--emittance",
        "1",
        "--reflectance",
        "all=0",
    ];
    assert_refused(
        &[&["split", "cube:1", "--patch", "0"], &dark[..]].concat(),
        "the sum of the weights is 0",
    );
    infoscene(&["radiosity", "cornell-box"]).assert().success();
}
